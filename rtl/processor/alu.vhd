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
    -- In the coding of funct3; 5 gives `second` as it is where `shift` is low.
    operation : in std_ulogic_vector(2 downto 0);
    shift : in std_ulogic;
    -- Subtract instead of add; needed for comparisons, too.
    subtract : in std_ulogic;
    -- Arithmetic instead of logical shift to the right.
    arithmetic_shift : in std_ulogic;
    compare_unsigned : in std_ulogic;
    result : out word_t;
    equal : out std_ulogic;
    less : out std_ulogic
  );
end entity;

architecture rtl of alu is

  signal addend, shifted, conditional, logical : word_t;
  signal first_sign, second_sign, is_left, fill : std_ulogic;
  signal sum : unsigned(33 downto 0);
  signal to_shift : unsigned(62 downto 0);
  signal distance : natural range 0 to 31;

begin

  -- One adder for all: with a bit below, from which the carry comes, and one above, which answers
  -- both comparisons.
  addend <= second xor (31 downto 0 => subtract);
  first_sign <= first(31) and not compare_unsigned;
  second_sign <= (second(31) and not compare_unsigned) xor subtract;
  sum <= unsigned(first_sign & first & '1') + unsigned(second_sign & addend & subtract);
  less <= sum(33);
  equal <= first ?= second;

  -- One shifter to the right for all: a shift to the left is one by 31 less from 31 bits above.
  is_left <= not operation(2);
  fill <= first(31) and arithmetic_shift;
  to_shift <= unsigned(first) & (30 downto 0 => '0') when is_left else
              (30 downto 0 => fill) & unsigned(first);
  distance <= to_integer(unsigned(second(4 downto 0) xor (4 downto 0 => is_left)));
  shifted <= std_ulogic_vector(resize(shift_right(to_shift, distance), 32));

  -- operation: 0 add, 1 shift left, 2 less, 3 less unsigned, 4 xor, 5 shift right or `second`, 6 or,
  -- 7 and.
  conditional <= (31 downto 1 => '0') & sum(33) when operation(1) else
                 std_ulogic_vector(sum(32 downto 1));
  logical <= first and second when operation(1) and operation(0) else
             first or second when operation(1) else
             second when operation(0) else
             first xor second;
  result <= shifted when shift else
            logical when operation(2) else
            conditional;

end architecture;
