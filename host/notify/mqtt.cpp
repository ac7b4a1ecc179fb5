// SPDX-License-Identifier: Apache-2.0
// One thread has the connection: libmosquitto is called from nowhere else.
#include "host/notify/mqtt.hpp"

#include <mosquitto.h>

#include <stdexcept>
#include <utility>

namespace notify {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int loop_ms = 50;
constexpr std::chrono::seconds longest_goodbye{2};
constexpr int at_most_once = 0, at_least_once = 1;

Mqtt& self(void* object) { return *static_cast<Mqtt*>(object); }

}  // namespace

void Mqtt::Ending::operator()(mosquitto* client) const {
  mosquitto_destroy(client);
  mosquitto_lib_cleanup();
}

Mqtt::Mqtt(MqttOptions options, Log log)
    : options_(std::move(options)), log_(std::move(log)), backlog_(options_.backlog) {
  mosquitto_lib_init();
  client_.reset(mosquitto_new(nullptr, true, this));
  if (!client_) throw std::runtime_error("no memory for MQTT");
  set_up();
  thread_ = std::thread([this] { run(); });
}

Mqtt::~Mqtt() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Mqtt::set_up() {
  const auto check = [](int error) {
    if (error != MOSQ_ERR_SUCCESS) throw std::runtime_error(mosquitto_strerror(error));
  };
  if (!options_.user.empty()) {
    check(
        mosquitto_username_pw_set(client_.get(), options_.user.c_str(), options_.password.c_str()));
  }
  const std::string will = "offline";
  check(mosquitto_will_set(client_.get(), (options_.topic + "/status").c_str(),
                           static_cast<int>(will.size()), will.data(), at_least_once, true));
  mosquitto_connect_callback_set(
      client_.get(), [](mosquitto*, void* object, int code) { self(object).answered(code); });
  mosquitto_publish_callback_set(client_.get(), [](mosquitto*, void* object, int number) {
    self(object).acknowledged(number);
  });
}

void Mqtt::take(const Event& event) {
  const std::scoped_lock lock(mutex_);
  backlog_.add(event);
}

void Mqtt::show(const Json& snapshot) {
  std::map<std::string, std::string> states;
  for (const Json& printer : snapshot.at("printers")) {
    states[options_.topic + "/" + printer.at("name").get<std::string>() + "/state"] =
        text_of(printer_state(snapshot, printer));
  }
  const std::scoped_lock lock(mutex_);
  states_ = std::move(states);
}

bool Mqtt::ends() {
  const std::scoped_lock lock(mutex_);
  return ends_;
}

void Mqtt::run() {
  while (!ends()) {
    if (connect()) work();
    if (is_connected_) say_goodbye();
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, options_.pauses.after(failures_), [this] { return ends_; });
  }
}

bool Mqtt::connect() {
  is_refused_ = false;
  const int error = mosquitto_connect_async(client_.get(), options_.host.c_str(), options_.port,
                                            static_cast<int>(options_.keep_alive.count()));
  if (error != MOSQ_ERR_SUCCESS) lost(error);
  return error == MOSQ_ERR_SUCCESS;
}

// Until the connection or the sink ends.
void Mqtt::work() {
  while (!ends()) {
    const int error = mosquitto_loop(client_.get(), loop_ms, 1);
    if (error != MOSQ_ERR_SUCCESS) return lost(error);
    if (is_connected_) publish_what_is_due();
  }
}

void Mqtt::lost(int error) {
  is_connected_ = false;
  ++failures_;
  if (std::exchange(is_logged_, true) || is_refused_) return;
  const std::string why = error == MOSQ_ERR_ERRNO ? "no connection" : mosquitto_strerror(error);
  log_("MQTT " + options_.host + ": " + why + "; it is tried again");
}

void Mqtt::answered(int code) {
  if (code != 0) {
    is_refused_ = true;
    if (!std::exchange(is_logged_, true)) {
      log_("MQTT " + options_.host + ": " + mosquitto_connack_string(code) + "; it is tried again");
    }
    return;
  }
  if (std::exchange(is_logged_, false)) log_("MQTT " + options_.host + ": connected");
  is_connected_ = true;
  failures_ = 0;
  // The broker may be another one, or may have forgotten everything.
  sent_states_.clear();
  publish(options_.topic + "/status", "online", at_least_once, true);
}

void Mqtt::publish_what_is_due() {
  // As long as the broker does not read, nothing is added to what waits in libmosquitto.
  if (mosquitto_want_write(client_.get())) return;
  publish_states();
  publish_event();
}

void Mqtt::publish_states() {
  std::map<std::string, std::string> states;
  {
    const std::scoped_lock lock(mutex_);
    states = states_;
  }
  for (const auto& [topic, text] : states) {
    std::string& sent = sent_states_[topic];
    if (sent != text && publish(topic, text, at_most_once, true)) sent = text;
  }
}

// One at a time: libmosquitto sends it again on the next connection until it is acknowledged.
void Mqtt::publish_event() {
  if (unacknowledged_) return;
  std::optional<Event> event;
  std::size_t dropped = 0;
  {
    const std::scoped_lock lock(mutex_);
    event = backlog_.next();
    dropped = backlog_.take_dropped();
  }
  if (dropped > 0) {
    log_("MQTT " + options_.host + ": " + std::to_string(dropped) +
         " old notifications were dropped");
  }
  if (!event) return;
  const std::string level = event->printer.empty() ? "" : "/" + event->printer;
  Sent sent{.id = event->id};
  if (publish(options_.topic + level + "/event", text_of(to_json(*event)), at_least_once, false,
              &sent.number)) {
    unacknowledged_ = sent;
  }
}

bool Mqtt::publish(const std::string& topic, const std::string& text, int quality, bool retained,
                   int* number) {
  return mosquitto_publish(client_.get(), number, topic.c_str(), static_cast<int>(text.size()),
                           text.data(), quality, retained) == MOSQ_ERR_SUCCESS;
}

void Mqtt::acknowledged(int number) {
  if (goodbye_ == number) goodbye_.reset();
  if (!unacknowledged_ || unacknowledged_->number != number) return;
  const std::scoped_lock lock(mutex_);
  backlog_.remove(unacknowledged_->id);
  unacknowledged_.reset();
}

// After an orderly end the broker drops the last will.
void Mqtt::say_goodbye() {
  const auto end = Clock::now() + longest_goodbye;
  const auto go_on = [&] {
    return Clock::now() < end && mosquitto_loop(client_.get(), loop_ms, 1) == MOSQ_ERR_SUCCESS;
  };
  const auto has_waiting = [this] {
    const std::scoped_lock lock(mutex_);
    return backlog_.size() > 0;
  };
  do {
    publish_what_is_due();
  } while (has_waiting() && go_on());
  int number = 0;
  publish(options_.topic + "/status", "offline", at_least_once, true, &number);
  goodbye_ = number;
  while (goodbye_ && go_on()) {
  }
  mosquitto_disconnect(client_.get());
  while (go_on()) {
  }
}

}  // namespace notify
