// SPDX-License-Identifier: Apache-2.0
// Moonraker's API for one printer: HTTP, WebSocket, and the files of a front end.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "host/moonraker/core.hpp"
#include "host/moonraker/sockets.hpp"
#include "host/web/connections.hpp"
#include "host/web/guard.hpp"
#include "host/web/listener.hpp"

namespace moonraker {

inline constexpr std::uint16_t usual_port = 7125;

struct Options {
  std::string printer{};
  web::Address address{};
  web::Rules rules{};
  std::filesystem::path frontend{};  // folder with Mainsail or Fluidd; empty: none
  web::WaitLimits wait{};
  SocketLimits sockets{};
  HubLimits hub{};
};

class Broadcaster;

class Server {
 public:
  // Listens when it returns. Throws std::runtime_error where the address is in use, other machines
  // reach it and there is no key, or the folder has no index.html.
  Server(spooler::Spooler& spooler, SettingsStore& settings, const Options& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // With the port that was chosen.
  const web::Address& address() const { return address_; }
  const std::string& printer() const { return core_.printer; }

 private:
  web::Policy policy();
  bool has_key(const web::RequestHead& request);
  web::Listener::Taker taker_for(const httplib::Request& request);

  Core core_;
  const Methods methods_;
  web::Address address_;
  Sockets sockets_;
  web::Listener listener_;
  std::unique_ptr<Broadcaster> broadcaster_;
  std::thread thread_;
};

}  // namespace moonraker
