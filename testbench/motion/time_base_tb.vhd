-- SPDX-License-Identifier: Apache-2.0
-- The base ticks at the asked rate, joins segments without a dead clock, freezes, floors and stops.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.time_base_harness_pkg.all;

entity time_base_tb is
end entity;

architecture simulation of time_base_tb is

  signal clk : std_ulogic;
  signal inputs : time_base_inputs_t := time_base_in_reset;
  signal outputs : time_base_outputs_t;
  signal counts : time_base_counts_t;

begin

  base : entity work.time_base_harness
    port map (clk => clk, inputs => inputs, outputs => outputs, counts => counts);

  test : process
    variable ticks_before : natural;
    variable ticks_in_between : natural;
    variable began : natural;
  begin
    wait_for_clocks(clk, 2);
    inputs.reset <= '0';
    wait_for_clocks(clk, 2);

    -- Nothing starts before it may.
    inputs.head_valid <= '1';
    wait_for_clocks(clk, 5);
    assert outputs.active = '0' severity failure;
    inputs.head_valid <= '0';
    inputs.run <= '1';

    -- From rest the first tick comes after a whole period.
    offer(clk, inputs, outputs, 3, quarter);
    wait_for_clocks(clk, 1);
    ticks_before := counts.ticks;
    wait_for_clocks(clk, 3);
    assert counts.ticks = ticks_before severity failure;
    wait_for_clocks(clk, 1);
    assert counts.ticks = ticks_before + 1 report "first tick not after 4 clocks" severity failure;
    wait_for_rest(clk, outputs);
    assert counts.ticks = ticks_before + 3 severity failure;
    assert counts.clocks_between_ticks = 4 severity failure;
    assert outputs.underruns = 0 severity failure;

    -- Single ticks at full rate follow each other every second clock.
    ticks_before := counts.ticks;
    offer(clk, inputs, outputs, 1, half, '0');
    for i in 1 to 9 loop
      offer(clk, inputs, outputs, 1, half, '0');
      wait_for_clocks(clk, 1);
      assert i = 1 or counts.clocks_between_ticks = 2 report "dead clock between segments" severity failure;
    end loop;
    wait_for_rest(clk, outputs);
    assert counts.ticks = ticks_before + 10 severity failure;
    assert outputs.underruns = 1 report "the end of motion was not intended" severity failure;

    -- What is left of the phase carries over to the next segment: 10 ticks at 0.3 take 34 clocks in all.
    ticks_before := counts.ticks;
    offer(clk, inputs, outputs, 1, x"4CCCCCCCCCCCCCCD", '0');
    began := counts.clocks;
    for i in 2 to 10 loop
      offer(clk, inputs, outputs, 1, x"4CCCCCCCCCCCCCCD", '0');
    end loop;
    wait until rising_edge(clk) and outputs.active = '0';
    assert counts.clocks - began = 35 report to_string(counts.clocks - began) & " clocks" severity failure;
    wait_for_clocks(clk, 2);

    -- Stalled axes and stalled time delay motion, and nothing is lost.
    ticks_before := counts.ticks;
    offer(clk, inputs, outputs, 4, half);
    inputs.axes_ready <= '0';
    wait_for_clocks(clk, 20);
    assert counts.ticks = ticks_before severity failure;
    assert outputs.stalls = 18 report to_string(to_integer(outputs.stalls)) & " stalls" severity failure;
    inputs.axes_ready <= '1';
    inputs.advance <= '0';
    wait_for_clocks(clk, 20);
    assert counts.ticks = ticks_before severity failure;
    inputs.advance <= '1';
    wait_for_rest(clk, outputs);
    assert counts.ticks = ticks_before + 4 severity failure;

    -- The rate stays between floor (here 2^-10) and 1/2. 2^62 is a change of 2^-22 per clock.
    inputs.rate_floor <= (22 => '1', others => '0');
    offer(clk, inputs, outputs, 40, half / 128, '1', x"C000000000000000");
    wait_for_rest(clk, outputs);
    assert counts.clocks_between_ticks = 1024 report to_string(counts.clocks_between_ticks) severity failure;
    offer(clk, inputs, outputs, 10000, half - half / 512, '1', x"4000000000000000");
    wait_for_clocks(clk, 8000);
    ticks_in_between := counts.ticks;
    wait_for_clocks(clk, 8000);
    assert counts.ticks - ticks_in_between = 4000 report "not at a rate of 1/2" severity failure;
    wait_for_rest(clk, outputs);
    assert counts.clocks_between_ticks = 2 report to_string(counts.clocks_between_ticks) severity failure;
    assert counts.ticks = ticks_before + 4 + 10040 severity failure;

    -- A rate that is just above the floor is kept: at it the tick would come 3 clocks later.
    inputs.rate_floor <= to_unsigned(2 ** 15, 31);
    offer(clk, inputs, outputs, 1, x"00008000FFFFFFFF");
    began := counts.clocks;
    wait until rising_edge(clk) and outputs.active = '0';
    assert counts.clocks - began = 131070 report to_string(counts.clocks - began) & " clocks"
      severity failure;
    wait_for_clocks(clk, 2);
    inputs.rate_floor <= (22 => '1', others => '0');

    -- A stop ends the segment at once, in a clock with a tick or without one.
    inputs.head.stop_on <= (mask => x"A5", on_change => '1', on_release => '0', brakes => '1');
    for delay in 10 to 11 loop
      offer(clk, inputs, outputs, 1000, half);
      wait_for_clocks(clk, delay);
      assert outputs.stop_on = inputs.head.stop_on severity failure;
      inputs.stop <= '1';
      wait for 1 ns;
      assert outputs.tick = '0' report "tick in the clock of a stop" severity failure;
      ticks_before := counts.ticks;
      wait_for_clocks(clk, 1);
      inputs.stop <= '0';
      wait_for_clocks(clk, 10);
      assert outputs.active = '0' and counts.ticks = ticks_before severity failure;
    end loop;
    assert outputs.segments = 27 report to_string(to_integer(outputs.segments)) & " segments"
      severity failure;

    -- A segment that waits begins from rest at its start, although it was there in time; this is no
    -- underrun. A start that nothing waits for is not remembered.
    began := to_integer(outputs.underruns);
    inputs.start <= '1';
    wait_for_clocks(clk, 1);
    inputs.start <= '0';
    inputs.head.waits_for_start <= '1';
    ticks_before := counts.ticks;
    inputs.head_valid <= '1';
    wait_for_clocks(clk, 30);
    assert outputs.active = '0' and outputs.waiting = '1' report "did not wait" severity failure;
    inputs.start <= '1';
    wait until rising_edge(clk) and outputs.take = '1';
    inputs.start <= '0';
    inputs.head.waits_for_start <= '0';
    inputs.head.ends_motion <= '0';
    wait until rising_edge(clk) and outputs.take = '1';
    inputs.head.waits_for_start <= '1';
    wait_for_clocks(clk, 1);
    assert outputs.active = '1' and outputs.waiting = '0' severity failure;
    wait_for_rest(clk, outputs);
    assert counts.ticks = ticks_before + 2000 severity failure;
    wait_for_clocks(clk, 30);
    assert outputs.waiting = '1' and counts.ticks = ticks_before + 2000 severity failure;
    inputs.head_valid <= '0';
    wait_for_clocks(clk, 1);
    assert outputs.waiting = '0' and outputs.underruns = began severity failure;
    inputs.head.waits_for_start <= '0';
    inputs.head.ends_motion <= '1';

    -- A reset ends the segment and forgets what was counted.
    offer(clk, inputs, outputs, 100, quarter, '0');
    inputs.axes_ready <= '0';
    wait_for_clocks(clk, 20);
    assert outputs.segments /= 0 and outputs.underruns /= 0 and outputs.stalls /= 0 and outputs.active = '1'
      severity failure;
    inputs.reset <= '1';
    wait_for_clocks(clk, 1);
    inputs.reset <= '0';
    inputs.axes_ready <= '1';
    wait for 1 ns;
    assert outputs.segments = 0 and outputs.underruns = 0 and outputs.stalls = 0 and outputs.active = '0'
      severity failure;
    wait_for_clocks(clk, 20);
    assert outputs.active = '0' and outputs.segments = 0 severity failure;

    finish;
  end process;

end architecture;
