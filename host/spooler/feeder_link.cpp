// SPDX-License-Identifier: Apache-2.0
// Starting, attaching, and the lines of JSON.
#include "host/spooler/feeder_link.hpp"

#include <poll.h>
#include <signal.h>

#include <exception>
#include <utility>

#include "host/feeder/feeder_names.hpp"
#include "host/queue/now.hpp"
#include "host/queue/store.hpp"

namespace spooler {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds attach_interval{200};
constexpr std::chrono::seconds longest_silence{4};  // it speaks every second
constexpr std::chrono::seconds stop_limit{5};
constexpr int poll_ms = 20;
constexpr std::size_t most_console_lines = 200;

std::vector<std::string> feeder_call(const Settings& settings, const PrinterSpec& printer,
                                     const std::filesystem::path& folder) {
  const std::filesystem::path port = printer.port.empty() ? folder / "port" : printer.port;
  return {settings.feeder_program.string(),
          "--folder",
          folder.string(),
          "--port",
          port.string(),
          "--baud",
          std::to_string(settings.baud),
          "--pause-limit",
          std::to_string(std::chrono::seconds(settings.pause_limit).count())};
}

std::vector<std::string> chip_call(const Settings& settings, const std::filesystem::path& folder) {
  return {settings.tool_program.string(),
          "serve",
          "--pty",
          (folder / "port").string(),
          "--speed",
          settings.simulation_speed,
          "--report",
          (folder / "report").string()};
}

}  // namespace

FeederLink::FeederLink(const Settings& settings, const PrinterSpec& printer)
    : printer_(printer),
      folder_(settings.data / "printers" / printer.name),
      feeder_(folder_ / "feeder.process", folder_ / "feeder.log",
              feeder_call(settings, printer, folder_)) {
  // With a lost folder its journal would be lost, and a job could be started again.
  queue::make_folder(folder_);
  if (is_simulated()) {
    chip_.emplace(folder_ / "chip.process", folder_ / "chip.log", chip_call(settings, folder_));
  }
}

bool FeederLink::update() {
  changed_ = false;
  if (chip_) chip_->keep_running();
  if (!connection_) attach();
  if (connection_) exchange();
  // Last: a feeder is heard also while the disk is full.
  feeder_.write_note();
  if (chip_) chip_->write_note();
  return changed_;
}

void FeederLink::exchange() {
  std::exception_ptr fault;
  for (const std::string& line : connection_->exchange()) {
    try {
      hear(line);
    } catch (...) {  // of an answer's receiver: the other lines are heard all the same
      fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
  if (!connection_->is_open()) {
    detach();
  } else if (state_ && !is_heard()) {
    state_.reset();
    changed_ = true;
  }
}

bool FeederLink::is_heard() const {
  return connection_ && Clock::now() - heard_at_ <= longest_silence;
}

void FeederLink::attach() {
  const auto now = Clock::now();
  if (now - tried_at_ < attach_interval) return;
  tried_at_ = now;
  feeder::Connection connection = feeder::connect_to(folder_, feeder::socket_name);
  if (connection.is_open()) {
    connection_.emplace(std::move(connection));
  } else {
    feeder_.keep_running();
  }
}

void FeederLink::detach() {
  connection_.reset();
  state_.reset();
  changed_ = true;
  std::exception_ptr fault;
  for (const Answer& answer : std::exchange(answers_, {})) {
    try {
      if (answer) answer(connection_lost);
    } catch (...) {
      fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
}

void FeederLink::hear(const std::string& line) {
  try {
    const auto message = nlohmann::json::parse(line);
    const std::string event = message.at("event");
    if (event == "state") {
      FeederState state = feeder_state_of(message);
      changed_ |= state_ != state;
      temperatures_.take(state, queue::now_ms());
      last_state_ = state;
      state_ = std::move(state);
      heard_at_ = Clock::now();
    } else if (event == "said") {
      console_.push_back(
          {.number = ++said_, .text = message.at("line"), .time_ms = queue::now_ms()});
      if (console_.size() > most_console_lines) console_.pop_front();
      changed_ = true;
    } else if (event == "answer" && !answers_.empty()) {
      const Answer answer = std::move(answers_.front());
      answers_.pop_front();
      state_.reset();  // as it was before: the next one comes at once
      if (answer) answer(message.at("refused"));
    }
  } catch (const nlohmann::json::exception&) {  // of another version: as if it had said nothing
  }
}

void FeederLink::ask(const nlohmann::json& wish, Answer answer) {
  if (!connection_) {
    if (answer) answer(connection_lost);
    return;
  }
  answers_.push_back(std::move(answer));
  connection_->send(wish.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string FeederLink::stop() const {
  const auto end = Clock::now() + stop_limit;
  feeder::Connection connection = feeder::connect_to(folder_, feeder::socket_name);
  connection.send(R"({"do":"stop"})");
  while (connection.is_open() && Clock::now() < end) {
    pollfd wait{connection.descriptor(), POLLIN, 0};
    poll(&wait, 1, poll_ms);
    for (const std::string& line : connection.exchange()) {
      const auto message = nlohmann::json::parse(line, nullptr, false);
      if (message.is_object() && message.value("event", "") == "answer") {
        return message.value("refused", "");
      }
    }
  }
  return connection.is_open() ? "the printer's feeder does not answer" : connection_lost;
}

void FeederLink::end_if_idle() {
  const bool prints = last_state_.job && !is_over(last_state_);
  if (prints || !connection_) return;
  connection_->send(R"({"do":"end"})");
  if (chip_) chip_->signal(SIGINT);
}

void FeederLink::restart_chip() {
  if (chip_) chip_->signal(SIGKILL);
}

}  // namespace spooler
