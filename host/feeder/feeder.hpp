// SPDX-License-Identifier: Apache-2.0
// One printer's feeder: its port, its journal, and a socket for the spooler.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/feeder/conversation.hpp"
#include "host/feeder/feeder_names.hpp"
#include "host/feeder/journal.hpp"
#include "host/feeder/local_socket.hpp"
#include "host/feeder/port.hpp"

namespace feeder {

struct Options {
  std::filesystem::path folder;  // of journal, lock and socket
  std::filesystem::path port;
  std::uint32_t baud = 250'000;
  Time pause_limit{};  // after which a paused job's hotend is switched off; 0: never
};

class Feeder {
 public:
  // Throws std::runtime_error where another feeder has the folder, or it cannot be used.
  explicit Feeder(const Options& options);
  ~Feeder();
  Feeder(const Feeder&) = delete;
  Feeder& operator=(const Feeder&) = delete;

  // Until `ended` says so, or a spooler asks for it. With no spooler and nothing to print it ends
  // by itself after a minute.
  void run(const std::function<bool()>& ended);

 private:
  void wait();
  void serve_port();
  void serve_connections();
  std::string obey(const std::string& line);
  void send_all(const std::string& line);
  std::string state() const;
  bool is_of_no_use() const;

  int lock_;
  Journal journal_;
  Conversation conversation_;
  Port port_;
  Listener listener_;
  std::vector<Connection> connections_;
  LineReader replies_;
  std::string to_port_;
  std::string sent_state_;  // the state, the last time
  Time sent_at_{}, tried_at_{-1'000'000}, used_at_{};
  bool end_wanted_ = false;
};

}  // namespace feeder
