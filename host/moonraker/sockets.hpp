// SPDX-License-Identifier: Apache-2.0
// The WebSockets of one printer's Moonraker, on Boost.Beast.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "host/moonraker/core.hpp"
#include "host/moonraker/rpc.hpp"

namespace moonraker {

struct SocketLimits {
  std::size_t message = 256 * 1024;  // bytes that a client may send at once
  std::size_t stranger_message = 8 * 1024;  // the same without the key
  std::size_t output = 2 * 1024 * 1024;  // bytes that may wait for a client
  int in_flight = 32;  // requests of a client that are not answered yet
  std::size_t bytes_in_flight = 1024 * 1024;  // of these
  int stops_in_flight = 4;  // emergency stops besides
  std::chrono::milliseconds stranger_life{60'000};  // until the key must have come
  std::chrono::milliseconds idle{60'000};  // without a sign of life; pings ask for one
};

// What the head of a request says for the handshake.
struct Handshake {
  bool is_http_1_1 = false;
  std::string target, host, connection, key, version;
  std::string client;  // its address
};

class Sockets {
 public:
  Sockets(Core& core, const Methods& methods, const SocketLimits& limits);
  // Closes them all.
  ~Sockets();
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;

  // A connection whose head has been read: it is answered, and then the client's. For any thread.
  void take(int socket, const Handshake& handshake, bool authorised);
  // It is answered with this status of HTTP, and closed. For any thread.
  static void refuse(int socket, int status);

 private:
  struct Machinery;
  std::unique_ptr<Machinery> machinery_;
};

}  // namespace moonraker
