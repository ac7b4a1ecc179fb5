-- SPDX-License-Identifier: Apache-2.0
-- Each command and each kind of stop of the step generator, and what it leaves behind.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_core_bench_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_pkg.all;

entity step_generator_core_commands_tb is
end entity;

architecture simulation of step_generator_core_commands_tb is

  signal clk : std_ulogic;
  signal drive : core_inputs_t := inputs_in_reset;
  signal seen : core_outputs_t;

begin

  rig : entity work.step_generator_core_rig
    port map (clk => clk, drive => drive, seen => seen);

  test : process
    variable expected_time : natural;
    variable expected_positions : position_array_t(axes - 1 downto 0);
    variable segments_before : count_t;

    -- The first word comes with the next clock.
    procedure expect_line(what : string) is
      variable before : count_t;
    begin
      put_words(clk, drive, 20);
      before := seen.segments;
      pulse(clk, drive.commit);
      assert seen.refused = refusal_none report "refused " & what severity failure;
      wait_clocks(clk, 3);
      wait_until_idle(clk, seen);
      assert seen.segments = before + 1 report "lost " & what severity failure;
    end procedure;
  begin
    wait_clocks(clk, 2);
    drive.reset <= '0';
    -- High from here on: a start that stays high starts once.
    drive.start <= '1';

    -- Without `run` nothing starts; a segment that waits starts at software's word, too.
    drive.run <= '0';
    put_line(clk, drive, seen, 20);
    wait_clocks(clk, 50);
    assert seen.moving = '0' and seen.level = 1 and seen.idle = '0' severity failure;
    drive.run <= '1';
    wait_until_idle(clk, seen);
    put_line(clk, drive, seen, 20, waits);
    wait_clocks(clk, 50);
    assert seen.waiting = '1' and seen.moving = '0' severity failure;
    pulse(clk, drive.software_start);
    wait_clocks(clk, 3);
    assert seen.waiting = '0' and seen.moving = '1' severity failure;
    wait_until_idle(clk, seen);

    -- A start that stays high starts once.
    drive.start <= '0';
    wait_clocks(clk, 2);
    drive.start <= '1';
    wait_clocks(clk, 3);
    put_line(clk, drive, seen, 20, waits);
    wait_clocks(clk, 50);
    assert seen.waiting = '1' and seen.moving = '0' severity failure;

    -- A flush leaves nothing: neither what is queued nor what is half written.
    put_line(clk, drive, seen, 20);
    assert seen.level = 2 severity failure;
    put(clk, drive.write, flags_lane, 0);
    put(clk, drive.write, line_ticks_lane, 20);
    pulse(clk, drive.flush);
    wait_clocks(clk, 1);
    assert seen.level = 0 and seen.waiting = '0' and seen.idle = '1' and seen.moving = '0' severity failure;
    put_steps(clk, drive, 20);
    expect_refusal(clk, drive.commit, seen, incomplete);
    put_line(clk, drive, seen, 20);
    assert seen.level = 1 or seen.moving = '1' report "nothing is accepted after a flush" severity failure;
    wait_until_idle(clk, seen);

    -- In motion it leaves what is executed, to its end, and nothing behind it.
    segments_before := seen.segments;
    expected_positions := seen.positions;
    for i in 1 to depth loop
      put_line(clk, drive, seen, 50);
    end loop;
    assert seen.moving = '1' and seen.level = depth - 1 severity failure;
    pulse(clk, drive.flush);
    wait_clocks(clk, 1);
    assert seen.level = 0 and seen.moving = '1' report "a flush in motion" severity failure;
    wait_until_idle(clk, seen);
    assert seen.segments = segments_before + 1 and seen.positions(0) = expected_positions(0) + 50
      report "not what was being executed alone" severity failure;

    -- What is written from the clock after a flush or a reset on counts, after any number of flushes before.
    for flushes in 1 to 2 loop
      pulse(clk, drive.flush);
      expect_line("after a flush");
      pulse(clk, drive.flush);
      wait_clocks(clk, 5);
      for clocks in 1 to 3 loop
        drive.reset <= '1';
        wait_clocks(clk, clocks);
        drive.reset <= '0';
        expect_line("after a reset");
        for i in 1 to flushes loop
          pulse(clk, drive.flush);
          wait_clocks(clk, 5);
        end loop;
      end loop;
    end loop;

    -- So it does after a reset of a full queue.
    drive.run <= '0';
    for i in 1 to depth loop
      put_line(clk, drive, seen, 20);
    end loop;
    pulse(clk, drive.reset);
    drive.run <= '1';
    expect_line("after a full queue");

    -- Time that stands still holds a segment only where there is one.
    drive.override <= to_unsigned(0, 18);
    wait_clocks(clk, 10);
    assert seen.scale = 0 and seen.held = '0' report "held without motion" severity failure;
    put_line(clk, drive, seen, 20);
    wait_clocks(clk, 10);
    assert seen.held = '1' and seen.moving = '1' severity failure;
    drive.override <= to_unsigned(65536, 18);
    wait_clocks(clk, 300);
    wait_until_idle(clk, seen);
    assert seen.held = '0' severity failure;

    -- No line for an axis without its driver.
    drive.enabled <= "101";
    put_words(clk, drive, 20);
    expect_refusal(clk, drive.commit, seen, disabled);
    drive.enabled <= "111";

    -- A full queue takes no more, and as soon as it has room it does.
    drive.run <= '0';
    for i in 1 to depth loop
      put_line(clk, drive, seen, 20);
    end loop;
    assert seen.level = depth severity failure;
    put_words(clk, drive, 20);
    expect_refusal(clk, drive.commit, seen, queue_full);
    drive.run <= '1';
    wait until rising_edge(clk) and seen.level < depth;
    wait_clocks(clk, 2);
    put_line(clk, drive, seen, 20);
    wait_until_idle(clk, seen);
    assert seen.max_level = depth severity failure;

    -- A snapshot takes positions and time of its clock; what stopped before stays as it was.
    put_line(clk, drive, seen, 100);
    wait_clocks(clk, 150);
    for i in 1 to 3 loop
      -- One in each half of a step.
      wait_clocks(clk, 37);
      wait until falling_edge(clk);
      expected_time := seen.clocks_run;
      expected_positions := seen.positions;
      drive.snapshot <= '1';
      wait_clocks(clk, 1);
      drive.snapshot <= '0';
      wait_clocks(clk, 20);
      assert seen.snapshot_time = expected_time report "the snapshot is of clock " &
        to_string(to_integer(seen.snapshot_time)) & " instead of " & to_string(expected_time)
        severity failure;
      assert seen.snapshot_positions = expected_positions severity failure;
    end loop;

    -- The watchdog: motion runs on while it is fed, then it stops.
    drive.watchdog_limit <= 100;
    pulse(clk, drive.feed_watchdog);
    for i in 1 to 4 loop
      wait_clocks(clk, 80);
      pulse(clk, drive.feed_watchdog);
    end loop;
    assert seen.moving = '1' and seen.stopped = '0' severity failure;
    wait_clocks(clk, 90);
    assert seen.stopped = '0' severity failure;
    wait_clocks(clk, 15);
    drive.watchdog_limit <= 0;
    expect_stop(clk, drive, seen, (end_stops => x"00", watchdog => '1', others => '0'));

    -- The emergency input, and software.
    put_line(clk, drive, seen, 100);
    wait_clocks(clk, 100);
    pulse(clk, drive.emergency_stop);
    expect_stop(clk, drive, seen, (end_stops => x"00", emergency_input => '1', others => '0'));
    put_line(clk, drive, seen, 100);
    wait_clocks(clk, 100);
    pulse(clk, drive.software_stop);
    expect_stop(clk, drive, seen, (end_stops => x"00", software => '1', others => '0'));
    put_line(clk, drive, seen, 100);
    wait_clocks(clk, 100);
    pulse(clk, drive.software_brake);
    wait_clocks(clk, 1);
    assert seen.braking = '1' and seen.stopped = '0' and seen.moving = '1' severity failure;
    put_words(clk, drive, 20);
    expect_refusal(clk, drive.commit, seen, while_stopped);
    wait_clocks(clk, 2100);
    expect_stop(clk, drive, seen, (end_stops => x"00", software_brake => '1', others => '0'));

    -- A stop comes while the bus rests, with a segment half written: the rest of it is not taken for a
    -- segment, and the next one is taken. Twice, for what counts modulo 2.
    for i in 1 to 2 loop
      put(clk, drive.write, flags_lane, 0);
      put(clk, drive.write, line_ticks_lane, 20);
      wait_clocks(clk, 2);
      drive.bus_rests <= true;
      wait_clocks(clk, 5);
      pulse(clk, drive.emergency_stop);
      wait_clocks(clk, 5);
      drive.bus_rests <= false;
      wait_clocks(clk, 1);
      acknowledge(clk, drive, seen);
      put_steps(clk, drive, 20);
      expect_refusal(clk, drive.commit, seen, incomplete);
      segments_before := seen.segments;
      put_line(clk, drive, seen, 20);
      wait_until_idle(clk, seen);
      assert seen.segments = segments_before + 1 severity failure;
    end loop;
    for axis in 0 to axes - 1 loop
      assert seen.stop_positions(axis) /= seen.positions(axis) severity failure;
    end loop;

    finish;
  end process;

end architecture;
