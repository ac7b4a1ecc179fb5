-- SPDX-License-Identifier: Apache-2.0
-- What an instruction writes to its register, but for loads and CSRs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

entity result_checks is
  port (
    clk : in std_ulogic;
    -- An instruction writes this value.
    writes : in std_ulogic;
    value : in value_t;
    word : in value_t;
    address, link : in unsigned(31 downto 0);
    -- Contents of its registers; the second one or the immediate.
    first, second, operand : in value_t
  );
end entity;

architecture proof of result_checks is

  signal kind : kind_t;
  signal expected : value_t;

  default clock is rising_edge(clk);

begin

  kind <= kind_of(word);
  expected <= std_ulogic_vector(immediate_u(word)) when kind = load_upper else
              std_ulogic_vector(address + immediate_u(word)) when kind = add_upper else
              std_ulogic_vector(link) when kind = jump or kind = jump_register else
              stand_in(word(14 downto 12), first, second) when kind = multiplication or kind = division else
              sum(word, first, operand) when word(14 downto 12) = "000" else
              shift(word, first, operand) when word(13 downto 12) = "01" else
              comparison(word, first, operand) when word(14) = '0' else
              logic(word, first, operand);

  upper_immediates_are_right : assert always
    ((writes = '1' and (kind = load_upper or kind = add_upper)) -> value = expected);
  links_are_right : assert always
    ((writes = '1' and (kind = jump or kind = jump_register)) -> value = expected);
  sums_are_right : assert always
    ((writes = '1' and kind = operation and word(14 downto 12) = "000") -> value = expected);
  shifts_are_right : assert always
    ((writes = '1' and kind = operation and word(13 downto 12) = "01") -> value = expected);
  comparisons_are_right : assert always
    ((writes = '1' and kind = operation and word(14 downto 13) = "01") -> value = expected);
  logic_is_right : assert always
    ((writes = '1' and kind = operation and word(14) = '1' and word(13 downto 12) /= "01") ->
     value = expected);
  products_and_quotients_are_right : assert always
    ((writes = '1' and (kind = multiplication or kind = division)) -> value = expected);

end architecture;
