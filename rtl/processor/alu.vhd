-- SPDX-License-Identifier: Apache-2.0
-- ALU: sums, logic, shifts and comparisons of two words, combinational.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity alu is
  generic (
    -- Zbb: andn, orn, xnor and rotations.
    has_zbb : boolean := false
  );
  port (
    first : in word_t;
    second : in word_t;
    -- As funct3; 5 without `shift` passes `second`.
    operation : in std_ulogic_vector(2 downto 0);
    shift : in std_ulogic;
    -- Subtract instead of add; with Zbb also inverts the second operand of logic.
    subtract : in std_ulogic;
    -- Arithmetic instead of logical right shift.
    arithmetic_shift : in std_ulogic;
    -- With Zbb: rotate instead of shift.
    rotate : in std_ulogic := '0';
    compare_unsigned : in std_ulogic;
    result : out word_t;
    less : out std_ulogic;
    comparison : out comparison_t
  );
end entity;

architecture rtl of alu is

  signal addend, logic_operand, shifted, without_sum, without_shift, logical : word_t;
  signal signs_differ, is_left, fill : std_ulogic;
  signal sum, difference, reverse_difference : unsigned(32 downto 0);
  signal above, below : std_ulogic_vector(30 downto 0);
  signal to_shift : unsigned(62 downto 0);
  signal distance : natural range 0 to 31;

begin

  -- One adder: an extra lowest bit is the carry in.
  addend <= second xor (31 downto 0 => subtract);
  sum <= unsigned(first & '1') + unsigned(addend & subtract);

  -- Critical path of branches: two subtractors of their own, with no gate before their carry chains.
  difference <= unsigned('0' & first) - unsigned('0' & second);
  reverse_difference <= unsigned('0' & second) - unsigned('0' & first);
  signs_differ <= (first(31) xor second(31)) and not compare_unsigned;
  less <= difference(32) xor signs_differ;
  comparison <= (
    below => difference(32), above => reverse_difference(32), signs_differ => signs_differ);

  -- One right shifter for all: a left shift by n is a right shift of 63 bits by 31 - n.
  is_left <= not operation(2);
  fill <= first(31) and arithmetic_shift;
  above <= first(30 downto 0) when has_zbb and rotate = '1' else (others => fill);
  below <= first(31 downto 1) when has_zbb and rotate = '1' else (others => '0');
  to_shift <= unsigned(first & below) when is_left else unsigned(above & first);
  distance <= to_integer(unsigned(second(4 downto 0) xor (4 downto 0 => is_left)));
  shifted <= std_ulogic_vector(resize(shift_right(to_shift, distance), 32));

  -- operation: 0 add, 1 shift left, 2 less, 3 less unsigned, 4 xor, 5 shift right or `second`, 6 or,
  -- 7 and.
  -- Shifts settle last, then sums: they are multiplexed last.
  without_sum <= logical when operation(2) else (31 downto 1 => '0') & less;
  without_shift <= without_sum when operation(2) or operation(1) else
                   std_ulogic_vector(sum(32 downto 1));
  logic_operand <= addend when has_zbb else second;
  logical <= first and logic_operand when operation(1) and operation(0) else
             first or logic_operand when operation(1) else
             second when operation(0) else
             first xor logic_operand;
  result <= shifted when shift else without_shift;

end architecture;
