// SPDX-License-Identifier: Apache-2.0
// Long jobs end when they are asked to, by Ctrl-C or `kill`, and say so.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

using namespace std::chrono_literals;
// In real time, for jobs that take a second on an idle machine. The benchmarks in full take
// many minutes.
constexpr auto timeout = 300s;

class StartedJob {
 public:
  explicit StartedJob(std::vector<std::string> arguments)
      : output_(scenarios::scratch_folder() / "output") {
    arguments.insert(arguments.begin(), BUILD_DIRECTORY "/bin/stepfabric");
    setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
    // What a job of an earlier run said is not this one's.
    std::filesystem::remove(output_);
    process_.emplace(process::Start{.arguments = arguments, .output = output_});
  }
  StartedJob(const StartedJob&) = delete;
  StartedJob& operator=(const StartedJob&) = delete;

  std::string output() const { return files::text_of(output_); }
  bool says(const std::string& text) const {
    return comes_true([&] { return output().find(text) != std::string::npos; });
  }
  // The exit status after the signal; -1 where it does not end.
  int status_after(int signal) {
    process_->signal(signal);
    if (!comes_true([&] { return process_->ending().has_value(); })) return -1;
    return process_->ending()->exit_status;
  }

 private:
  template <class Condition>
  static bool comes_true(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (std::chrono::steady_clock::now() < end) {
      if (condition()) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

  std::filesystem::path output_;
  std::optional<process::Process> process_;
};

TEST(interrupt, ends_the_stepping_benchmark_in_its_search) {
  StartedJob job({"bench", "stepping", "--report", scenarios::scratch_folder().string()});
  ASSERT_TRUE(job.says("highest rates, 1 axis, A4988")) << job.output();
  EXPECT_EQ(job.status_after(SIGTERM), 130);
  EXPECT_NE(job.output().find("stepfabric: interrupted"), std::string::npos) << job.output();
}

TEST(interrupt, ends_the_processor_benchmark_with_the_program_that_does_it) {
  StartedJob job({"bench", "processor", "--report", scenarios::scratch_folder().string()});
  ASSERT_TRUE(job.says("core")) << job.output();
  EXPECT_EQ(job.status_after(SIGINT), 130);
  EXPECT_NE(job.output().find("stepfabric: interrupted"), std::string::npos) << job.output();
}

// Intervals that are chosen at random are replayed after the print, here for half a minute.
TEST(interrupt, ends_a_replay_after_its_print) {
  const std::filesystem::path file = scenarios::scratch_folder() / "input.gcode";
  scenarios::write_file(file, "G4 S10\n");
  StartedJob job({"print", file.string(), "--report", scenarios::scratch_folder().string(),
                  "--replay", "1000", "--replay-every-clock"});
  ASSERT_TRUE(job.says("report.html")) << job.output();
  EXPECT_EQ(job.status_after(SIGINT), 130);
  EXPECT_NE(job.output().find("chosen intervals were not compared"), std::string::npos)
      << job.output();
}

}  // namespace
