// SPDX-License-Identifier: Apache-2.0
// Rules first, then routes; a WebSocket leaves httplib after its head.
#include "host/moonraker/server.hpp"

#include <algorithm>
#include <array>

#include "host/moonraker/broadcaster.hpp"
#include "host/moonraker/routes.hpp"
#include "host/web/head.hpp"

namespace moonraker {

namespace {

constexpr std::size_t workers = 32;
constexpr std::string_view socket_path = "/websocket", stop_path = "/printer/emergency_stop";

bool is_socket(const httplib::Request& request) {
  return request.path == socket_path && web::wants_websocket(request);
}

// Scripts and styles are the front end's own; no other page may show it in a frame.
void set_headers(httplib::Server& server) {
  server.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "SAMEORIGIN"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cache-Control", "no-store"},
                              {"Content-Security-Policy",
                               "object-src 'none'; base-uri 'self'; form-action 'self'; "
                               "frame-ancestors 'self'"}});
}

}  // namespace

Server::Server(spooler::Spooler& spooler, SettingsStore& settings, const Options& options)
    : core_{.spooler = spooler,
            .settings = settings,
            .printer = options.printer,
            .access = Access(options.rules.key),
            .guard = web::Guard(options.rules, policy()),
            .hub = Hub(options.hub)},
      address_(options.address),
      sockets_(core_, methods_, options.sockets),
      listener_(options.wait, workers) {
  web::check_reach(address_, options.rules);
  if (!std::ranges::contains(spooler.printer_names(), options.printer)) {
    throw spooler::NoSuchPrinter(options.printer);
  }
  set_headers(listener_);
  listener_.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        if (is_socket(request)) {
          return httplib::Server::HandlerResponse::Handled;  // by its taker
        }
        const auto refusal = core_.guard.refusal_of(web::head_of(request), request.remote_addr);
        if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
        if (refusal->status == 429) response.set_header("Retry-After", "1");
        answer_error(response, {refusal->status, refusal->why});
        return httplib::Server::HandlerResponse::Handled;
      });
  // Of a method that is for those without the key: a wrong password, or a wrong token.
  listener_.set_post_routing_handler(
      [this](const httplib::Request& request, const httplib::Response& response) {
        if (response.status == 401 && methods_.is_open(request.path)) {
          core_.guard.note_wrong_key(request.remote_addr);
        }
      });
  listener_.on_upgrade = [this](const httplib::Request& request) { return taker_for(request); };
  add_routes(listener_, core_, methods_);
  add_file_routes(listener_, core_);
  add_frontend(listener_, options.frontend);
  address_ = listener_.bind(address_);
  broadcaster_ = std::make_unique<Broadcaster>(core_);
  thread_ = std::thread([this] { listener_.listen_after_bind(); });
  listener_.wait_until_ready();
}

Server::~Server() {
  listener_.end();
  listener_.stop();
  thread_.join();
}

bool Server::has_key(const web::RequestHead& request) {
  return core_.access.is_good(request.key) || core_.access.take_oneshot(request.token);
}

web::Policy Server::policy() {
  return {.is_emergency_stop =
              [](const web::RequestHead& request) {
                return request.method == "POST" && request.path == stop_path;
              },
          .needs_key =
              [this](const web::RequestHead& request) {
                return is_api_path(request.path) && request.path != socket_path &&
                       !methods_.is_open(request.path);
              },
          .has_key = [this](const web::RequestHead& request) { return has_key(request); },
          .status_without_key = 401};
}

// Of any request for a WebSocket, so that the guard is asked once.
web::Listener::Taker Server::taker_for(const httplib::Request& request) {
  if (!is_socket(request)) return {};
  web::RequestHead head = web::head_of(request);
  head.method = "POST";  // it can do everything: no page of another site may open one
  if (const auto refusal = core_.guard.refusal_of(head, request.remote_addr)) {
    return [status = refusal->status](int socket) { Sockets::refuse(socket, status); };
  }
  const Handshake handshake{.is_http_1_1 = request.version == "HTTP/1.1",
                            .target = std::string(socket_path),
                            .host = request.get_header_value("Host"),
                            .connection = request.get_header_value("Connection"),
                            .key = request.get_header_value("Sec-WebSocket-Key"),
                            .version = request.get_header_value("Sec-WebSocket-Version"),
                            .client = request.remote_addr};
  const bool is_authorised = has_key(head);
  const bool gives_any = !head.key.empty() || !head.token.empty();
  if (!is_authorised && gives_any) core_.guard.note_wrong_key(request.remote_addr);
  return [this, handshake, is_authorised](int socket) {
    sockets_.take(socket, handshake, is_authorised);
  };
}

}  // namespace moonraker
