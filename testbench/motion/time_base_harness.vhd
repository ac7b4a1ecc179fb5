-- SPDX-License-Identifier: Apache-2.0
-- A time_base with its clock, its model and counters, for its benches.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.time_base_harness_pkg.all;

entity time_base_harness is
  port (
    clk : buffer std_ulogic := '0';
    inputs : in time_base_inputs_t;
    outputs : buffer time_base_outputs_t;
    counts : out time_base_counts_t := (others => 0)
  );
end entity;

architecture simulation of time_base_harness is
begin

  clk <= not clk after 10 ns;

  base : entity work.time_base
    port map (
      clk => clk, always_clk => clk, reset => inputs.reset,
      advance => inputs.advance, leap => inputs.leap, longest_leap => outputs.longest_leap,
      run => inputs.run, start => inputs.start, stop => inputs.stop, rate_floor => inputs.rate_floor,
      head_valid => inputs.head_valid, head => inputs.head, take => outputs.take, due => outputs.due,
      axes_ready => inputs.axes_ready, tick => outputs.tick, stalled => outputs.stalled,
      active => outputs.active, accelerating => outputs.accelerating,
      decelerating => outputs.decelerating, stop_on => outputs.stop_on, waiting => outputs.waiting,
      segments => outputs.segments, underruns => outputs.underruns, stalls => outputs.stalls);

  model : entity work.time_base_model
    port map (clk => clk, inputs => inputs, outputs => outputs);

  count : process
  begin
    wait until rising_edge(clk);
    counts.clocks <= counts.clocks + 1;
    counts.clocks_since_tick <= counts.clocks_since_tick + 1;
    if outputs.tick then
      counts.ticks <= counts.ticks + 1;
      counts.clocks_between_ticks <= counts.clocks_since_tick;
      counts.clocks_since_tick <= 1;
    end if;
  end process;

end architecture;
