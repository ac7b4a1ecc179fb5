// SPDX-License-Identifier: Apache-2.0
// All connections of one printer's Moonraker.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "host/moonraker/connection.hpp"

namespace moonraker {

struct HubLimits {
  std::size_t connections = 128;
  // That have not given the key yet. One more pushes out the oldest of the client that has most.
  std::size_t strangers = 16;
};

// For any thread.
class Hub {
 public:
  explicit Hub(HubLimits limits = {}) : limits_(limits) {}

  // The number of the next connection.
  std::int64_t next_number();
  // False where there are too many.
  bool enter(const std::shared_ptr<Connection>& connection);
  void leave(std::int64_t number);
  void clear();
  std::shared_ptr<Connection> find(std::int64_t number) const;
  std::size_t size() const;

  // To all that have given the key.
  void broadcast(const std::string& text);
  void update(const Json& objects, double event_time);

 private:
  std::vector<std::shared_ptr<Connection>> all() const;
  std::shared_ptr<Connection> one_too_many(const Connection& stranger) const;

  const HubLimits limits_;
  mutable std::mutex mutex_;
  std::map<std::int64_t, std::shared_ptr<Connection>> connections_;
  std::int64_t last_number_ = 0;
};

}  // namespace moonraker
