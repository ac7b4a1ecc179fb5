// SPDX-License-Identifier: Apache-2.0
// A client of Moonraker's WebSocket, on Boost.Beast.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace moonraker_test {

using Json = nlohmann::json;

class SocketClient {
 public:
  // Whether it was accepted: status() is 101 then, and else the answer's. `headers` may replace
  // those of the handshake.
  explicit SocketClient(int port, const std::map<std::string, std::string>& headers = {},
                        const std::string& target = "/websocket");
  ~SocketClient();
  SocketClient(SocketClient&&) noexcept;

  int status() const;
  void send(const std::string& text, bool is_text = true);
  // The next message; nothing where none comes in this time, or the connection has ended.
  std::optional<Json> receive(std::chrono::milliseconds time = std::chrono::seconds(30));
  // The answer with its id, also an error's. Notifications before it are kept for notified().
  Json call(const std::string& method, const Json& params = Json::object());
  // The next notification of this name.
  std::optional<Json> notified(const std::string& method,
                               std::chrono::milliseconds time = std::chrono::seconds(30));
  // Waits for its end; the close code, 0 where there was none, nothing where it goes on.
  std::optional<int> end(std::chrono::milliseconds time = std::chrono::seconds(30));
  void close();

 private:
  struct Machinery;
  std::unique_ptr<Machinery> machinery_;
};

}  // namespace moonraker_test
