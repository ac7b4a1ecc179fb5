-- SPDX-License-Identifier: Apache-2.0
-- Carries and comparisons of numbers of 64 bits, in units of 2^-64, without waiting for their sum.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package carries_pkg is

  -- Whether value + change reaches 1/2, of a value below it and a change of at most 1/2: the carry into the
  -- highest bit. The halves are added side by side, the upper one without and with a carry from the lower, so
  -- that the carry chain has half the length of the sum's own.
  function reaches_half(value : unsigned(62 downto 0); change : unsigned(63 downto 0)) return std_ulogic;

  -- Whether value + change is below the floor. The value is not, and the change is below 2^46 of the 2^64
  -- that make a rate of 1, so that a difference below 0 shows as one above 3/4. In the upper half, where the
  -- floor lies, three numbers become two without a carry: the comparison does not wait for the sum. In the
  -- lower half, where the carry chain begins, nothing lies before it.
  function falls_below(value : unsigned(63 downto 0); change : unsigned(63 downto 0);
    floor : unsigned(30 downto 0)) return std_ulogic;

end package;

package body carries_pkg is

  function reaches_half(value : unsigned(62 downto 0); change : unsigned(63 downto 0)) return std_ulogic is
    constant lower_sum : unsigned(32 downto 0) := resize(value(31 downto 0), 33) + change(31 downto 0);
    constant upper_sum : unsigned(31 downto 0) := ('0' & value(62 downto 32)) + change(63 downto 32);
    constant carried_sum : unsigned(32 downto 0) :=
      ('0' & value(62 downto 32) & '1') + (change(63 downto 32) & '1');
  begin
    return (lower_sum(32) and carried_sum(32)) or (not lower_sum(32) and upper_sum(31));
  end function;

  function falls_below(value : unsigned(63 downto 0); change : unsigned(63 downto 0);
    floor : unsigned(30 downto 0)) return std_ulogic is
    constant less_floor : unsigned(31 downto 0) := not ('0' & floor);
    constant upper : unsigned(31 downto 0) := value(63 downto 32);
    constant upper_change : unsigned(31 downto 0) := change(63 downto 32);
    constant carries : unsigned(31 downto 0) :=
      (upper and upper_change) or (upper and less_floor) or (upper_change and less_floor);
    variable difference : unsigned(63 downto 0);
  begin
    difference := ((upper xor upper_change xor less_floor) & value(31 downto 0)) +
                  (carries(30 downto 0) & '1' & change(31 downto 0));
    return difference(63) and difference(62);
  end function;

end package body;
