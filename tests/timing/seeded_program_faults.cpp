// SPDX-License-Identifier: Apache-2.0
// What the analysis takes the image for: costs, ways, addresses, facts.
#include <fmt/format.h>

#include <algorithm>

#include "tests/timing/cost_rows.hpp"
#include "tests/timing/seeded_faults.hpp"

namespace timing {

namespace {

namespace encode = processor::encode;

constexpr auto address = MeasuredProgram::address;
constexpr std::uint32_t set_bits = 2, status_register = 0x300;

void add_to(unsigned& cost, int fault) {
  cost = static_cast<unsigned>(static_cast<int>(cost) + fault);
}

}  // namespace

std::vector<Fault> wrong_costs() {
  std::vector<Fault> faults;
  for (const CostRow& row : cost_rows_without({&Costs::trap_return, &Costs::wait})) {
    const auto add = [&](const char* what, Check finds, int fault) {
      faults.push_back({.kind = "a wrong cost",
                        .name = fmt::format("{} {}", row.name, what),
                        .finds = finds,
                        .seed = [row, fault](Tool& tool) { add_to(tool.costs.*row.cost, fault); }});
    };
    add("a clock too much", cost_sum, 1);
    add("a clock too little, by the sum", cost_sum, -1);
    add("a clock too little, by the bound", measured_time, -1);
  }
  return faults;
}

std::vector<Fault> wrong_flow() {
  return {
      {"an edge lost", "to the division behind a condition", measured_time,
       [](Tool& tool) { tool.replace(place::limited_choice, encode::jump_and_link(0, 8)); }},
      {"an edge lost", "back to the start of a declared loop", measured_time,
       [](Tool& tool) { tool.replace(place::back, encode::nop()); }},
      {"an edge lost", "out of a jump to itself, which is no halt", refusal,
       [](Tool& tool) { tool.replace(place::limited_choice, encode::jump_and_link(0, 0)); }},
      {"an edge too much", "into the middle of a loop", refusal,
       [](Tool& tool) { tool.replace(place::run_begins - 1, encode::branch(0, 10, 0, 12)); }},
      {"a call's target wrong", "the shorter of two functions", measured_time,
       [](Tool& tool) {
         tool.replace(place::call_by_table,
                      encode::jump_and_link(1, 4 * (place::shorter - place::call_by_table)));
       }},
      {"a call's target missing", "the longer one in a table", measured_time,
       [](Tool& tool) { tool.program.call_tables[0].bytes = 4; }},
      {"a call's target missing", "the whole table", refusal,
       [](Tool& tool) { tool.program.call_tables.clear(); }},
      {"a call's target missing", "the table may change", refusal,
       [](Tool& tool) { tool.program.call_tables[0].first = 0x9000'0000; }},
      {"a call's target missing", "the code ends before it", measured_time,
       [](Tool& tool) { tool.program.code_end = address(place::longer); }},
      {"a call's target wrong", "outside the code", refusal,
       [](Tool& tool) {
         tool.replace(place::known_call,
                      encode::jump_and_link(1, 4 * (place::table - place::known_call)));
       }},
      {"a call's target wrong", "the function itself", refusal,
       [](Tool& tool) {
         tool.replace(
             place::known_call,
             encode::jump_and_link(1, -4 * static_cast<int>(place::known_call - place::function)));
       }},
      {"a return too early", "of a function with an event", measured_time,
       [](Tool& tool) {
         tool.replace(place::limited_choice, encode::jump_and_link_register(0, 1, 0));
       }},
      {"an address wrong", "the bus taken for memory", measured_time,
       [](Tool& tool) { tool.program.memory_start = 0xF000'0000; }},
      {"an address wrong", "a bus address that is not known priced as memory", measured_time,
       [](Tool& tool) { tool.replace(place::bus_address, encode::add_immediate(17, 2, 0)); }},
      {"an access lost", "of a function of which the source says nothing", refusal,
       [](Tool& tool) { tool.program.functions_on_bus.emplace(); }},
      {"an access lost", "of a sample on the bus", cost_sum,
       [](Tool& tool) { std::ranges::find(tool.steps, true, &Step::on_bus)->on_bus = false; }},
      {"an instruction lost", "of the samples", cost_sum,
       [](Tool& tool) { tool.steps.erase(tool.steps.begin() + 1); }},
      {"a stall left out", "of a late product, in the sum", cost_sum,
       [](Tool& tool) { tool.replace(place::reads_product, encode::add_immediate(11, 12, 1)); }},
      {"a stall left out", "of a late product, in the bound", measured_time,
       [](Tool& tool) { tool.replace(place::reads_product, encode::add_immediate(11, 12, 1)); }},
      {"an assumption broken", "an interrupt runs code", refusal,
       [](Tool& tool) {
         tool.replace(place::counted_loop, encode::csr(set_bits, 0, status_register, 5));
       }},
      {"a span wrong", "its end before the loop in it", measured_span,
       [](Tool& tool) { tool.span_end = address(place::counted_loop); }}};
}

std::vector<Fault> wrong_facts() {
  return {{"a loop bound too small", "a declared one", measured_time,
           [](Tool& tool) { tool.program.markers[0].most -= 1; }},
          {"a loop bound too small", "by a constant of the code", measured_time,
           [](Tool& tool) { tool.replace(place::counter, encode::add_immediate(6, 0, 4)); }},
          {"a loop bound too small", "by a constant argument", measured_time,
           [](Tool& tool) { tool.replace(place::behind_loop, encode::add_immediate(10, 0, 3)); }},
          {"a loop bound missing", "of a declared loop", refusal,
           [](Tool& tool) { tool.program.markers.clear(); }},
          {"a loop bound missing", "its marker outside the loop", refusal,
           [](Tool& tool) { tool.program.markers[0].address = address(place::behind_loop); }},
          {"a loop bound missing", "its object ends in the loop", refusal,
           [](Tool& tool) {
             tool.program.markers.push_back(tool.program.markers[0]);
             tool.program.markers.back().address = address(place::behind_limited_call);
             tool.program.markers.back().is_end = 1;
           }},
          {"a fact too tight", "an event less", measured_time,
           [](Tool& tool) { tool.program.event_markers[0].most -= 1; }},
          {"a fact too tight", "on all ways", refusal,
           [](Tool& tool) {
             tool.program.event_markers[0].most = 0;
             tool.program.event_markers.erase(tool.program.event_markers.begin() + 1);
           }},
          {"an event at a wrong place", "in each round", measured_time,
           [](Tool& tool) {
             tool.program.event_markers.back().address = address(place::behind_limited_call);
           }},
          {"a run too long", "its end lost", measured_time,
           [](Tool& tool) {
             tool.program.event_markers.erase(tool.program.event_markers.begin() + 1);
           }},
          {"a run too long", "over the function", measured_time, [](Tool& tool) {
             tool.program.event_markers[0].address = address(place::counted_loop);
             tool.program.event_markers[1].address = address(place::event_behind_run + 1);
             std::swap(tool.program.event_markers[1], tool.program.event_markers[2]);
           }}};
}

}  // namespace timing
