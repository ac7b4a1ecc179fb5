-- SPDX-License-Identifier: Apache-2.0
-- The ALU computes what the instruction set specifies, for all operands.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity alu_proof is
  port (
    clk : in std_ulogic;
    first : in value_t;
    second : in value_t;
    operation : in std_ulogic_vector(2 downto 0);
    shifts : in std_ulogic;
    subtract : in std_ulogic;
    arithmetic_shift : in std_ulogic;
    compare_unsigned : in std_ulogic
  );
end entity;

architecture proof of alu_proof is

  -- The register-register instruction for this operation; a shift does not subtract.
  signal word : value_t;
  signal alternate : std_ulogic;
  signal result : value_t;
  signal less : std_ulogic;
  signal compared : comparison_t;

  default clock is rising_edge(clk);

begin

  alternate <= arithmetic_shift when shifts else subtract;
  word <= '0' & alternate & 15x"0" & operation & "00000" & "0110011";

  arithmetic : entity work.alu
    port map (
      first => first,
      second => second,
      operation => operation,
      shift => shifts,
      subtract => subtract,
      arithmetic_shift => arithmetic_shift,
      compare_unsigned => compare_unsigned,
      result => result,
      less => less,
      comparison => compared);

  only_shifts_shift : assume always (shifts -> operation(1 downto 0) = "01");
  compare_unsigned_matches_operation : assume always
    (operation(2 downto 1) = "01" -> compare_unsigned = operation(0));

  sums_and_differences_are_right : assert always
    ((shifts = '0' and operation = "000") -> result = sum(word, first, second));
  shifts_by_any_distance_are_right : assert always
    (shifts -> result = shift(word, first, second));
  comparisons_give_one_or_zero : assert always
    (operation(2 downto 1) = "01" -> result = comparison(word, first, second));
  logic_operations_are_right : assert always
    ((operation(2) = '1' and operation(1 downto 0) /= "01") -> result = logic(word, first, second));
  second_operand_passes_unchanged : assert always
    ((shifts = '0' and operation = "101") -> result = second);
  below_is_unsigned_less : assert always
    ((compared.below = '1') = (unsigned(first) < unsigned(second)));
  above_is_unsigned_greater : assert always
    ((compared.above = '1') = (unsigned(first) > unsigned(second)));
  signs_differ_is_right : assert always
    ((compared.signs_differ = '1') = (compare_unsigned = '0' and first(31) /= second(31)));
  signed_less_is_right : assert always
    (not compare_unsigned -> (less = '1') = (signed(first) < signed(second)));
  unsigned_less_is_right : assert always
    (compare_unsigned -> (less = '1') = (unsigned(first) < unsigned(second)));

end architecture;
