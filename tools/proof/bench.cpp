// SPDX-License-Identifier: Apache-2.0
// Calls of the simulator and what they mean.
#include "tools/proof/bench.hpp"

#include <fmt/format.h>

#include <regex>

#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

Outcome run_bench(const Folders& folders, const fs::path& sources, const std::string& bench,
                  const fs::path& folder, std::chrono::seconds limit) {
  const fs::path library = analyse(folders, sources, {}, bench, folder);
  const fs::path log = folder / "run.log";
  const ProcessResult result =
      run_process({"ghdl", "-r", "--std=08", "-fpsl", "--workdir=" + library.string(), bench,
                   "--assert-level=error"},
                  folder, log, limit);
  // What fails while time goes by gives its time: "FILE:LINE:COLUMN:@TIME:(assertion failure): ..."
  static const std::regex failure(R"(:@[0-9]+[a-z]+:.*)");
  const std::string text = text_of(log) + text_of(log.string() + ".err");
  Outcome outcome;
  std::smatch match;
  if (result.timed_out) {
    outcome.verdict = Verdict::undecided;
    outcome.explanation = fmt::format("{} does not end within {} s", bench, limit.count());
  } else if (result.exit_status == 0) {
    outcome.verdict = Verdict::holds;
    outcome.asserted = {bench};
  } else if (std::regex_search(text, match, failure)) {
    outcome.verdict = Verdict::fails;
    outcome.explanation = fmt::format("{}{}", bench, match[0].str());
  } else {
    outcome.explanation = fmt::format("{} broke down, see {}", bench, log.string());
  }
  return outcome;
}

}  // namespace proof
