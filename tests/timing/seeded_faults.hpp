// SPDX-License-Identifier: Apache-2.0
// Faults of the analysis, seeded into what it works with: each is found by a check that passes
// without it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/timing/measured_program.hpp"
#include "tools/timing/certificate.hpp"
#include "tools/timing/cost_sum.hpp"

namespace timing {

// The linear program of the measured function, and the prices that prove its bound.
struct Proof {
  Networks networks;
  LinearProgram rows;
  Prices prices;
};
// With the solver's prices of the facts.
Proof proof_of(Networks networks);

// All that the analysis works with, and what the checks hold it against.
struct Tool {
  Tool();

  MeasuredProgram measured;
  Program program;  // what the analysis takes the measured one for
  Costs costs;
  std::vector<Step> steps;  // as the sum of the costs gets them
  Address span_end;
  Proof proof;

  void replace(std::size_t number, processor::encode::Word word);  // an instruction
};

// Each says what it finds; nothing where all is well.
using Check = std::string (*)(const Tool&);
struct NamedCheck {
  std::string name;
  Check check;
};

// The costs of all executed instructions add up to the clocks.
std::string cost_sum(const Tool& tool);
// The bound exists and is at least the measured time.
std::string measured_time(const Tool& tool);
// The same of a part of the function.
std::string measured_span(const Tool& tool);
// No function is without a bound, and no interrupt runs code.
std::string refusal(const Tool& tool);
// The proof's inequalities hold.
std::string certificate(const Tool& tool);
// What is proved is at least the measured time.
std::string proved_time(const Tool& tool);
// A second solver finds the same optimum.
std::string second_opinion(const Tool& tool);

struct Fault {
  std::string kind, name;
  Check finds;
  std::function<void(Tool&)> seed;
};

std::vector<Fault> wrong_costs();
std::vector<Fault> wrong_flow();
std::vector<Fault> wrong_facts();
std::vector<Fault> wrong_proofs();

}  // namespace timing
