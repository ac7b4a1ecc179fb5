-- SPDX-License-Identifier: Apache-2.0
-- Any line under any guard: exactly its steps, in its direction, each at its tick.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.axis_stepper_harness_pkg.all;
use work.random_source_pkg.all;
use work.step_generator_pkg.all;

entity axis_stepper_lines_tb is
end entity;

architecture simulation of axis_stepper_lines_tb is

  signal clk : std_ulogic;
  signal inputs : axis_stepper_inputs_t := axis_stepper_in_reset;
  signal outputs : axis_stepper_outputs_t;

begin

  axis : entity work.axis_stepper_harness
    port map (clk => clk, inputs => inputs, outputs => outputs);

  test : process
    variable random : random_source_t;
    variable pulses_before : natural;
    variable position_before : position_t;
    variable falling_too : std_ulogic;
    variable count : natural;
    variable of_ticks : natural;
    variable negative : std_ulogic;
    variable start : natural;
    variable made : natural;
  begin
    wait_for_clocks(clk, 2);
    inputs.reset <= '0';
    set_guard(clk, inputs, 4, 9, 1, 1);

    for line in 1 to 300 loop
      if line mod 10 = 0 then
        wait_for_clocks(clk, 20);
        -- With a high pin it cannot change to pulses.
        falling_too := '1' when line mod 40 = 0 or outputs.step = '1' else '0';
        set_guard(clk, inputs, random.between(0, 6), random.between(0, 6), random.between(0, 9),
          random.between(0, 9),
          falling_too);
      end if;
      of_ticks := random.between(1, 40);
      count := random.between(0, of_ticks);
      negative := '1' when random.between(0, 1) = 1 else '0';
      pulses_before := outputs.pulses;
      position_before := outputs.position;
      start := random.between(0, of_ticks - 1);
      start_line(clk, inputs, count, of_ticks, start, negative);
      for i in 1 to of_ticks loop
        wait_for_clocks(clk, random.between(0, 3));
        make_tick(clk, inputs, outputs);
        wait for 1 ns;
        made := to_integer(abs (outputs.position - position_before));
        assert made = (i * count + start) / of_ticks
          report to_string(made) & " of " & to_string(count) & " steps after " & to_string(i) &
            " of " & to_string(of_ticks) & " ticks from " & to_string(start)
          severity failure;
      end loop;
      wait_for_clocks(clk, 2);
      assert outputs.pulses - pulses_before = count
        report to_string(count) & " steps asked, " & to_string(outputs.pulses - pulses_before) & " made"
        severity failure;
      if negative = '1' then
        assert outputs.position = position_before - count severity failure;
      else
        assert outputs.position = position_before + count severity failure;
      end if;
    end loop;

    finish;
  end process;

end architecture;
