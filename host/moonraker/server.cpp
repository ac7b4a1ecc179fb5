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

web::Rules without_key(web::Rules rules) {
  rules.key.clear();
  return rules;
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
            .hub = Hub(options.hub)},
      address_(options.address),
      rules_(without_key(options.rules)),
      rate_(options.rules.rate),
      sockets_(core_, methods_, options.sockets),
      listener_(options.wait, workers) {
  web::check_reach(address_, options.rules);
  if (!std::ranges::contains(spooler.printer_names(), options.printer)) {
    throw spooler::NoSuchPrinter(options.printer);
  }
  set_headers(listener_);
  listener_.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        const auto refusal = refusal_for(request);
        if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
        if (refusal->status == 429) response.set_header("Retry-After", "1");
        answer_error(response, {refusal->status, refusal->why});
        return httplib::Server::HandlerResponse::Handled;
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

bool Server::has_key(const httplib::Request& request) {
  return core_.access.is_good(web::head_of(request).key) ||
         core_.access.take_oneshot(request.get_param_value("token"));
}

std::optional<web::Refusal> Server::refusal_for(const httplib::Request& request) {
  const bool is_stop = request.method == "POST" && request.path == stop_path;
  if (!is_stop && !rate_.take(request.remote_addr)) {
    return web::Refusal{.status = 429, .why = "too many requests: wait a second"};
  }
  auto refusal = refusal_of(request);
  if (refusal && refusal->has_wrong_key) rate_.note_wrong_key(request.remote_addr);
  return refusal;
}

std::optional<web::Refusal> Server::refusal_of(const httplib::Request& request) {
  if (auto fault = web::fault_of(request)) return fault;
  web::RequestHead head = web::head_of(request);
  // A WebSocket can do everything: no page of another site may open one.
  if (head.path == socket_path) head.method = "POST";
  if (auto refusal = web::refusal_of(head, rules_)) return refusal;
  if (!is_api_path(head.path) || head.path == socket_path) return std::nullopt;
  const auto& all = methods_.all();
  const bool is_open = std::ranges::any_of(all, [&](const Method& method) {
    return method.needs_no_key && !method.path.empty() && method.path == head.path;
  });
  if (is_open || has_key(request)) return std::nullopt;
  return web::Refusal{.status = 401,
                      .why = "Unauthorized: the key is missing or wrong (header X-Api-Key)",
                      .has_wrong_key = !head.key.empty()};
}

web::Listener::Taker Server::taker_for(const httplib::Request& request) {
  if (request.path != socket_path || refusal_for(request)) return {};
  const Handshake handshake{.is_http_1_1 = request.version == "HTTP/1.1",
                            .target = std::string(socket_path),
                            .host = request.get_header_value("Host"),
                            .connection = request.get_header_value("Connection"),
                            .key = request.get_header_value("Sec-WebSocket-Key"),
                            .version = request.get_header_value("Sec-WebSocket-Version")};
  return [this, handshake, authorised = has_key(request)](int socket) {
    sockets_.take(socket, handshake, authorised);
  };
}

}  // namespace moonraker
