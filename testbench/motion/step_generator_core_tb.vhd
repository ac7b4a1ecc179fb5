-- SPDX-License-Identifier: Apache-2.0
-- Random lines through queue, base and axes: exact counts, guards, positions; then hold, end stop and brake.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_core_bench_pkg.all;
use work.random_source_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_pkg.all;

entity step_generator_core_tb is
end entity;

architecture simulation of step_generator_core_tb is

  signal clk : std_ulogic;
  signal drive : core_inputs_t := inputs_in_reset;
  signal seen : core_outputs_t;

begin

  rig : entity work.step_generator_core_rig
    port map (clk => clk, drive => drive, seen => seen);

  test : process
    constant mask_of_2 : natural := 2 ** 2 * one_of_mask;
    type integers_t is array (natural range <>) of integer;
    variable random : random_source_t;
    variable expected : integers_t(axes - 1 downto 0) := (others => 0);
    variable expected_pulses : naturals_t(axes - 1 downto 0) := (others => 0);
    variable line_ticks, steps, backward, starts : natural;
    variable pulses_at_stop : naturals_t(axes - 1 downto 0);
  begin
    random.seed(3, 5);
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    drive.reset <= '0';

    for line in 1 to 60 loop
      if seen.level = depth then
        wait until rising_edge(clk) and seen.level < depth;
      end if;
      line_ticks := random.between(1, 20);
      backward := random.between(0, 7);
      -- Some axes ahead, some behind.
      starts := 0;
      for axis in 0 to axes - 1 loop
        case random.between(0, 2) is
          when 1 => starts := starts + 2 ** axis * one_ahead;
          when 2 => starts := starts + 2 ** axis * one_behind;
          when others => null;
        end case;
      end loop;
      put(clk, drive.write, flags_lane, starts + backward);
      put(clk, drive.write, line_ticks_lane, line_ticks);
      for axis in 0 to axes - 1 loop
        steps := random.between(0, line_ticks);
        put(clk, drive.write, steps_lane + axis, steps);
        expected_pulses(axis) := expected_pulses(axis) + steps;
        if (backward / 2 ** axis) mod 2 = 1 then
          expected(axis) := expected(axis) - steps;
        else
          expected(axis) := expected(axis) + steps;
        end if;
      end loop;
      put_course(clk, drive, line_ticks, 2 ** random.between(26, 30));
    end loop;
    wait_until_idle(clk, seen);
    for axis in 0 to axes - 1 loop
      assert seen.positions(axis) = expected(axis) report "axis " & to_string(axis) severity failure;
      assert seen.pulses(axis) = expected_pulses(axis) severity failure;
    end loop;
    assert seen.segments = 60 and seen.max_level >= 2 severity failure;
    assert seen.axis_stalls(2) > 0 and seen.stalls >= seen.axis_stalls(2) severity failure;
    assert seen.axis_stalls(0) = 0 report "the fast axis was late" severity failure;

    -- Positions are set at rest, and refused in motion.
    drive.new_position <= to_signed(-77, 32);
    drive.set_position <= "010";
    wait for 1 ns;
    assert seen.position_refused = '0' severity failure;
    wait until rising_edge(clk);
    drive.set_position <= "000";
    drive.new_position <= to_signed(12345, 32);
    put(clk, drive.write, flags_lane, mask_of_2);
    put(clk, drive.write, line_ticks_lane, 1000);
    for axis in 0 to axes - 1 loop
      put(clk, drive.write, steps_lane + axis, 1000);
    end loop;
    put_course(clk, drive, 600, 2 ** 24);
    put(clk, drive.write, flags_lane, mask_of_2 + continues);
    put_course(clk, drive, 400, 2 ** 24);
    wait until rising_edge(clk) and seen.moving = '1';
    drive.set_position <= "010";
    wait for 1 ns;
    assert seen.position_refused = '1' severity failure;
    wait until rising_edge(clk);
    drive.set_position <= "000";

    -- A hold comes along its ramp of 256 clocks, and nothing moves until it is over.
    wait until rising_edge(seen.step(0));
    assert seen.positions(1) = -76 severity failure;
    wait_clocks(clk, 300);
    drive.override <= to_unsigned(0, 18);
    wait_clocks(clk, 250);
    assert seen.held = '0' and seen.moving = '1' severity failure;
    wait_clocks(clk, 12);
    assert seen.held = '1' and seen.moving = '1' and seen.scale = 0 severity failure;
    pulses_at_stop := seen.pulses;
    wait_clocks(clk, 2000);
    assert seen.pulses = pulses_at_stop severity failure;
    drive.override <= to_unsigned(2 * 65536, 18);
    wait_clocks(clk, 520);
    assert seen.held = '0' and seen.scale = 2 * scale_of_one severity failure;
    -- Twice as fast: a tick in 128 clocks.
    pulses_at_stop := seen.pulses;
    wait_clocks(clk, 1280);
    assert abs (seen.pulses(0) - pulses_at_stop(0) - 10) <= 1
      report to_string(seen.pulses(0) - pulses_at_stop(0)) & " steps" severity failure;

    -- The end stop hits: no step from its clock on.
    wait_clocks(clk, 1000);
    wait until falling_edge(clk);
    drive.end_stops <= x"04";
    pulses_at_stop := seen.pulses;
    wait_clocks(clk, 1000);
    assert seen.stopped = '1' and seen.moving = '0' and seen.level = 0 severity failure;
    assert seen.stop_cause.end_stops = x"04" severity failure;
    assert seen.stop_positions = seen.positions severity failure;
    assert seen.stop_time = seen.clocks_run - 999
      report "the stop is of clock " & to_string(to_integer(seen.stop_time)) & ", now " &
        to_string(seen.clocks_run) severity failure;
    for axis in 0 to axes - 1 loop
      assert seen.pulses(axis) <= pulses_at_stop(axis) + 1 severity failure;
    end loop;

    -- The brake: positions of the hit are latched, motion goes on along the ramp, then it is a stop.
    drive.override <= to_unsigned(65536, 18);
    drive.end_stops <= x"00";
    drive.acknowledge_stop <= '1';
    wait_clocks(clk, 1);
    drive.acknowledge_stop <= '0';
    put(clk, drive.write, flags_lane, mask_of_2 + brakes + waits);
    put(clk, drive.write, line_ticks_lane, 5000);
    for axis in 0 to axes - 1 loop
      put(clk, drive.write, steps_lane + axis, 5000 - axis);
    end loop;
    put_course(clk, drive, 5000, 2 ** 24);
    wait_clocks(clk, 10);
    assert seen.waiting = '1' and seen.moving = '0' severity failure;
    drive.start <= '1';
    wait_clocks(clk, 3);
    assert seen.waiting = '0' and seen.moving = '1' severity failure;
    wait_clocks(clk, 2000);
    drive.end_stops <= x"04";
    wait_clocks(clk, 2);
    assert seen.braking = '1' and seen.stopped = '0' severity failure;
    wait_clocks(clk, 1);
    assert seen.stop_positions = seen.positions severity failure;
    -- 2048 clocks at half of 2^-8 ticks per clock on average: 4 ticks.
    pulses_at_stop := seen.pulses;
    wait_clocks(clk, 2051);
    assert seen.stopped = '1' and seen.moving = '0' and seen.level = 0 and seen.idle = '1' severity failure;
    assert seen.pulses(0) - pulses_at_stop(0) = 4
      report to_string(seen.pulses(0) - pulses_at_stop(0)) & " steps along the ramp" severity failure;
    assert seen.positions(0) - seen.stop_positions(0) = 4 severity failure;
    drive.end_stops <= x"00";
    acknowledge(clk, drive, seen);
    finish;
  end process;

end architecture;
