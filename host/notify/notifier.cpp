// SPDX-License-Identifier: Apache-2.0
// Looks at the spooler's snapshot four times a second, as each open page does.
#include "host/notify/notifier.hpp"

#include <fmt/format.h>

#include <chrono>
#include <random>

namespace notify {

namespace {

using namespace std::chrono_literals;
constexpr auto interval = 250ms;

std::string random_name() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

template <class Clock>
std::chrono::milliseconds now_of() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now().time_since_epoch());
}

}  // namespace

Notifier::Notifier(spooler::Spooler& spooler, std::vector<std::unique_ptr<Sink>> sinks,
                   EventFinder finder)
    : spooler_(spooler), sinks_(std::move(sinks)), finder_(std::move(finder)), run_(random_name()) {
  look();
  thread_ = std::thread([this] { run(); });
}

Notifier::~Notifier() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
  look();  // what happened since the last look
}

void Notifier::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval, [this] { return ends_; })) {
    lock.unlock();
    look();
    lock.lock();
  }
}

void Notifier::look() {
  try {
    const auto snapshot = spooler_.snapshot();
    for (Event& event : finder_.look(snapshot->json, now_of<std::chrono::steady_clock>())) {
      event.time_ms = now_of<std::chrono::system_clock>().count();
      event.id = run_ + "-" + std::to_string(++number_);
      for (const auto& sink : sinks_) sink->take(event);
    }
    if (snapshot->version == version_) return;
    for (const auto& sink : sinks_) sink->show(snapshot->json);
    version_ = snapshot->version;
  } catch (const std::exception&) {  // the queue cannot be read now: the next look reports it
  }
}

}  // namespace notify
