// SPDX-License-Identifier: Apache-2.0
// A feeder's conversation with a LinkPrinter in simulated time, over a cable that may be bad.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/feeder/conversation.hpp"
#include "tests/host/link_printer.hpp"
#include "tests/temporary_folder.hpp"

namespace host_test {

class ConversationTest : public testing::Test {
 protected:
  ConversationTest() { begin_feeder(); }

  // As after a kill: only the journal is left.
  void begin_feeder() {
    conversation_.reset();
    journal_.emplace(folder_.path() / "journal.json");
    conversation_ = std::make_unique<feeder::Conversation>(
        *journal_, [this] { return bases_ += 100'000; }, pause_limit);
    conversation_->on_said = [this](std::string_view line) { said += std::string(line) + "\n"; };
    conversation_->opened(now_);
  }
  void write_job(int lines) {
    std::string text;
    for (int i = 1; i <= lines; ++i) {
      wanted.push_back("G1 X" + std::to_string(i));
      text += wanted.back() + "\n";
    }
    write_file("job", text);
  }
  void write_file(const std::string& name, const std::string& text) { folder_.write(name, text); }
  std::string start(int lines = 50) {
    write_job(lines);
    run(feeder::Time(1000));
    return feed().start(7, (folder_.path() / "job").string(), lines);
  }
  void run(feeder::Time time) {
    for (const feeder::Time end = now_ + time; now_ < end; now_ += feeder::Time(10)) {
      feed().update(now_);
      printer.receive(disturbed(feed().take_output()), now_);
      std::string replies = disturbed(printer.work(now_));
      for (const char c : replies) {
        if (c == '\n') {
          feed().heard(std::exchange(line_, {}), now_);
        } else {
          line_ += c;
        }
      }
    }
  }
  // Until the job is over, or an hour has gone.
  void run_to_end() {
    for (int i = 0; i < 36'000 && !is_over(phase()); ++i) run(feeder::Time(100));
  }
  void run_until_executed(std::size_t lines) {
    for (int i = 0; i < 36'000 && printer.executed.size() < lines; ++i) run(feeder::Time(10));
  }
  // As with a full disk: no new journal can be written.
  void set_disk_full(bool full) {
    const auto spare = folder_.path() / "journal.json.new";
    std::filesystem::remove_all(spare);
    if (full) std::filesystem::create_directory(spare);
  }
  std::filesystem::path folder() const { return folder_.path(); }
  std::ptrdiff_t executed_moves() const {
    return std::ranges::count_if(printer.executed,
                                 [](const std::string& line) { return line.starts_with("G1"); });
  }
  std::ptrdiff_t executed(const std::string& text) const {
    return std::ranges::count(printer.executed, text);
  }
  feeder::Conversation& feed() { return *conversation_; }
  feeder::Time now() const { return now_; }
  feeder::Phase phase() const { return conversation_->record()->phase; }
  std::string why() const { return conversation_->record()->why; }

  feeder::Time pause_limit{};  // of the next feeder that begins
  host_test::LinkPrinter printer;
  std::vector<std::string> wanted;
  std::string said;
  double faults = 0;  // of a byte

 private:
  std::string disturbed(std::string bytes) {
    std::bernoulli_distribution hit(faults);
    std::string out;
    for (char& c : bytes) {
      if (!hit(random_)) {
        out += c;
      } else if (random_() % 4 != 0) {  // otherwise it is lost
        out += static_cast<char>(c ^ (1 << random_() % 7));
      }
    }
    return out;
  }

  TemporaryFolder folder_;
  std::optional<feeder::Journal> journal_;
  std::unique_ptr<feeder::Conversation> conversation_;
  std::int64_t bases_ = feeder::Conversation::lowest_base;
  feeder::Time now_{0};
  std::string line_;
  std::mt19937 random_{7};
};

}  // namespace host_test
