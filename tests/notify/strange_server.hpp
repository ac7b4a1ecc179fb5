// SPDX-License-Identifier: Apache-2.0
// A server that says the same again and again, or nothing.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace notify_test {

// Accepts, reads, and sends this to each again and again.
class StrangeServer {
 public:
  explicit StrangeServer(std::string words) : words_(std::move(words)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
    listen(listener_, 8);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~StrangeServer() {
    ends_ = true;
    shutdown(listener_, SHUT_RDWR);
    thread_.join();
    close(listener_);
  }
  StrangeServer(const StrangeServer&) = delete;
  StrangeServer& operator=(const StrangeServer&) = delete;
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/"; }
  bool has_had(int connections) const {
    for (int i = 0; i < 6000 && connections_ < connections; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return connections_ >= connections;
  }

  int port() const { return port_; }

 private:
  // False once the client has closed.
  static bool reads(int connection) {
    char byte = 0;
    return recv(connection, &byte, 1, MSG_DONTWAIT) != 0;
  }
  void run() {
    while (!ends_) {
      const int connection = accept(listener_, nullptr, nullptr);
      if (connection < 0) continue;
      ++connections_;
      while (!ends_ &&
             (words_.empty() ? reads(connection)
                             : send(connection, words_.data(), words_.size(), MSG_NOSIGNAL) > 0)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      close(connection);
    }
  }
  std::string words_;
  int listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), port_ = 0;
  std::atomic<bool> ends_ = false;
  std::atomic<int> connections_ = 0;
  std::thread thread_;
};

}  // namespace notify_test
