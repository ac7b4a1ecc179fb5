// SPDX-License-Identifier: Apache-2.0
// Equality of both netlists clock by clock, by Yosys, under what is proved of the original.
#include "tools/proof/netlist_judge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <regex>
#include <set>
#include <stdexcept>

#include "tools/files/write_text.hpp"
#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

// Positions in the sources, which GHDL writes.
std::string without_comments(const std::string& verilog) {
  static const std::regex comment(R"(/\*[^*]*\*/|//[^\n]*)");
  return std::regex_replace(verilog, comment, "");
}

}  // namespace

std::map<std::string, std::string> NetlistJudge::compared_generics(
    const std::string& entity) const {
  for (const Proof& proof : list_.proofs) {
    if (proof.entity == entity && proof.method == Method::induction && !proof.generics.empty() &&
        proof.stand_ins.empty()) {
      return proof.generics;
    }
  }
  return {};
}

std::optional<Choice> NetlistJudge::invariants_of(const std::string& entity) const {
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
      if (!only.contains(property)) choice.except.push_back(property);
    }
    return choice;
  }
  if (!only.empty()) {
    choice.only.assign(only.begin(), only.end());
    return choice;
  }
  return std::nullopt;
}

std::string NetlistJudge::key(const Variant& variant) const {
  const std::vector<std::string> entities = sources_.entities_of(variant.unit);
  std::string keys;
  for (const std::string& entity : entities) {
    std::string text = fmt::format("comparison 3 {}", fmt::join(compared_generics(entity), ","));
    if (const auto invariants = invariants_of(entity)) {
      text += fmt::format(" {} {}", fmt::join(invariants->only, ","),
                          fmt::join(invariants->except, ","));
    }
    keys += sources_.key(sources_.synthesized(), entity, text, variant);
  }
  return entities.size() == 1 ? keys : fingerprint(keys);
}

// Names numbered by GHDL are hidden: the numbers differ between variants.
std::string NetlistJudge::write_netlist(const std::string& verilog, const std::string& entity,
                                        const char* name, const fs::path& folder) const {
  const bool is_original = name == std::string("gold");
  const auto invariants = is_original ? invariants_of(entity) : std::nullopt;
  const FormalNetlist formal = make_formal(verilog, entity, invariants.value_or(Choice{}));
  const fs::path source = folder / fmt::format("{}.v", name);
  const fs::path netlist = folder / fmt::format("{}.il", name);
  files::write_text(source, formal.verilog);
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
  if (result.exit_status != 0) throw std::runtime_error(last_words(log));
  return netlist.string();
}

const NetlistJudge::Original& NetlistJudge::original(const std::string& entity) {
  Original* original = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    auto& entry = originals_[entity];
    if (!entry) entry = std::make_unique<Original>();
    original = entry.get();
  }
  std::call_once(original->once, [&] {
    const fs::path folder = sources_.work() / "originals" / entity;
    fs::create_directories(folder);
    const auto verilog = sources_.synthesize(entity, "", "", compared_generics(entity), folder);
    if (!verilog) throw std::runtime_error(entity + " cannot be synthesized");
    original->verilog = *verilog;
    original->netlist = write_netlist(*verilog, entity, "gold", folder);
  });
  return *original;
}

Judged NetlistJudge::ask(const Variant& variant, const fs::path& folder) {
  Judged judged;
  for (const std::string& entity : sources_.entities_of(variant.unit)) {
    judged = compare_in(entity, variant, folder);
    if (judged.finding != Finding::equivalent) break;
  }
  return judged;
}

Judged NetlistJudge::compare_in(const std::string& entity, const Variant& variant,
                                const fs::path& folder) {
  const Original& gold = original(entity);
  const fs::path file = folder / (variant.unit + ".vhd");
  files::write_text(file, variant.synthesized);
  const auto verilog =
      sources_.synthesize(entity, variant.unit, file.string(), compared_generics(entity), folder);
  if (!verilog) return {Finding::refused, "refused by synthesis"};
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
    timed_out = timed_out || result.timed_out;
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
  return {Finding::passes, timed_out ? "not decided in time" : "not proved equal", timed_out};
}

}  // namespace proof
