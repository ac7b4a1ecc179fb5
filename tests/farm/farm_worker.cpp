// SPDX-License-Identifier: Apache-2.0
// Does a spooler's work with a farm's queue, for one printer and without end, and says on standard
// output what was acknowledged and begun: to be killed, stopped, and cut off from its server.
// Usage: farm_worker FOLDER ADDRESS NAME SEED LEASE_MS
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <thread>

#include "host/feeder/journal.hpp"
#include "host/queue/queue.hpp"
#include "host/queue/shared_files.hpp"
#include "host/queue/store.hpp"
#include "tests/farm/farm_queue.hpp"
#include "tests/host/known_text.hpp"

namespace {

using namespace std::chrono_literals;
using queue::JobState;

// In one write, so that the reader gets whole lines.
void say(const std::string& line) {
  const std::string text = line + "\n";
  if (write(STDOUT_FILENO, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    std::_Exit(3);
  }
}

class Worker {
 public:
  Worker(const std::string& folder, std::string address, std::string name, unsigned seed,
         std::chrono::milliseconds lease_time)
      : address_(std::move(address)),
        name_(std::move(name)),
        random_(seed),
        lease_time_(lease_time),
        store_(folder + "/files"),
        journal_(folder + "/journal"),
        jobs_(farm_test::open_farm(address_, name_, lease_time)) {}

  // One round; what it throws does not end the work.
  void work() {
    keep_lease();
    // A bad moment for a kill is any; most of the work is here.
    add();
    if (!jobs_.holds(name_)) return;
    recover();
    print();
  }

 private:
  void keep_lease() {
    const auto now = std::chrono::steady_clock::now();
    if (now < renew_at_) return;
    jobs_.renew();
    if (!jobs_.holds(name_) && jobs_.claim(name_).empty()) say("claimed 0");
    renew_at_ = now + lease_time_ / 5;
  }

  void add() {
    queue::Store::Upload upload(store_);
    const std::string text = host_test::known_text(static_cast<unsigned>(random_()));
    upload.write(text);
    const std::int64_t bytes = upload.bytes();
    const std::string file = upload.keep();
    queue::SharedFiles(address_).put(file, store_.path_of(file));
    queue::JobId id = 0;
    try {
      id = jobs_.add({.name = "job", .file = file, .bytes = bytes});
    } catch (const queue::OutcomeUnknown&) {
      id = looked_up(file);
    }
    store_.remove(file);
    if (id == 0) return;
    say("added " + std::to_string(id) + " " + std::to_string(bytes));
    jobs_.change(id, JobState::checking, "");
    jobs_.change(id, JobState::queued, "");
  }

  queue::JobId looked_up(const std::string& file) {
    while (true) {
      try {
        return jobs_.job_of_upload(file).value_or(0);
      } catch (const queue::Unavailable&) {
        std::this_thread::sleep_for(50ms);
      }
    }
  }

  // As the spooler decides: a job that the journal has not was not begun.
  void recover() {
    const auto active = jobs_.active_on(name_);
    const bool is_begun = active && journal_.record() && journal_.record()->job == active->id;
    if (active && !is_begun && active->state == JobState::starting) {
      jobs_.take_back(active->id, "not begun");
    } else if (active) {
      jobs_.change(active->id, JobState::interrupted, "killed");
    }
    if (journal_.record() || !journal_.damage().empty()) journal_.clear();
  }

  void print() {
    jobs_.set_bed_clear(name_, true);
    const auto next = jobs_.next_for(name_);
    if (!next || !jobs_.start_if_next(next->id, name_)) return;
    journal_.write(
        {.job = next->id, .file = next->file, .phase = feeder::Phase::opening, .why = {}});
    // As the feeder does, but after the journal, whose writing takes milliseconds: a stop then is
    // no fault of the queue.
    if (queue::boot_ms() > jobs_.held_until(name_)) {
      journal_.clear();
      return;
    }
    say("sent " + std::to_string(next->id));  // the first byte
    jobs_.change(next->id, JobState::printing, "");
    journal_.note(
        {.job = next->id, .file = next->file, .phase = feeder::Phase::finished, .why = {}});
    jobs_.change(next->id, JobState::finished, "");
    journal_.clear();
  }

  std::string address_, name_;
  std::mt19937 random_;
  std::chrono::milliseconds lease_time_;
  queue::Store store_;
  feeder::Journal journal_;
  queue::Queue jobs_;
  std::chrono::steady_clock::time_point renew_at_{};
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 6) return 2;
  const auto seed = static_cast<unsigned>(std::atoi(arguments[4]));
  const std::chrono::milliseconds lease_time(std::atoi(arguments[5]));
  while (true) {  // the server may be away
    try {
      Worker worker(arguments[1], arguments[2], arguments[3], seed, lease_time);
      while (true) {
        try {
          worker.work();
        } catch (const queue::Unavailable&) {
          std::this_thread::sleep_for(20ms);
        } catch (const queue::NotPermitted&) {  // another one has its printer, or its checks
          say("refused 0");
        }
      }
    } catch (const queue::Unavailable&) {
      std::this_thread::sleep_for(20ms);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
  }
}
