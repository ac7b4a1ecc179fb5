// SPDX-License-Identifier: Apache-2.0
// The spooler's end of a feeder: keeps its process running, attaches to it, asks and listens.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/feeder/local_socket.hpp"
#include "host/spooler/feeder_state.hpp"
#include "host/spooler/kept_process.hpp"
#include "host/spooler/settings.hpp"
#include "host/spooler/temperature_log.hpp"

namespace spooler {

struct ConsoleLine {
  std::int64_t number{};  // counted from 1
  std::string text;
  std::int64_t time_ms{};  // since 1970, when it was heard
};

// For one thread at a time, but for stop().
class FeederLink {
 public:
  static constexpr const char* connection_lost = "the printer's feeder has ended";
  using Answer = std::function<void(const std::string& refusal)>;  // empty: granted

  FeederLink(const Settings& settings, const PrinterSpec& printer);

  const std::string& name() const { return printer_.name; }
  bool is_simulated() const { return printer_.port.empty(); }

  // To be called often. True where something has changed for people.
  bool update();
  // The feeder's last word; nothing while it is not connected, is silent for some seconds, or was
  // asked for something that changes it.
  const std::optional<FeederState>& state() const { return state_; }
  // The last state of all, however old, and whether it is that of now.
  const FeederState& last_state() const { return last_state_; }
  bool is_heard() const;

  // `answer` is called from update(), with a reason too where the connection ends.
  void ask(const nlohmann::json& wish, Answer answer);
  bool is_asked() const { return !answers_.empty(); }

  const std::deque<ConsoleLine>& console() const { return console_; }
  const TemperatureLog& temperatures() const { return temperatures_; }

  // M112, on a connection of its own, so that nothing that the spooler waits for holds it up. For
  // any thread. Returns why it could not be given, or nothing.
  std::string stop() const;

  // Ends feeder and simulated printer, if nothing is being printed.
  void end_if_idle();
  // A simulated printer's chip is started again, as by its switch.
  void restart_chip();

 private:
  void attach();
  void exchange();
  void detach();
  void hear(const std::string& line);

  PrinterSpec printer_;
  std::filesystem::path folder_;
  KeptProcess feeder_;
  std::optional<KeptProcess> chip_;  // of a simulated printer
  std::optional<feeder::Connection> connection_;
  std::deque<Answer> answers_;
  std::optional<FeederState> state_;
  FeederState last_state_;
  std::chrono::steady_clock::time_point heard_at_{}, tried_at_{};
  std::deque<ConsoleLine> console_;
  TemperatureLog temperatures_;
  std::int64_t said_ = 0;
  bool changed_ = false;
};

}  // namespace spooler
