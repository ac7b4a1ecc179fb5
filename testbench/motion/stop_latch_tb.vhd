-- SPDX-License-Identifier: Apache-2.0
-- A stop begins in the clock of its cause, remembers it, and ends only when acknowledged.

library ieee;
use ieee.std_logic_1164.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.step_generator_pkg.all;
use work.stop_latch_harness_pkg.all;

entity stop_latch_tb is
end entity;

architecture simulation of stop_latch_tb is

  signal clk : std_ulogic;
  signal inputs : stop_latch_inputs_t := stop_latch_in_reset;
  signal outputs : stop_latch_outputs_t;

begin

  latch : entity work.stop_latch_harness
    port map (clk => clk, inputs => inputs, outputs => outputs);

  test : process
  begin
    wait_for_clock(clk);
    inputs.reset <= '0';
    wait_for_clock(clk);
    assert outputs.stop = '0' severity failure;

    -- Only end stops of the mask, and only during a segment.
    inputs.stop_on.mask <= x"0C";
    inputs.end_stops <= x"FF";
    settle;
    assert outputs.stop = '0' report "stopped while at rest" severity failure;
    inputs.active <= '1';
    inputs.end_stops <= x"F3";
    settle;
    assert outputs.stop = '0' report "stopped by an end stop that is not asked for" severity failure;
    inputs.end_stops <= x"0B";
    settle;
    assert outputs.stop = '1' and outputs.stop_begins = '1' and outputs.hit = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    inputs.end_stops <= x"00";
    settle;
    assert outputs.stop = '1' and outputs.stop_begins = '0' and outputs.stopped = '1' severity failure;
    assert outputs.cause = (end_stops => x"08", others => '0') severity failure;

    -- What comes later changes neither cause nor moment.
    inputs.software_stop <= '1';
    settle;
    assert outputs.stop_begins = '0' severity failure;
    wait_for_clock(clk);
    inputs.software_stop <= '0';
    assert outputs.cause.software = '0' severity failure;
    acknowledge_stop(clk, inputs);
    settle;
    assert outputs.stop = '0' and outputs.stopped = '0' severity failure;

    inputs.software_stop <= '1';
    settle;
    assert outputs.stop = '1' severity failure;
    wait_for_clock(clk);
    inputs.software_stop <= '0';
    assert outputs.stopped = '1' and outputs.cause = (end_stops => x"00", software => '1', others => '0')
      severity failure;
    acknowledge_stop(clk, inputs);

    -- The emergency stop holds as long as it is active, and then until acknowledged.
    inputs.emergency_stop <= '1';
    wait_for_clock(clk);
    assert outputs.cause.emergency_input = '1' severity failure;
    acknowledge_stop(clk, inputs);
    assert outputs.stopped = '1' report "acknowledged under an active emergency stop" severity failure;
    inputs.emergency_stop <= '0';
    wait_for_clock(clk);
    assert outputs.stop = '1' severity failure;
    acknowledge_stop(clk, inputs);
    settle;
    assert outputs.stop = '0' severity failure;

    inputs.watchdog_expired <= '1';
    settle;
    assert outputs.stop = '1' and outputs.hit = '1' severity failure;
    wait_for_clock(clk);
    inputs.watchdog_expired <= '0';
    assert outputs.stopped = '1' and outputs.cause = (end_stops => x"00", watchdog => '1', others => '0')
      severity failure;
    acknowledge_stop(clk, inputs);

    -- Released instead of triggered.
    inputs.stop_on <= (mask => x"06", on_change => '0', on_release => '1', brakes => '0');
    inputs.end_stops <= x"06";
    inputs.active <= '1';
    settle;
    assert outputs.stop = '0' severity failure;
    inputs.end_stops <= x"04";
    settle;
    assert outputs.stop = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    assert outputs.cause.end_stops = x"02" severity failure;
    acknowledge_stop(clk, inputs);

    -- Only a change, in the direction that is requested.
    inputs.stop_on <= (mask => x"0F", on_change => '1', on_release => '0', brakes => '0');
    inputs.end_stops <= x"0A";
    wait_for_clock(clk);
    inputs.active <= '1';
    wait_for_clock(clk);
    assert outputs.stop = '0' report "stopped by an end stop that was triggered before" severity failure;
    inputs.end_stops <= x"02";
    wait_for_clock(clk);
    assert outputs.stop = '0' report "stopped by the release" severity failure;
    inputs.end_stops <= x"06";
    settle;
    assert outputs.stop = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    assert outputs.cause.end_stops = x"04" severity failure;
    acknowledge_stop(clk, inputs);

    -- In one word with its acknowledgement a stop wins.
    inputs.software_stop <= '1';
    wait_for_clock(clk);
    acknowledge_stop(clk, inputs);
    assert outputs.stopped = '1' severity failure;
    inputs.software_stop <= '0';
    acknowledge_stop(clk, inputs);
    assert outputs.stopped = '0' severity failure;

    -- A change of any end stop is watched, for the clock in which it comes.
    for input in inputs.end_stops'range loop
      inputs.end_stops(input) <= not inputs.end_stops(input);
      settle;
      assert outputs.watching = '1' severity failure;
      wait_for_clock(clk);
      assert outputs.watching = '0' severity failure;
      wait_for_clock(clk);
      assert outputs.watching = '0' severity failure;
    end loop;
    inputs.end_stops <= x"00";
    wait_for_clock(clk);

    -- A reset ends a stop.
    inputs.software_stop <= '1';
    wait_for_clock(clk);
    inputs.software_stop <= '0';
    assert outputs.stopped = '1' severity failure;
    inputs.reset <= '1';
    wait_for_clock(clk);
    inputs.reset <= '0';
    settle;
    assert outputs.stopped = '0' and outputs.stop = '0' and outputs.closed = '0' severity failure;

    finish;
  end process;

end architecture;
