// SPDX-License-Identifier: Apache-2.0
// Reads the program before it opens the port, and reports progress.
#include "tools/command/load_job.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "tools/command/exit_status.hpp"
#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"
#include "tools/loading/loading.hpp"
#include "tools/loading/serial_port.hpp"

namespace command {

int load(const LoadOptions& options) {
  end_at_interrupts();
  let_writes_fail();  // a load that is broken off leaves a chip without a program
  const loading::Program program = loading::read_program(options.program);
  loading::SerialPort port(options.port, options.baud);
  constexpr std::size_t reported_bytes = 8192;
  loading::Progress progress{
      .say = [](const std::string& what) { say_to(stderr, "stepfabric: {}\n", what); },
      .sent =
          [&](std::size_t bytes) {
            if (bytes % reported_bytes == 0) {
              say_to(stderr, "stepfabric: {} of {} bytes\n", bytes, program.bytes.size());
            }
          }};
  try {
    const auto figures = loading::load(port, program, progress);
    say("loaded {} bytes, {} frames repeated; the program starts at {:#010x}\n",
        program.bytes.size(), figures.repeated_frames, program.entry);
    return success;
  } catch (const loading::LoadFailed& error) {
    say_to(stderr, "stepfabric: {}\n", error.what());
    return failure;
  }
}

}  // namespace command
