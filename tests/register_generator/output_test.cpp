// SPDX-License-Identifier: Apache-2.0
// What one description gives in VHDL and in C++.
#include <gmock/gmock.h>

#include "register_generator/description.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace register_generator;
using testing::HasSubstr;

class Output : public testing::Test {
 protected:
  void SetUp() override {
    const TemporaryFolder folder;
    folder.write("unit.toml", R"(
name = 'unit'
address = 0xF0009000
summary = 'A unit.'
[[constant]]
name = 'depth'
value = 12
summary = 'Bytes.'
[[register]]
name = 'mode'
access = 'read_write'
summary = 'How.'
[[register.field]]
name = 'speed'
bits = '10:8'
values = { slow = 1, fast = 6 }
reset = 6
summary = 'A speed.'
[[register.field]]
name = 'lit'
bits = 31
summary = 'Whether.'
)");
    const Peripheral unit = load(folder.path() / "unit.toml");
    package_ = vhdl_package(unit, "unit.toml");
    registers_ = vhdl_registers(unit, "unit.toml");
    header_ = cpp_file(unit, "unit.toml");
  }
  std::string package_, registers_, header_;
};

TEST_F(Output, names_the_places_of_fields_on_both_sides) {
  EXPECT_THAT(package_, HasSubstr("subtype unit_mode_speed_bits is natural range 10 downto 8;"));
  EXPECT_THAT(package_, HasSubstr("constant unit_mode_lit_bit : natural := 31;"));
  EXPECT_THAT(header_, HasSubstr("unsigned speed_low = 8, speed_width = 3;"));
  EXPECT_THAT(header_, HasSubstr("unsigned lit_bit = 31;"));
}

TEST_F(Output, gives_named_values_the_same_codes_on_both_sides) {
  EXPECT_THAT(package_, HasSubstr("constant unit_mode_speed_fast : natural := 6;"));
  EXPECT_THAT(header_, HasSubstr("enum class Speed : std::uint8_t"));
  EXPECT_THAT(header_, HasSubstr("fast = 6,"));
  EXPECT_THAT(header_, HasSubstr("Speed speed{};"));
}

TEST_F(Output, shares_constants) {
  EXPECT_THAT(package_, HasSubstr("constant unit_depth : natural := 12;"));
  EXPECT_THAT(header_, HasSubstr("depth = 12;"));
}

TEST_F(Output, makes_words_of_values_with_zeros_where_no_field_is) {
  EXPECT_THAT(package_, HasSubstr("return value.lit & \"00000000000000000000\" & "
                                  "std_ulogic_vector(value.speed) & \"00000000\";"));
  EXPECT_THAT(package_, HasSubstr("speed => unsigned(word(unit_mode_speed_bits)),"));
}

TEST_F(Output, keeps_what_is_stored_as_a_value_from_its_reset_on) {
  EXPECT_THAT(package_, HasSubstr("unit_mode_after_reset : unit_mode_t := "
                                  "(speed => 3x\"6\", lit => '0');"));
  EXPECT_THAT(registers_, HasSubstr("mode_stored <= to_unit_mode(written_data);"));
  EXPECT_THAT(registers_, HasSubstr("mode_word <= to_word(mode_stored)"));
}

}  // namespace
