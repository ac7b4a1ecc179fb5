// SPDX-License-Identifier: Apache-2.0
// The environment of socket activation, and what the socket is.
#include "host/web/inherited_socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace web {

namespace {

constexpr int first = 3;  // SD_LISTEN_FDS_START
constexpr std::array variables{"LISTEN_PID", "LISTEN_FDS", "LISTEN_FDNAMES", "LISTEN_PIDFDID"};

std::string value_of(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Address address_at(int number) {
  sockaddr_storage bound{};
  socklen_t size = sizeof bound;
  getsockname(number, reinterpret_cast<sockaddr*>(&bound), &size);
  std::array<char, INET6_ADDRSTRLEN> host{};
  if (bound.ss_family == AF_INET) {
    const auto& address = reinterpret_cast<const sockaddr_in&>(bound);
    inet_ntop(AF_INET, &address.sin_addr, host.data(), host.size());
    return {.host = host.data(), .port = ntohs(address.sin_port)};
  }
  if (bound.ss_family == AF_INET6) {
    const auto& address = reinterpret_cast<const sockaddr_in6&>(bound);
    inet_ntop(AF_INET6, &address.sin6_addr, host.data(), host.size());
    return {.host = host.data(), .port = ntohs(address.sin6_port)};
  }
  throw std::runtime_error("the socket that was handed over is no TCP socket");
}

}  // namespace

std::optional<InheritedSocket> inherited_socket() {
  const std::string process = value_of("LISTEN_PID"), count = value_of("LISTEN_FDS");
  for (const char* name : variables) unsetenv(name);
  if (count.empty() || process != std::to_string(getpid())) return std::nullopt;
  if (count != "1") throw std::runtime_error(count + " sockets were handed over, not one");
  return inherited_socket_at(first);
}

InheritedSocket inherited_socket_at(int number) {
  int listens = 0, type = 0;
  socklen_t size = sizeof listens;
  const bool known = getsockopt(number, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) == 0 &&
                     getsockopt(number, SOL_SOCKET, SO_TYPE, &type, &size) == 0;
  if (!known || listens == 0 || type != SOCK_STREAM) {
    throw std::runtime_error("the socket that was handed over does not listen");
  }
  InheritedSocket socket{.number = number, .address = address_at(number)};
  fcntl(number, F_SETFD, FD_CLOEXEC);
  return socket;
}

}  // namespace web
