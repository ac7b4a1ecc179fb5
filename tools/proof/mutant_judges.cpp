// SPDX-License-Identifier: Apache-2.0
// Calls of GHDL and Yosys; each call gets only the files that its unit needs.
#include "tools/proof/mutant_judges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>

#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds wall_limit{1800};
constexpr std::chrono::seconds synthesis_limit{60};
constexpr std::chrono::seconds solver_limit{8};
constexpr int deepest_run = 10;  // clocks from the start in which a proof by induction is run

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text;
  if (!stream.flush()) {
    throw std::runtime_error("cannot write " + file.string());
  }
}

SourceTree woven(const Folders& folders, const char* name, Purpose purpose) {
  const fs::path folder = folders.work / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  prepare_sources(folders, folder / "sources", nullptr, purpose);
  // A copy, too: what is changed while a campaign goes on must not be taken for what it was.
  fs::copy(folders.project / "testbench", folder / "testbench", fs::copy_options::recursive);
  return SourceTree({folder / "sources", folder / "testbench"});
}

std::string last_words(const fs::path& log) {
  const std::string text = text_of(log.string() + ".err") + text_of(log);
  constexpr std::size_t length = 300;
  return text.substr(text.size() - std::min(text.size(), length));
}

// GHDL gives the places in the sources.
std::string without_comments(const std::string& verilog) {
  static const std::regex comment(R"(/\*[^*]*\*/|//[^\n]*)");
  return std::regex_replace(verilog, comment, "");
}

bool is_clocked(const Proof& proof) {
  return proof.method == Method::induction || proof.method == Method::bounded;
}

}  // namespace

Judges::Judges(const Folders& folders, const List& list)
    : folders_(folders),
      list_(list),
      simulated_(woven(folders, "simulated", Purpose::simulator)),
      synthesized_(woven(folders, "synthesized", Purpose::solver)) {}

std::vector<std::string> Judges::own_benches(const std::string& unit) const {
  std::vector<std::string> benches;
  for (const std::string& name : simulated_.units()) {
    if (name.ends_with("_tb") && name.starts_with(unit + "_") &&
        simulated_.closure_of(name).contains(unit) &&
        // The bench of `step_generator_core` is not that of `step_generator`.
        (name == unit + "_tb" || !simulated_.has(name.substr(0, name.size() - 3)))) {
      benches.push_back(name);
    }
  }
  return benches;
}

std::vector<std::string> Judges::other_benches(const std::string& unit) const {
  const std::vector<std::string> own = own_benches(unit);
  std::vector<std::string> benches;
  for (const std::string& name : simulated_.units()) {
    if (name.ends_with("_tb") && simulated_.closure_of(name).contains(unit) &&
        simulated_.file_of(name).parent_path().filename() ==
            simulated_.file_of(unit).parent_path().filename() &&
        std::ranges::find(own, name) == own.end()) {
      benches.push_back(name);
    }
  }
  return benches;
}

std::vector<Proof> Judges::proofs_of(const std::string& unit) const {
  std::vector<Proof> proofs;
  for (const Proof& proof : list_.proofs) {
    // Of what contains the unit only the quick ones: the others take minutes and find little more.
    if (is_clocked(proof) && proof.stand_ins.empty() && synthesized_.has(proof.entity) &&
        (proof.entity == unit || proof.quick) &&
        synthesized_.closure_of(proof.entity).contains(unit) &&
        std::ranges::find(proof.free, unit) == proof.free.end()) {
      proofs.push_back(proof);
    }
  }
  std::ranges::stable_partition(proofs,
                                [&unit](const Proof& proof) { return proof.entity == unit; });
  return proofs;
}

std::vector<std::string> Judges::compared_entities(const std::string& unit) const {
  static const std::regex entity(R"((^|\n)entity )");
  if (std::regex_search(synthesized_.text_of(unit), entity)) {
    return {unit};
  }
  const fs::path folder = synthesized_.file_of(unit).parent_path();
  std::vector<std::string> users;
  for (const std::string& name : synthesized_.units()) {
    if (synthesized_.file_of(name).parent_path() == folder && name != unit &&
        synthesized_.closure_of(name).contains(unit) &&
        std::regex_search(synthesized_.text_of(name), entity)) {
      users.push_back(name);
    }
  }
  // What is part of another one is compared with it.
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

std::vector<std::string> Judges::files(const SourceTree& tree, const std::string& top,
                                       const std::string& unit, const std::string& stand_in) const {
  std::vector<std::string> paths;
  for (const std::string& name : tree.closure_of(top)) {
    paths.push_back(name == unit ? stand_in : tree.file_of(name).string());
  }
  return paths;
}

std::string Judges::key(const SourceTree& tree, const std::string& top, const std::string& text,
                        const Variant& variant) const {
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

std::string Judges::key_of_bench(const std::string& bench, const Variant& variant) const {
  return key(simulated_, bench, "bench " + bench, variant);
}

std::string Judges::key_of_proof(const Proof& proof, const Variant& variant) const {
  return key(
      synthesized_, proof.entity,
      fmt::format("proof {} {} {} {} {} {} {} {}", proof.entity, deepest_run, proof.depth,
                  name_of(proof.method), fmt::join(proof.only, ","), fmt::join(proof.except, ","),
                  fmt::join(proof.free, ","), fmt::join(proof.free_copies, ",")),
      variant);
}

std::string Judges::key_of_comparison(const Variant& variant) const {
  const std::vector<std::string> entities = compared_entities(variant.unit);
  std::string keys;
  for (const std::string& entity : entities) {
    std::string text = fmt::format("comparison 3 {}", fmt::join(compared_generics(entity), ","));
    if (const auto invariants = invariants_of(entity)) {
      text += fmt::format(" {} {}", fmt::join(invariants->only, ","),
                          fmt::join(invariants->except, ","));
    }
    keys += key(synthesized_, entity, text, variant);
  }
  return entities.size() == 1 ? keys : fingerprint(keys);
}

double Judges::bench_seconds(const std::string& bench, const fs::path& folder) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = seconds_.find(bench); found != seconds_.end()) {
      return found->second;
    }
  }
  std::vector<std::string> arguments{"ghdl", "-c", "--std=08", "-fpsl"};
  for (const std::string& file : files(simulated_, bench, "", "")) {
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

void Judges::know_seconds(const std::string& bench, double seconds) {
  const std::scoped_lock lock(mutex_);
  seconds_[bench] = seconds;
}

Judged Judges::ask_bench(const std::string& bench, const Variant& variant, const fs::path& folder) {
  const double usual = bench_seconds(bench, folder);
  const fs::path file = folder / (variant.unit + ".vhd");
  write(file, variant.simulated);
  std::vector<std::string> arguments{"ghdl", "-c", "--std=08", "-fpsl"};
  for (const std::string& name : files(simulated_, bench, variant.unit, file.string())) {
    arguments.push_back(name);
  }
  arguments.insert(arguments.end(), {"-r", bench, "--assert-level=error"});
  const fs::path log = folder / (bench + ".log");
  // One that hangs is found by its processor time.
  const std::chrono::seconds limit(static_cast<int>(std::ceil(3 * usual + 3)));
  const ProcessResult result = run_process(arguments, folder, log, wall_limit, limit);
  if (result.exit_status == 0) {
    return {Finding::passes, bench};
  }
  if (result.timed_out) {
    return {Finding::killed, bench + " does not end"};
  }
  // What fails while time goes by gives its time: "FILE:LINE:COLUMN:@TIME:(assertion failure): ..."
  static const std::regex failure(R"(:@[0-9]+[a-z]+:.*)");
  const std::string text = text_of(log) + text_of(log.string() + ".err");
  std::smatch match;
  if (std::regex_search(text, match, failure)) {
    return {Finding::killed, bench};
  }
  if (text.find("simulation failed") == std::string::npos) {
    return {Finding::refused, last_words(log)};
  }
  // A value out of its range: a fault where the chip can be made all the same.
  for (const std::string& entity : compared_entities(variant.unit)) {
    if (!synthesize(entity, variant.unit, file.string(), {}, folder)) {
      return {Finding::refused, "refused by synthesis"};
    }
  }
  return {Finding::killed, bench + " breaks down"};
}

std::optional<std::string> Judges::synthesize(const std::string& top, const std::string& unit,
                                              const std::string& stand_in,
                                              const std::map<std::string, std::string>& generics,
                                              const fs::path& folder) const {
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

std::map<std::string, std::string> Judges::compared_generics(const std::string& entity) const {
  for (const Proof& proof : list_.proofs) {
    if (proof.entity == entity && proof.method == Method::induction && !proof.generics.empty() &&
        proof.stand_ins.empty()) {
      return proof.generics;
    }
  }
  return {};
}

std::optional<Choice> Judges::invariants_of(const std::string& entity) const {
  // By the proofs that take all properties but some, and those that take some.
  bool some_take_all = false;
  std::set<std::string> except;
  std::set<std::string> only;
  for (const Proof& proof : list_.proofs) {
    if (proof.entity != entity || proof.method != Method::induction ||
        proof.generics != compared_generics(entity) || !proof.stand_ins.empty()) {
      continue;
    }
    if (proof.only.empty()) {
      some_take_all = true;
      except.insert(proof.except.begin(), proof.except.end());
    } else {
      only.insert(proof.only.begin(), proof.only.end());
    }
  }
  Choice choice;
  if (some_take_all) {
    for (const std::string& property : except) {
      if (!only.contains(property)) {
        choice.except.push_back(property);
      }
    }
    return choice;
  }
  if (!only.empty()) {
    choice.only.assign(only.begin(), only.end());
    return choice;
  }
  return std::nullopt;
}

// Names that GHDL numbers are hidden: they differ between variants for no reason.
std::string Judges::write_netlist(const std::string& verilog, const std::string& entity,
                                  const char* name, const fs::path& folder) const {
  const bool is_original = name == std::string("gold");
  const auto invariants = is_original ? invariants_of(entity) : std::nullopt;
  const FormalNetlist formal = make_formal(verilog, entity, invariants.value_or(Choice{}));
  const fs::path source = folder / fmt::format("{}.v", name);
  const fs::path netlist = folder / fmt::format("{}.il", name);
  write(source, formal.verilog);
  const std::string script = fmt::format(
      "read_verilog -formal -sv {0}; hierarchy -top {1}; proc; flatten; memory_map; "
      "rename -hide w:n*_o w:n*_q w:*.n*_o w:*.n*_q; opt_clean; "
      "opt -full; async2sync; {2}; chformal -lower; dffunmap; setundef -init -zero; opt_clean; "
      "rename -top {3}; write_rtlil {4}",
      source.string(), entity, invariants ? "chformal -assert2assume" : "chformal -remove", name,
      netlist.string());
  const fs::path log = folder / fmt::format("{}.log", name);
  const ProcessResult result =
      run_process({"yosys", "-q", "-p", script}, folder, log, wall_limit, synthesis_limit);
  if (result.exit_status != 0) {
    throw std::runtime_error(last_words(log));
  }
  return netlist.string();
}

const Judges::Original& Judges::original(const std::string& entity) {
  Original* original = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    auto& entry = originals_[entity];
    if (!entry) {
      entry = std::make_unique<Original>();
    }
    original = entry.get();
  }
  std::call_once(original->once, [&] {
    const fs::path folder = folders_.work / "originals" / entity;
    fs::create_directories(folder);
    const auto verilog = synthesize(entity, "", "", compared_generics(entity), folder);
    if (!verilog) {
      throw std::runtime_error(entity + " cannot be synthesized");
    }
    original->verilog = *verilog;
    original->netlist = write_netlist(*verilog, entity, "gold", folder);
  });
  return *original;
}

Judged Judges::compare(const Variant& variant, const fs::path& folder) {
  Judged judged;
  for (const std::string& entity : compared_entities(variant.unit)) {
    judged = compare_in(entity, variant, folder);
    if (judged.finding != Finding::equivalent) {
      break;
    }
  }
  return judged;
}

Judged Judges::compare_in(const std::string& entity, const Variant& variant,
                          const fs::path& folder) {
  const Original& gold = original(entity);
  const fs::path file = folder / (variant.unit + ".vhd");
  write(file, variant.synthesized);
  const auto verilog =
      synthesize(entity, variant.unit, file.string(), compared_generics(entity), folder);
  if (!verilog) {
    return {Finding::refused, "refused by synthesis"};
  }
  if (without_comments(*verilog) == without_comments(gold.verilog)) {
    return {Finding::equivalent, "the same netlist"};
  }
  const std::string gate = write_netlist(*verilog, entity, "gate", folder);
  bool timed_out = false;
  const auto proves = [&](const char* exposed, const char* question, const char* name) {
    const std::string script = fmt::format(
        "read_rtlil {}; read_rtlil {}; expose {} -shared gold gate; "
        "miter -equiv -make_assert -flatten gold gate miter; hierarchy -top miter; "
        "opt_clean; opt_merge; opt_clean; sat {} -prove-asserts -set-assumes -verify miter",
        gold.netlist, gate, exposed, question);
    const fs::path log = folder / fmt::format("{}.log", name);
    const ProcessResult result =
        run_process({"yosys", "-p", script}, folder, log, wall_limit, solver_limit);
    timed_out = result.timed_out;
    return result.exit_status == 0;
  };
  // Outputs and the registers that both have must be equal in every clock, where all that is proved
  // of the original holds. First with these registers as common inputs, which lets Yosys merge what
  // is the same in both, and the first clock apart; then by induction over clocks.
  if (proves("-evert-dff", "", "one_clock") &&
      proves("-dff", "-tempinduct -tempinduct-baseonly -maxsteps 1", "start")) {
    return {Finding::equivalent, "clock by clock"};
  }
  if (proves("-dff", "-tempinduct -maxsteps 3", "induction")) {
    return {Finding::equivalent, "by induction"};
  }
  return {Finding::passes, timed_out ? "not decided in time" : "not proved equal"};
}

Judged Judges::ask_proof(const Proof& proof, const Variant& variant, const fs::path& folder) {
  const fs::path file = folder / (variant.unit + ".vhd");
  write(file, variant.synthesized);
  const auto verilog =
      synthesize(proof.entity, variant.unit, file.string(), proof.generics, folder);
  if (!verilog) {
    return {Finding::passes, "not synthesized with these generics"};
  }
  FormalNetlist formal;
  try {
    formal = make_formal(*verilog, proof.entity,
                         {proof.only, proof.except, proof.free, proof.free_copies});
  } catch (const std::runtime_error&) {
    return {Finding::passes, "a property is gone"};
  }
  write(folder / "formal.v", formal.verilog);
  std::string cuts;
  for (const std::string& entity : proof.free) {
    cuts += fmt::format("cutpoint t:{0} t:{0}_*; ", entity);
  }
  for (const std::string& copy : proof.free_copies) {
    cuts += fmt::format("cutpoint c:*{}_*; ", copy);
  }
  const int depth =
      proof.method == Method::bounded ? std::min(proof.depth, deepest_run) : deepest_run;
  const std::string script = fmt::format(
      "read_verilog -formal -sv formal.v; hierarchy -top {0}; proc; {1}flatten; opt_clean -purge; "
      "prep -top {0}; opt -full -purge; async2sync; chformal -lower; dffunmap; memory_map; "
      "opt -full -purge; sat -tempinduct -tempinduct-baseonly -prove-asserts -set-assumes "
      "-maxsteps {2} -verify",
      proof.entity, cuts, depth);
  const fs::path log = folder / "proof.log";
  const ProcessResult result =
      run_process({"yosys", "-p", script}, folder, log, wall_limit, solver_limit);
  // What Yosys writes before this error is not always in the log.
  if (text_of(log.string() + ".err").find("proof did fail") != std::string::npos) {
    return {Finding::killed, proof.name};
  }
  return {Finding::passes, result.timed_out          ? "not decided in time"
                           : result.exit_status != 0 ? "the solver broke down"
                                                     : proof.name};
}

}  // namespace proof
