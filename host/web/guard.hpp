// SPDX-License-Identifier: Apache-2.0
// Who may do what: checked before anything of a request is done.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
  std::optional<Refusal> fault;  // of the head itself
};

struct Rules {
  std::string key;  // empty: none is needed
  std::vector<std::string> names;  // of this server, apart from addresses and localhost
  RateLimits rate{};
  RateLimits stop_rate{.burst = 20, .per_second = 5};  // of emergency stops, which have their own
};

// For any thread.
class Guard {
 public:
  explicit Guard(Rules rules)
      : rules_(std::move(rules)), rate_(rules_.rate), stop_rate_(rules_.stop_rate) {}

  bool has_key() const { return !rules_.key.empty(); }
  // 429 beyond the rate, for which each request counts, also a refused one; then the fault of the
  // head; 403 for another name, another site, a missing or wrong key. `address`: the client's.
  std::optional<Refusal> refusal_of(const RequestHead& request, std::string_view address);

 private:
  const Rules rules_;
  RateLimit rate_, stop_rate_;
};

}  // namespace web
