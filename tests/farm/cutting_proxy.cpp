// SPDX-License-Identifier: Apache-2.0
// A thread for each connection.
#include "tests/farm/cutting_proxy.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>

namespace farm_test {

namespace {

constexpr int pass_ms = 50;
constexpr const char* socket_name = ".s.PGSQL.5432";

sockaddr_un name_in(const std::filesystem::path& folder) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  const std::string path = (folder / socket_name).string();
  if (path.size() >= sizeof name.sun_path) throw std::runtime_error("too long: " + path);
  std::ranges::copy(path, static_cast<char*>(name.sun_path));
  return name;
}

int new_socket() { return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0); }

bool waits(int socket) {
  pollfd each{.fd = socket, .events = POLLIN, .revents = 0};
  return poll(&each, 1, pass_ms) > 0;
}

// What has come; nothing where the other end is closed.
std::string received(int socket) {
  std::array<char, 65536> buffer{};
  const ssize_t count = recv(socket, buffer.data(), buffer.size(), 0);
  return {buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

void send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace

CuttingProxy::CuttingProxy(std::filesystem::path server_folder)
    : server_folder_(std::move(server_folder)), listener_(new_socket()) {
  const sockaddr_un name = name_in(folder_.path());
  const auto* const address = reinterpret_cast<const sockaddr*>(&name);
  if (bind(listener_, address, sizeof name) != 0 || listen(listener_, 8) != 0) {
    throw std::runtime_error("no socket for the proxy");
  }
  thread_ = std::thread([this] { accept_clients(); });
}

CuttingProxy::~CuttingProxy() {
  ends_ = true;
  thread_.join();
  for (std::thread& client : clients_) client.join();
  close(listener_);
}

void CuttingProxy::accept_clients() {
  while (!ends_) {
    if (!waits(listener_)) continue;
    const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (refuses_) {
      close(client);
    } else {
      clients_.emplace_back([this, client] { pass_on(client); });
    }
  }
}

void CuttingProxy::pass_on(int client) {
  const int server = new_socket();
  const sockaddr_un name = name_in(server_folder_);
  bool open = connect(server, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
  while (open && !ends_) {
    std::array<pollfd, 2> ends{pollfd{.fd = client, .events = POLLIN, .revents = 0},
                               pollfd{.fd = server, .events = POLLIN, .revents = 0}};
    if (poll(ends.data(), ends.size(), pass_ms) <= 0) continue;
    if (ends[1].revents != 0) {
      const std::string bytes = received(server);
      send_all(client, bytes);
      open = !bytes.empty();
    }
    if (ends[0].revents == 0 || !open) continue;
    const std::string bytes = received(client);
    open = !bytes.empty();
    const bool is_commit = bytes.contains("COMMIT");
    const Cut how = is_commit ? cut_.exchange(Cut::none) : Cut::none;
    if (how == Cut::none) {
      send_all(server, bytes);
      continue;
    }
    open = false;
    if (how == Cut::silence) {
      while (!ends_) std::this_thread::sleep_for(std::chrono::milliseconds(pass_ms));
    } else if (how == Cut::late_commit) {
      shutdown(client, SHUT_RDWR);
      std::this_thread::sleep_for(std::chrono::seconds(1));
      send_all(server, bytes);
      received(server);
    } else if (how == Cut::after_commit) {
      send_all(server, bytes);
      received(server);
    }
  }
  close(client);
  close(server);
}

}  // namespace farm_test
