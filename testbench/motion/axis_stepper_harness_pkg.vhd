-- SPDX-License-Identifier: Apache-2.0
-- The pins of an axis_stepper as records, and the lines and ticks that its benches give it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

package axis_stepper_harness_pkg is

  type axis_stepper_inputs_t is record
    reset : std_ulogic;
    guard : guard_t;
    both_edges : std_ulogic;
    begin_line : std_ulogic;
    steps : ticks_t;
    backward : std_ulogic;
    first_error : ticks_t;
    line_ticks : ticks_t;
    -- A tick is due: it is made in the next clock, if the axis is ready.
    due : std_ulogic;
    set_position : std_ulogic;
    new_position : position_t;
  end record;

  constant axis_stepper_in_reset : axis_stepper_inputs_t := (
    reset => '1', guard => guard_after_reset, steps => (others => '0'),
    first_error => (others => '0'), line_ticks => (others => '0'),
    new_position => (others => '0'), others => '0');

  type axis_stepper_outputs_t is record
    ready : std_ulogic;
    tick : std_ulogic;
    step : std_ulogic;
    direction : std_ulogic;
    busy : std_ulogic;
    working : std_ulogic;
    position : position_t;
    stalls : count_t;
    pulses : natural;
  end record;

  procedure wait_for_clocks (signal clk : in std_ulogic; count : in natural);

  -- The error term before the first tick is `start`, or half the ticks.
  procedure start_line (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    count, of_ticks, start : in natural; negative : in std_ulogic);
  procedure start_line (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    count, of_ticks : in natural; negative : in std_ulogic);

  -- A tick as soon as the axis is ready, up to the end of the clock in which it is made.
  procedure make_tick (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    signal outputs : in axis_stepper_outputs_t);

  procedure set_guard (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    high, low, setup, hold : in natural; falling_too : in std_ulogic := '0');

end package;

package body axis_stepper_harness_pkg is

  procedure wait_for_clocks (signal clk : in std_ulogic; count : in natural) is
  begin
    for i in 1 to count loop
      wait until rising_edge(clk);
    end loop;
  end procedure;

  procedure start_line (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    count, of_ticks, start : in natural; negative : in std_ulogic) is
  begin
    inputs.steps <= to_unsigned(count, 31);
    inputs.backward <= negative;
    inputs.first_error <= to_unsigned(start, 31);
    inputs.line_ticks <= to_unsigned(of_ticks, 31);
    inputs.begin_line <= '1';
    wait until rising_edge(clk);
    inputs.begin_line <= '0';
    inputs.steps <= (others => '1');
    inputs.backward <= not negative;
    inputs.first_error <= (others => '1');
  end procedure;

  procedure start_line (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    count, of_ticks : in natural; negative : in std_ulogic) is
  begin
    start_line(clk, inputs, count, of_ticks, of_ticks / 2, negative);
  end procedure;

  procedure make_tick (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    signal outputs : in axis_stepper_outputs_t) is
  begin
    inputs.due <= '1';
    wait until rising_edge(clk) and outputs.ready = '1';
    inputs.due <= '0';
    wait until rising_edge(clk);
  end procedure;

  procedure set_guard (
    signal clk : in std_ulogic; signal inputs : inout axis_stepper_inputs_t;
    high, low, setup, hold : in natural; falling_too : in std_ulogic := '0') is
  begin
    wait_for_clocks(clk, 20);
    inputs.guard <= (
      high => to_unsigned(high, 12), low => to_unsigned(low, 12),
      direction_setup => to_unsigned(setup, 12), direction_hold => to_unsigned(hold, 12));
    inputs.both_edges <= falling_too;
  end procedure;

end package body;
