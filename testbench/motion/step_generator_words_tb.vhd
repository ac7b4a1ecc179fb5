-- SPDX-License-Identifier: Apache-2.0
-- Every register of the step generator by what it does: each setting, command, error and counter
-- leads to its own place. A second generator with gated clocks does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_words_tb is
end entity;

architecture simulation of step_generator_words_tb is

  constant axes : positive := 2;
  constant depth : positive := 4;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : generator_inputs_t := generator_inputs_none;
  signal outputs : generator_outputs_t;
  signal clocks_run, clocks_left_out : natural;

  type naturals_t is array (0 to axes - 1) of natural;
  signal pulses, rose_at, first_rise_at, high_clocks, period_clocks : naturals_t := (others => 0);
  signal wait_for_first : boolean := false;

  alias clk is master.clk;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => depth)
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      clocks_run => clocks_run, clocks_left_out => clocks_left_out);

  watch_pins : process
    variable before : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  begin
    wait until rising_edge(clk);
    for axis in 0 to axes - 1 loop
      if outputs.step(axis) = '1' and before(axis) = '0' then
        pulses(axis) <= pulses(axis) + 1;
        rose_at(axis) <= clocks_run;
        period_clocks(axis) <= clocks_run - rose_at(axis);
        if wait_for_first and first_rise_at(axis) = 0 then
          first_rise_at(axis) <= clocks_run;
        end if;
      elsif outputs.step(axis) = '0' and before(axis) = '1' then
        high_clocks(axis) <= clocks_run - rose_at(axis);
      end if;
      if not wait_for_first then
        first_rise_at(axis) <= 0;
      end if;
    end loop;
    before := outputs.step;
  end process;

  test : process
    variable word : word_t;
    variable number, other : natural;
    type shifts_t is array (0 to 3) of natural;
    constant shifts : shifts_t := (one_ahead, 2 * one_ahead, one_behind, 2 * one_behind);

  begin
    wait_clocks(clk, 2);
    reset <= '0';
    wait_clocks(clk, 2);

    -- After reset.
    expect(master, step_generator_build_address,
      axes + depth * 2 ** step_generator_build_queue_depth_bits'low);
    expect(master, step_generator_control_address, 0);
    expect(master, step_generator_status_address, depth * one_free + idle_status);
    expect(master, step_generator_motor_enable_address, 0);
    expect(master, step_generator_rate_floor_address, 8590);
    expect(master, step_generator_override_address, 65536);
    expect(master, step_generator_scale_address, 65536);
    expect(master, step_generator_errors_address, 0);
    assert outputs.queue_interrupt = '0' and outputs.stop_interrupt = '0' and outputs.enable = "00"
      severity failure;

    -- Settings read as they were written; at rest the scale follows at once.
    write(master, step_generator_control_address, 16#1234# * one_of_threshold + both_interrupts);
    expect(master, step_generator_control_address, 16#1234# * one_of_threshold + both_interrupts);
    assert outputs.queue_interrupt = '1' severity failure;
    write(master, step_generator_motor_enable_address, 3);
    expect(master, step_generator_motor_enable_address, 3);
    assert outputs.enable = "11" severity failure;
    write(master, step_generator_rate_floor_address, 4321);
    expect(master, step_generator_rate_floor_address, 4321);
    write(master, step_generator_override_address, 16#23456#);
    expect(master, step_generator_override_address, 16#23456#);
    expect(master, step_generator_scale_address, 16#23456#);
    write(master, step_generator_override_address, 65536);
    write(master, step_generator_override_slope_address, 2 ** 26);
    write(master, step_generator_brake_slope_address, 2 ** 24);
    write(master, step_generator_position_address, x"FFFFFFFB");
    write(master, step_generator_position_address + 4, 1000);
    write(master, step_generator_pulse_guard_address, pulse_guard(high => 4, low => 9));
    write(master, step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 40));
    write(master, step_generator_direction_guard_address, direction_guard(setup => 3, hold => 2));
    write(master, step_generator_direction_guard_address + 4, direction_guard(setup => 3, hold => 2));
    expect(master, step_generator_errors_address, 0);

    -- What is queued waits for `run`; the queue requests more at its threshold.
    write(master, step_generator_control_address, one_of_threshold + both_interrupts);
    append_segment(master, 2, 1, 8, 0);
    assert outputs.queue_interrupt = '1' severity failure;
    for i in 2 to depth loop
      append_segment(master, 2, 1, 8, 2 * one_backward);
    end loop;
    assert outputs.queue_interrupt = '0' severity failure;
    expect(master, step_generator_status_address, depth * one_queued);
    expect(master, step_generator_max_level_address, depth);
    write_segment(master, 2, 1, 8);
    write(master, step_generator_segment_commit_address, 0);
    expect_error(master, step_generator_errors_queue_full_bit);
    write(master, step_generator_position_address, 0);
    expect_error(master, step_generator_errors_position_bit);
    write(master, step_generator_rate_floor_address, 1);
    expect_error(master, step_generator_errors_settings_bit);
    write(master, step_generator_motor_enable_address, 1);
    expect_error(master, step_generator_errors_settings_bit);
    assert outputs.enable = "11" and outputs.moving = '0' and pulses = (0, 0) severity failure;
    write(master, step_generator_control_address, one_of_threshold + both_interrupts + run);
    wait_clocks(clk, 4);
    assert outputs.moving = '1' severity failure;
    wait_until_idle(clk, outputs.idle);
    assert pulses = (2 * depth, depth) and outputs.direction = "10" severity failure;
    assert high_clocks = (4, 6) report to_string(high_clocks(0)) & " " & to_string(high_clocks(1))
      severity failure;
    expect(master, step_generator_position_address, 2 * depth - 5);
    expect(master, step_generator_position_address + 4, 1000 + 1 - (depth - 1));
    expect(master, step_generator_position_address + 4 * axes, 0);
    expect(master, step_generator_segments_executed_address, depth);
    expect(master, step_generator_underruns_address, 1);
    expect(master, step_generator_stalls_address, 0);
    assert outputs.queue_interrupt = '1' severity failure;

    -- Steps faster than the second axis can: it stalls both.
    append_segment(master, 20, 20, 20);
    wait_until_idle(clk, outputs.idle);
    assert period_clocks(1) = 46 report to_string(period_clocks(1)) & " clocks" severity failure;
    read(master, step_generator_axis_stalls_address + 4, number);
    other := number;
    assert other > 19 * 25 severity failure;
    expect(master, step_generator_axis_stalls_address, 0);
    expect(master, step_generator_axis_stalls_address + 8, 0);
    read(master, step_generator_stalls_address, number);
    assert number >= other severity failure;
    expect(master, step_generator_underruns_address, 1);
    write(master, step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 4));

    -- Each refusal has its own bit; what is half written goes with a flush.
    write(master, step_generator_segment_flags_address, 0);
    write(master, step_generator_segment_commit_address, 0);
    expect_error(master, step_generator_errors_incomplete_bit);
    append_segment(master, 9, 0, 8);
    expect_error(master, step_generator_errors_illegal_bit);
    append_segment(master, 4, 0, 8, ends_motion + one_ahead + one_behind);
    expect_error(master, step_generator_errors_illegal_bit);
    write(master, step_generator_motor_enable_address, 1);
    append_segment(master, 0, 1, 8);
    expect_error(master, step_generator_errors_disabled_bit);
    write(master, step_generator_motor_enable_address, 3);
    write(master, step_generator_rate_floor_address, 0);
    expect_error(master, step_generator_errors_settings_bit);
    write_segment(master, 4, 4, 8);
    write(master, step_generator_command_address, flush_command);
    write(master, step_generator_segment_commit_address, 0);
    expect_error(master, step_generator_errors_incomplete_bit);

    -- Ahead comes earlier, behind later than the axis without either.
    for i in 0 to 3 loop
      wait_for_first <= true;
      append_segment(master, 1, 1, 8, ends_motion + shifts(i));
      wait_until_idle(clk, outputs.idle);
      -- Axis 0 ahead of axis 1 where it is ahead itself, or axis 1 behind.
      assert (first_rise_at(0) < first_rise_at(1)) = (i = 0 or i = 3) severity failure;
      assert (first_rise_at(0) > first_rise_at(1)) = (i = 1 or i = 2) severity failure;
      wait_for_first <= false;
      wait_clocks(clk, 2);
    end loop;

    -- The start: as a command, and at the pin; only where a segment waits.
    write(master, step_generator_command_address, start_command);
    append_segment(master, 2, 2, 8, ends_motion + waits);
    wait_clocks(clk, 20);
    expect(master, step_generator_status_address, (depth - 1) * one_free + one_queued + waiting_status);
    write(master, step_generator_command_address, start_command);
    wait_clocks(clk, 3);
    assert outputs.moving = '1' severity failure;
    wait_until_idle(clk, outputs.idle);
    for i in 1 to 2 loop
      append_segment(master, 2, 2, 8, ends_motion + waits);
      -- Long enough for a rest, before and while it is high.
      wait_clocks(clk, 30);
      inputs.start <= '1';
      wait_clocks(clk, 4);
      assert outputs.moving = '1' severity failure;
      wait_until_idle(clk, outputs.idle);
      -- It rests anyway.
      other := clocks_left_out;
      wait_clocks(clk, 30);
      assert clocks_left_out - other > 10 severity failure;
      inputs.start <= '0';
      wait_clocks(clk, 30);
    end loop;
    append_segment(master, 2, 2, 8, ends_motion + waits);
    wait_clocks(clk, 20);
    -- What waits needs its drivers as what moves does.
    write(master, step_generator_motor_enable_address, 1);
    expect_error(master, step_generator_errors_settings_bit);
    assert outputs.enable = "11" report "a driver is off under a segment that waits" severity failure;
    write(master, step_generator_command_address, flush_command);
    expect(master, step_generator_status_address, depth * one_free + idle_status);

    -- A reset clears all of it; many edges were left out by then.
    write(master, step_generator_motor_enable_address, 3);
    write(master, step_generator_position_address, 77);
    write(master, step_generator_position_address, 78);
    wait_clocks(clk, 300);
    assert clocks_left_out > 200 report to_string(clocks_left_out) & " clocks left out" severity failure;
    write(master, step_generator_segment_flags_address, 0);
    write(master, step_generator_segment_commit_address, 0);
    wait_clocks(clk, 3);
    reset <= '1';
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 2);
    expect(master, step_generator_control_address, 0);
    expect(master, step_generator_errors_address, 0);
    expect(master, step_generator_position_address, 0);
    expect(master, step_generator_rate_floor_address, 8590);
    expect(master, step_generator_status_address, depth * one_free + idle_status);
    assert outputs.queue_interrupt = '0' and outputs.stop_interrupt = '0' and outputs.enable = "00"
      severity failure;

    std.env.finish;
  end process;

end architecture;
