// SPDX-License-Identifier: Apache-2.0
// Names against DNS rebinding, origins against forged requests, the key.
#include "host/web/guard.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace web {

namespace {

constexpr std::size_t shortest_key = 16, longest_key = 256;

bool changes_nothing(std::string_view method) {
  return method == "GET" || method == "HEAD" || method == "OPTIONS";
}

// A page of another site: browsers say so, other programs say nothing.
bool comes_from_another_site(const RequestHead& request) {
  if (request.origin) {  // of this server, or of one with TLS before it
    return *request.origin != "http://" + request.host &&
           *request.origin != "https://" + request.host;
  }
  return request.fetch_site && *request.fetch_site != "same-origin" &&
         *request.fetch_site != "none";
}

// Only the page that asks for the key is shown without it.
bool needs_key(const RequestHead& request) {
  return request.path != "/" && request.path != "/page.css" && request.path != "/page.js";
}

// Of one printer: its route and no other.
bool is_emergency_stop(const RequestHead& request) {
  constexpr std::string_view begin = "/api/v1/printers/", end = "/stop";
  std::string_view name = request.path;
  if (request.method != "POST" || !name.starts_with(begin)) return false;
  name.remove_prefix(begin.size());
  if (!name.ends_with(end)) return false;
  name.remove_suffix(end.size());
  return !name.empty() && !name.contains('/');
}

}  // namespace

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  volatile unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = difference | static_cast<unsigned char>(a[i] ^ b[i]);
  }
  return difference == 0;
}

std::string read_key(const std::filesystem::path& file) {
  struct stat status{};
  std::ifstream stream(file);
  if (!stream || stat(file.c_str(), &status) != 0) {
    throw std::runtime_error("cannot read the key in " + file.string());
  }
  if ((status.st_mode & (S_IRGRP | S_IROTH)) != 0) {
    throw std::runtime_error("other users can read the key: chmod 600 " + file.string());
  }
  std::string key;
  std::getline(stream, key);
  const bool printable = std::ranges::all_of(key, [](char c) { return c > ' ' && c <= '~'; });
  if (key.size() < shortest_key || key.size() > longest_key || !printable) {
    throw std::runtime_error("the first line of " + file.string() +
                             " is no key: 16 to 256 characters without blanks");
  }
  return key;
}

void check_reach(const Address& address, const Rules& rules) {
  if (is_loopback(address.host) || !rules.key.empty()) return;
  throw std::runtime_error("other machines reach " + written(address) +
                           ": a key is needed (--key FILE)");
}

Guard::Guard(const Rules& rules)
    : Guard(rules, {.is_emergency_stop = is_emergency_stop,
                    .needs_key = needs_key,
                    .has_key = [key = rules.key](const RequestHead& request) {
                      return key.empty() || equal_in_constant_time(request.key, key);
                    }}) {}

Guard::Guard(const Rules& rules, Policy policy)
    : rules_(rules), policy_(std::move(policy)), rate_(rules.rate), stop_rate_(rules.stop_rate) {}

std::optional<Refusal> Guard::refusal_of(const RequestHead& request, std::string_view address) {
  RateLimit& rate = policy_.is_emergency_stop(request) ? stop_rate_ : rate_;
  if (!rate.take(address)) return Refusal{.status = 429, .why = "too many requests: wait a second"};
  if (request.fault) return request.fault;
  if (!is_own_name(request.host, rules_.names)) {
    return Refusal{.status = 403,
                   .why = "this server is not named so; --host-name gives it a name"};
  }
  if (!changes_nothing(request.method) && comes_from_another_site(request)) {
    return Refusal{.status = 403, .why = "a page of another site may change nothing"};
  }
  if (policy_.needs_key(request) && !policy_.has_key(request)) {
    if (!request.key.empty() || !request.token.empty()) rate.note_wrong_key(address);
    return Refusal{.status = policy_.status_without_key,
                   .why = "the key is missing or wrong (header X-Api-Key)"};
  }
  return std::nullopt;
}

}  // namespace web
