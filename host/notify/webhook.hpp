// SPDX-License-Identifier: Apache-2.0
// Notifications as POST requests to one address.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "host/notify/backlog.hpp"
#include "host/notify/sink.hpp"

namespace notify {

struct WebhookAddress {
  std::string server;  // http://HOST:PORT or https://HOST:PORT
  std::string target;  // path and query
  bool operator==(const WebhookAddress&) const = default;
};

// An http or https URL, or @FILE with one in its first line, for one that is a secret: other users
// must not be able to read that file. Throws std::runtime_error.
WebhookAddress webhook_of(std::string_view text);

struct WebhookLimits {
  std::chrono::milliseconds connect{5000};
  std::chrono::milliseconds request{15'000};  // for the whole of it, however slowly bytes come
  Pauses pauses{};
  BacklogLimits backlog{};
};

// One request at a time, in order, each until the receiver answers with 2xx. It is sent again after
// a failure of the connection or an answer of 408, 425, 429 or 5xx, so a receiver may get it twice
// with the same `id`; any other answer drops it. What waits is lost with the process. Redirects are
// not followed, and certificates are checked. SIGPIPE must be ignored.
class Webhook final : public Sink {
 public:
  Webhook(WebhookAddress address, Log log, WebhookLimits limits = {});
  ~Webhook() override;

  void take(const Event& event) override;
  void show(const Json&) override {}

 private:
  enum class Outcome : std::uint8_t { delivered, refused, failed };
  struct Answer {
    Outcome outcome{};
    std::string why;
  };
  void run();
  Answer post(const std::string& body);
  void note(const Answer& answer);
  std::string name() const;  // for the log

  const WebhookAddress address_;
  const Log log_;
  const WebhookLimits limits_;
  std::mutex mutex_;
  std::condition_variable wake_;
  Backlog backlog_;
  int failures_ = 0;  // in a row
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

}  // namespace notify
