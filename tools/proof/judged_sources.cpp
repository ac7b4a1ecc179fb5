// SPDX-License-Identifier: Apache-2.0
// Copies with the properties in them, for the simulator and for the solvers.
#include "tools/proof/judged_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

SourceTree woven(const Folders& folders, const char* name, Purpose purpose) {
  const fs::path folder = folders.work / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  prepare_sources(folders, folder / "sources", nullptr, purpose);
  // A copy, so that changes of the sources during a campaign have no effect.
  fs::copy(folders.project / "testbench", folder / "testbench", fs::copy_options::recursive);
  return SourceTree({folder / "sources", folder / "testbench"});
}

}  // namespace

JudgedSources::JudgedSources(const Folders& folders)
    : work_(folders.work),
      simulated_(woven(folders, "simulated", Purpose::simulator)),
      synthesized_(woven(folders, "synthesized", Purpose::solver)) {}

std::vector<std::string> JudgedSources::entities_of(const std::string& unit) const {
  static const std::regex entity(R"((^|\n)entity )");
  if (std::regex_search(synthesized_.text_of(unit), entity)) return {unit};
  const fs::path folder = synthesized_.file_of(unit).parent_path();
  std::vector<std::string> users;
  for (const std::string& name : synthesized_.units()) {
    if (synthesized_.file_of(name).parent_path() == folder && name != unit &&
        synthesized_.closure_of(name).contains(unit) &&
        std::regex_search(synthesized_.text_of(name), entity)) {
      users.push_back(name);
    }
  }
  // An entity that is part of another one is compared with it.
  std::vector<std::string> largest;
  for (const std::string& user : users) {
    if (std::ranges::none_of(users, [&](const std::string& other) {
          return other != user && synthesized_.closure_of(other).contains(user);
        })) {
      largest.push_back(user);
    }
  }
  if (largest.empty()) {
    throw std::runtime_error(fmt::format("no entity of its folder uses {}", unit));
  }
  return largest;
}

std::vector<std::string> JudgedSources::files(const SourceTree& tree, const std::string& top,
                                              const std::string& unit,
                                              const std::string& stand_in) const {
  std::vector<std::string> paths;
  for (const std::string& name : tree.closure_of(top)) {
    paths.push_back(name == unit ? stand_in : tree.file_of(name).string());
  }
  return paths;
}

std::string JudgedSources::key(const SourceTree& tree, const std::string& top,
                               const std::string& text, const Variant& variant) const {
  std::string all = text;
  for (const std::string& name : tree.closure_of(top)) {
    all += '\f';
    all += name;
    all += '\f';
    if (name != variant.unit) {
      all += tree.text_of(name);
    } else {
      all += &tree == &simulated_ ? variant.simulated : variant.synthesized;
    }
  }
  return fingerprint(all);
}

std::optional<std::string> JudgedSources::synthesize(
    const std::string& top, const std::string& unit, const std::string& stand_in,
    const std::map<std::string, std::string>& generics, const fs::path& folder) const {
  std::vector<std::string> arguments{
      "ghdl", "synth", "--std=08", "-fpsl", "--no-assert-cover", "--out=verilog"};
  for (const auto& [name, value] : generics) {
    arguments.push_back(fmt::format("-g{}={}", name, value));
  }
  for (const std::string& file : files(synthesized_, top, unit, stand_in)) {
    arguments.push_back(file);
  }
  arguments.insert(arguments.end(), {"-e", top});
  const fs::path log = folder / (top + ".v");
  const ProcessResult result = run_process(arguments, folder, log, wall_limit, synthesis_limit);
  return result.exit_status == 0 ? std::optional(text_of(log)) : std::nullopt;
}

std::string last_words(const fs::path& log) {
  const std::string text = text_of(log.string() + ".err") + text_of(log);
  constexpr std::size_t length = 300;
  return text.substr(text.size() - std::min(text.size(), length));
}

}  // namespace proof
