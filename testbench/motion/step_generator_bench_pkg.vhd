-- SPDX-License-Identifier: Apache-2.0
-- The step generator's registers as its benches use them: bits and places as numbers, and a segment in
-- one call.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.step_generator_registers_pkg.all;

package step_generator_bench_pkg is

  constant run : natural := 2 ** step_generator_control_run_bit;
  constant stop_interrupt_enable : natural := 2 ** step_generator_control_stop_interrupt_enable_bit;
  constant both_interrupts : natural := stop_interrupt_enable
    + 2 ** step_generator_control_queue_interrupt_enable_bit;
  constant one_of_threshold : natural := 2 ** step_generator_control_queue_threshold_bits'low;

  constant flush_command : natural := 2 ** step_generator_command_flush_bit;
  constant stop_command : natural := 2 ** step_generator_command_stop_bit;
  constant acknowledge_command : natural := 2 ** step_generator_command_acknowledge_stop_bit;
  constant snapshot_command : natural := 2 ** step_generator_command_snapshot_bit;
  constant clear_errors_command : natural := 2 ** step_generator_command_clear_errors_bit;
  constant start_command : natural := 2 ** step_generator_command_start_bit;
  constant brake_command : natural := 2 ** step_generator_command_brake_bit;
  constant feed_command : natural := 2 ** step_generator_command_feed_watchdog_bit;
  constant positions_known_command : natural := 2 ** step_generator_command_positions_known_bit;

  constant idle_status : natural := 2 ** step_generator_status_idle_bit;
  constant waiting_status : natural := 2 ** step_generator_status_waiting_bit;
  constant positions_lost_status : natural := 2 ** step_generator_status_positions_lost_bit;
  constant one_queued : natural := 2 ** step_generator_status_level_bits'low;
  constant one_free : natural := 2 ** step_generator_status_free_bits'low;

  constant ends_motion : natural := 2 ** step_generator_segment_flags_ends_motion_bit;
  constant on_change : natural := 2 ** step_generator_segment_flags_stop_on_change_bit;
  constant on_release : natural := 2 ** step_generator_segment_flags_stop_on_release_bit;
  constant brakes : natural := 2 ** step_generator_segment_flags_stop_brakes_bit;
  constant waits : natural := 2 ** step_generator_segment_flags_waits_for_start_bit;
  constant continues : natural := 2 ** step_generator_segment_flags_continues_line_bit;
  constant one_backward : natural := 2 ** step_generator_segment_flags_backward_bits'low;
  constant one_of_mask : natural := 2 ** step_generator_segment_flags_stop_mask_bits'low;
  constant one_ahead : natural := 2 ** step_generator_segment_flags_ahead_bits'low;
  constant one_behind : natural := 2 ** step_generator_segment_flags_behind_bits'low;

  -- The pins of a generator of two axes.
  type generator_inputs_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_stop : std_ulogic;
    start : std_ulogic;
  end record;

  type generator_outputs_t is record
    step : std_ulogic_vector(1 downto 0);
    direction : std_ulogic_vector(1 downto 0);
    enable : std_ulogic_vector(1 downto 0);
    moving : std_ulogic;
    idle : std_ulogic;
    queue_interrupt : std_ulogic;
    stop_interrupt : std_ulogic;
  end record;

  constant generator_inputs_none : generator_inputs_t := (end_stops => x"00", others => '0');

  function pulse_guard(high, low : natural) return natural;
  function direction_guard(setup, hold : natural) return natural;

  -- All words of a segment of two axes but the commit, at a constant rate: `rate_high` in 2^-32 ticks
  -- per clock, 16 clocks a tick where it is not given.
  procedure write_segment (
    signal master : inout bus_master_t;
    x, y, ticks : in natural;
    flags : in natural := ends_motion;
    rate_high : in natural := 2 ** 28);

  -- The same with its commit.
  procedure append_segment (
    signal master : inout bus_master_t;
    x, y, ticks : in natural;
    flags : in natural := ends_motion;
    rate_high : in natural := 2 ** 28);

  -- It is the only error since they were cleared; clears it.
  procedure expect_error (
    signal master : inout bus_master_t;
    bit_number : in natural);

  procedure wait_until_idle (signal clk, idle : in std_ulogic);

end package;

package body step_generator_bench_pkg is

  function pulse_guard(high, low : natural) return natural is
  begin
    return high * 2 ** step_generator_pulse_guard_high_bits'low
      + low * 2 ** step_generator_pulse_guard_low_bits'low;
  end function;

  function direction_guard(setup, hold : natural) return natural is
  begin
    return setup * 2 ** step_generator_direction_guard_setup_bits'low
      + hold * 2 ** step_generator_direction_guard_hold_bits'low;
  end function;

  procedure write_segment (
    signal master : inout bus_master_t;
    x, y, ticks : in natural;
    flags : in natural := ends_motion;
    rate_high : in natural := 2 ** 28) is
  begin
    write(master, step_generator_segment_flags_address, flags);
    write(master, step_generator_segment_line_ticks_address, ticks);
    write(master, step_generator_segment_steps_address, x);
    write(master, step_generator_segment_steps_address + 4, y);
    write(master, step_generator_segment_ticks_address, ticks);
    write(master, step_generator_segment_rate_low_address, 0);
    write(master, step_generator_segment_acceleration_low_address, 0);
    write(master, step_generator_segment_acceleration_high_address, 0);
    write(master, step_generator_segment_jerk_low_address, 0);
    write(master, step_generator_segment_jerk_high_address, 0);
    write(master, step_generator_segment_rate_high_address, rate_high);
  end procedure;

  procedure append_segment (
    signal master : inout bus_master_t;
    x, y, ticks : in natural;
    flags : in natural := ends_motion;
    rate_high : in natural := 2 ** 28) is
  begin
    write_segment(master, x, y, ticks, flags, rate_high);
    write(master, step_generator_segment_commit_address, 0);
  end procedure;

  procedure expect_error (
    signal master : inout bus_master_t;
    bit_number : in natural) is
  begin
    expect(master, step_generator_errors_address, 2 ** bit_number);
    write(master, step_generator_command_address, clear_errors_command);
    expect(master, step_generator_errors_address, 0);
  end procedure;

  procedure wait_until_idle (signal clk, idle : in std_ulogic) is
  begin
    wait until rising_edge(clk) and idle = '1' for 100 us;
    assert idle = '1' report "does not come to rest" severity failure;
    wait_clocks(clk, 3);
  end procedure;

end package body;
