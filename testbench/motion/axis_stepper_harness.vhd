-- SPDX-License-Identifier: Apache-2.0
-- An axis_stepper with its clock, a monitor of its pins and a watch over its idleness, for its benches.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.axis_stepper_harness_pkg.all;

entity axis_stepper_harness is
  port (
    clk : buffer std_ulogic := '0';
    inputs : in axis_stepper_inputs_t;
    outputs : buffer axis_stepper_outputs_t
  );
end entity;

architecture simulation of axis_stepper_harness is

  signal was_due : std_ulogic := '0';

begin

  clk <= not clk after 10 ns;

  -- As the core does: the axis follows a clock later, and no tick is due in the clock after one.
  follow_base : process
  begin
    wait until rising_edge(clk);
    outputs.tick <= inputs.due and outputs.ready and not (outputs.tick or inputs.reset);
    was_due <= inputs.due and not (outputs.tick or inputs.reset);
  end process;

  axis : entity work.axis_stepper
    port map (
      clk => clk, reset => inputs.reset, guard => inputs.guard, both_edges => inputs.both_edges,
      begin_line => inputs.begin_line, steps => inputs.steps,
      backward => inputs.backward, first_error => inputs.first_error, line_ticks => inputs.line_ticks,
      ready => outputs.ready, was_due => was_due, tick => outputs.tick, step => outputs.step,
      direction => outputs.direction, busy => outputs.busy, working => outputs.working,
      position => outputs.position, set_position => inputs.set_position,
      new_position => inputs.new_position, stalls => outputs.stalls);

  monitor : entity work.pulse_monitor
    port map (
      clk => clk, reset => inputs.reset, guard => inputs.guard, both_edges => inputs.both_edges,
      step => outputs.step, direction => outputs.direction, position => outputs.position,
      set_position => inputs.set_position, new_position => inputs.new_position,
      pulses => outputs.pulses);

  -- Without work, and two clocks after a line or a tick, an edge of the clock changes nothing that is seen.
  watch_work : process
    variable seen, before : std_ulogic_vector(4 downto 0);
    variable quiet_clocks : natural := 0;
    variable had_work : std_ulogic := '1';
  begin
    wait until rising_edge(clk);
    seen := outputs.step & outputs.direction & outputs.ready & outputs.busy & outputs.working;
    no_change_without_work : assert had_work = '1' or quiet_clocks < 2 or seen = before
      report "changes without work" severity failure;
    before := seen;
    had_work := outputs.working;
    quiet_clocks := 0 when (inputs.begin_line or outputs.tick or inputs.reset) = '1' else quiet_clocks + 1;
    if outputs.busy then
      a_pulse_is_work : assert outputs.working = '1' severity failure;
    end if;
    if quiet_clocks > 30 and inputs.guard.direction_setup < 10 and inputs.guard.high < 10 then
      work_has_an_end : assert outputs.working = '0' report "works forever" severity failure;
    end if;
  end process;

end architecture;
