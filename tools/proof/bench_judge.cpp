// SPDX-License-Identifier: Apache-2.0
// Compiles a bench with the mutant and runs it.
#include "tools/proof/bench_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>

#include "tools/files/write_text.hpp"
#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

std::vector<std::string> BenchJudge::own_benches(const std::string& unit) const {
  std::vector<std::string> benches;
  for (const std::string& name : sources_.simulated().units()) {
    if (name.ends_with("_tb") && name.starts_with(unit + "_") &&
        sources_.simulated().closure_of(name).contains(unit) &&
        // The bench of `step_generator_core` is not that of `step_generator`.
        (name == unit + "_tb" || !sources_.simulated().has(name.substr(0, name.size() - 3)))) {
      benches.push_back(name);
    }
  }
  return benches;
}

std::vector<std::string> BenchJudge::other_benches(const std::string& unit) const {
  const std::vector<std::string> own = own_benches(unit);
  std::vector<std::string> benches;
  for (const std::string& name : sources_.simulated().units()) {
    if (name.ends_with("_tb") && sources_.simulated().closure_of(name).contains(unit) &&
        sources_.simulated().file_of(name).parent_path().filename() ==
            sources_.simulated().file_of(unit).parent_path().filename() &&
        std::ranges::find(own, name) == own.end()) {
      benches.push_back(name);
    }
  }
  return benches;
}

std::string BenchJudge::key(const std::string& bench, const Variant& variant) const {
  return sources_.key(sources_.simulated(), bench, "bench " + bench, variant);
}

double BenchJudge::seconds(const std::string& bench, const fs::path& folder) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = seconds_.find(bench); found != seconds_.end()) return found->second;
  }
  std::vector<std::string> arguments{"ghdl", "-c", "--std=08", "-fpsl"};
  for (const std::string& file : sources_.files(sources_.simulated(), bench, "", "")) {
    arguments.push_back(file);
  }
  arguments.insert(arguments.end(), {"-r", bench, "--assert-level=error"});
  const fs::path log = folder / (bench + ".log");
  const ProcessResult result = run_process(arguments, folder, log, wall_limit);
  if (result.exit_status != 0) {
    throw std::runtime_error(
        fmt::format("{} fails without any mutant: {}", bench, last_words(log)));
  }
  const std::scoped_lock lock(mutex_);
  return seconds_[bench] = result.cpu_seconds;
}

void BenchJudge::know_seconds(const std::string& bench, double seconds) {
  const std::scoped_lock lock(mutex_);
  seconds_[bench] = seconds;
}

Judged BenchJudge::ask(const std::string& bench, const Variant& variant, const fs::path& folder) {
  const double usual = seconds(bench, folder);
  const fs::path file = folder / (variant.unit + ".vhd");
  files::write_text(file, variant.simulated);
  std::vector<std::string> arguments{"ghdl", "-c", "--std=08", "-fpsl"};
  for (const std::string& name :
       sources_.files(sources_.simulated(), bench, variant.unit, file.string())) {
    arguments.push_back(name);
  }
  arguments.insert(arguments.end(), {"-r", bench, "--assert-level=error"});
  const fs::path log = folder / (bench + ".log");
  // One that hangs is found by its processor time.
  const std::chrono::seconds limit(static_cast<int>(std::ceil(3 * usual + 3)));
  const ProcessResult result = run_process(arguments, folder, log, wall_limit, limit);
  // Where nothing settles, or nothing happens any more, GHDL ends without an error.
  if (result.exit_status == 0) {
    return text_of(log).find("simulation finished") == std::string::npos
               ? Judged{Finding::killed, bench + " does not finish"}
               : Judged{Finding::passes, bench};
  }
  if (result.timed_out) return {Finding::killed, bench + " does not end"};
  // What fails while time goes by gives its time: "FILE:LINE:COLUMN:@TIME:(assertion failure): ..."
  static const std::regex failure(R"(:@[0-9]+[a-z]+:.*)");
  const std::string text = text_of(log) + text_of(log.string() + ".err");
  std::smatch match;
  if (std::regex_search(text, match, failure)) return {Finding::killed, bench};
  if (text.find("simulation failed") == std::string::npos) {
    return {Finding::refused, last_words(log)};
  }
  // A value out of its range: a fault where the chip can be made anyway.
  for (const std::string& entity : sources_.entities_of(variant.unit)) {
    if (!sources_.synthesize(entity, variant.unit, file.string(), {}, folder)) {
      return {Finding::refused, "refused by synthesis"};
    }
  }
  return {Finding::killed, bench + " breaks down"};
}

}  // namespace proof
