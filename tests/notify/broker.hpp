// SPDX-License-Identifier: Apache-2.0
// Debian's MQTT broker on a port of the loopback, and its subscribers.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/notify/strange_server.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace notify_test {

class Broker {
 public:
  // `more`: lines of its configuration.
  explicit Broker(const std::string& more = "allow_anonymous true\n")
      : more_(more), port_(StrangeServer("").port()) {
    begin();
  }

  void begin() {
    folder_.write("broker.conf", "listener " + std::to_string(port_) +
                                     " 127.0.0.1\nuser root\npersistence_location " +
                                     folder_.path().string() + "/\n" + more_);
    process_.emplace(process::Start{.arguments = {"mosquitto", "-c", path("broker.conf")},
                                    .output = path("broker.log"),
                                    .has_input = false});
    for (int i = 0; i < 6000 && !answers(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  void end() {
    process_->signal(SIGTERM);
    process_->wait();
  }

  // What a subscriber with these arguments prints.
  std::string subscriber(std::vector<std::string> more) const {
    std::vector<std::string> call{"mosquitto_sub", "-h", "127.0.0.1", "-p", std::to_string(port_)};
    call.insert(call.end(), more.begin(), more.end());
    return process::capture({.arguments = call, .has_input = false}).output;
  }
  // The retained message of a topic; empty where there is none.
  std::string retained(const std::string& topic) const {
    const std::string text =
        subscriber({"-t", topic, "--retained-only", "-C", "1", "-W", "1", "-F", "%p"});
    return text.starts_with("Timed out") ? "" : text.substr(0, text.find('\n'));
  }
  // Waits until the retained message has these words.
  bool retains(const std::string& topic, const std::string& words) const {
    for (int i = 0; i < 60; ++i) {
      if (retained(topic).find(words) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  // From then on the broker keeps messages of this topic for remembered().
  void remember(const std::string& topic) const {
    subscriber({"-i", "memory", "-c", "-q", "1", "-t", topic, "-E"});
  }
  // So many of them: topic and message.
  std::string remembered(const std::string& topic, int count) const {
    return subscriber({"-i", "memory", "-c", "-q", "1", "-t", topic, "-R", "-C",
                       std::to_string(count), "-W", "60", "-F", "%t %p"});
  }
  int port() const { return port_; }
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  std::string path(const std::string& name) const { return folder_.path() / name; }

 private:
  bool answers() const {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool good = connect(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    close(probe);
    return good;
  }

  std::string more_;
  int port_;
  TemporaryFolder folder_;
  std::optional<process::Process> process_;
};

}  // namespace notify_test
