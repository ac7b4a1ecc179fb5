// SPDX-License-Identifier: Apache-2.0
// Reads with one limit of time for all of a request.
#include "host/web/request_stream.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "host/web/rate.hpp"

namespace web {

namespace {

using std::chrono::milliseconds;
constexpr milliseconds look_interval{100};  // nothing wakes who waits to write and is given up

// False after this time.
bool wait_for(int socket, short events, milliseconds time) {
  const auto end = Clock::now() + time;
  while (true) {
    const auto left = std::chrono::ceil<milliseconds>(end - Clock::now());
    pollfd waiting{.fd = socket, .events = events, .revents = 0};
    const int count = poll(&waiting, 1, static_cast<int>(std::max(left, milliseconds(0)).count()));
    if (count > 0) return true;
    if (count == 0 || errno != EINTR) return false;
  }
}

void read_address(const sockaddr_storage& address, std::string& ip, int& port) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (address.ss_family == AF_INET) {
    sockaddr_in known{};
    std::memcpy(&known, &address, sizeof known);
    inet_ntop(AF_INET, &known.sin_addr, text.data(), text.size());
    port = ntohs(known.sin_port);
  } else if (address.ss_family == AF_INET6) {
    sockaddr_in6 known{};
    std::memcpy(&known, &address, sizeof known);
    inet_ntop(AF_INET6, &known.sin6_addr, text.data(), text.size());
    port = ntohs(known.sin6_port);
  }
  ip = text.data();
}

}  // namespace

RequestStream::RequestStream(int socket, Connections& connections) : connections_(connections) {
  awaited_.socket = socket;
  int port = 0;
  std::string address;
  get_remote_ip_and_port(address, port);
  awaited_.client = client_of(address);
}

bool RequestStream::is_readable() const { return !ended_ && used_ < filled_; }
bool RequestStream::is_writable() const { return !ended_ && wait_to_write(); }

// Until the client has sent more.
Clock::duration RequestStream::time_left() const {
  const WaitLimits& limits = connections_.limits();
  if (!head_ended_) return limits.patience - waited_;
  const std::chrono::duration<double> more(static_cast<double>(total_) / limits.bytes_per_second);
  const Clock::duration all =
      2 * limits.patience + std::chrono::duration_cast<Clock::duration>(more);
  return std::min<Clock::duration>(all - waited_, limits.patience);
}

ssize_t RequestStream::read(char* bytes, std::size_t size) {
  if (used_ == filled_ && !fill()) return ended_ ? -1 : 0;
  const std::size_t count = std::min(size, filled_ - used_);
  std::copy_n(buffer_.data() + used_, count, bytes);
  used_ += count;
  return static_cast<ssize_t>(count);
}

// Waits for more. False at the end of the connection, or where the request is given up.
bool RequestStream::fill() {
  if (ended_) return false;
  bool is_there = wait_for(awaited_.socket, POLLIN, milliseconds(0));
  if (!is_there) {
    const Clock::time_point begin = Clock::now();
    const Clock::duration left = std::max(time_left(), Clock::duration::zero());
    awaited_.due = begin + left;
    connections_.enter(awaited_);
    is_there = wait_for(awaited_.socket, POLLIN, std::chrono::ceil<milliseconds>(left));
    connections_.leave(awaited_);
    waited_ += Clock::now() - begin;
  }
  if (awaited_.given_up) {
    answer_and_end("503 Service Unavailable", "too many requests are on their way: try again");
    return false;
  }
  if (!is_there || time_left() < Clock::duration::zero()) {
    answer_and_end("408 Request Timeout", "the request came too slowly");
    return false;
  }
  const ssize_t count = recv(awaited_.socket, buffer_.data(), buffer_.size(), 0);
  if (count <= 0) return false;
  used_ = 0;
  filled_ = static_cast<std::size_t>(count);
  total_ += filled_;
  if (!head_ended_) follow_head();
  return !ended_;
}

// The head ends with an empty line, at which httplib ends it too.
void RequestStream::follow_head() {
  for (std::size_t i = 0; i < filled_ && !head_ended_; ++i) {
    last_ = {last_[1], last_[2], buffer_[i]};
    head_ended_ = last_ == std::array{'\n', '\r', '\n'};
    if (++head_bytes_ > connections_.limits().longest_head) {
      return answer_and_end("431 Request Header Fields Too Large", "the head is too long");
    }
  }
}

void RequestStream::answer_and_end(const char* status, const char* why) {
  const std::string body = std::string(R"({"error":")") + why + "\"}\n";
  const std::string text = std::string("HTTP/1.1 ") + status +
                           "\r\nContent-Type: application/json\r\nConnection: close\r\n"
                           "Content-Length: " +
                           std::to_string(body.size()) + "\r\n\r\n" + body;
  write(text.data(), text.size());
  ended_ = true;
}

// A client that does not read counts among those that are waited for.
bool RequestStream::wait_to_write() const {
  bool is_ready = wait_for(awaited_.socket, POLLOUT, milliseconds(0));
  if (is_ready || awaited_.given_up) return is_ready;
  awaited_.due = Clock::now() + connections_.limits().patience;
  connections_.enter(awaited_);
  while (!is_ready && !awaited_.given_up && Clock::now() < awaited_.due) {
    is_ready = wait_for(awaited_.socket, POLLOUT, look_interval);
  }
  connections_.leave(awaited_);
  return is_ready && !awaited_.given_up;
}

ssize_t RequestStream::write(const char* bytes, std::size_t size) {
  if (ended_) return -1;
  if (drops_output_) return static_cast<ssize_t>(size);
  while (wait_to_write()) {
    const ssize_t count = send(awaited_.socket, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0 || (errno != EAGAIN && errno != EINTR)) return count;
  }
  return -1;
}

void RequestStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getpeername(awaited_.socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return;
  read_address(address, ip, port);
}

void RequestStream::get_local_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(awaited_.socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return;
  read_address(address, ip, port);
}

}  // namespace web
