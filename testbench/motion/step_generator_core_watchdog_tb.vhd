-- SPDX-License-Identifier: Apache-2.0
-- The watchdog counts all motion, also what is held or brakes, and nothing but its feeding feeds it. The
-- time of a hit is that of the hit, whatever follows, and counts in 64 bits.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_core_bench_pkg.all;
use work.step_generator_pkg.all;

entity step_generator_core_watchdog_tb is
end entity;

architecture simulation of step_generator_core_watchdog_tb is

  constant limit : positive := 300;

  signal clk : std_ulogic;
  signal drive : core_inputs_t := inputs_in_reset;
  signal seen : core_outputs_t;

begin

  rig : entity work.step_generator_core_rig
    port map (clk => clk, drive => drive, seen => seen);

  test : process
    alias now is << signal .step_generator_core_watchdog_tb.rig.core.now : time_t >>;
    constant before_carry : time_t := x"00000000_fffffff8";

    variable hit_time, fed_at : natural;
    variable hit_positions : position_array_t(axes - 1 downto 0);

    -- Fed in this clock; stops in time, and no earlier.
    procedure expect_expiry (cause : stop_cause_t) is
    begin
      wait_clocks(clk, limit - 2);
      not_yet : assert seen.stopped = '0' report "expires early" severity failure;
      wait_clocks(clk, 6);
      in_time : assert seen.stopped = '1' report "does not expire" severity failure;
      drive.watchdog_limit <= 0;
      expect_stop(clk, drive, seen, cause);
      drive.watchdog_limit <= limit;
    end procedure;

    procedure move is
    begin
      put_line(clk, drive, seen, 100);
      wait until rising_edge(clk) and seen.moving = '1';
    end procedure;

    -- The brake begins in the next clock.
    procedure brake is
    begin
      wait until falling_edge(clk);
      hit_time := seen.clocks_run;
      hit_positions := seen.positions;
      drive.software_brake <= '1';
      drive.feed_watchdog <= '1';
      wait_clocks(clk, 1);
      drive.software_brake <= '0';
      drive.feed_watchdog <= '0';
    end procedure;

    procedure expect_hit is
    begin
      has_the_time_of_the_hit : assert seen.stop_time = hit_time
        report to_string(to_integer(seen.stop_time)) & " instead of " & to_string(hit_time) severity failure;
      has_the_positions_of_the_hit : assert seen.stop_positions = hit_positions severity failure;
    end procedure;

  begin
    wait_clocks(clk, 2);
    drive.reset <= '0';
    drive.watchdog_limit <= limit;
    wait_clocks(clk, 5);

    -- In a feed hold.
    move;
    drive.override <= to_unsigned(0, 18);
    while seen.held = '0' loop
      wait_clocks(clk, 20);
      pulse(clk, drive.feed_watchdog);
    end loop;
    expect_expiry((end_stops => x"00", watchdog => '1', others => '0'));
    drive.override <= to_unsigned(65536, 18);
    wait_clocks(clk, 5);

    -- In a brake, of which time and positions stay.
    move;
    wait_clocks(clk, 100);
    brake;
    expect_expiry((end_stops => x"00", watchdog => '1', software_brake => '1', others => '0'));
    expect_hit;

    -- So do they where something else cuts it short, also a long time later.
    for delay in 0 to 4 loop
      move;
      wait_clocks(clk, 100);
      brake;
      wait_clocks(clk, 50 * delay);
      pulse(clk, drive.software_stop);
      wait_clocks(clk, 5);
      expect_hit;
      expect_stop(clk, drive, seen,
        (end_stops => x"00", software => '1', software_brake => '1', others => '0'));
    end loop;

    -- Software that does anything else is not alive: its watchdog's feeding may be in a part that hangs.
    move;
    wait_clocks(clk, 10);
    pulse(clk, drive.feed_watchdog);
    fed_at := seen.clocks_run;
    -- 17 clocks for a line of three axes.
    put_line(clk, drive, seen, 100);
    put_line(clk, drive, seen, 100);
    pulse(clk, drive.snapshot);
    pulse(clk, drive.software_start);
    pulse(clk, drive.start);
    pulse(clk, drive.acknowledge_stop);
    pulse(clk, drive.set_position(0));
    drive.override <= to_unsigned(65535, 18);
    wait_clocks(clk, 20);
    drive.override <= to_unsigned(65536, 18);
    put_line(clk, drive, seen, 100);
    pulse(clk, drive.flush);
    for i in 1 to limit loop
      exit when seen.stopped = '1';
      wait_clocks(clk, 1);
    end loop;
    only_feeding_feeds : assert seen.stop_cause.watchdog = '1' and seen.clocks_run - fed_at < limit + 6
      report "fed by something else" severity failure;
    drive.watchdog_limit <= 0;
    acknowledge(clk, drive, seen);

    -- Time goes on beyond 32 bits.
    now <= force before_carry;
    wait_clocks(clk, 1);
    wait until falling_edge(clk);
    now <= release;
    wait_clocks(clk, 20);
    pulse(clk, drive.snapshot);
    wait_clocks(clk, 2);
    counts_in_64_bits : assert
      seen.snapshot_time > before_carry + 15 and seen.snapshot_time < before_carry + 30
      report to_hstring(seen.snapshot_time) severity failure;
    finish;
  end process;

end architecture;
