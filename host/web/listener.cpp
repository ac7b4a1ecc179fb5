// SPDX-License-Identifier: Apache-2.0
// A connection from its begin to its end, in one of the workers.
#include "host/web/listener.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>

#include "host/web/request_stream.hpp"

namespace web {

namespace {

constexpr std::chrono::seconds write_limit{10};
constexpr int most_queued = 512;  // by the system
constexpr std::size_t most_left_unread = 1024 * 1024;

// What has come and was not read would make close() reset the connection, and the client might lose
// its answer.
void drop_unread(int socket) {
  std::array<char, 16 * 1024> buffer;
  for (std::size_t dropped = 0; dropped < most_left_unread;) {
    const ssize_t count = recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count <= 0) return;
    dropped += static_cast<std::size_t>(count);
  }
}

}  // namespace

void Listener::queue_connections() { ::listen(svr_sock_, most_queued); }

bool Listener::process_and_close_socket(socket_t socket) {
  bool answered = false;
  try {
    RequestStream stream(socket, connections_, write_limit);
    std::string remote, local;
    int remote_port = 0, local_port = 0;
    stream.get_remote_ip_and_port(remote, remote_port);
    stream.get_local_ip_and_port(local, local_port);
    bool is_closed = false;
    answered = process_request(stream, remote, remote_port, local, local_port, true, is_closed,
                               set_form_type);
  } catch (const std::exception&) {  // the fault of one request ends no other
  }
  shutdown(socket, SHUT_WR);
  drop_unread(socket);
  close(socket);
  return answered;
}

}  // namespace web
