// SPDX-License-Identifier: Apache-2.0
// Random tokens with a time of life.
#include "host/moonraker/access.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "host/moonraker/rpc.hpp"
#include "host/web/guard.hpp"

namespace moonraker {

namespace {

std::string random_token() {
  std::array<unsigned char, 20> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error(errno, std::generic_category(), "no random bytes");
  }
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
  std::string token;
  for (const unsigned char byte : bytes) token += digits[byte & 31u];
  return token;
}

}  // namespace

Access::Access(std::string key, std::function<Clock::time_point()> now)
    : key_(std::move(key)), now_(std::move(now)) {}

bool Access::is_good(std::string_view key_or_token) const {
  if (key_.empty() || web::equal_in_constant_time(key_or_token, key_)) return true;
  const std::scoped_lock lock(mutex_);
  const auto now = now_();
  return std::ranges::any_of(logins_, [&](const auto& each) {
    return web::equal_in_constant_time(each.first, key_or_token) && now < each.second;
  });
}

std::string Access::add(Tokens& tokens, Clock::duration life) {
  const std::scoped_lock lock(mutex_);
  const auto now = now_();
  std::erase_if(tokens, [&](const auto& each) { return each.second <= now; });
  if (tokens.size() >= most_tokens) {
    tokens.erase(
        std::ranges::min_element(tokens, {}, [](const auto& each) { return each.second; }));
  }
  std::string token = random_token();
  tokens[token] = now + life;
  return token;
}

std::string Access::new_oneshot() { return add(oneshots_, oneshot_life); }

bool Access::take_oneshot(const std::string& token) {
  const std::scoped_lock lock(mutex_);
  const auto found = oneshots_.find(token);
  if (found == oneshots_.end()) return false;
  const bool is_in_time = now_() < found->second;
  oneshots_.erase(found);
  return is_in_time;
}

std::string Access::log_in(std::string_view password) {
  if (!key_.empty() && !web::equal_in_constant_time(password, key_)) {
    throw Error(401, "the password is the key that the spooler was given by --key");
  }
  return add(logins_, login_life);
}

void Access::log_out(const std::string& token) {
  const std::scoped_lock lock(mutex_);
  logins_.erase(token);
}

}  // namespace moonraker
