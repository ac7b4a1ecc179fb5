// SPDX-License-Identifier: Apache-2.0
// Limits, rules, and the routes together.
#include "host/web/server.hpp"

#include "host/web/head.hpp"
#include "host/web/listener.hpp"
#include "host/web/routes.hpp"

namespace web {

namespace {

void set_headers(httplib::Server& server) {
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

Server::Server(spooler::Spooler& spooler, const Address& address, const Rules& rules,
               const WaitLimits& limits, const std::optional<InheritedSocket>& socket)
    : spooler_(spooler),
      address_(socket ? socket->address : address),
      guard_(rules),
      server_(std::make_unique<Listener>(limits)) {
  check_reach(address_, rules);
  set_headers(*server_);
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
  add_picture_routes(*server_, spooler_);
  add_event_route(*server_, spooler_, {.ends = ends_, .streams = streams_});
  add_octoprint_routes(*server_, spooler_);
  add_prusalink_routes(*server_, spooler_);
  add_last_routes(*server_);
  if (socket) {
    server_->adopt(socket->number);
  } else {
    address_ = server_->bind(address_);
  }
  thread_ = std::thread([this] { server_->listen_after_bind(); });
  server_->wait_until_ready();
}

Server::~Server() {
  ends_ = true;
  server_->end();
  server_->stop();
  thread_.join();
}

const std::vector<Route>& Server::routes() const { return server_->routes(); }

}  // namespace web
