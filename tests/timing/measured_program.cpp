// SPDX-License-Identifier: Apache-2.0
// Words, and the facts that are true of them.
#include "tests/timing/measured_program.hpp"

#include <algorithm>
#include <stdexcept>

namespace timing {

namespace {

namespace encode = processor::encode;
using encode::Word;

constexpr Word link = 1, stack = 2, kept = 9, counter = 6, bus = 13, rounds = 18;
constexpr std::uint32_t bus_word = 3;  // so many rounds, in two of which the event happens
constexpr std::uint32_t event = 7;

std::vector<Word> words() {
  const Word back = encode::jump_and_link_register(0, link, 0);
  return {encode::add_upper_to_pc(stack, 0),  // the stack is somewhere in the memory
          encode::add_immediate(stack, stack, 1024),
          encode::add_immediate(kept, link, 0),  // the function
          encode::add_immediate(counter, 0, 5),
          encode::add_immediate(counter, counter, -1),  // 4: a loop
          encode::load(2, 10, stack, 0),
          encode::add_immediate(10, 10, 1),
          encode::operation(0, 1, 11, 10, 10),
          encode::add_immediate(11, 11, 1),
          encode::operation(4, 1, 12, 11, 10),
          encode::load_upper(bus, 0xF0000000),
          encode::load(2, 14, bus, 0),
          encode::store(2, 14, bus, 4),
          encode::store(2, 14, stack, 4),
          encode::leading_zeros(15, 10),
          encode::add_immediate(15, 15, 1),
          encode::branch(1, counter, 0, -48),  // predicted to be taken
          encode::csr(2, 16, 0x340, 0),
          encode::fence_i(),
          encode::branch(0, 0, 0, 8),  // taken, not predicted
          encode::nop(),
          encode::branch(1, 0, 0, 8),
          encode::jump_and_link(0, 4),
          encode::load(2, 14, bus, 0),  // 23: a number that the code does not show
          encode::operation_immediate(7, 14, 14, 1),
          encode::operation_immediate(1, 14, 14, 4),
          encode::nop(),
          encode::operation(0, 0, 17, bus, 14),  // 27: some register of the bus
          encode::load(2, 16, 17, 0),
          encode::add_upper_to_pc(15, 0),
          encode::operation(0, 0, 15, 15, 14),
          encode::jump_and_link_register(link, 15, 4 * (50 - 29)),  // one of two functions
          encode::load_upper(bus, 0xF0000000),
          encode::load(2, rounds, bus, 0),
          encode::branch(0, rounds, 0, 20),  // 34: a loop whose rounds are declared
          encode::operation_immediate(7, 11, rounds, 1),
          encode::jump_and_link(link, 4 * (44 - 36)),
          encode::add_immediate(rounds, rounds, -1),
          encode::jump_and_link(0, -16),
          encode::add_immediate(10, 0, 4),  // 39: a constant argument
          encode::jump_and_link(link, 4 * (47 - 40)),
          encode::operation(4, 1, 12, 12, 10),
          encode::add_immediate(link, kept, 0),
          back,
          encode::branch(0, 11, 0, 8),  // 44: a function with an event
          encode::operation(4, 1, 12, rounds, rounds),
          back,
          encode::add_immediate(10, 10, -1),  // 47: a function with so many rounds
          encode::branch(1, 10, 0, -4),
          back,
          back,  // 50: the shorter of two functions
          encode::nop(),
          encode::nop(),
          encode::nop(),
          encode::operation(4, 1, 12, 16, 16),  // 54: the longer one
          back,
          MeasuredProgram::address(place::shorter),  // 56: a table of both
          MeasuredProgram::address(place::longer)};
}

Program program_with_facts() {
  Program program = program_of(words());
  const auto address = MeasuredProgram::address;
  program.code_end = address(place::table);
  program.symbols[address(place::function)] = {.name = "function", .size = 4};
  program.symbols[address(place::limited_choice)] = {.name = "limited", .size = 12};
  program.symbols[address(place::counted_function)] = {.name = "counted", .size = 12};
  program.symbols[address(place::shorter)] = {.name = "shorter", .size = 16};
  program.symbols[address(place::longer)] = {.name = "longer", .size = 8};
  program.functions_on_bus = {address(place::function)};
  program.call_tables = {
      {.place = address(place::call_by_table), .first = address(place::table), .bytes = 8}};
  program.markers = {{.address = address(place::declared_round), .most = bus_word}};
  program.event_markers = {
      {.address = address(place::run_begins),
       .event = event,
       .most = 2,
       .kind = EventMarker::begin},
      {.address = address(place::run_ends), .event = event, .most = 2, .kind = EventMarker::end},
      {.address = address(place::event_behind_run), .event = event},
      {.address = address(place::limited_event), .event = event}};
  return program;
}

}  // namespace

Address MeasuredProgram::address(std::size_t number) {
  return Program().memory_start + 4 * static_cast<Address>(number);
}

MeasuredProgram measured_program() {
  MeasuredProgram measured{.program = program_with_facts(), .steps = {}};
  // It returns to 0.
  measured.steps = trace(measured.program, 0, 4000, bus_word);
  std::erase_if(measured.steps, [](const Step& step) {
    return step.address != 0 && step.address < MeasuredProgram::address(place::function);
  });
  if (measured.steps.back().address != 0) throw std::runtime_error("the program does not end");
  const std::uint64_t begins = measured.steps.front().begins;
  measured.clocks = measured.steps.back().begins - begins;
  const auto loop = std::ranges::find(measured.steps, MeasuredProgram::address(place::run_begins),
                                      &Step::address);
  measured.span = loop->begins - begins;
  return measured;
}

}  // namespace timing
