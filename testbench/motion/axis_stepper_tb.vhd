-- SPDX-License-Identifier: Apache-2.0
-- The axis keeps every guard time, and says when it is not ready.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.axis_stepper_harness_pkg.all;
use work.step_generator_pkg.all;

entity axis_stepper_tb is
end entity;

architecture simulation of axis_stepper_tb is

  signal clk : std_ulogic;
  signal inputs : axis_stepper_inputs_t := axis_stepper_in_reset;
  signal outputs : axis_stepper_outputs_t;

begin

  axis : entity work.axis_stepper_harness
    port map (clk => clk, inputs => inputs, outputs => outputs);

  test : process
    variable pulses_before : natural;
    variable stalls_before : count_t;
    variable count : natural;
    variable made : natural;
  begin
    wait_for_clocks(clk, 2);
    inputs.reset <= '0';

    -- Every tick a step, every second clock, at the shortest guard; also where the direction changes.
    set_guard(clk, inputs, 1, 1, 1, 1);
    for line in 1 to 4 loop
      start_line(clk, inputs, 5, 5, not outputs.direction);
      for i in 1 to 5 loop
        make_tick(clk, inputs, outputs);
      end loop;
    end loop;
    wait_for_clocks(clk, 2);
    assert outputs.pulses = 20 report "20 ticks made " & to_string(outputs.pulses) & " pulses"
      severity failure;
    assert outputs.stalls = 0 report "the shortest guard delayed the base" severity failure;
    assert outputs.position = 0 report "forth and back do not cancel" severity failure;

    -- Zero clocks count as one.
    set_guard(clk, inputs, 0, 0, 0, 0);
    start_line(clk, inputs, 3, 3, '1');
    for i in 1 to 3 loop
      make_tick(clk, inputs, outputs);
    end loop;
    wait_for_clocks(clk, 2);
    assert outputs.position = -3 severity failure;
    assert outputs.stalls = 0 severity failure;

    -- The guard delays, by the clocks that are missing.
    set_guard(clk, inputs, 4, 5, 6, 7);
    wait_for_clocks(clk, 20);
    start_line(clk, inputs, 2, 2, '1');
    stalls_before := outputs.stalls;
    make_tick(clk, inputs, outputs);
    make_tick(clk, inputs, outputs);
    wait_for_clocks(clk, 1);
    assert outputs.stalls = stalls_before + 4 + 5 - 2
      report "the second tick was delayed by " & to_string(to_integer(outputs.stalls - stalls_before))
      severity failure;

    -- A tick without a step is not delayed, whatever the guard still forbids.
    set_guard(clk, inputs, 20, 20, 20, 20);
    wait_for_clocks(clk, 60);
    start_line(clk, inputs, 1, 3, outputs.direction);
    stalls_before := outputs.stalls;
    pulses_before := outputs.pulses;
    for i in 1 to 3 loop
      make_tick(clk, inputs, outputs);
    end loop;
    wait_for_clocks(clk, 2);
    assert outputs.stalls = stalls_before and outputs.pulses = pulses_before + 1
      report "a tick without a step was delayed" severity failure;
    wait_for_clocks(clk, 60);

    -- Busy for the pulse and the pause after it: another could rise in the clock in which this has ended.
    for high in 1 to 4 loop
      for low in 1 to 4 loop
        for falling_counts in 0 to 1 loop
          set_guard(clk, inputs, high, low, 9, 9);
          inputs.both_edges <= '1' when falling_counts = 1 else '0';
          wait_for_clocks(clk, 1);
          made := 0;
          for toggles in 0 to falling_counts loop
            start_line(clk, inputs, 1, 1, outputs.direction);
            make_tick(clk, inputs, outputs);
            wait_for_clocks(clk, 1);
            while outputs.busy = '1' loop
              made := made + 1;
              wait_for_clocks(clk, 1);
            end loop;
          end loop;
          count := high + low - 1 - falling_counts;
          assert made = count
            report "busy for " & to_string(made) & " clocks instead of " & to_string(count)
            severity failure;
          wait_for_clocks(clk, 20);
        end loop;
      end loop;
    end loop;

    -- A direction that turns back in time is not turned at all.
    wait_for_clocks(clk, 20);
    assert outputs.direction = '1' severity failure;
    start_line(clk, inputs, 0, 2, '0');
    wait_for_clocks(clk, 20);
    assert outputs.direction = '1' report "an axis without steps has turned" severity failure;

    -- With both edges every tick toggles the pin, which then stays, and this is a step.
    set_guard(clk, inputs, 1, 1, 1, 1, falling_too => '1');
    stalls_before := outputs.stalls;
    start_line(clk, inputs, 7, 7, not outputs.direction);
    pulses_before := outputs.pulses;
    for i in 1 to 7 loop
      make_tick(clk, inputs, outputs);
      wait for 1 ns;
      assert (outputs.step = '1') = (i mod 2 = 1) severity failure;
    end loop;
    wait_for_clocks(clk, 50);
    assert outputs.step = '1' and outputs.busy = '0' severity failure;
    assert outputs.pulses = pulses_before + 7 and outputs.stalls = stalls_before severity failure;
    set_guard(clk, inputs, 4, 9, 1, 1, falling_too => '1');
    start_line(clk, inputs, 3, 3, outputs.direction);
    stalls_before := outputs.stalls;
    make_tick(clk, inputs, outputs);
    make_tick(clk, inputs, outputs);
    wait for 1 ns;
    assert outputs.stalls = stalls_before + 9 - 2 report "low too short" severity failure;
    make_tick(clk, inputs, outputs);
    wait for 1 ns;
    assert outputs.stalls = stalls_before + 9 - 2 + 4 - 2 report "high too short" severity failure;
    wait_for_clocks(clk, 1);

    wait_for_clocks(clk, 20);
    assert outputs.busy = '0' report "still busy long after the last pulse" severity failure;
    inputs.new_position <= to_signed(-1000, 32);
    inputs.set_position <= '1';
    wait_for_clocks(clk, 1);
    inputs.set_position <= '0';
    wait_for_clocks(clk, 1);
    assert outputs.position = -1000 severity failure;

    -- A reset ends a pulse, its pause, every guard time and a turn at once, and counts from 0.
    for case_of_reset in 1 to 4 loop
      set_guard(clk, inputs, 20, 20, 20, 20);
      wait_for_clocks(clk, 30);
      start_line(clk, inputs, 2, 2, '1');
      make_tick(clk, inputs, outputs);
      inputs.due <= '1';
      case case_of_reset is
        when 1 => wait_for_clocks(clk, 2);
        when 2 => wait_for_clocks(clk, 25);
        when 3 =>
          inputs.due <= '0';
          start_line(clk, inputs, 1, 1, '0');
        when others => wait_for_clocks(clk, 45);
      end case;
      inputs.due <= '0';
      inputs.reset <= '1';
      wait until rising_edge(clk);
      inputs.reset <= '0';
      wait for 1 ns;
      assert outputs.step = '0' and outputs.direction = '0' and outputs.busy = '0' and outputs.working = '0'
        and outputs.ready = '1'
        report "not at rest after reset " & to_string(case_of_reset) severity failure;
      assert outputs.position = 0 and outputs.stalls = 0
        report "counts after reset " & to_string(case_of_reset) severity failure;
      start_line(clk, inputs, 1, 1, '0');
      make_tick(clk, inputs, outputs);
      wait for 1 ns;
      assert outputs.stalls = 0 and outputs.position = 1
        report "a guard time outlasts reset " & to_string(case_of_reset) severity failure;
      wait_for_clocks(clk, 50);
    end loop;

    finish;
  end process;

end architecture;
