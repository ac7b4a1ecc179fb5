// SPDX-License-Identifier: Apache-2.0
// From GHDL's Verilog to formal Verilog: nothing that was asserted may get lost on the way.
#include <gmock/gmock.h>

#include <stdexcept>

#include "tools/proof/formal_netlist.hpp"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* netlist = R"(module part
  (input  clk);
  wire n1_o;
  watch_it: assert n1_o = '1' severity warning; --  assume
  always @*
    if (!n1_o)
      $fatal(1, "assertion failure in_the_part");
endmodule

module whole
  (input  clk);
  wire [30:0] n7_o;
  wire n2_o;
  always @*
    if (!n2_o)
      $fatal(1, "assertion failure process_of_the_whole");
  relied_upon: assert n2_o = '1' severity warning; --  assume
   gate_anyconst inst_7 (
);
endmodule
)";

TEST(formal_netlist, assertions_are_asserted_and_assumptions_of_the_top_assumed) {
  const proof::FormalNetlist formal = proof::make_formal(netlist, "whole", {});
  EXPECT_THAT(formal.verilog, HasSubstr("process_of_the_whole: assert (n2_o);"));
  EXPECT_THAT(formal.verilog, HasSubstr("relied_upon: assume (n2_o);"));
  EXPECT_THAT(formal.verilog, Not(HasSubstr("$fatal")));
  EXPECT_THAT(formal.assumed, ElementsAre("relied_upon"));
}

TEST(formal_netlist, what_a_part_relies_on_is_asserted_of_the_whole) {
  const proof::FormalNetlist formal = proof::make_formal(netlist, "whole", {});
  EXPECT_THAT(formal.verilog, HasSubstr("watch_it: assert (n1_o);"));
  EXPECT_THAT(formal.asserted, ElementsAre("watch_it", "in_the_part", "process_of_the_whole"));
}

TEST(formal_netlist, a_free_signal_becomes_a_free_register_of_its_width) {
  const proof::FormalNetlist formal = proof::make_formal(netlist, "whole", {});
  EXPECT_THAT(formal.verilog, HasSubstr("(* anyconst *) reg [30:0] n7_o;"));
  EXPECT_THAT(formal.verilog, Not(HasSubstr("gate_any")));
}

TEST(formal_netlist, only_the_named_properties_are_asserted) {
  const proof::FormalNetlist formal =
      proof::make_formal(netlist, "whole", {.only = {"of_the_whole"}});
  EXPECT_THAT(formal.asserted, ElementsAre("process_of_the_whole"));
  EXPECT_THAT(proof::make_formal(netlist, "whole", {.except = {"of_the_whole"}}).asserted,
              ElementsAre("watch_it", "in_the_part"));
}

TEST(formal_netlist, the_assertions_of_a_part_that_is_free_do_not_count) {
  EXPECT_THAT(proof::make_formal(netlist, "whole", {.free = {"part"}}).asserted,
              ElementsAre("process_of_the_whole"));
}

TEST(formal_netlist, the_assertions_of_a_copy_that_is_free_do_not_count) {
  constexpr const char* copies =
      "module whole\n"
      "    if (!n1_o)\n"
      "      $fatal(1, \"assertion failure unit_each_n1_holds\");\n"
      "    if (!n2_o)\n"
      "      $fatal(1, \"assertion failure unit_each_n2_holds\");\n"
      "    if (!n3_o)\n"
      "      $fatal(1, \"assertion failure unit_each_n22_holds\");\n"
      "endmodule\n";
  EXPECT_THAT(proof::make_formal(copies, "whole", {.free_copies = {"each_n2"}}).asserted,
              ElementsAre("unit_each_n1_holds", "unit_each_n22_holds"));
}

TEST(formal_netlist, a_property_that_is_not_there_is_an_error) {
  EXPECT_THROW(proof::make_formal(netlist, "whole", {.only = {"missing"}}), std::runtime_error);
  EXPECT_THROW(proof::make_formal(netlist, "whole", {.except = {"the_whole_of_it"}}),
               std::runtime_error);
}

TEST(formal_netlist, an_unknown_form_of_a_property_is_an_error_and_not_lost) {
  constexpr const char* strange = "module whole\n  if (x) $error(\"assertion failure here\");\n";
  EXPECT_THROW(proof::make_formal(strange, "whole", {}), std::runtime_error);
}

TEST(formal_netlist, a_property_is_found_behind_the_names_of_its_process_and_instance) {
  EXPECT_TRUE(proof::is_property("holds", "holds"));
  EXPECT_TRUE(proof::is_property("watch_holds", "holds"));
  EXPECT_TRUE(proof::is_property("axis.holds", "holds"));
  EXPECT_FALSE(proof::is_property("upholds", "holds"));
  EXPECT_FALSE(proof::is_property("holds_too", "holds"));
}

}  // namespace
