// SPDX-License-Identifier: Apache-2.0
// What is wrong between the networks of a function and its proved bound.
#include <algorithm>

#include "tests/timing/seeded_faults.hpp"
#include "tools/timing/pricing.hpp"

namespace timing {

namespace {

// Of the network asked for.
std::vector<Arc>& arcs(Proof& proof) { return proof.networks.networks[0].arcs; }

Arc& longest_arc(Proof& proof) { return *std::ranges::max_element(arcs(proof), {}, &Arc::clocks); }

Arc& call(Proof& proof) {
  return *std::ranges::find_if(arcs(proof), [](const Arc& arc) { return !arc.calls.empty(); });
}

std::size_t loop_row(const Proof& proof) { return RowNumbers(proof.networks).loop(0, 0); }
std::size_t fact_row(const Proof& proof) { return RowNumbers(proof.networks).fact(0); }

// Prices of networks with a fault, for the rows of those without.
Fault price_fault(const char* name, void (*seed)(Proof&)) {
  return {"prices of wrong networks", name, certificate, [seed](Tool& tool) {
            Proof wrong = tool.proof;
            seed(wrong);
            tool.proof.prices = price(wrong.networks, 1, {wrong.prices.of_rows[fact_row(wrong)]});
          }};
}

// Networks with a fault, priced and proved as they are.
Fault network_fault(const char* kind, const char* name, void (*seed)(Proof&)) {
  return {kind, name, proved_time, [seed](Tool& tool) {
            seed(tool.proof);
            tool.proof = proof_of(tool.proof.networks);
          }};
}

Fault solver_fault(const char* name, Check finds, void (*seed)(Proof&)) {
  return {"a solver's answer falsified", name, finds, [seed](Tool& tool) { seed(tool.proof); }};
}

Fault row_fault(const char* name, void (*seed)(Proof&)) {
  return {"a linear program falsified", name, second_opinion,
          [seed](Tool& tool) { seed(tool.proof); }};
}

void lose_the_longest_arc(Proof& proof) {
  arcs(proof).erase(arcs(proof).begin() + (&longest_arc(proof) - arcs(proof).data()));
}
void shorten_the_longest_arc(Proof& proof) { longest_arc(proof).clocks -= 1; }
void lose_the_calls(Proof& proof) { call(proof).calls.clear(); }

}  // namespace

std::vector<Fault> wrong_proofs() {
  return {
      network_fault("a network's clocks wrong", "of the longest way, one less",
                    shorten_the_longest_arc),
      network_fault("a network's call left out", "of a function with an event", lose_the_calls),
      network_fault("a network's rounds too few", "by one",
                    [](Proof& proof) { proof.networks.networks[0].loops[0].most -= 1; }),
      network_fault("a network's fact too tight", "by one",
                    [](Proof& proof) { proof.networks.facts[0].most -= 1; }),
      price_fault("an arc lost", lose_the_longest_arc),
      price_fault("a clock less", shorten_the_longest_arc),
      price_fault("a call left out", lose_the_calls),
      solver_fault("a node's price a clock less", certificate,
                   [](Proof& proof) { proof.prices.of_rows[0] -= 1; }),
      solver_fault("a loop's price a clock less", certificate,
                   [](Proof& proof) { proof.prices.of_rows[loop_row(proof)] -= 1; }),
      solver_fault("a fact's price a clock less", certificate,
                   [](Proof& proof) { proof.prices.of_rows[fact_row(proof)] -= 1; }),
      solver_fault("a loop's price below 0", certificate,
                   [](Proof& proof) { proof.prices.of_rows[loop_row(proof)] = -1; }),
      solver_fault("a price missing", certificate,
                   [](Proof& proof) { proof.prices.of_rows.pop_back(); }),
      solver_fault("all prices halved", certificate, [](Proof& proof) { proof.prices.scale = 2; }),
      solver_fault("no price of a fact", second_opinion,
                   [](Proof& proof) { proof.prices = price(proof.networks, 1, {0}); }),
      row_fault("a column lost",
                [](Proof& proof) {
                  const auto longest = &longest_arc(proof) - arcs(proof).data();
                  proof.rows.columns.erase(proof.rows.columns.begin() + longest);
                }),
      row_fault("a column's clocks less",
                [](Proof& proof) {
                  proof.rows
                      .columns[static_cast<std::size_t>(&longest_arc(proof) - arcs(proof).data())]
                      .clocks -= 1;
                }),
      row_fault("a round less for each entry of a loop", [](Proof& proof) {
        for (Column& column : proof.rows.columns) {
          for (auto& [row, factor] : column.entries) {
            if (row == loop_row(proof) && factor < 0) factor += 1;
          }
        }
      })};
}

}  // namespace timing
