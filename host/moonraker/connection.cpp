// SPDX-License-Identifier: Apache-2.0
// Subscriptions of a connection.
#include "host/moonraker/connection.hpp"

#include "host/moonraker/rpc.hpp"

namespace moonraker {

void Connection::subscribe(Json wanted, Json sent) {
  const std::scoped_lock lock(mutex_);
  asked_ = {.wanted = std::move(wanted), .sent = std::move(sent)};
  is_asked_ = true;
}

void Connection::begin_updates() {
  const std::scoped_lock lock(mutex_);
  if (std::exchange(is_asked_, false)) active_ = std::move(asked_);
}

void Connection::update(const Json& objects, double event_time) {
  const std::scoped_lock lock(mutex_);
  if (is_asked_ || !is_authorised()) {
    return;  // the answer must come first
  }
  const Json changes = active_.changes_to(objects);
  if (changes.empty()) return;
  send(std::make_shared<const std::string>(
      notification("notify_status_update", Json::array({changes, event_time}))));
}

}  // namespace moonraker
