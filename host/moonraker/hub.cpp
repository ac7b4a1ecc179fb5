// SPDX-License-Identifier: Apache-2.0
// Sends without its lock, so that a connection may leave meanwhile.
#include "host/moonraker/hub.hpp"

#include <algorithm>

namespace moonraker {

std::int64_t Hub::next_number() {
  const std::scoped_lock lock(mutex_);
  return ++last_number_;
}

bool Hub::enter(const std::shared_ptr<Connection>& connection) {
  const std::scoped_lock lock(mutex_);
  const auto strangers = static_cast<std::size_t>(std::ranges::count_if(
      connections_, [](const auto& each) { return !each.second->is_authorised(); }));
  if (connections_.size() >= limits_.connections) return false;
  if (!connection->is_authorised() && strangers >= limits_.strangers) return false;
  connections_[connection->id()] = connection;
  return true;
}

void Hub::leave(std::int64_t number) {
  const std::scoped_lock lock(mutex_);
  connections_.erase(number);
}

void Hub::clear() {
  std::map<std::int64_t, std::shared_ptr<Connection>> gone;  // destroyed without the lock
  const std::scoped_lock lock(mutex_);
  gone.swap(connections_);
}

std::shared_ptr<Connection> Hub::find(std::int64_t number) const {
  const std::scoped_lock lock(mutex_);
  const auto found = connections_.find(number);
  return found == connections_.end() ? nullptr : found->second;
}

std::size_t Hub::size() const {
  const std::scoped_lock lock(mutex_);
  return connections_.size();
}

std::vector<std::shared_ptr<Connection>> Hub::all() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::shared_ptr<Connection>> list;
  for (const auto& [number, connection] : connections_) list.push_back(connection);
  return list;
}

void Hub::broadcast(const std::string& text) {
  const auto shared = std::make_shared<const std::string>(text);
  for (const auto& connection : all()) {
    if (connection->is_authorised()) connection->send(shared);
  }
}

void Hub::update(const Json& objects, double event_time) {
  for (const auto& connection : all()) connection->update(objects, event_time);
}

}  // namespace moonraker
