-- SPDX-License-Identifier: Apache-2.0
-- A brake ends in a stop: at rest, at once where something cuts it short, and all causes are reported.

library ieee;
use ieee.std_logic_1164.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.step_generator_pkg.all;
use work.stop_latch_harness_pkg.all;

entity stop_latch_brake_tb is
end entity;

architecture simulation of stop_latch_brake_tb is

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
    inputs.end_stops <= x"06";
    wait_for_clock(clk);

    -- A brake is hit at once, and stops when time stands still. Its own switches may stay triggered.
    inputs.stop_on <= (mask => x"FF", on_change => '0', on_release => '0', brakes => '1');
    inputs.active <= '1';
    settle;
    assert outputs.hit = '1' and outputs.stop = '0' and outputs.closed = '1' severity failure;
    wait_for_clock(clk);
    inputs.stop_on.brakes <= '0';
    for i in 1 to 5 loop
      settle;
      assert outputs.braking = '1' and outputs.hit = '0' and outputs.stop = '0' and outputs.stopped = '0'
        and outputs.closed = '1'
        severity failure;
      wait_for_clock(clk);
    end loop;
    inputs.standing <= '1';
    settle;
    assert outputs.stop = '1' and outputs.stop_begins = '1' and outputs.hit = '0' severity failure;
    wait_for_clock(clk);
    inputs.standing <= '0';
    inputs.active <= '0';
    assert outputs.stopped = '1' and outputs.braking = '0'
      and outputs.cause = (end_stops => x"06", others => '0')
      severity failure;
    acknowledge_stop(clk, inputs);
    assert outputs.closed = '0' severity failure;

    -- Another switch ends it, also one that would brake, and so does the same once more.
    inputs.stop_on.brakes <= '1';
    inputs.active <= '1';
    inputs.end_stops <= x"02";
    wait_for_clock(clk);
    inputs.end_stops <= x"12";
    settle;
    assert outputs.stop_begins = '1' and outputs.hit = '0' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    assert outputs.stopped = '1' and outputs.cause = (end_stops => x"12", others => '0') severity failure;
    acknowledge_stop(clk, inputs);
    inputs.active <= '1';
    inputs.end_stops <= x"02";
    wait_for_clock(clk);
    inputs.end_stops <= x"00";
    wait_for_clock(clk);
    assert outputs.braking = '1' and outputs.stop = '0' severity failure;
    inputs.end_stops <= x"02";
    settle;
    assert outputs.stop_begins = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    acknowledge_stop(clk, inputs);

    -- Without a ramp there is no brake.
    inputs.no_ramp <= '1';
    inputs.active <= '1';
    settle;
    assert outputs.stop_begins = '1' and outputs.hit = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    inputs.end_stops <= x"00";
    acknowledge_stop(clk, inputs);
    inputs.software_brake <= '1';
    settle;
    assert outputs.stop_begins = '1' and outputs.hit = '1' severity failure;
    wait_for_clock(clk);
    inputs.software_brake <= '0';
    acknowledge_stop(clk, inputs);
    inputs.no_ramp <= '0';

    -- Software's brake ends with the motion, where that is over before the ramp.
    inputs.stop_on <= stop_condition_none;
    inputs.active <= '1';
    inputs.software_brake <= '1';
    wait_for_clock(clk);
    inputs.software_brake <= '0';
    wait_for_clock(clk);
    assert outputs.braking = '1' and outputs.stop = '0' severity failure;
    inputs.active <= '0';
    settle;
    assert outputs.stop_begins = '1' severity failure;
    wait_for_clock(clk);
    assert outputs.cause = (end_stops => x"00", software_brake => '1', others => '0') severity failure;
    acknowledge_stop(clk, inputs);

    -- The emergency stop does not wait for the ramp.
    inputs.active <= '1';
    inputs.software_brake <= '1';
    wait_for_clock(clk);
    inputs.software_brake <= '0';
    inputs.emergency_stop <= '1';
    settle;
    assert outputs.stop_begins = '1' and outputs.hit = '0' severity failure;
    wait_for_clock(clk);
    inputs.emergency_stop <= '0';
    inputs.active <= '0';
    assert outputs.stopped = '1' and outputs.braking = '0' and
      outputs.cause = (end_stops => x"00", software_brake => '1', emergency_input => '1', others => '0')
      severity failure;
    acknowledge_stop(clk, inputs);
    assert outputs.stop = '0' severity failure;

    -- Whatever cuts a brake short is reported, in addition to what began it.
    for cut in 1 to 3 loop
      inputs.active <= '1';
      inputs.software_brake <= '1';
      wait_for_clock(clk);
      inputs.software_brake <= '0';
      wait_for_clock(clk);
      if cut = 1 then
        inputs.watchdog_expired <= '1';
      elsif cut = 2 then
        inputs.software_stop <= '1';
      else
        inputs.watchdog_expired <= '1';
        inputs.software_stop <= '1';
        inputs.emergency_stop <= '1';
      end if;
      settle;
      assert outputs.stop_begins = '1' and outputs.hit = '0' severity failure;
      wait_for_clock(clk);
      inputs.watchdog_expired <= '0';
      inputs.software_stop <= '0';
      inputs.emergency_stop <= '0';
      inputs.active <= '0';
      settle;
      assert outputs.stopped = '1' and outputs.braking = '0' severity failure;
      assert outputs.cause.end_stops = x"00" and outputs.cause.software_brake = '1'
        and (outputs.cause.watchdog = '1') = (cut /= 2) and (outputs.cause.software = '1') = (cut /= 1)
        and (outputs.cause.emergency_input = '1') = (cut = 3)
        report "causes after cut " & to_string(cut) severity failure;
      acknowledge_stop(clk, inputs);
    end loop;

    -- The next segment of a brake selects another switch: it stops, though it was triggered before.
    inputs.stop_on <= (mask => x"02", on_change => '0', on_release => '0', brakes => '1');
    inputs.end_stops <= x"12";
    inputs.active <= '1';
    wait_for_clock(clk);
    wait_for_clock(clk);
    assert outputs.braking = '1' and outputs.stop = '0' severity failure;
    inputs.stop_on.mask <= x"12";
    settle;
    assert outputs.stop_begins = '1' severity failure;
    wait_for_clock(clk);
    assert outputs.cause.end_stops = x"12" severity failure;
    inputs.active <= '0';
    acknowledge_stop(clk, inputs);
    -- Or for the release of the switch that brakes.
    inputs.stop_on.mask <= x"02";
    inputs.active <= '1';
    wait_for_clock(clk);
    wait_for_clock(clk);
    assert outputs.braking = '1' and outputs.stop = '0' severity failure;
    inputs.stop_on.on_release <= '1';
    inputs.end_stops <= x"10";
    settle;
    assert outputs.stop_begins = '1' severity failure;
    wait_for_clock(clk);
    inputs.active <= '0';
    inputs.stop_on <= stop_condition_none;
    acknowledge_stop(clk, inputs);

    -- That there is no ramp stops nothing by itself, but every brake, also one that is on.
    inputs.active <= '1';
    inputs.no_ramp <= '1';
    settle;
    assert outputs.stop = '0' and outputs.closed = '0' severity failure;
    wait_for_clock(clk);
    inputs.no_ramp <= '0';
    inputs.software_brake <= '1';
    wait_for_clock(clk);
    inputs.software_brake <= '0';
    wait_for_clock(clk);
    assert outputs.braking = '1' and outputs.stop = '0' severity failure;
    inputs.no_ramp <= '1';
    settle;
    assert outputs.stop_begins = '1' severity failure;
    wait_for_clock(clk);
    inputs.no_ramp <= '0';
    inputs.active <= '0';
    assert outputs.stopped = '1' severity failure;

    -- In one word with its acknowledgement a brake wins, too.
    inputs.software_brake <= '1';
    acknowledge_stop(clk, inputs);
    inputs.software_brake <= '0';
    assert outputs.stopped = '1' severity failure;

    acknowledge_stop(clk, inputs);

    -- A reset ends a brake.
    inputs.active <= '1';
    inputs.software_brake <= '1';
    wait_for_clock(clk);
    assert outputs.braking = '1' severity failure;
    inputs.software_brake <= '0';
    inputs.reset <= '1';
    wait_for_clock(clk);
    inputs.reset <= '0';
    settle;
    assert outputs.braking = '0' and outputs.stop = '0' and outputs.closed = '0' severity failure;

    finish;
  end process;

end architecture;
