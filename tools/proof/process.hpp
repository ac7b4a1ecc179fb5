// SPDX-License-Identifier: Apache-2.0
// Calls of the tools that prove and simulate, with what they say in LOG and LOG.err.
#pragma once

#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace proof {

using files::text_of;
using ProcessResult = process::Ending;

// As process::run(), within wall clock time, and each process within processor time (0: any), which
// does not depend on what else the machine does.
inline ProcessResult run_process(const std::vector<std::string>& arguments,
                                 const std::filesystem::path& folder,
                                 const std::filesystem::path& log, std::chrono::seconds limit,
                                 std::chrono::seconds cpu_limit = std::chrono::seconds{0}) {
  return process::run({.arguments = arguments,
                       .folder = folder,
                       .output = log,
                       .errors = log.string() + ".err",
                       .cpu_limit = cpu_limit},
                      limit);
}

}  // namespace proof
