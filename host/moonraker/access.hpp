// SPDX-License-Identifier: Apache-2.0
// Tokens that stand for the key where a browser cannot send it.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace moonraker {

// For any thread.
class Access {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds oneshot_life{5};
  static constexpr std::chrono::hours login_life{24};
  static constexpr std::size_t most_tokens = 256;  // of each kind; the oldest goes

  // `key`: empty where none is needed.
  explicit Access(std::string key, std::function<Clock::time_point()> now = Clock::now);

  bool needs_key() const { return !key_.empty(); }
  // The key itself, or the token of a login.
  bool is_good(std::string_view key_or_token) const;

  // For one request, within 5 s.
  std::string new_oneshot();
  bool take_oneshot(const std::string& token);

  // Throws Error 401 where the password is not the key.
  std::string log_in(std::string_view password);
  // The token of a login is good no more.
  void log_out(const std::string& token);

 private:
  using Tokens = std::map<std::string, Clock::time_point, std::less<>>;  // with their ends
  std::string add(Tokens& tokens, Clock::duration life);

  const std::string key_;
  std::function<Clock::time_point()> now_;
  mutable std::mutex mutex_;
  Tokens oneshots_, logins_;
};

}  // namespace moonraker
