// SPDX-License-Identifier: Apache-2.0
// A spooler that gets jobs without end and whose bed is always clear: to be killed. It says on
// standard output which jobs it has acknowledged. Usage: spooler_worker FOLDER PORT FIRST [JOBS]
// FIRST: number of the first job's text; JOBS: so many, then it works until all are over.
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>

#include "directories.hpp"
#include "host/spooler/spooler.hpp"

namespace {

using namespace std::chrono_literals;

// In one write, so that the reader gets whole lines.
void say(const std::string& line) {
  const std::string text = line + "\n";
  if (write(STDOUT_FILENO, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    std::_Exit(3);
  }
}

// Five lines that no other job has.
std::string text_of(int number) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text += "M117 job " + std::to_string(number) + " line " + std::to_string(i) + "\n";
  }
  return text;
}

// A person would look first.
void clear_bed(spooler::Spooler& spool) {
  try {
    spool.set_bed_clear("printer", true);
  } catch (const spooler::Refused&) {  // it prints
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  spooler::Spooler spool({.data = arguments[1],
                          .printers = {{.name = "printer", .port = arguments[2]}},
                          .feeder_program = BUILD_DIRECTORY "/bin/stepfabric_feeder",
                          .tool_program = BUILD_DIRECTORY "/bin/stepfabric"});
  std::atomic<bool> ends = false;
  std::thread loop([&] { spool.run([&ends] { return ends.load(); }); });
  const int first = std::atoi(arguments[3]);
  const int jobs = count > 4 ? std::atoi(arguments[4]) : std::numeric_limits<int>::max();
  say("begins");
  for (int i = 0; i < jobs; ++i) {
    queue::Store::Upload upload(spool.store());
    upload.write(text_of(first + i));
    const auto id = spool.add(upload, std::to_string(first + i) + ".gcode", false, "");
    say("added " + std::to_string(id) + " " + std::to_string(first + i));
    for (int j = 0; j < 10; ++j) {
      clear_bed(spool);
      std::this_thread::sleep_for(20ms);
    }
  }
  for (bool waits = true; waits;) {
    clear_bed(spool);
    std::this_thread::sleep_for(50ms);
    waits = false;
    for (const queue::Job& job : spool.jobs()) {
      waits |= !is_final(job.state) && job.state != queue::JobState::interrupted;
    }
  }
  ends = true;
  loop.join();
}
