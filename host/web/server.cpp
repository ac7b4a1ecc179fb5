// SPDX-License-Identifier: Apache-2.0
// Limits, rules, and the routes together.
#include "host/web/server.hpp"

#include "host/web/head.hpp"
#include "host/web/listener.hpp"
#include "host/web/routes.hpp"

namespace web {

namespace {

// More than are waited for and listen to events together.
constexpr std::size_t workers = 64;
constexpr std::size_t most_waiting_connections = 256;

void set_limits(httplib::Server& server) {
  server.new_task_queue = [] {
    return new httplib::ThreadPool(workers, most_waiting_connections);  // httplib deletes it
  };
  server.set_payload_max_length(UploadLimits{}.bytes + 64 * 1024);
  server.set_tcp_nodelay(true);
  // httplib's own ones let two servers share a port.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_default_headers(
      {{"X-Content-Type-Options", "nosniff"},
       {"X-Frame-Options", "DENY"},
       {"Referrer-Policy", "no-referrer"},
       {"Cache-Control", "no-store"},
       {"Content-Security-Policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
        "img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}});
}

}  // namespace

Server::Server(spooler::Spooler& spooler, const Address& address, Rules rules,
               const WaitLimits& limits)
    : spooler_(spooler),
      address_(address),
      guard_(std::move(rules)),
      server_(std::make_unique<Listener>(limits)) {
  if (!is_loopback(address_.host) && !guard_.has_key()) {
    throw std::runtime_error("other machines reach " + written(address_) +
                             ": a key is needed (--key FILE)");
  }
  set_limits(*server_);
  server_->set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        const auto refusal = guard_.refusal_of(head_of(request), request.remote_addr);
        if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
        if (refusal->status == 429) response.set_header("Retry-After", "1");
        answer_error(response, refusal->status, refusal->why);
        return httplib::Server::HandlerResponse::Handled;
      });
  add_page(*server_);
  add_rest_routes(*server_, spooler_);
  add_event_route(*server_, spooler_, {.ends = ends_, .streams = streams_});
  add_octoprint_routes(*server_, spooler_);
  add_last_routes(*server_);
  if (address_.port == 0) {
    const int port = server_->bind_to_any_port(address_.host);
    if (port < 0) throw std::runtime_error("cannot listen on " + address_.host);
    address_.port = static_cast<std::uint16_t>(port);
  } else if (!server_->bind_to_port(address_.host, address_.port)) {
    throw std::runtime_error("cannot listen on " + written(address_) + "; is it in use?");
  }
  server_->queue_connections();
  thread_ = std::thread([this] { server_->listen_after_bind(); });
  server_->wait_until_ready();
}

Server::~Server() {
  ends_ = true;
  server_->end();
  server_->stop();
  thread_.join();
}

}  // namespace web
