// SPDX-License-Identifier: Apache-2.0
// Who is given up when too many are waited for.
#include "host/web/connections.hpp"

#include <sys/socket.h>

#include <map>
#include <string_view>
#include <utility>

namespace web {

void Connections::enter(Awaited& connection) {
  const std::scoped_lock lock(mutex_);
  awaited_.insert(&connection);
  if (ends_) return give_up(connection);
  if (awaited_.size() <= limits_.most_waiting) return;
  std::map<std::string_view, std::size_t> of_client;
  for (const Awaited* each : awaited_) ++of_client[each->client];
  const auto goes_before = [&](const Awaited& one, const Awaited& other) {
    const std::size_t ones = of_client[one.client], others = of_client[other.client];
    return ones != others ? ones > others : one.due < other.due;
  };
  Awaited* first = nullptr;
  for (Awaited* each : awaited_) {
    if (each == &connection) continue;
    if (first == nullptr || goes_before(*each, *first)) first = each;
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
  for (Awaited* each : std::exchange(awaited_, {})) give_up(*each);
}

// Its thread wakes up and finds the end of what it reads. Until then it counts no more.
void Connections::give_up(Awaited& connection) {
  awaited_.erase(&connection);
  connection.given_up = true;
  shutdown(connection.socket, SHUT_RD);
}

}  // namespace web
