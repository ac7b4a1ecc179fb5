// SPDX-License-Identifier: Apache-2.0
// The feeder of one printer, as a process of its own.
#include <fmt/format.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "host/feeder/feeder.hpp"

namespace {

volatile std::sig_atomic_t end_requested = 0;
void request_end(int) { end_requested = 1; }

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Feeds one printer over its serial line; the spooler starts it.",
               "stepfabric_feeder");
  feeder::Options options;
  app.add_option("--folder", options.folder, "for journal, lock and socket")->required();
  app.add_option("--port", options.port, "serial port")->required();
  app.add_option("--baud", options.baud, "its speed")->check(CLI::Range(300, 10'000'000));
  std::int64_t pause_limit_s = 0;
  app.add_option("--pause-limit", pause_limit_s,
                 "seconds after which a paused job's hotend is switched off; 0: never")
      ->check(CLI::Range(0, 1'000'000));
  CLI11_PARSE(app, count, arguments);
  options.pause_limit = std::chrono::seconds(pause_limit_s);
  signal(SIGPIPE, SIG_IGN);
  signal(SIGTERM, request_end);
  signal(SIGINT, request_end);
  try {
    feeder::Feeder(options).run([] { return end_requested != 0; });
  } catch (const std::exception& error) {
    fmt::print(stderr, "stepfabric_feeder: {}\n", error.what());
    return 2;
  }
  return 0;
}
