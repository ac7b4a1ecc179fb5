// SPDX-License-Identifier: Apache-2.0
// Works with a queue without end, and says on standard output what was acknowledged: to be killed.
// Usage: queue_worker FOLDER SEED
#include <unistd.h>

#include <cstdlib>
#include <random>
#include <string>

#include "host/queue/queue.hpp"
#include "host/queue/store.hpp"

namespace {

// In one write, so that the reader gets whole lines.
void say(const std::string& line) {
  const std::string text = line + "\n";
  if (write(STDOUT_FILENO, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    std::_Exit(3);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::string folder = arguments[1];
  std::mt19937 random(static_cast<unsigned>(std::atoi(arguments[2])));
  queue::Store store(folder + "/files");
  queue::Queue jobs(folder + "/queue.db");
  store.remove_all_but(jobs.files_in_use());
  // A start that the killed one has committed and of which the outcome is not known.
  if (const auto active = jobs.active_on("printer")) {
    jobs.change(active->id, queue::JobState::interrupted, "killed");
  }
  while (true) {
    queue::Store::Upload upload(store);
    const std::string part(1 + random() % 20'000, 'G');
    for (unsigned i = 0; i < 1 + random() % 4; ++i) upload.write(part);
    const std::int64_t bytes = upload.bytes();
    const std::string file = upload.keep();
    const auto id = jobs.add({.name = "job", .file = file, .bytes = bytes});
    say("added " + std::to_string(id) + " " + std::to_string(bytes));
    jobs.change(id, queue::JobState::checking, "");
    jobs.change(id, queue::JobState::queued, "");
    if (random() % 3 == 0) jobs.move(id, jobs.jobs().front().id);
    if (random() % 2 == 0) continue;
    jobs.set_bed_clear("printer", true);
    const auto next = jobs.next_for("printer");
    if (!next) continue;
    jobs.start(next->id, "printer");
    say("sent " + std::to_string(next->id));  // the first byte
    jobs.change(next->id, queue::JobState::printing, "");
    jobs.change(next->id, queue::JobState::finished, "");
  }
}
