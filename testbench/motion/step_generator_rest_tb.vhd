-- SPDX-License-Identifier: Apache-2.0
-- A step generator does the same whether it gets the clock edges at rest or not, under random segments,
-- switches, starts, commands, settings and resets; and it rests between ticks that are far apart.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.random_source_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_rest_tb is
end entity;

architecture simulation of step_generator_rest_tb is

  constant depth : positive := 3;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : generator_inputs_t := generator_inputs_none;
  signal outputs : generator_outputs_t;
  signal clocks_left_out : natural;

  alias clk is master.clk;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => depth)
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      clocks_run => open, clocks_left_out => clocks_left_out);

  test : process

    constant slow : natural := 2 ** 24;  -- a tick in 256 clocks

    variable random : random_source_t;
    variable word : word_t;
    variable motions, stops : natural := 0;
    variable left_out_before : natural;

    -- One in so many.
    impure function seldom(share : positive) return boolean is
    begin
      return random.between(1, share) = 1;
    end function;

    procedure start_over is
    begin
      inputs <= generator_inputs_none;
      reset <= '1';
      wait_clocks(clk, random.between(1, 3));
      reset <= '0';
      wait_clocks(clk, 1);
      write(master, step_generator_control_address, run + both_interrupts + one_of_threshold);
      write(master, step_generator_motor_enable_address, 3);
      write(master, step_generator_brake_slope_address, 2 ** 24);
      write(master, step_generator_override_slope_address, 2 ** 25);
      write(master, step_generator_pulse_guard_address, pulse_guard(high => 4, low => 9));
      write(master, step_generator_pulse_guard_address + 4, pulse_guard(high => 30, low => 20));
      write(master, step_generator_direction_guard_address, direction_guard(setup => 3, hold => 2));
      write(master, step_generator_direction_guard_address + 4, direction_guard(setup => 20, hold => 30));
    end procedure;

    -- Of few ticks, mostly far apart; often ended by one of three switches.
    procedure append_anything is
      variable ticks : positive;
      variable flags : natural;
    begin
      ticks := random.between(1, 12);
      flags := random.between(0, 3) * one_backward + random.between(0, 7) * one_of_mask;
      for each in 1 to 5 loop
        if seldom(3) then
          case each is
            when 1 => flags := flags + ends_motion;
            when 2 => flags := flags + waits;
            when 3 => flags := flags + on_change;
            when 4 => flags := flags + on_release;
            when others => flags := flags + brakes;
          end case;
        end if;
      end loop;
      write_segment(master, random.between(0, ticks), random.between(0, ticks), ticks, flags,
        rate_high => 2 ** random.between(24, 28));
      -- The rate falls or rises, also within a tick.
      if seldom(3) then
        write(master, step_generator_segment_acceleration_high_address, random.between(0, 2 ** 20) - 2 ** 19);
        write(master, step_generator_segment_jerk_high_address, random.between(0, 2 ** 14) - 2 ** 13);
      end if;
      write(master, step_generator_segment_commit_address, 0);
    end procedure;

    procedure command_anything is
    begin
      case random.between(0, 19) is
        when 0 => write(master, step_generator_command_address, flush_command);
        when 1 => write(master, step_generator_command_address, stop_command);
        when 2 | 3 => write(master, step_generator_command_address, brake_command);
        when 4 | 5 => write(master, step_generator_command_address, snapshot_command);
        when 6 | 7 | 8 => write(master, step_generator_command_address, start_command);
        when 9 => write(master, step_generator_command_address, feed_command);
        when 10 => write(master, step_generator_position_address, random.between(0, 1000));
        when others => write(master, step_generator_command_address, acknowledge_command);
      end case;
    end procedure;

    procedure set_anything is
    begin
      case random.between(0, 5) is
        when 0 =>
          write(master, step_generator_watchdog_address, random.between(0, 1) * random.between(1, 3000));
        when 1 => write(master, step_generator_brake_slope_address, random.between(0, 2) * 2 ** 24);
        when 2 => write(master, step_generator_override_slope_address, random.between(0, 2) * 2 ** 25);
        when 3 => write(master, step_generator_override_address, random.between(0, 3) * 2 ** 16);
        when 4 => write(master, step_generator_override_address, random.between(0, 2 ** 18 - 1));
        when others => write(master, step_generator_override_address, 2 ** 16);
      end case;
    end procedure;

    procedure change_pin is
      variable switch : natural range 0 to 7;
    begin
      switch := random.between(0, 3);
      if seldom(3) then
        inputs.start <= not inputs.start;
      elsif seldom(20) then
        inputs.emergency_stop <= '1';
        wait_clocks(clk, random.between(1, 20));
        inputs.emergency_stop <= '0';
        write(master, step_generator_command_address, acknowledge_command);
        write(master, step_generator_motor_enable_address, 3);
      else
        inputs.end_stops(switch) <= not inputs.end_stops(switch);
      end if;
    end procedure;

    -- Of those that can be read: in front of the guard times, or behind.
    procedure read_anything is
    begin
      if seldom(2) then
        read(master, step_generator_status_address + 4 * random.between(0, 1), word);
      else
        read(master, step_generator_position_address + 4 * random.between(0, 39), word);
      end if;
    end procedure;

    procedure do_anything is
    begin
      case random.between(0, 15) is
        when 0 | 1 | 2 | 3 => append_anything;
        when 4 | 5 | 6 | 7 | 8 => change_pin;
        when 9 | 10 | 11 => command_anything;
        when 12 => set_anything;
        when others => read_anything;
      end case;
      if seldom(100) then
        start_over;
      end if;
      motions := motions + 1 when outputs.moving = '1' else motions;
      stops := stops + 1 when outputs.stop_interrupt = '1' else stops;
    end procedure;

    procedure expect_rest(what : string; least : natural) is
      variable before : natural;
    begin
      before := clocks_left_out;
      wait_clocks(clk, 1000);
      rests : assert clocks_left_out - before >= least
        report what & ": " & to_string(clocks_left_out - before) & " clocks left out" severity failure;
    end procedure;

    procedure expect_motion(what : string) is
    begin
      wait_clocks(clk, 4);
      assert outputs.moving = '1' report what severity failure;
    end procedure;

  begin
    random.seed(11, 3);
    wait_clocks(clk, 2);
    start_over;
    for round in 1 to 100 loop
      do_anything;
      case random.between(0, 3) is
        when 0 => null;
        when 1 => wait_clocks(clk, random.between(1, 20));
        when others => wait_clocks(clk, random.between(20, 100));
      end case;
    end loop;
    moves_and_stops : assert motions > 20 and stops > 10
      report to_string(motions) & " times in motion, " & to_string(stops) & " times stopped" severity failure;

    -- Without anything to do it rests; in motion it does between ticks, but for some clocks at each.
    start_over;
    wait_clocks(clk, 20);
    expect_rest("idle", 1000);
    append_segment(master, 6, 6, 6, rate_high => slow);
    expect_motion("does not start");
    expect_rest("in motion", 600);
    wait_until_idle(clk, outputs.idle);

    -- A start that has fallen at rest is one when it rises.
    inputs.start <= '1';
    wait_clocks(clk, 20);
    append_segment(master, 2, 2, 2, ends_motion + waits, slow);
    wait_clocks(clk, 20);
    inputs.start <= '0';
    wait_clocks(clk, 20);
    assert outputs.moving = '0' severity failure;
    inputs.start <= '1';
    expect_motion("a start is missed");
    wait_until_idle(clk, outputs.idle);

    -- A switch that was released at rest, between two ticks, stops by its change when it is triggered.
    inputs.end_stops <= x"01";
    append_segment(master, 20, 20, 20, ends_motion + one_of_mask + on_change, slow);
    -- The pulse of the first tick is over, and the second is far away.
    wait_clocks(clk, 400);
    left_out_before := clocks_left_out;
    inputs.end_stops <= x"00";
    wait_clocks(clk, 40);
    assert outputs.moving = '1' and clocks_left_out - left_out_before > 30
      report to_string(clocks_left_out - left_out_before) & " clocks left out" severity failure;
    inputs.end_stops <= x"01";
    wait_clocks(clk, 3);
    assert outputs.moving = '0' and outputs.stop_interrupt = '1' report "a switch is missed" severity failure;
    std.env.finish;
  end process;

end architecture;
