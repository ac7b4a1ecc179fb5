// SPDX-License-Identifier: Apache-2.0
// Runs the clocked properties of an entity with the mutant for some clocks.
#include "tools/proof/proof_judge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "tools/files/write_text.hpp"
#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

constexpr int deepest_run = 10;  // clocks from the start in which a proof by induction is run

bool is_clocked(const Proof& proof) {
  return proof.method == Method::induction || proof.method == Method::bounded;
}

}  // namespace

std::vector<Proof> ProofJudge::proofs_of(const std::string& unit) const {
  std::vector<Proof> proofs;
  for (const Proof& proof : list_.proofs) {
    // For entities that contain the unit only the quick ones: the others take minutes and find
    // little more.
    if (is_clocked(proof) && proof.stand_ins.empty() && sources_.synthesized().has(proof.entity) &&
        (proof.entity == unit || proof.quick) &&
        sources_.synthesized().closure_of(proof.entity).contains(unit) &&
        std::ranges::find(proof.free, unit) == proof.free.end()) {
      proofs.push_back(proof);
    }
  }
  std::ranges::stable_partition(proofs,
                                [&unit](const Proof& proof) { return proof.entity == unit; });
  return proofs;
}

std::string ProofJudge::key(const Proof& proof, const Variant& variant) const {
  return sources_.key(
      sources_.synthesized(), proof.entity,
      fmt::format("proof {} {} {} {} {} {} {} {}", proof.entity, deepest_run, proof.depth,
                  name_of(proof.method), fmt::join(proof.only, ","), fmt::join(proof.except, ","),
                  fmt::join(proof.free, ","), fmt::join(proof.free_copies, ",")),
      variant);
}

Judged ProofJudge::ask(const Proof& proof, const Variant& variant, const fs::path& folder) const {
  const fs::path file = folder / (variant.unit + ".vhd");
  files::write_text(file, variant.synthesized);
  const auto verilog =
      sources_.synthesize(proof.entity, variant.unit, file.string(), proof.generics, folder);
  if (!verilog) return {Finding::passes, "not synthesized with these generics"};
  FormalNetlist formal;
  try {
    formal = make_formal(*verilog, proof.entity,
                         {proof.only, proof.except, proof.free, proof.free_copies});
  } catch (const std::runtime_error&) {
    return {Finding::passes, "a property is gone"};
  }
  files::write_text(folder / "formal.v", formal.verilog);
  std::string cuts;
  for (const std::string& entity : proof.free) {
    cuts += fmt::format("cutpoint t:{0} t:{0}_*; ", entity);
  }
  for (const std::string& copy : proof.free_copies) cuts += fmt::format("cutpoint c:*{}_*; ", copy);
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
  return {Finding::passes,
          result.timed_out          ? "not decided in time"
          : result.exit_status != 0 ? "the solver broke down"
                                    : proof.name,
          result.timed_out};
}

}  // namespace proof
