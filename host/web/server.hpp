// SPDX-License-Identifier: Apache-2.0
// The web server of a spooler: page, REST, server-sent events, OctoPrint's routes.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/spooler/spooler.hpp"
#include "host/web/address.hpp"
#include "host/web/connections.hpp"
#include "host/web/guard.hpp"
#include "host/web/inherited_socket.hpp"

namespace web {

class Listener;
struct Route;

class Server {
 public:
  // Listens when it returns, on `socket` where there is one. Throws std::runtime_error where the
  // address is in use, or other machines reach it and the rules have no key.
  Server(spooler::Spooler& spooler, const Address& address, const Rules& rules,
         const WaitLimits& limits = {}, const std::optional<InheritedSocket>& socket = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // With the port that was chosen.
  const Address& address() const { return address_; }
  const std::vector<Route>& routes() const;

 private:
  spooler::Spooler& spooler_;
  Address address_;
  Guard guard_;
  std::unique_ptr<Listener> server_;
  std::atomic<bool> ends_ = false;
  std::atomic<int> streams_ = 0;
  std::thread thread_;
};

}  // namespace web
