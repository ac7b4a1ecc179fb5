// SPDX-License-Identifier: Apache-2.0
// A webhook's receiver, well-behaved or not.
#pragma once

#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace notify_test {

inline constexpr std::chrono::seconds patience{60};  // on a machine under load

// Dies and returns at one port.
class Receiver {
 public:
  explicit Receiver(int port = 0) : port_(port) { begin(); }
  ~Receiver() {
    release();
    end();
  }
  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;

  void begin() {
    server_ = std::make_unique<httplib::Server>();
    server_->set_keep_alive_max_count(1);
    server_->Post(".*", [this](const httplib::Request& request, httplib::Response& response) {
      std::unique_lock lock(mutex_);
      ++requests_;
      changed_.notify_all();
      changed_.wait(lock, [this] { return !held_; });
      response.status = status_;
      targets_.push_back(request.target);
      bodies_.push_back(nlohmann::json::parse(request.body, nullptr, false));
      types_.push_back(request.get_header_value("Content-Type"));
      changed_.notify_all();
    });
    if (port_ == 0) {
      port_ = server_->bind_to_any_port("127.0.0.1");
    } else if (!server_->bind_to_port("127.0.0.1", port_)) {
      throw std::runtime_error("the port is in use");
    }
    thread_ = std::thread([this] { server_->listen_after_bind(); });
    server_->wait_until_ready();
  }
  void end() {
    if (!thread_.joinable()) return;
    server_->stop();
    thread_.join();
  }

  // Requests are not answered until release().
  void hold() {
    const std::scoped_lock lock(mutex_);
    held_ = true;
  }
  void release() {
    const std::scoped_lock lock(mutex_);
    held_ = false;
    changed_.notify_all();
  }
  void answer_with(int status) {
    const std::scoped_lock lock(mutex_);
    status_ = status;
  }

  bool soon(const std::function<bool()>& fits) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, fits);
  }
  // Waits until so many requests have begun, or were answered.
  bool has_begun(std::size_t count) {
    return soon([&] { return requests_ >= count; });
  }
  bool has_answered(std::size_t count) {
    return soon([&] { return bodies_.size() >= count; });
  }
  std::string url(const std::string& target = "/hook") const {
    return "http://127.0.0.1:" + std::to_string(port_) + target;
  }
  // Of those that were answered, one value of each.
  std::vector<std::string> values(const char* name) {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> all;
    for (const auto& each : bodies_) all.push_back(each.at(name));
    return all;
  }
  std::vector<nlohmann::json> bodies() {
    const std::scoped_lock lock(mutex_);
    return bodies_;
  }
  std::vector<std::string> targets() {
    const std::scoped_lock lock(mutex_);
    return targets_;
  }
  std::vector<std::string> types() {
    const std::scoped_lock lock(mutex_);
    return types_;
  }
  int port() const { return port_; }

 private:
  int port_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool held_ = false;
  int status_ = 200;
  std::size_t requests_ = 0;
  std::vector<nlohmann::json> bodies_;
  std::vector<std::string> targets_, types_;
  std::unique_ptr<httplib::Server> server_;
  std::thread thread_;
};

}  // namespace notify_test
