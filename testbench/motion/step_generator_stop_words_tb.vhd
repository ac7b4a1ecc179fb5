-- SPDX-License-Identifier: Apache-2.0
-- Snapshot, hold, watchdog and every way to stop, by the registers: each cause, switch flag and
-- latch leads to its own place. A second generator with gated clocks does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_stop_words_tb is
end entity;

architecture simulation of step_generator_stop_words_tb is

  constant axes : positive := 2;
  constant depth : positive := 4;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : generator_inputs_t := generator_inputs_none;
  signal outputs : generator_outputs_t;
  signal clocks_run, clocks_left_out : natural;

  alias clk is master.clk;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => depth)
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      clocks_run => clocks_run, clocks_left_out => clocks_left_out);

  test : process
    variable word, kept : word_t;
    variable status : step_generator_status_t;
    variable number, other : natural;

    procedure expect_stop(cause_bit : natural) is
    begin
      wait_clocks(clk, 4);
      assert outputs.stop_interrupt = '1' and outputs.moving = '0' severity failure;
      expect(master, step_generator_stop_cause_address, 2 ** cause_bit);
      read(master, step_generator_status_address, word);
      status := to_step_generator_status(word);
      assert status.stopped and not (status.braking or status.held) and status.level ?= 0 severity failure;
      inputs.end_stops <= x"00";
      write(master, step_generator_command_address, acknowledge_command);
      wait_clocks(clk, 3);
      assert outputs.stop_interrupt = '0' report "the stop is not acknowledged" severity failure;
      wait_until_idle(clk, outputs.idle);
    end procedure;

    -- An end stop of the mask ends a segment in its middle.
    procedure stop_by_switch(flags : natural; levels, new_levels : std_ulogic_vector(7 downto 0)) is
    begin
      inputs.end_stops <= levels;
      append_segment(master, 90, 90, 100, ends_motion + 2 ** 3 * one_of_mask + flags);
      wait_clocks(clk, 150);
      assert outputs.moving = '1' report "stopped before its switch" severity failure;
      other := clocks_run;
      inputs.end_stops <= new_levels;
    end procedure;
  begin
    wait_clocks(clk, 2);
    reset <= '0';
    wait_clocks(clk, 2);

    write(master, step_generator_control_address, run + both_interrupts);
    write(master, step_generator_motor_enable_address, 3);
    write(master, step_generator_brake_slope_address, 2 ** 24);
    write(master, step_generator_override_slope_address, 2 ** 26);
    write(master, step_generator_pulse_guard_address, pulse_guard(high => 4, low => 9));
    write(master, step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 4));
    write(master, step_generator_direction_guard_address, direction_guard(setup => 3, hold => 2));
    write(master, step_generator_direction_guard_address + 4, direction_guard(setup => 3, hold => 2));
    expect(master, step_generator_errors_address, 0);

    -- A snapshot takes one clock; a hold stands still, and the override is a scale of time.
    write(master, step_generator_watchdog_address, 400);
    expect(master, step_generator_watchdog_address, 400);
    append_segment(master, 50, 25, 100);
    wait_clocks(clk, 100);
    write(master, step_generator_override_address, 0);
    wait_clocks(clk, 80);
    read(master, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.held and status.moving and not (status.braking or status.stopped or status.idle)
      report to_hstring(word) severity failure;
    expect(master, step_generator_scale_address, 0);
    write(master, step_generator_command_address, snapshot_command);
    read(master, step_generator_snapshot_time_low_address, number);
    assert clocks_run - number < 12 severity failure;
    expect(master, step_generator_snapshot_time_low_address + 4, 0);
    read(master, step_generator_position_address, word);
    expect(master, step_generator_snapshot_position_address, word);
    read(master, step_generator_position_address + 4, word);
    expect(master, step_generator_snapshot_position_address + 4, word);
    expect(master, step_generator_snapshot_position_address + 8, 0);
    write(master, step_generator_override_address, 65536);

    -- The watchdog: motion runs on while it is fed.
    write(master, step_generator_command_address, feed_command);
    for i in 1 to 3 loop
      wait_clocks(clk, 300);
      write(master, step_generator_command_address, feed_command);
    end loop;
    wait_clocks(clk, 390);
    assert outputs.moving = '1' severity failure;
    wait_clocks(clk, 15);
    expect_stop(step_generator_stop_cause_watchdog_bit);
    write(master, step_generator_watchdog_address, 0);
    read(master, step_generator_position_address, word);
    expect(master, step_generator_stop_position_address, word);
    read(master, step_generator_position_address + 4, word);
    expect(master, step_generator_stop_position_address + 4, word);
    kept := word;
    expect(master, step_generator_stop_position_address + 8, 0);
    append_segment(master, 8, 8, 8);
    wait_until_idle(clk, outputs.idle);
    expect(master, step_generator_stop_position_address + 4, kept);
    read(master, step_generator_position_address + 4, word);
    assert word /= kept severity failure;
    read(master, step_generator_stop_time_low_address, number);
    assert number < clocks_run and number > clocks_run - 1000 severity failure;
    expect(master, step_generator_stop_time_low_address + 4, 0);

    -- Software stops and brakes.
    append_segment(master, 90, 90, 100);
    wait_clocks(clk, 150);
    write(master, step_generator_command_address, stop_command);
    append_segment(master, 1, 1, 8);
    expect_error(master, step_generator_errors_while_stopped_bit);
    expect_stop(step_generator_stop_cause_software_bit);
    append_segment(master, 90, 90, 100);
    wait_clocks(clk, 150);
    write(master, step_generator_command_address, brake_command);
    read(master, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.braking and status.moving and not status.stopped report to_hstring(word) severity failure;
    wait_clocks(clk, 260);
    expect_stop(step_generator_stop_cause_software_brake_bit);

    -- Each switch flag.
    stop_by_switch(0, x"F7", x"08");
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(on_change, x"08", x"00");
    wait_clocks(clk, 10);
    inputs.end_stops <= x"08";
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(on_release, x"08", x"F7");
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);
    stop_by_switch(brakes, x"00", x"08");
    wait_clocks(clk, 2);
    read(master, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.braking and status.moving and not status.stopped report to_hstring(word) severity failure;
    read(master, step_generator_stop_time_low_address, number);
    assert number >= other and number <= other + 1 severity failure;
    wait_clocks(clk, 260);
    expect_stop(step_generator_stop_cause_end_stops_bits'low + 3);

    -- Without its bit no interrupt.
    write(master, step_generator_control_address, run);
    wait_clocks(clk, 2);
    assert outputs.queue_interrupt = '0' severity failure;
    append_segment(master, 90, 90, 100);
    wait_clocks(clk, 100);
    wait until falling_edge(clk);
    inputs.emergency_stop <= '1';
    wait for 1 ns;
    assert outputs.enable = "00" report "a driver is enabled in an emergency" severity failure;
    wait_clocks(clk, 2);
    inputs.emergency_stop <= '0';
    wait_clocks(clk, 2);
    assert outputs.stop_interrupt = '0' and outputs.moving = '0' severity failure;
    expect(master, step_generator_motor_enable_address, 0);
    read(master, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.positions_lost and status.stopped severity failure;
    write(master, step_generator_motor_enable_address, 3);
    expect_error(master, step_generator_errors_settings_bit);
    write(master, step_generator_control_address, run + stop_interrupt_enable);
    wait_clocks(clk, 2);
    expect_stop(step_generator_stop_cause_emergency_input_bit);
    expect(master, step_generator_status_address, depth * one_free + positions_lost_status + idle_status);
    write(master, step_generator_command_address, positions_known_command);
    expect(master, step_generator_status_address, depth * one_free + idle_status);

    std.env.finish;
  end process;

end architecture;
