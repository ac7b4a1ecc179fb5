// SPDX-License-Identifier: Apache-2.0
// Requests by cpp-httplib's client, each with a limit for the whole of it.
#include "host/notify/webhook.hpp"

#include <httplib.h>

#include <algorithm>
#include <array>
#include <regex>
#include <stdexcept>
#include <utility>

#include "host/notify/secret_file.hpp"

namespace notify {

namespace {

using namespace std::chrono_literals;
constexpr std::size_t longest_answer = 64 * 1024;  // more of it is not read
constexpr std::size_t longest_url = 2000;

// httplib limits single reads only: an answer that comes byte by byte would hold the request
// without end. This ends it at its time, and when the sink ends.
class Deadline {
 public:
  Deadline(httplib::Client& client, std::chrono::milliseconds limit, const std::atomic<bool>& ends)
      : thread_([this, &client, limit, &ends] {
          const auto end = std::chrono::steady_clock::now() + limit;
          std::unique_lock lock(mutex_);
          while (!wake_.wait_for(lock, 50ms, [this] { return is_over_; })) {
            if (!ends && std::chrono::steady_clock::now() < end) continue;
            lock.unlock();
            client.stop();
            lock.lock();
          }
        }) {}
  ~Deadline() {
    {
      const std::scoped_lock lock(mutex_);
      is_over_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool is_over_ = false;
  std::thread thread_;
};

bool is_worth_a_repetition(int status) {
  constexpr std::array passing{408, 425, 429};
  return status >= 500 || std::ranges::contains(passing, status);
}

}  // namespace

WebhookAddress webhook_of(std::string_view text) {
  if (text.starts_with('@')) return webhook_of(read_secret(text.substr(1), 1).front());
  // No user and password: they would be seen in the list of processes.
  static const std::regex form(
      R"((https?://(?:\[[0-9A-Fa-f:.]+\]|[A-Za-z0-9._-]+)(?::([0-9]{1,5}))?)([/?][!-~]*)?)");
  std::match_results<std::string_view::const_iterator> parts;
  const bool fits = text.size() <= longest_url &&
                    std::regex_match(text.begin(), text.end(), parts, form) && !text.contains('#');
  const int port = fits && parts[2].matched ? std::stoi(parts[2].str()) : 1;
  if (!fits || port < 1 || port > 65535) {
    throw std::runtime_error(
        "--webhook: not http[s]://HOST[:PORT][/PATH], without user, nor @FILE with such a line");
  }
  std::string target = parts[3].str();
  if (!target.starts_with('/')) target.insert(0, "/");
  return {.server = parts[1].str(), .target = std::move(target)};
}

Webhook::Webhook(WebhookAddress address, Log log, WebhookLimits limits)
    : address_(std::move(address)),
      log_(std::move(log)),
      limits_(limits),
      backlog_(limits.backlog),
      thread_([this] { run(); }) {}

Webhook::~Webhook() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Webhook::take(const Event& event) {
  {
    const std::scoped_lock lock(mutex_);
    backlog_.add(event);
  }
  wake_.notify_all();
}

void Webhook::run() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    const auto event = backlog_.next();
    const std::size_t dropped = backlog_.take_dropped();
    if (!event && dropped == 0) {
      wake_.wait(lock, [this] { return ends_ || backlog_.size() > 0; });
      continue;
    }
    lock.unlock();
    if (dropped > 0) {
      log_(name() + std::to_string(dropped) + " old notifications were dropped");
      lock.lock();
      continue;
    }
    const Answer answer = post(text_of(to_json(*event)));
    lock.lock();
    if (ends_) return;
    if (answer.outcome != Outcome::failed) backlog_.remove(event->id);
    lock.unlock();
    note(answer);
    lock.lock();
    if (failures_ > 0) {
      wake_.wait_for(lock, limits_.pauses.after(failures_), [this] { return ends_.load(); });
    }
  }
}

Webhook::Answer Webhook::post(const std::string& body) {
  httplib::Client client(address_.server);
  if (!client.is_valid()) return {.outcome = Outcome::failed, .why = "the address cannot be used"};
  client.set_connection_timeout(limits_.connect);
  client.set_read_timeout(limits_.request);
  client.set_write_timeout(limits_.request);
  client.set_keep_alive(false);
  client.set_follow_location(false);
  client.set_url_encode(false);
  int status = 0;
  std::size_t read = 0;
  httplib::Request request;
  request.method = "POST";
  request.path = address_.target;
  request.headers = {{"Content-Type", "application/json"}, {"User-Agent", "stepfabric"}};
  request.body = body;
  request.response_handler = [&](const httplib::Response& response) {
    status = response.status;
    return true;
  };
  request.content_receiver = [&](const char*, std::size_t count, std::uint64_t, std::uint64_t) {
    read += count;
    return read <= longest_answer;
  };
  const Deadline deadline(client, limits_.request, ends_);
  const httplib::Result result = client.send(request);
  if (result) {
    status = result->status;  // the handler is not asked about one without content
  }
  if (status == 0) return {.outcome = Outcome::failed, .why = httplib::to_string(result.error())};
  if (status >= 200 && status < 300) return {.outcome = Outcome::delivered, .why = ""};
  return {.outcome = is_worth_a_repetition(status) ? Outcome::failed : Outcome::refused,
          .why = "status " + std::to_string(status)};
}

// The path may be a secret: it is not written.
std::string Webhook::name() const { return "webhook " + address_.server + ": "; }

// The first failure of a row, and its end.
void Webhook::note(const Answer& answer) {
  if (answer.outcome == Outcome::refused) log_(name() + "refused for good: " + answer.why);
  if (answer.outcome == Outcome::failed) {
    if (++failures_ == 1) log_(name() + answer.why + "; it is tried again");
    return;
  }
  if (std::exchange(failures_, 0) > 0) log_(name() + "it answers again");
}

}  // namespace notify
