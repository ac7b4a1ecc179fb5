// SPDX-License-Identifier: Apache-2.0
// Reading OpenOCD's requests and moving the pins.
#include "sim/devices/debug_adapter.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace devices {

namespace {

// rtl/debug/debug_transport.vhd requests five clocks with TCK low.
constexpr sim::Clock clocks_per_level = 6;
// Looking for requests costs a system call.
constexpr sim::Clock clocks_between_looks = 500;
constexpr std::size_t buffer_bytes = 4096;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

DebugAdapter::DebugAdapter(std::uint16_t port, sim::InputPins& inputs) : pins_(inputs.jtag) {
  listen_on(port);
  next_wake_ = clocks_between_looks;
}

DebugAdapter::~DebugAdapter() {
  if (debugger_ >= 0) close(debugger_);
  close(listener_);
}

void DebugAdapter::listen_on(std::uint16_t port) {
  listener_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (listener_ < 0) fail("cannot make a socket");
  const int yes = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener_, generic, size) != 0 || listen(listener_, 1) != 0 ||
      getsockname(listener_, generic, &size) != 0) {
    close(listener_);
    fail("cannot listen on the debugger's port");
  }
  port_ = ntohs(address.sin_port);
}

void DebugAdapter::pins_changed(sim::Clock, sim::OutputPins pins, sim::OutputPins) {
  output_ = pins.jtag_data();
}

void DebugAdapter::wake(sim::Clock now) {
  next_wake_ = now + clocks_between_looks;
  if (debugger_ < 0) {
    look_for_debugger(now);
    return;
  }
  while (!move_pins()) {
    send_replies();
    if (leaving_) {
      disconnect(now);
      return;
    }
    if (!receive(now)) return;
  }
  next_wake_ = now + clocks_per_level;
}

void DebugAdapter::look_for_debugger(sim::Clock now) {
  debugger_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (debugger_ < 0) return;
  const int yes = 1;
  setsockopt(debugger_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  if (on_connect) on_connect(now);
}

void DebugAdapter::disconnect(sim::Clock now) {
  close(debugger_);
  debugger_ = -1;
  leaving_ = false;
  requests_.clear();
  next_request_ = 0;
  replies_.clear();
  if (on_disconnect) on_disconnect(now);
}

bool DebugAdapter::receive(sim::Clock now) {
  std::array<char, buffer_bytes> buffer{};
  const ssize_t count = recv(debugger_, buffer.data(), buffer.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  if (count <= 0) {
    disconnect(now);
    return false;
  }
  requests_.assign(buffer.data(), static_cast<std::size_t>(count));
  next_request_ = 0;
  return true;
}

bool DebugAdapter::move_pins() {
  while (next_request_ < requests_.size()) {
    if (obey(requests_[next_request_++])) return true;
  }
  return false;
}

// Section "remote_bitbang" of OpenOCD's manual for developers: digits are the levels of TCK,
// TMS and TDI, R requests TDO, Q ends it; B, b (a lamp) and r to u (reset lines) have nothing
// to move here.
bool DebugAdapter::obey(char request) {
  if (request >= '0' && request <= '7') {
    const int levels = request - '0';
    pins_ = {.tck = (levels & 4) != 0, .tms = (levels & 2) != 0, .tdi = (levels & 1) != 0};
    return true;
  }
  if (request == 'R') {
    replies_ += output_ ? '1' : '0';
  } else if (request == 'Q') {
    leaving_ = true;
    requests_.clear();
  }
  return false;
}

void DebugAdapter::send_replies() {
  std::size_t sent = 0;
  while (sent < replies_.size()) {
    const ssize_t count =
        send(debugger_, replies_.data() + sent, replies_.size() - sent, MSG_NOSIGNAL);
    // A debugger that does not read its few answers has disconnected, which receive() detects.
    if (count < 0 && errno != EAGAIN && errno != EINTR) break;
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  replies_.clear();
}

}  // namespace devices
