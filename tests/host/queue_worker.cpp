// SPDX-License-Identifier: Apache-2.0
// Works with a queue and a feeder's journal without end, and says on standard output what was
// acknowledged: to be killed. Usage: queue_worker FOLDER SEED.
// With FOLDER alone it makes the folder and ends, with status 1 where it cannot.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <system_error>

#include "host/feeder/journal.hpp"
#include "host/queue/queue.hpp"
#include "host/queue/store.hpp"
#include "tests/host/known_text.hpp"

namespace {

using queue::JobState;

// In one write, so that the reader gets whole lines.
void say(const std::string& line) {
  const std::string text = line + "\n";
  if (write(STDOUT_FILENO, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    std::_Exit(3);
  }
}

// As the spooler decides: a job that the journal has not was not begun.
void recover(queue::Queue& jobs, feeder::Journal& journal) {
  const auto active = jobs.active_on("printer");
  const bool is_begun = active && journal.record() && journal.record()->job == active->id;
  if (active && !is_begun && active->state == JobState::starting) {
    jobs.take_back(active->id, "not begun");
  } else if (active) {
    jobs.change(active->id, JobState::interrupted, "killed");
  }
  if (journal.record() || !journal.damage().empty()) journal.clear();
}

int make(const char* folder) {
  try {
    queue::make_folder(folder);
    return 0;
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2) return make(arguments[1]);
  if (count != 3) return 2;
  const std::string folder = arguments[1];
  std::mt19937 random(static_cast<unsigned>(std::atoi(arguments[2])));
  queue::Store store(folder + "/files");
  queue::Queue jobs(folder + "/queue.db");
  feeder::Journal journal(folder + "/journal");
  store.remove_all_but(jobs.files_in_use());
  recover(jobs, journal);
  while (true) {
    queue::Store::Upload upload(store);
    const std::string text = host_test::known_text(static_cast<unsigned>(random()));
    upload.write(std::string_view(text).substr(0, text.size() / 2));
    upload.write(std::string_view(text).substr(text.size() / 2));
    const std::int64_t bytes = upload.bytes();
    const std::string file = upload.keep();
    const auto id = jobs.add({.name = "job", .file = file, .bytes = bytes});
    say("added " + std::to_string(id) + " " + std::to_string(bytes));
    jobs.change(id, JobState::checking, "");
    jobs.change(id, JobState::queued, "");
    if (random() % 3 == 0) jobs.move(id, jobs.jobs().front().id);
    if (random() % 2 == 0) continue;
    jobs.set_bed_clear("printer", true);
    const auto next = jobs.next_for("printer");
    if (!next) continue;
    jobs.start(next->id, "printer");
    journal.write({.job = next->id, .file = file, .phase = feeder::Phase::opening, .why = {}});
    say("sent " + std::to_string(next->id));  // the first byte
    jobs.change(next->id, JobState::printing, "");
    journal.note({.job = next->id, .file = file, .phase = feeder::Phase::finished, .why = {}});
    jobs.change(next->id, JobState::finished, "");
    journal.clear();
  }
}
