-- SPDX-License-Identifier: Apache-2.0
-- Snapshot, hold, watchdog and every way to stop, by the registers: each cause, switch flag and latch
-- leads to its own place. A second generator, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_stop_words_tb is
end entity;

architecture simulation of step_generator_stop_words_tb is

  constant axes : positive := 2;
  constant depth : positive := 4;

  signal clk, moving, idle, queue_interrupt, stop_interrupt : std_ulogic;
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal step, direction, enable : std_ulogic_vector(axes - 1 downto 0);
  signal end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop, start : std_ulogic := '0';
  signal clocks_run, clocks_left_out : natural;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => depth)
    port map (
      clk => clk, reset => reset, request => request, response => response, end_stops => end_stops,
      emergency_stop => emergency_stop, start => start, step => step, direction => direction,
      enable => enable, moving => moving, idle => idle, queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt, clocks_run => clocks_run, clocks_left_out => clocks_left_out);

  test : process
    variable word, kept : word_t;
    variable status : step_generator_status_t;
    variable number, other : natural;

    procedure write(address : unsigned(31 downto 0); data : natural) is
    begin
      bus_write(clk, request, response, address, data);
    end procedure;

    procedure read(address : unsigned(31 downto 0)) is
    begin
      bus_read(clk, request, response, address, word);
      number := to_integer(unsigned(word(30 downto 0)));
    end procedure;

    procedure expect(address : unsigned(31 downto 0); data : word_t) is
    begin
      bus_expect(clk, request, response, address, data);
    end procedure;

    procedure expect(address : unsigned(31 downto 0); data : natural) is
    begin
      expect(address, word_t(to_unsigned(data, 32)));
    end procedure;

    procedure clocks(count : natural) is
    begin
      wait_clocks(clk, count);
    end procedure;

    procedure put(x, y, ticks : natural; flags : natural := ends_motion) is
    begin
      write_segment(clk, request, response, x, y, ticks, flags);
    end procedure;

    procedure append(x, y, ticks : natural; flags : natural := ends_motion) is
    begin
      put(x, y, ticks, flags);
      write(step_generator_segment_commit_address, 0);
    end procedure;

    procedure expect_error(bit_number : natural) is
    begin
      expect_error(clk, request, response, bit_number);
    end procedure;


    procedure expect_stop(cause_bit : natural) is
    begin
      clocks(4);
      assert stop_interrupt = '1' and moving = '0' severity failure;
      expect(step_generator_stop_cause_address, 2 ** cause_bit);
      read(step_generator_status_address);
      status := to_step_generator_status(word);
      assert status.stopped and not (status.braking or status.held) and status.level ?= 0 severity failure;
      end_stops <= x"00";
      write(step_generator_command_address, acknowledge_command);
      clocks(3);
      assert stop_interrupt = '0' report "the stop is not acknowledged" severity failure;
      wait_until_idle(clk, idle);
    end procedure;

    -- An end stop of the mask ends a segment in its middle.
    procedure stop_by_switch(flags : natural; levels, new_levels : std_ulogic_vector(7 downto 0)) is
    begin
      end_stops <= levels;
      append(90, 90, 100, ends_motion + 2 ** 3 * one_of_mask + flags);
      clocks(150);
      assert moving = '1' report "stopped before its switch" severity failure;
      other := clocks_run;
      end_stops <= new_levels;
    end procedure;
  begin
    clocks(2);
    reset <= '0';
    clocks(2);

    write(step_generator_control_address, run + both_interrupts);
    write(step_generator_motor_enable_address, 3);
    write(step_generator_brake_slope_address, 2 ** 24);
    write(step_generator_override_slope_address, 2 ** 26);
    write(step_generator_pulse_guard_address, pulse_guard(high => 4, low => 9));
    write(step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 4));
    write(step_generator_direction_guard_address, direction_guard(setup => 3, hold => 2));
    write(step_generator_direction_guard_address + 4, direction_guard(setup => 3, hold => 2));
    expect(step_generator_errors_address, 0);

    -- A snapshot takes one clock; a hold stands still, and the override is a scale of time.
    write(step_generator_watchdog_address, 400);
    expect(step_generator_watchdog_address, 400);
    append(50, 25, 100);
    clocks(100);
    write(step_generator_override_address, 0);
    clocks(80);
    read(step_generator_status_address);
    status := to_step_generator_status(word);
    assert status.held and status.moving and not (status.braking or status.stopped or status.idle)
      report to_hstring(word) severity failure;
    expect(step_generator_scale_address, 0);
    write(step_generator_command_address, snapshot_command);
    read(step_generator_snapshot_time_low_address);
    assert clocks_run - number < 12 severity failure;
    expect(step_generator_snapshot_time_low_address + 4, 0);
    read(step_generator_position_address);
    expect(step_generator_snapshot_position_address, word);
    read(step_generator_position_address + 4);
    expect(step_generator_snapshot_position_address + 4, word);
    expect(step_generator_snapshot_position_address + 8, 0);
    write(step_generator_override_address, 65536);

    -- The watchdog: fed it lets motion be.
    write(step_generator_command_address, feed_command);
    for i in 1 to 3 loop
      clocks(300);
      write(step_generator_command_address, feed_command);
    end loop;
    clocks(390);
    assert moving = '1' severity failure;
    clocks(15);
    expect_stop(step_generator_stop_cause_watchdog_bit);
    write(step_generator_watchdog_address, 0);
    read(step_generator_position_address);
    expect(step_generator_stop_position_address, word);
    read(step_generator_position_address + 4);
    expect(step_generator_stop_position_address + 4, word);
    kept := word;
    expect(step_generator_stop_position_address + 8, 0);
    append(8, 8, 8);
    wait_until_idle(clk, idle);
    expect(step_generator_stop_position_address + 4, kept);
    read(step_generator_position_address + 4);
    assert word /= kept severity failure;
    read(step_generator_stop_time_low_address);
    assert number < clocks_run and number > clocks_run - 1000 severity failure;
    expect(step_generator_stop_time_low_address + 4, 0);

    -- Software stops and brakes.
    append(90, 90, 100);
    clocks(150);
    write(step_generator_command_address, stop_command);
    append(1, 1, 8);
    expect_error(step_generator_errors_while_stopped_bit);
    expect_stop(step_generator_stop_cause_software_bit);
    append(90, 90, 100);
    clocks(150);
    write(step_generator_command_address, brake_command);
    read(step_generator_status_address);
    status := to_step_generator_status(word);
    assert status.braking and status.moving and not status.stopped report to_hstring(word) severity failure;
    clocks(260);
    expect_stop(step_generator_stop_cause_software_brake_bit);

    -- Each switch flag.
    stop_by_switch(0, x"F7", x"08");
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(on_change, x"08", x"00");
    clocks(10);
    end_stops <= x"08";
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(on_release, x"08", x"F7");
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(brakes, x"00", x"08");
    clocks(2);
    read(step_generator_status_address);
    status := to_step_generator_status(word);
    assert status.braking and status.moving and not status.stopped report to_hstring(word) severity failure;
    read(step_generator_stop_time_low_address);
    assert number >= other and number <= other + 1 severity failure;
    clocks(260);
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);

    -- Without its bit no interrupt.
    write(step_generator_control_address, run);
    clocks(2);
    assert queue_interrupt = '0' severity failure;
    append(90, 90, 100);
    clocks(100);
    wait until falling_edge(clk);
    emergency_stop <= '1';
    wait for 1 ns;
    assert enable = "00" report "a driver is enabled in an emergency" severity failure;
    clocks(2);
    emergency_stop <= '0';
    clocks(2);
    assert stop_interrupt = '0' and moving = '0' severity failure;
    expect(step_generator_motor_enable_address, 0);
    read(step_generator_status_address);
    status := to_step_generator_status(word);
    assert status.positions_lost and status.stopped severity failure;
    write(step_generator_motor_enable_address, 3);
    expect_error(step_generator_errors_settings_bit);
    write(step_generator_control_address, run + stop_interrupt_enable);
    clocks(2);
    expect_stop(step_generator_stop_cause_emergency_input_bit);
    expect(step_generator_status_address, depth * one_free + positions_lost_status + idle_status);
    write(step_generator_command_address, positions_known_command);
    expect(step_generator_status_address, depth * one_free + idle_status);

    finish;
  end process;

end architecture;
