// SPDX-License-Identifier: Apache-2.0
// One thread for all sockets, a few for the methods, one for emergency stops.
#include "host/moonraker/sockets.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <thread>

#include "host/moonraker/session.hpp"
#include "host/web/http.hpp"

namespace moonraker {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr std::size_t worker_threads = 4;

tcp protocol_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  const bool is_known = getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  return is_known && address.ss_family == AF_INET6 ? tcp::v6() : tcp::v4();
}

}  // namespace

struct Sockets::Machinery {
  Machinery(Core& core, const Methods& methods, const SocketLimits& wanted)
      : limits(wanted),
        context{.core = core,
                .methods = methods,
                .limits = limits,
                .ends = ends,
                .workers = workers,
                .urgent = urgent} {}

  const SocketLimits limits;
  std::atomic<bool> ends = false;
  // Sessions use them, and go with the io_context: it is destroyed first.
  asio::thread_pool workers{worker_threads};
  asio::thread_pool urgent{1};
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  SessionContext context;
  std::thread thread{[this] { io.run(); }};
};

Sockets::Sockets(Core& core, const Methods& methods, const SocketLimits& limits)
    : machinery_(std::make_unique<Machinery>(core, methods, limits)) {}

Sockets::~Sockets() {
  Machinery& machinery = *machinery_;
  machinery.ends = true;
  machinery.io.stop();
  machinery.thread.join();
  machinery.workers.join();
  machinery.urgent.join();
  machinery.context.core.hub.clear();
}

void Sockets::refuse(int socket, int status) {
  const std::string answer = "HTTP/1.1 " + std::to_string(status) + " " +
                             httplib::status_message(status) +
                             "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";
  ::send(socket, answer.data(), answer.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  ::close(socket);
}

void Sockets::take(int socket, const Handshake& handshake, bool authorised) {
  tcp::socket connection(machinery_->io);
  boost::system::error_code error;
  connection.assign(protocol_of(socket), socket, error);
  if (error) {
    ::close(socket);
    return;
  }
  const auto session = std::make_shared<Session>(std::move(connection), machinery_->context,
                                                 handshake.client, authorised);
  if (!machinery_->context.core.hub.enter(session)) return session->refuse();
  asio::post(machinery_->io, [session, handshake] { session->begin(handshake); });
}

}  // namespace moonraker
