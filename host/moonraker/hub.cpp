// SPDX-License-Identifier: Apache-2.0
// Sends without its lock, so that a connection may leave meanwhile.
#include "host/moonraker/hub.hpp"

#include <algorithm>

#include "host/web/rate.hpp"

namespace moonraker {

std::int64_t Hub::next_number() {
  const std::scoped_lock lock(mutex_);
  return ++last_number_;
}

bool Hub::enter(const std::shared_ptr<Connection>& connection) {
  std::shared_ptr<Connection> pushed_out;
  {
    const std::scoped_lock lock(mutex_);
    if (!connection->is_authorised()) pushed_out = one_too_many(*connection);
    if (pushed_out) connections_.erase(pushed_out->id());
    if (connections_.size() >= limits_.connections) return false;
    connections_[connection->id()] = connection;
  }
  if (pushed_out) pushed_out->push_out();
  return true;
}

// Who goes where this one comes; nothing where there is room.
std::shared_ptr<Connection> Hub::one_too_many(const Connection& stranger) const {
  std::map<std::string, std::size_t> of_client{{web::client_of(stranger.client()), 1}};
  std::vector<std::shared_ptr<Connection>> strangers;  // the oldest first
  for (const auto& [number, each] : connections_) {
    if (each->is_authorised()) continue;
    strangers.push_back(each);
    ++of_client[web::client_of(each->client())];
  }
  if (strangers.empty() || strangers.size() < limits_.strangers) return nullptr;
  return *std::ranges::max_element(strangers, {}, [&](const auto& each) {
    return of_client.at(web::client_of(each->client()));
  });
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
