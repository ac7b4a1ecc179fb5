// SPDX-License-Identifier: Apache-2.0
// The stack of short programs, and that of the images for the chip.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/timing/short_program.hpp"
#include "tools/timing/stack.hpp"

namespace timing {
namespace {

namespace encode = processor::encode;
using encode::Word;

constexpr Word zero = 0, ra = 1, sp = 2, t0 = 5, a0 = 10, a5 = 15;
const Word back = encode::jump_and_link_register(zero, ra, 0);

Word move_stack(std::int32_t bytes) { return encode::add_immediate(sp, sp, bytes); }

struct Found {
  std::optional<std::uint32_t> bytes;
  std::string problem;
};

Found found(const Program& program) {
  Stack stack(program, true);
  const auto bytes = stack.depth(program.first);
  return {bytes, stack.problems().empty() ? "" : stack.problems().begin()->what};
}

TEST(Stack, of_a_function_is_its_frame_and_the_deepest_of_its_calls) {
  // 32 bytes, in which it calls what takes 48; 64 on another path, without a call.
  Program program =
      program_of({encode::branch(0, a0, zero, 20), move_stack(-32), encode::jump_and_link(ra, 24),
                  move_stack(32), back,  // at 20
                  move_stack(-64), move_stack(64), back, move_stack(-48), move_stack(48), back});
  // The call of the word at 8 goes to that at 32.
  program.symbols[program.first + 32] = {.name = "called", .size = 12};
  EXPECT_EQ(found(program).bytes, 80U);
}

TEST(Stack, of_a_call_in_place_of_a_return_is_that_of_both) {
  Program program = program_of({move_stack(-32), move_stack(32), encode::jump_and_link(zero, 4),
                                move_stack(-16), move_stack(16), back});
  program.symbols[program.first + 12] = {.name = "other", .size = 12};
  EXPECT_EQ(found(program).bytes, 32U);
  // With the frame still there.
  program = program_of(
      {move_stack(-32), encode::jump_and_link(zero, 4), move_stack(-16), move_stack(48), back});
  program.symbols[program.first + 8] = {.name = "other", .size = 12};
  EXPECT_EQ(found(program).bytes, 48U);
}

TEST(Stack, that_common_code_saves_registers_in_counts) {
  Program program = program_of({encode::jump_and_link(t0, 16), move_stack(-16), move_stack(16),
                                encode::jump_and_link(zero, 12), move_stack(-64),
                                encode::jump_and_link_register(zero, t0, 0), move_stack(64), back});
  program.symbols[program.first + 16] = {.name = "__riscv_save_4", .size = 8};
  program.symbols[program.first + 24] = {.name = "__riscv_restore_4", .size = 8};
  EXPECT_EQ(found(program).bytes, 80U);
}

TEST(Stack, below_the_pointer_counts) {
  EXPECT_EQ(found(program_of({encode::store(2, a0, sp, -8), back})).bytes, 8U);
  EXPECT_EQ(
      found(program_of({encode::add_immediate(a5, sp, -16), encode::store(2, a0, a5, -4), back}))
          .bytes,
      20U);
}

TEST(Stack, is_not_known_where_the_pointer_is_not) {
  EXPECT_FALSE(found(program_of({encode::operation(0, 0, sp, sp, a0), encode::nop(), back})).bytes);
  EXPECT_FALSE(
      found(program_of({encode::branch(0, a0, zero, 8), move_stack(-16), encode::nop(), back}))
          .bytes);
}

TEST(Stack, of_a_function_that_calls_itself_is_not_known) {
  EXPECT_EQ(found(program_of({move_stack(-16), encode::branch(0, a0, zero, 8),
                              encode::jump_and_link(ra, -8), move_stack(16), back}))
                .problem,
            "the function calls itself, or others that call it");
}

// A call through a pointer; two functions, whose addresses stand behind the code.
Program with_a_table() {
  Program program = program_of(
      {encode::load(2, a5, a0, 0), encode::jump_and_link_register(ra, a5, 0), back, move_stack(-32),
       move_stack(32), back, move_stack(-96), move_stack(96), back, 0x8000000C, 'S', 0x80000018});
  program.code_end = program.first + 36;
  program.symbols[program.first + 12] = {.name = "one", .size = 12};
  program.symbols[program.first + 24] = {.name = "two", .size = 12};
  return program;
}

TEST(Stack, of_a_call_through_a_table_is_the_deepest_of_all_in_it) {
  Program program = with_a_table();
  EXPECT_EQ(found(program).problem, "the function called here is not known");
  const CallTable table{.place = program.first + 4, .first = program.code_end, .bytes = 12};
  program.call_tables = {table};
  EXPECT_EQ(found(program).bytes, 96U);
  EXPECT_TRUE(bound_of(program, true_costs()));
  program.call_tables[0].bytes = 8;
  EXPECT_EQ(found(program).bytes, 32U);
  program.call_tables[0] = table;
  program.call_tables[0].place = program.first + 12;  // in another function
  EXPECT_FALSE(found(program).bytes);
}

TEST(Stack, each_call_through_a_pointer_needs_its_declaration) {
  Program program = with_a_table();
  program.call_tables = {{.place = program.first, .first = program.code_end, .bytes = 12}};
  const auto call = encode::jump_and_link_register(ra, a5, 0);
  for (unsigned i = 0; i < 4; ++i) {
    program.bytes[4 + i] = program.bytes[8 + i] = static_cast<std::uint8_t>(call >> 8 * i);
  }
  EXPECT_EQ(found(program).problem, "the function called here is not known");
}

TEST(Stack, a_declaration_that_is_not_reached_counts_for_no_other_call) {
  // a1 is 0: the branch jumps over the declared call.
  Program program = program_of({encode::add_immediate(11, zero, 0), encode::branch(0, 11, zero, 12),
                                encode::nop(), encode::jump_and_link_register(ra, a5, 0),
                                encode::jump_and_link_register(ra, a0, 0), back, 0x80000014});
  program.code_end = program.first + 24;
  program.call_tables = {{.place = program.first + 8, .first = program.code_end, .bytes = 4}};
  EXPECT_EQ(found(program).problem, "the function called here is not known");
}

TEST(Stack, of_a_call_through_a_table_that_may_change_is_not_known) {
  Program program = with_a_table();
  program.call_tables = {{.place = program.first + 4, .first = program.code_end + 4, .bytes = 12}};
  EXPECT_EQ(found(program).problem, "the function called here is not known");
}

TEST(Stack, of_what_is_called_outside_the_code_is_not_known) {
  const Program program = program_of(
      {encode::load_upper(a5, 0x90000000), encode::jump_and_link_register(ra, a5, 0), back});
  EXPECT_EQ(found(program).problem, "what is called here lies outside the code");
}

class StackOfImage : public testing::TestWithParam<const char*> {};

TEST_P(StackOfImage, fits_into_what_is_left_for_it) {
  const Program program =
      read_program(fmt::format("{}/firmware/{}.elf", BUILD_DIRECTORY, GetParam()));
  Stack stack(program, CHIP_HAS_ZBB);
  const auto bytes = stack.of_image();
  for (const Problem& problem : stack.problems()) {
    ADD_FAILURE() << problem.place << ": in " << problem.function << ": " << problem.what;
  }
  ASSERT_TRUE(bytes);
  fmt::print("{} of {} bytes\n", *bytes, program.addresses.at("least_stack_bytes"));
  EXPECT_LE(*bytes, program.addresses.at("least_stack_bytes"));
  // A fault is reported on the whole stack.
  EXPECT_LE(stack.depth(program.addresses.at("report_trap")), *bytes);
}

INSTANTIATE_TEST_SUITE_P(images, StackOfImage,
                         testing::Values("firmware", "software_stepping",
                                         "printing_benchmark_hardware",
                                         "printing_benchmark_software", "link_benchmark_3000000"),
                         [](const auto& image) { return std::string(image.param); });

}  // namespace
}  // namespace timing
