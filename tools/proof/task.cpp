// SPDX-License-Identifier: Apache-2.0
// Calls of the solver and what they mean.
#include "tools/proof/task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tools/proof/bench.hpp"
#include "tools/proof/process.hpp"
#include "tools/proof/solver_log.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

using Time = std::chrono::steady_clock;

double seconds_since(Time::time_point start) {
  return std::chrono::duration<double>(Time::now() - start).count();
}

struct Stage {
  const char* name;
  const char* option;  // of yosys-smtbmc; may be empty
  int depth;
};

// What the solver says of one stage; an outcome that holds has nothing to explain.
Outcome solve(const SolverInput& input, const Stage& stage, const fs::path& folder,
              std::chrono::seconds limit) {
  const fs::path trace = folder / fmt::format("{}.vcd", stage.name);
  std::vector<std::string> arguments{
      "yosys-smtbmc", "-s", "z3", "-t", std::to_string(stage.depth), "--dump-vcd", trace.string()};
  if (*stage.option != '\0') arguments.insert(arguments.begin() + 1, stage.option);
  arguments.push_back(input.file.string());
  const fs::path log_file = folder / fmt::format("{}.log", stage.name);
  const ProcessResult result = run_process(arguments, folder, log_file, limit);
  const SolverLog log = read_solver_log(text_of(log_file));
  Outcome outcome;
  outcome.failed = log.failed;
  if (result.timed_out) {
    outcome.verdict = Verdict::undecided;
    outcome.explanation = fmt::format("{}: not decided within {} s (at clock {})", stage.name,
                                      limit.count(), log.failed_at);
  } else if (!log.holds || (*log.holds != (result.exit_status == 0))) {
    outcome.explanation =
        fmt::format("{}: the solver broke down, see {}", stage.name, log_file.string());
  } else if (*log.holds) {
    outcome.verdict = Verdict::holds;
  } else {
    outcome.verdict = Verdict::fails;
    outcome.explanation =
        *stage.option == '\0'
            ? fmt::format("{} fails {} clocks after the start; trace in {}",
                          fmt::join(log.failed, ", "), log.failed_at, trace.string())
            : fmt::format(
                  "the induction does not close: {} can fail after {} clocks in which all "
                  "hold, from a state that the start need not lead to; trace in {}",
                  fmt::join(log.failed, ", "), stage.depth, trace.string());
  }
  return outcome;
}

Stage from_start(int depth) { return {"bounded", "", depth}; }

enum class Answer { yes, no, unknown };

// Whether one half of a proof holds, by Yosys' own solver: it is far faster than z3 for most of
// this, but says little where it does not hold.
Answer ask_sat(const SolverInput& input, const char* half, int depth, const fs::path& folder,
               std::chrono::seconds limit) {
  const fs::path log = folder / "sat.log";
  const std::string script = fmt::format(
      "read_rtlil {}; sat -tempinduct {} -prove-asserts -set-assumes -maxsteps {} -verify",
      (input.file.parent_path() / "formal.il").string(), half, depth);
  const ProcessResult result = run_process({"yosys", "-p", script}, folder, log, limit);
  const std::string text = text_of(log);
  // Yosys ends with an error, and what it wrote before is not always in the log.
  if (text.find("model found for base case: FAIL!") != std::string::npos ||
      text_of(log.string() + ".err").find("proof did fail") != std::string::npos) {
    return Answer::no;
  }
  return result.exit_status == 0 &&
                 text.find("SAT temporal induction proof finished") == std::string::npos
             ? Answer::yes
             : Answer::unknown;
}

Outcome solve_clocked(const SolverInput& input, const Proof& proof, const fs::path& folder,
                      std::chrono::seconds limit) {
  const int clocks = proof.method == Method::bounded ? proof.depth : proof.depth + 1;
  Outcome base;
  base.verdict = Verdict::holds;
  if (ask_sat(input, "-tempinduct-baseonly", clocks, folder, limit) != Answer::yes) {
    base = solve(input, from_start(clocks), folder, limit);
  }
  if (proof.method == Method::bounded || base.verdict != Verdict::holds) return base;
  if (ask_sat(input, "-tempinduct-inductonly", proof.depth, folder, limit) == Answer::yes) {
    return base;
  }
  return solve(input, {"induction", "-i", proof.depth}, folder, limit);
}

// Every value in turn: asked for in each clock as the first that is not zero.
Outcome sight(const SolverInput& input, const Proof& proof, const fs::path& folder,
              std::chrono::seconds limit) {
  std::string script =
      fmt::format("read_rtlil {};", (input.file.parent_path() / "formal.il").string());
  for (int clock = 1; clock <= proof.depth; ++clock) {
    script += fmt::format(" sat -all -set-assumes -set-init-zero -seq {}", clock);
    for (const std::string& signal : proof.signals) {
      script += fmt::format(" -show {}", signal);
      for (int before = 1; before < clock; ++before) {
        script += fmt::format(" -set-at {} {} 0", before, signal);
      }
    }
    script += ";";
  }
  const fs::path log = folder / "sightings.log";
  const ProcessResult result = run_process({"yosys", "-p", script}, folder, log, limit);
  Outcome outcome;
  const auto found = static_cast<int>(read_solutions(text_of(log)).size());
  if (result.timed_out) {
    outcome.verdict = Verdict::undecided;
    outcome.explanation =
        fmt::format("{} of {} values seen within {} s", found, proof.values, limit.count());
  } else if (result.exit_status != 0) {
    outcome.explanation = fmt::format("the solver broke down, see {}", log.string());
  } else {
    outcome.verdict = found == proof.values ? Verdict::holds : Verdict::fails;
    if (found != proof.values) {
      outcome.explanation = fmt::format("{} values instead of {} are seen within {} clocks, see {}",
                                        found, proof.values, proof.depth, log.string());
    }
    outcome.asserted = proof.signals;
  }
  return outcome;
}

// The lemma's negation must have no solution.
Outcome solve_lemma(const fs::path& lemma, const fs::path& folder, std::chrono::seconds limit) {
  const fs::path log_file = folder / "z3.log";
  const ProcessResult result = run_process({"z3", lemma.string()}, folder, log_file, limit);
  const std::string log = text_of(log_file) + text_of(log_file.string() + ".err");
  Outcome outcome;
  if (result.timed_out) {
    outcome.verdict = Verdict::undecided;
    outcome.explanation = fmt::format("not decided within {} s", limit.count());
  } else if (result.exit_status != 0 || log.find("error") != std::string::npos) {
    outcome.explanation = "z3 broke down: " + log;
  } else {
    // Every question of the file is asked; one that has a solution breaks the lemma.
    const bool solved = log.starts_with("unsat\n") || log == "unsat";
    const bool broken = log.find("\nsat") != std::string::npos || log.starts_with("sat");
    const bool unknown = log.find("unknown") != std::string::npos;
    outcome.verdict = broken               ? Verdict::fails
                      : solved && !unknown ? Verdict::holds
                                           : Verdict::undecided;
    outcome.explanation = outcome.verdict == Verdict::holds ? "" : "z3 says: " + log;
    outcome.asserted = {lemma.stem().string()};
  }
  return outcome;
}

// With the fault in, a proof without properties of a netlist must fail as a whole.
Outcome turned_around(Outcome outcome, const std::string& proof) {
  if (outcome.verdict == Verdict::holds) {
    outcome.verdict = Verdict::fails;
    outcome.explanation = fmt::format("survives: {} holds all the same", proof);
  } else if (outcome.verdict == Verdict::fails) {
    outcome.verdict = Verdict::holds;
    outcome.failed = {proof};
  }
  return outcome;
}

// The fault is one of the lemma itself.
Outcome try_on_lemma(const Folders& folders, const Mutation& mutation, const Proof& proof,
                     const fs::path& folder, std::chrono::seconds limit) {
  fs::create_directories(folder);
  const fs::path lemma = folder / mutation.file.filename();
  write_mutated(folders, mutation, lemma);
  return turned_around(solve_lemma(lemma, folder, limit), proof.name);
}

// A bench must fail on the fault.
Outcome try_on_bench(const Folders& folders, const Mutation& mutation, const std::string& bench,
                     const fs::path& folder, std::chrono::seconds limit) {
  prepare_sources(folders, folder / "sources", &mutation, Purpose::simulator);
  return turned_around(run_bench(folders, folder / "sources", bench, folder, limit), bench);
}

template <typename Trial>
Outcome timed(const Trial& trial) {
  const Time::time_point start = Time::now();
  Outcome outcome;
  try {
    outcome = trial();
  } catch (const std::exception& error) {
    outcome.verdict = Verdict::broken;
    outcome.explanation = error.what();
  }
  outcome.seconds = seconds_since(start);
  return outcome;
}

}  // namespace

Outcome try_proof(const Folders& folders, const Proof& proof, const fs::path& sources,
                  std::chrono::seconds limit) {
  return timed([&] {
    const fs::path folder = folders.work / proof.name;
    fs::create_directories(folder);
    if (proof.method == Method::arithmetic) {
      return solve_lemma(folders.list() / proof.lemma, folder, limit);
    }
    if (proof.method == Method::bench) {
      prepare_sources(folders, folder / "sources", nullptr, Purpose::simulator);
      return run_bench(folders, folder / "sources", proof.entity, folder, limit);
    }
    const SolverInput input = make_solver_input(folders, sources, proof, nullptr, folder);
    if (proof.method == Method::sighting) return sight(input, proof, folder, limit);
    Outcome outcome = solve_clocked(input, proof, folder, limit);
    outcome.asserted = input.netlist.asserted;
    outcome.assumed = input.netlist.assumed;
    if (outcome.verdict == Verdict::holds && outcome.asserted.empty()) {
      throw std::runtime_error("there is nothing to prove");
    }
    return outcome;
  });
}

Outcome try_mutation(const Folders& folders, const Mutation& mutation, const Proof& proof,
                     std::chrono::seconds limit) {
  return timed([&] {
    const fs::path folder = folders.work / "mutations" / mutation.name;
    if (proof.method == Method::bench) {
      return try_on_bench(folders, mutation, proof.entity, folder, limit);
    }
    if (proof.method == Method::arithmetic) {
      return try_on_lemma(folders, mutation, proof, folder, limit);
    }
    prepare_sources(folders, folder / "sources", &mutation);
    if (proof.method == Method::sighting) {
      const SolverInput input =
          make_solver_input(folders, folder / "sources", proof, nullptr, folder);
      return turned_around(sight(input, proof, folder, limit), proof.name);
    }
    const SolverInput input =
        make_solver_input(folders, folder / "sources", proof, &mutation.property, folder);
    Outcome outcome;
    if (ask_sat(input, "-tempinduct-baseonly", mutation.depth, folder, limit) == Answer::no) {
      outcome.verdict = Verdict::holds;
      outcome.failed = {mutation.property};
      return outcome;
    }
    outcome = solve(input, from_start(mutation.depth), folder, limit);
    if (outcome.verdict == Verdict::holds) {
      outcome.verdict = Verdict::fails;
      outcome.explanation = fmt::format("survives: {} holds for {} clocks all the same",
                                        mutation.property, mutation.depth);
    } else if (outcome.verdict == Verdict::fails) {
      outcome.verdict = Verdict::holds;
    }
    return outcome;
  });
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::fails:
      return "fails";
    case Verdict::undecided:
      return "undecided";
    case Verdict::broken:
      return "broken";
  }
  return "";
}

}  // namespace proof
