// SPDX-License-Identifier: Apache-2.0
// httplib's server with a limit of time for each request.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/web/address.hpp"
#include "host/web/connections.hpp"
#include "host/web/http.hpp"

namespace web {

// A route that is served, as httplib has it.
struct Route {
  std::string method;
  std::string pattern;  // regular expression of the whole path
};

// A handshake to go on in another protocol.
bool wants_websocket(const httplib::Request& request);

class Listener final : public httplib::Server {
 public:
  // Of `workers` there should be more than are waited for.
  explicit Listener(WaitLimits limits, std::size_t workers = 64);
  // Returns the address with the port that was chosen. Throws std::runtime_error.
  Address bind(Address address);
  // In the place of bind(). The socket is neither closed nor shut down: its owner listens on.
  void adopt(int socket);
  void stop();

  // As httplib's, and noted in routes().
  void Get(const std::string& pattern, Handler handler);
  void Post(const std::string& pattern, HandlerWithContentReader handler);
  void Put(const std::string& pattern, HandlerWithContentReader handler);
  void Patch(const std::string& pattern, HandlerWithContentReader handler);
  void Delete(const std::string& pattern, HandlerWithContentReader handler);
  const std::vector<Route>& routes() const { return routes_; }

  // Those that are waited for are given up. To be called before stop().
  void end() { connections_.end(); }

  // Has the connection from then on.
  using Taker = std::function<void(int socket)>;
  // Asked for each request to go on in another protocol (`Upgrade: websocket`), from any thread.
  // Without a taker the request is answered as any other.
  std::function<Taker(const httplib::Request&)> on_upgrade;

 private:
  // One request for each connection: what a refused one leaves unread is never taken for another.
  bool process_and_close_socket(socket_t socket) override;

  Connections connections_;
  std::vector<Route> routes_;
  bool is_adopted_ = false;
};

}  // namespace web
