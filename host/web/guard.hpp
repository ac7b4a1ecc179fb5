// SPDX-License-Identifier: Apache-2.0
// Who may do what: checked before anything of a request is done.
#pragma once

#include <filesystem>
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

struct RequestHead {
  std::string method;
  std::string path;
  std::string host;  // header Host
  std::optional<std::string> origin;
  std::optional<std::string> fetch_site;  // header Sec-Fetch-Site
  std::string key;  // header X-Api-Key, or the token of Authorization: Bearer
};

struct Refusal {
  int status{};
  std::string why;
  bool has_wrong_key = false;
};

struct Rules {
  std::string key;  // empty: none is needed
  std::vector<std::string> names;  // of this server, apart from addresses and localhost
  RateLimits rate{};
};

// Of the request as such. A caller with a RateLimit asks it before, unless may_always_come(), and
// notes a wrong key there.
bool may_always_come(const RequestHead& request);  // an emergency stop
// Throws std::runtime_error where other machines reach the address and there is no key.
void check_reach(const Address& address, const Rules& rules);

std::optional<Refusal> refusal_of(const RequestHead& request, const Rules& rules);

}  // namespace web
