// SPDX-License-Identifier: Apache-2.0
// Who is given up when too many are waited for.
#include "host/web/connections.hpp"

#include <sys/socket.h>

#include <algorithm>

namespace web {

void Connections::enter(Awaited& connection) {
  const std::scoped_lock lock(mutex_);
  awaited_.insert(&connection);
  if (ends_) return give_up(connection);
  if (awaited_.size() <= limits_.most_waiting) return;
  Awaited* first = nullptr;
  for (Awaited* each : awaited_) {
    const bool is_earlier = first == nullptr || each->due < first->due;
    if (each != &connection && !each->given_up && is_earlier) first = each;
  }
  if (first != nullptr) give_up(*first);
}

void Connections::leave(Awaited& connection) {
  const std::scoped_lock lock(mutex_);
  awaited_.erase(&connection);
}

void Connections::end() {
  const std::scoped_lock lock(mutex_);
  ends_ = true;
  std::ranges::for_each(awaited_, [](Awaited* each) { give_up(*each); });
}

// Its thread wakes up and finds the end of what it reads.
void Connections::give_up(Awaited& connection) {
  connection.given_up = true;
  shutdown(connection.socket, SHUT_RD);
}

}  // namespace web
