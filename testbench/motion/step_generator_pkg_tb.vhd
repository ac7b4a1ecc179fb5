-- SPDX-License-Identifier: Apache-2.0
-- The constants that a chip starts with are what drivers and software rely on.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;

entity step_generator_pkg_tb is
end entity;

architecture simulation of step_generator_pkg_tb is

  constant clock_hz : real := 50.0e6;

  -- A time in clocks, none too few and none too many.
  procedure check(name : string; clocks : unsigned; seconds : real) is
  begin
    assert to_integer(clocks) = integer(seconds * clock_hz)
      report name & " after reset is " & integer'image(to_integer(clocks)) & " clocks" severity failure;
  end procedure;

begin

  test : process
    variable one : unsigned(34 downto 0);
  begin
    -- An A4988's data sheet: 1 us high and low, 200 ns around a change of direction.
    check("high time", guard_after_reset.high, 1.0e-6);
    check("low time", guard_after_reset.low, 1.0e-6);
    check("set-up time", guard_after_reset.direction_setup, 200.0e-9);
    check("hold time", guard_after_reset.direction_hold, 200.0e-9);

    -- 100 ticks/s at the same clock.
    assert abs (real(to_integer(rate_floor_after_reset)) / 2.0 ** 32 * clock_hz - 100.0) < 0.01
      report "the floor of the rate" severity failure;

    -- A scale of one owes one base clock in each clock, and nothing else.
    one := '0' & scale_of_one;
    assert one(34 downto 32) = 1 and one(31 downto 0) = 0 report "scale of one" severity failure;

    -- Nothing stops a segment that names no condition.
    assert (or stop_condition_none.mask) = '0' and stop_condition_none.on_change = '0'
      and stop_condition_none.on_release = '0' and stop_condition_none.brakes = '0'
      report "no condition" severity failure;

    assert (or stop_cause_none.end_stops) = '0' and stop_cause_none.emergency_input = '0'
      and stop_cause_none.software = '0' and stop_cause_none.watchdog = '0'
      and stop_cause_none.software_brake = '0'
      report "no cause" severity failure;

    finish;
  end process;

end architecture;
