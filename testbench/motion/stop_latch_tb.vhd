-- SPDX-License-Identifier: Apache-2.0
-- A stop begins in the clock of its cause, remembers it, and ends only when acknowledged.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;

entity stop_latch_tb is
end entity;

architecture simulation of stop_latch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal active : std_ulogic := '0';
  signal stop_on : stop_condition_t := stop_condition_none;
  signal end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop : std_ulogic := '0';
  signal watchdog_expired : std_ulogic := '0';
  signal software_stop : std_ulogic := '0';
  signal software_brake : std_ulogic := '0';
  signal acknowledge : std_ulogic := '0';
  signal standing : std_ulogic := '0';
  signal no_ramp : std_ulogic := '0';
  signal hit : std_ulogic;
  signal braking : std_ulogic;
  signal stop : std_ulogic;
  signal stop_begins : std_ulogic;
  signal stopped : std_ulogic;
  signal closed : std_ulogic;
  signal cause : stop_cause_t;
  signal watching : std_ulogic;

begin

  clk <= not clk after 10 ns;

  latch : entity work.stop_latch
    port map (
      clk => clk, reset => reset, active => active, stop_on => stop_on, end_stops => end_stops,
      emergency_stop => emergency_stop, watchdog_expired => watchdog_expired,
      software_stop => software_stop, software_brake => software_brake,
      acknowledge => acknowledge, standing => standing, no_ramp => no_ramp, hit => hit,
      braking => braking, stop => stop, stop_begins => stop_begins, stopped => stopped,
      closed => closed, cause => cause, watching => watching);

  test : process
    procedure settle is
    begin
      wait for 1 ns;
    end procedure;

    procedure clock is
    begin
      wait until rising_edge(clk);
      settle;
    end procedure;

    procedure acknowledge_it is
    begin
      acknowledge <= '1';
      clock;
      acknowledge <= '0';
    end procedure;
  begin
    clock;
    reset <= '0';
    clock;
    assert stop = '0' severity failure;

    -- Only end stops that are asked for, and only during a segment.
    stop_on.mask <= x"0C";
    end_stops <= x"FF";
    settle;
    assert stop = '0' report "stopped while at rest" severity failure;
    active <= '1';
    end_stops <= x"F3";
    settle;
    assert stop = '0' report "stopped by an end stop that is not asked for" severity failure;
    end_stops <= x"0B";
    settle;
    assert stop = '1' and stop_begins = '1' and hit = '1' severity failure;
    clock;
    active <= '0';
    end_stops <= x"00";
    settle;
    assert stop = '1' and stop_begins = '0' and stopped = '1' severity failure;
    assert cause = (end_stops => x"08", others => '0') severity failure;

    -- What comes later changes neither cause nor moment.
    software_stop <= '1';
    settle;
    assert stop_begins = '0' severity failure;
    clock;
    software_stop <= '0';
    assert cause.software = '0' severity failure;
    acknowledge_it;
    settle;
    assert stop = '0' and stopped = '0' severity failure;

    software_stop <= '1';
    settle;
    assert stop = '1' severity failure;
    clock;
    software_stop <= '0';
    assert stopped = '1' and cause = (end_stops => x"00", software => '1', others => '0')
      severity failure;
    acknowledge_it;

    -- The emergency stop holds as long as it is active, and then until acknowledged.
    emergency_stop <= '1';
    clock;
    assert cause.emergency_input = '1' severity failure;
    acknowledge_it;
    assert stopped = '1' report "acknowledged under an active emergency stop" severity failure;
    emergency_stop <= '0';
    clock;
    assert stop = '1' severity failure;
    acknowledge_it;
    settle;
    assert stop = '0' severity failure;

    watchdog_expired <= '1';
    settle;
    assert stop = '1' and hit = '1' severity failure;
    clock;
    watchdog_expired <= '0';
    assert stopped = '1' and cause = (end_stops => x"00", watchdog => '1', others => '0')
      severity failure;
    acknowledge_it;

    -- Released instead of triggered.
    stop_on <= (mask => x"06", on_change => '0', on_release => '1', brakes => '0');
    end_stops <= x"06";
    active <= '1';
    settle;
    assert stop = '0' severity failure;
    end_stops <= x"04";
    settle;
    assert stop = '1' severity failure;
    clock;
    active <= '0';
    assert cause.end_stops = x"02" severity failure;
    acknowledge_it;

    -- Only a change, in the direction that is asked for.
    stop_on <= (mask => x"0F", on_change => '1', on_release => '0', brakes => '0');
    end_stops <= x"0A";
    clock;
    active <= '1';
    clock;
    assert stop = '0' report "stopped by an end stop that was triggered before" severity failure;
    end_stops <= x"02";
    clock;
    assert stop = '0' report "stopped by the release" severity failure;
    end_stops <= x"06";
    settle;
    assert stop = '1' severity failure;
    clock;
    active <= '0';
    assert cause.end_stops = x"04" severity failure;
    acknowledge_it;

    -- A brake is hit at once, and stops when time stands still. Its own switches may stay triggered.
    stop_on <= (mask => x"FF", on_change => '0', on_release => '0', brakes => '1');
    active <= '1';
    settle;
    assert hit = '1' and stop = '0' and closed = '1' severity failure;
    clock;
    stop_on.brakes <= '0';
    for i in 1 to 5 loop
      settle;
      assert braking = '1' and hit = '0' and stop = '0' and stopped = '0' and closed = '1'
        severity failure;
      clock;
    end loop;
    standing <= '1';
    settle;
    assert stop = '1' and stop_begins = '1' and hit = '0' severity failure;
    clock;
    standing <= '0';
    active <= '0';
    assert stopped = '1' and braking = '0' and cause = (end_stops => x"06", others => '0')
      severity failure;
    acknowledge_it;
    assert closed = '0' severity failure;

    -- Another switch ends it, also one that would brake, and so does the same once more.
    stop_on.brakes <= '1';
    active <= '1';
    end_stops <= x"02";
    clock;
    end_stops <= x"12";
    settle;
    assert stop_begins = '1' and hit = '0' severity failure;
    clock;
    active <= '0';
    assert stopped = '1' and cause = (end_stops => x"12", others => '0') severity failure;
    acknowledge_it;
    active <= '1';
    end_stops <= x"02";
    clock;
    end_stops <= x"00";
    clock;
    assert braking = '1' and stop = '0' severity failure;
    end_stops <= x"02";
    settle;
    assert stop_begins = '1' severity failure;
    clock;
    active <= '0';
    acknowledge_it;

    -- Without a ramp there is no brake.
    no_ramp <= '1';
    active <= '1';
    settle;
    assert stop_begins = '1' and hit = '1' severity failure;
    clock;
    active <= '0';
    end_stops <= x"00";
    acknowledge_it;
    software_brake <= '1';
    settle;
    assert stop_begins = '1' and hit = '1' severity failure;
    clock;
    software_brake <= '0';
    acknowledge_it;
    no_ramp <= '0';

    -- In one word with its acknowledgement a stop wins.
    software_stop <= '1';
    clock;
    acknowledge_it;
    assert stopped = '1' severity failure;
    software_stop <= '0';
    acknowledge_it;
    assert stopped = '0' severity failure;

    -- Software's brake ends with the motion, where that is over before the ramp.
    stop_on <= stop_condition_none;
    active <= '1';
    software_brake <= '1';
    clock;
    software_brake <= '0';
    clock;
    assert braking = '1' and stop = '0' severity failure;
    active <= '0';
    settle;
    assert stop_begins = '1' severity failure;
    clock;
    assert cause = (end_stops => x"00", software_brake => '1', others => '0') severity failure;
    acknowledge_it;

    -- The emergency stop does not wait for the ramp.
    active <= '1';
    software_brake <= '1';
    clock;
    software_brake <= '0';
    emergency_stop <= '1';
    settle;
    assert stop_begins = '1' and hit = '0' severity failure;
    clock;
    emergency_stop <= '0';
    active <= '0';
    assert stopped = '1' and braking = '0' and
      cause = (end_stops => x"00", software_brake => '1', emergency_input => '1', others => '0')
      severity failure;
    acknowledge_it;
    assert stop = '0' severity failure;

    -- Whatever cuts a brake short is reported, in addition to what began it.
    for cut in 1 to 3 loop
      active <= '1';
      software_brake <= '1';
      clock;
      software_brake <= '0';
      clock;
      if cut = 1 then
        watchdog_expired <= '1';
      elsif cut = 2 then
        software_stop <= '1';
      else
        watchdog_expired <= '1';
        software_stop <= '1';
        emergency_stop <= '1';
      end if;
      settle;
      assert stop_begins = '1' and hit = '0' severity failure;
      clock;
      watchdog_expired <= '0';
      software_stop <= '0';
      emergency_stop <= '0';
      active <= '0';
      settle;
      assert stopped = '1' and braking = '0' severity failure;
      assert cause.end_stops = x"00" and cause.software_brake = '1'
        and (cause.watchdog = '1') = (cut /= 2) and (cause.software = '1') = (cut /= 1)
        and (cause.emergency_input = '1') = (cut = 3)
        report "causes after cut " & to_string(cut) severity failure;
      acknowledge_it;
    end loop;

    -- A change of any end stop is watched, for the clock in which it comes.
    for input in end_stops'range loop
      end_stops(input) <= not end_stops(input);
      settle;
      assert watching = '1' severity failure;
      clock;
      assert watching = '0' severity failure;
      clock;
      assert watching = '0' severity failure;
    end loop;
    end_stops <= x"00";
    clock;

    -- The next segment of a brake asks for another switch: it stops, though it was triggered before.
    stop_on <= (mask => x"02", on_change => '0', on_release => '0', brakes => '1');
    end_stops <= x"12";
    active <= '1';
    clock;
    clock;
    assert braking = '1' and stop = '0' severity failure;
    stop_on.mask <= x"12";
    settle;
    assert stop_begins = '1' severity failure;
    clock;
    assert cause.end_stops = x"12" severity failure;
    active <= '0';
    acknowledge_it;
    -- Or for the release of the switch that brakes.
    stop_on.mask <= x"02";
    active <= '1';
    clock;
    clock;
    assert braking = '1' and stop = '0' severity failure;
    stop_on.on_release <= '1';
    end_stops <= x"10";
    settle;
    assert stop_begins = '1' severity failure;
    clock;
    active <= '0';
    stop_on <= stop_condition_none;
    acknowledge_it;

    -- That there is no ramp stops nothing by itself, but every brake, also one that is on.
    active <= '1';
    no_ramp <= '1';
    settle;
    assert stop = '0' and closed = '0' severity failure;
    clock;
    no_ramp <= '0';
    software_brake <= '1';
    clock;
    software_brake <= '0';
    clock;
    assert braking = '1' and stop = '0' severity failure;
    no_ramp <= '1';
    settle;
    assert stop_begins = '1' severity failure;
    clock;
    no_ramp <= '0';
    active <= '0';
    assert stopped = '1' severity failure;

    -- In one word with its acknowledgement a brake wins, too.
    software_brake <= '1';
    acknowledge_it;
    software_brake <= '0';
    assert stopped = '1' severity failure;

    -- A reset ends stop and brake.
    reset <= '1';
    clock;
    reset <= '0';
    settle;
    assert stopped = '0' and stop = '0' and closed = '0' severity failure;
    active <= '1';
    software_brake <= '1';
    clock;
    assert braking = '1' severity failure;
    software_brake <= '0';
    reset <= '1';
    clock;
    reset <= '0';
    settle;
    assert braking = '0' and stop = '0' and closed = '0' severity failure;

    finish;
  end process;

end architecture;
