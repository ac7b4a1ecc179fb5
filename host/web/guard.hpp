// SPDX-License-Identifier: Apache-2.0
// Who may do what: checked before anything of a request is done.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/web/address.hpp"
#include "host/web/rate.hpp"

namespace web {

// The same time for every wrong key of a length.
bool equal_in_constant_time(std::string_view a, std::string_view b);

// The first line of a file that no other user can read: 16 to 256 printable characters, no blanks.
// Throws std::runtime_error where it is no such key.
std::string read_key(const std::filesystem::path& file);

struct Refusal {
  int status{};
  std::string why;
};

struct RequestHead {
  std::string method;
  std::string path;
  std::string host;  // header Host
  std::optional<std::string> origin;
  std::optional<std::string> fetch_site;  // header Sec-Fetch-Site
  std::string key;  // header X-Api-Key, or the token of Authorization: Bearer
  std::string token;  // parameter `token` of the address
  std::optional<Refusal> fault;  // of the head itself
};

struct Rules {
  std::string key;  // empty: none is needed
  std::vector<std::string> names;  // of this server, apart from addresses and localhost
  RateLimits rate{};
  RateLimits stop_rate{.burst = 20, .per_second = 5};  // of emergency stops, which have their own
};

// What a server asks of a request apart from the rules; each of them is for any thread.
struct Policy {
  std::function<bool(const RequestHead&)> is_emergency_stop;
  std::function<bool(const RequestHead&)> needs_key;
  std::function<bool(const RequestHead&)> has_key;
  int status_without_key = 403;
};

// Throws std::runtime_error where other machines reach the address and there is no key.
void check_reach(const Address& address, const Rules& rules);

// For any thread.
class Guard {
 public:
  // Of the web server: an emergency stop is the route of one printer, and all but the page needs
  // the key, in its header.
  explicit Guard(const Rules& rules);
  Guard(const Rules& rules, Policy policy);

  // 429 beyond the rate, for which each request counts, also a refused one; then the fault of the
  // head; 403 for another name or another site; the policy's status for a missing or wrong key.
  // `address`: the client's.
  std::optional<Refusal> refusal_of(const RequestHead& request, std::string_view address);

  // For what comes over a connection that stays: whether one more is within the rate.
  bool may_ask(std::string_view address) { return rate_.take(address); }
  bool may_stop(std::string_view address) { return stop_rate_.take(address); }
  // Where a key is given in another way than by a head.
  void note_wrong_key(std::string_view address) { rate_.note_wrong_key(address); }

 private:
  const Rules rules_;
  const Policy policy_;
  RateLimit rate_, stop_rate_;
};

}  // namespace web
