// SPDX-License-Identifier: Apache-2.0
// A client that stays: what the methods see of its WebSocket.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "host/moonraker/subscription.hpp"

namespace moonraker {

// All calls are for any thread.
class Connection {
 public:
  using Text = std::shared_ptr<const std::string>;

  // `client`: its address.
  Connection(std::int64_t number, std::string client, bool authorised)
      : id_(number), client_(std::move(client)), authorised_(authorised) {}
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // Never waits: a client that does not take what is sent is dropped.
  virtual void send(Text text) = 0;
  // Its place is needed: it is closed.
  virtual void push_out() = 0;

  std::int64_t id() const { return id_; }
  const std::string& client() const { return client_; }
  // Has given the key.
  bool is_authorised() const { return authorised_; }
  void authorise() { authorised_ = true; }

  // `sent`: what the answer has. Differences come once the answer is on its way: begin_updates().
  void subscribe(Json wanted, Json sent);
  void begin_updates();
  // Sends what has changed of the objects that it wants.
  void update(const Json& objects, double event_time);

 private:
  const std::int64_t id_;
  const std::string client_;
  std::atomic<bool> authorised_;
  std::mutex mutex_;
  Subscription asked_, active_;
  bool is_asked_ = false;
};

}  // namespace moonraker
