// SPDX-License-Identifier: Apache-2.0
// A connection from its begin to its end, in one of the workers.
#include "host/web/listener.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <functional>
#include <semaphore>
#include <stdexcept>
#include <utility>

#include "host/web/ascii.hpp"
#include "host/web/request_stream.hpp"

namespace web {

namespace {

constexpr std::chrono::milliseconds look_interval{50};  // whether an adopted socket is to be left
constexpr int most_queued = 512;  // by the system
constexpr std::size_t most_left_unread = 1024 * 1024;
constexpr std::ptrdiff_t most_waiting_connections = 256;
constexpr std::size_t longest_body = (std::size_t{1} << 30u) + 64 * 1024;

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

// Where all workers are busy and as many connections wait as may, the next one stays with the
// system until one of them has been taken. httplib's own queue would close it: of a burst of
// connections, also that of a person's request.
class PatientPool final : public httplib::TaskQueue {
 public:
  explicit PatientPool(std::size_t workers) : pool_(workers) {}

  bool enqueue(std::function<void()> serve) override {
    room_.acquire();
    return pool_.enqueue([this, serve = std::move(serve)] {
      room_.release();
      serve();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  std::counting_semaphore<> room_{most_waiting_connections};
  httplib::ThreadPool pool_;
};

}  // namespace

bool wants_websocket(const httplib::Request& request) {
  return request.method == "GET" && equal_names(request.get_header_value("Upgrade"), "websocket");
}

Listener::Listener(WaitLimits limits, std::size_t workers) : connections_(limits) {
  new_task_queue = [workers] {
    return new PatientPool(workers);  // httplib deletes it
  };
  set_payload_max_length(longest_body);
  set_tcp_nodelay(true);
  // httplib's own ones let two servers share a port.
  set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
}

Address Listener::bind(Address address) {
  if (address.port == 0) {
    const int port = bind_to_any_port(address.host);
    if (port < 0) throw std::runtime_error("cannot listen on " + address.host);
    address.port = static_cast<std::uint16_t>(port);
  } else if (!bind_to_port(address.host, address.port)) {
    throw std::runtime_error("cannot listen on " + written(address) + "; is it in use?");
  }
  // httplib lets the system queue 5 connections only: in a burst the others wait for seconds.
  ::listen(svr_sock_, most_queued);
  return address;
}

// httplib waits in accept() for the shutdown of its socket. This one is looked at instead, since
// another one of its owners may have taken the connection too.
void Listener::adopt(int socket) {
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
  set_idle_interval(look_interval);
  svr_sock_ = socket;
  is_adopted_ = true;
}

void Listener::stop() {
  if (is_adopted_) {
    svr_sock_ = INVALID_SOCKET;
  } else {
    httplib::Server::stop();
  }
}

void Listener::Get(const std::string& pattern, Handler handler) {
  routes_.push_back({.method = "GET", .pattern = pattern});
  httplib::Server::Get(pattern, std::move(handler));
}

void Listener::Post(const std::string& pattern, HandlerWithContentReader handler) {
  routes_.push_back({.method = "POST", .pattern = pattern});
  httplib::Server::Post(pattern, std::move(handler));
}

void Listener::Put(const std::string& pattern, HandlerWithContentReader handler) {
  routes_.push_back({.method = "PUT", .pattern = pattern});
  httplib::Server::Put(pattern, std::move(handler));
}

void Listener::Patch(const std::string& pattern, HandlerWithContentReader handler) {
  routes_.push_back({.method = "PATCH", .pattern = pattern});
  httplib::Server::Patch(pattern, std::move(handler));
}

void Listener::Delete(const std::string& pattern, HandlerWithContentReader handler) {
  routes_.push_back({.method = "DELETE", .pattern = pattern});
  httplib::Server::Delete(pattern, std::move(handler));
}

bool Listener::process_and_close_socket(socket_t socket) {
  bool answered = false;
  try {
    RequestStream stream(socket, connections_);
    std::string remote, local;
    int remote_port = 0, local_port = 0;
    stream.get_remote_ip_and_port(remote, remote_port);
    stream.get_local_ip_and_port(local, local_port);
    bool is_closed = false;
    Taker take;
    answered = process_request(stream, remote, remote_port, local, local_port, true, is_closed,
                               [&](httplib::Request& request) {
                                 set_form_type(request);
                                 if (!on_upgrade || !wants_websocket(request)) return;
                                 take = on_upgrade(request);
                                 if (take) stream.drop_output();
                               });
    if (take && !stream.is_readable()) {  // nothing may follow before the answer
      take(socket);
      return true;
    }
  } catch (const std::exception&) {  // the fault of one request ends no other
  }
  shutdown(socket, SHUT_WR);
  drop_unread(socket);
  close(socket);
  return answered;
}

}  // namespace web
