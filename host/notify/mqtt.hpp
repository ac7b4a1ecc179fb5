// SPDX-License-Identifier: Apache-2.0
// Notifications and the state of each printer for an MQTT broker.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/notify/backlog.hpp"
#include "host/notify/sink.hpp"

struct mosquitto;

namespace notify {

inline constexpr std::uint16_t usual_mqtt_port = 1883;

struct MqttOptions {
  std::string host{};
  std::uint16_t port = usual_mqtt_port;
  std::string user{}, password{};  // empty: none
  std::string topic = "stepfabric";  // that all topics begin with
  std::chrono::seconds keep_alive{10};
  Pauses pauses{.longest = std::chrono::seconds{30}};
  BacklogLimits backlog{};
};

// `login`: file with user and password in two lines, readable for its owner only; empty: none.
// Throws std::runtime_error where address, topic or file cannot be used.
MqttOptions mqtt_options(const std::string& address, const std::filesystem::path& login,
                         const std::string& topic);

// The state of a printer out of the snapshot, as its topic has it.
Json printer_state(const Json& snapshot, const Json& printer);

// MQTT 3.1.1 by libmosquitto, without TLS:
//   TOPIC/status         online, or offline: after an end and, by the last will, a crash; retained
//   TOPIC/PRINTER/state  JSON, retained
//   TOPIC/PRINTER/event  events, at least once, not retained; TOPIC/event: without a printer
class Mqtt final : public Sink {
 public:
  Mqtt(MqttOptions options, Log log);
  ~Mqtt() override;

  void take(const Event& event) override;
  void show(const Json& snapshot) override;

 private:
  struct Ending {
    void operator()(mosquitto* client) const;
  };
  void set_up();
  void run();
  bool ends();
  bool connect();
  void work();
  void lost(int error);
  void say_goodbye();
  void publish_what_is_due();
  void publish_states();
  void publish_event();
  bool publish(const std::string& topic, const std::string& text, int quality, bool retained,
               int* number = nullptr);
  void answered(int code);
  void acknowledged(int number);

  const MqttOptions options_;
  const Log log_;
  std::unique_ptr<mosquitto, Ending> client_;

  // Of the thread alone.
  bool is_connected_ = false;
  bool is_refused_ = false;  // by the broker, which says why
  bool is_logged_ = false;  // that there is no connection
  int failures_ = 0;  // to connect, in a row
  std::map<std::string, std::string> sent_states_;  // on this connection, by topic
  struct Sent {
    int number{};  // of libmosquitto
    std::string id;
  };
  std::optional<Sent> unacknowledged_;
  std::optional<int> goodbye_;

  std::mutex mutex_;
  std::condition_variable wake_;
  Backlog backlog_;
  std::map<std::string, std::string> states_;  // by topic
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace notify
