// SPDX-License-Identifier: Apache-2.0
// Descriptions that the generator reads, and those that it refuses.
#include "register_generator/description.hpp"

#include <gmock/gmock.h>

#include "tests/temporary_folder.hpp"

namespace {

using namespace register_generator;
using testing::HasSubstr;

Peripheral read(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("unit.toml", "name = 'unit'\naddress = 0xF0009000\nsummary = 'A unit.'\n" + text);
  return load(folder.path() / "unit.toml");
}

std::string refusal_of(const std::string& text) {
  try {
    read(text);
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* wide =
    "[[register]]\nname = 'time'\naccess = 'read'\nread_event = true\nsummary = 'Clocks.'\n"
    "[[register.field]]\nname = 'clocks'\nbits = '63:0'\nsummary = 'Since reset.'\n";
constexpr const char* plain =
    "[[register]]\nname = 'state'\naccess = 'read'\nsummary = 'A state.'\n"
    "[[register.field]]\nname = 'busy'\nbits = 0\nsummary = 'On.'\n";

TEST(Description, makes_two_registers_of_64_bits_the_low_word_first) {
  const Peripheral unit = read(std::string(wide) + plain);
  ASSERT_EQ(unit.registers.size(), 3u);
  EXPECT_EQ(unit.registers[0].name, "time_low");
  EXPECT_EQ(unit.registers[0].offset, 0u);
  EXPECT_TRUE(unit.registers[0].read_event);
  EXPECT_EQ(unit.registers[1].name, "time_high");
  EXPECT_EQ(unit.registers[1].offset, 4u);
  EXPECT_FALSE(unit.registers[1].read_event);
  EXPECT_EQ(unit.registers[2].offset, 8u);
  ASSERT_EQ(unit.wide_registers.size(), 1u);
  EXPECT_EQ(unit.wide_registers[0].field, "clocks");
}

TEST(Description, takes_the_registers_of_included_files_behind_its_own) {
  const TemporaryFolder folder;
  folder.write("unit.toml", std::string("name = 'unit'\naddress = 0xF0009000\nsummary = 'A unit.'\n"
                                        "include = ['unit_more.toml']\n") +
                                plain);
  folder.write("unit_more.toml", wide);
  const Peripheral unit = load(folder.path() / "unit.toml");
  ASSERT_EQ(unit.registers.size(), 3u);
  EXPECT_EQ(unit.registers[0].name, "state");
  EXPECT_EQ(unit.registers[1].name, "time_low");
  EXPECT_EQ(unit.registers[1].offset, 4u);
  EXPECT_THAT(description_files(folder.path()), testing::ElementsAre(folder.path() / "unit.toml"));
}

TEST(Description, names_the_included_file_that_is_wrong) {
  const TemporaryFolder folder;
  folder.write("unit.toml", std::string("name = 'unit'\naddress = 0xF0009000\nsummary = 'A unit.'\n"
                                        "include = ['unit_more.toml']\n") +
                                plain);
  const auto refusal = [&]() -> std::string {
    try {
      load(folder.path() / "unit.toml");
    } catch (const DescriptionError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(), HasSubstr("unit_more.toml"));  // There is none.
  folder.write("unit_more.toml", plain);
  EXPECT_THAT(refusal(), HasSubstr("unit_more.toml: state: is described twice"));
  folder.write("unit_more.toml", "name = 'more'\n");
  EXPECT_THAT(refusal(), HasSubstr("unit_more.toml: top level: unknown key 'name'"));
}

TEST(Description, gives_each_half_of_64_bits_its_own_access_and_reset) {
  const Peripheral unit = read(
      "[[register]]\nname = 'deadline'\naccess_low = 'read_write'\naccess_high = 'external'\n"
      "summary = 'When.'\n[[register.field]]\nname = 'clocks'\nbits = '63:0'\nreset = 7\n"
      "summary = 'Since reset.'\n");
  ASSERT_EQ(unit.registers.size(), 2u);
  EXPECT_EQ(unit.registers[0].access, Access::read_write);
  EXPECT_EQ(unit.registers[0].fields[0].reset, 7u);
  EXPECT_EQ(unit.registers[1].access, Access::external);
  EXPECT_EQ(unit.registers[1].fields[0].reset, 0u);
}

TEST(Description, refuses_64_bits_with_company) {
  EXPECT_THAT(refusal_of(std::string(wide) +
                         "[[register.field]]\nname = 'more'\nbits = 3\nsummary = 'More.'\n"),
              HasSubstr("time: 64 bits are one field alone"));
}

TEST(Description, refuses_a_reserved_word_of_vhdl_or_cpp_as_a_name) {
  for (const std::string name : {"on", "signal", "register", "default"}) {
    const auto field = "[[register.field]]\nname = '" + name + "'\nbits = 3\nsummary = 'More.'\n";
    EXPECT_THAT(refusal_of(plain + field), HasSubstr("'" + name + "' is a reserved word"));
  }
}

TEST(Description, refuses_a_constant_without_a_value) {
  EXPECT_THAT(refusal_of(std::string("[[constant]]\nname = 'depth'\nsummary = 'Bytes.'\n") + plain),
              HasSubstr("depth: needs a 'value'"));
}

Peripheral with_interrupt(const char* name, const char* number) {
  return read(std::string("[[interrupt]]\nname = '") + name + "'\nnumber = " + number +
              "\nsummary = 'It happens.'\n" + plain);
}

TEST(Interrupts, come_in_the_order_of_their_numbers) {
  const auto all = interrupts_of({with_interrupt("late", "20"), with_interrupt("early", "16")});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "early");
  EXPECT_EQ(all[0].peripheral, "unit");
  EXPECT_EQ(all[1].number, 20u);
}

TEST(Interrupts, share_neither_name_nor_number) {
  EXPECT_THROW(interrupts_of({with_interrupt("one", "16"), with_interrupt("other", "16")}),
               DescriptionError);
  EXPECT_THROW(interrupts_of({with_interrupt("one", "16"), with_interrupt("one", "17")}),
               DescriptionError);
  EXPECT_THAT(refusal_of("[[interrupt]]\nname = 'far'\nnumber = 32\nsummary = 'Far.'\n" +
                         std::string(plain)),
              HasSubstr("far: 'number' must be"));
}

}  // namespace
