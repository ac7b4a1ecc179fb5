// SPDX-License-Identifier: Apache-2.0
// httplib's server with a limit of time for each request.
#pragma once

#include "host/web/connections.hpp"
#include "host/web/http.hpp"

namespace web {

class Listener final : public httplib::Server {
 public:
  explicit Listener(WaitLimits limits) : connections_(limits) {}
  // httplib lets the system queue 5 connections only: in a burst the others wait for seconds. To be
  // called once it is bound.
  void queue_connections();
  // Those that are waited for are given up. To be called before stop().
  void end() { connections_.end(); }

 private:
  // One request for each connection: what a refused one leaves unread is never taken for another.
  bool process_and_close_socket(socket_t socket) override;

  Connections connections_;
};

}  // namespace web
