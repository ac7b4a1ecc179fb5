-- SPDX-License-Identifier: Apache-2.0
-- The arithmetic unit: sums, logic, shifts and comparisons of two words, within one clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity alu is
  port (
    first : in word_t;
    second : in word_t;
    -- In the coding of funct3.
    operation : in std_ulogic_vector(2 downto 0);
    -- Subtract instead of add, arithmetic instead of logical shift to the right.
    alternate : in std_ulogic;
    compare_unsigned : in std_ulogic;
    result : out word_t;
    equal : out std_ulogic;
    less : out std_ulogic
  );
end entity;

architecture rtl of alu is

  signal sum, difference, shifted_left, shifted_right, logical : word_t;
  signal arithmetic_or_left, conditional : word_t;
  signal wide_difference : unsigned(32 downto 0);
  signal first_carry, second_carry : std_ulogic;
  signal wide_shifted : signed(32 downto 0);
  signal distance : natural range 0 to 31;

begin

  sum <= std_ulogic_vector(unsigned(first) + unsigned(second));

  -- One bit more than the operands: then its top bit is the answer of both comparisons.
  first_carry <= first(31) and not compare_unsigned;
  second_carry <= second(31) and not compare_unsigned;
  wide_difference <= unsigned(first_carry & first) - unsigned(second_carry & second);
  difference <= std_ulogic_vector(wide_difference(31 downto 0));
  less <= wide_difference(32);
  equal <= first ?= second;

  distance <= to_integer(unsigned(second(4 downto 0)));
  shifted_left <= std_ulogic_vector(shift_left(unsigned(first), distance));
  wide_shifted <= shift_right(signed((first(31) and alternate) & first), distance);
  shifted_right <= std_ulogic_vector(wide_shifted(31 downto 0));

  -- operation: 0 add, 1 shift left, 2 less, 3 less unsigned, 4 xor, 5 shift right, 6 or, 7 and.
  arithmetic_or_left <= shifted_left when operation(0) else
                        difference when alternate else
                        sum;
  conditional <= (31 downto 1 => '0') & wide_difference(32) when operation(1) else
                 arithmetic_or_left;
  logical <= first and second when operation(1) and operation(0) else
           first or second when operation(1) else
           shifted_right when operation(0) else
           first xor second;
  result <= logical when operation(2) else conditional;

end architecture;
