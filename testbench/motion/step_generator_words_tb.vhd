-- SPDX-License-Identifier: Apache-2.0
-- Every register of the step generator by what it does: each setting, command, error and counter leads to
-- its own place. A second generator, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_words_tb is
end entity;

architecture simulation of step_generator_words_tb is

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

  type naturals_t is array (0 to axes - 1) of natural;
  signal pulses, rose_at, first_rise_at, high_clocks, period_clocks : naturals_t := (others => 0);
  signal wait_for_first : boolean := false;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => depth)
    port map (
      clk => clk, reset => reset, request => request, response => response, end_stops => end_stops,
      emergency_stop => emergency_stop, start => start, step => step, direction => direction,
      enable => enable, moving => moving, idle => idle, queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt, clocks_run => clocks_run, clocks_left_out => clocks_left_out);

  watch_pins : process
    variable before : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  begin
    wait until rising_edge(clk);
    for axis in 0 to axes - 1 loop
      if step(axis) = '1' and before(axis) = '0' then
        pulses(axis) <= pulses(axis) + 1;
        rose_at(axis) <= clocks_run;
        period_clocks(axis) <= clocks_run - rose_at(axis);
        if wait_for_first and first_rise_at(axis) = 0 then
          first_rise_at(axis) <= clocks_run;
        end if;
      elsif step(axis) = '0' and before(axis) = '1' then
        high_clocks(axis) <= clocks_run - rose_at(axis);
      end if;
      if not wait_for_first then
        first_rise_at(axis) <= 0;
      end if;
    end loop;
    before := step;
  end process;

  test : process
    variable word : word_t;
    variable number, other : natural;
    type shifts_t is array (0 to 3) of natural;
    constant shifts : shifts_t := (one_ahead, 2 * one_ahead, one_behind, 2 * one_behind);

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

  begin
    clocks(2);
    reset <= '0';
    clocks(2);

    -- After reset.
    expect(step_generator_build_address, axes + depth * 2 ** step_generator_build_queue_depth_bits'low);
    expect(step_generator_control_address, 0);
    expect(step_generator_status_address, depth * one_free + idle_status);
    expect(step_generator_motor_enable_address, 0);
    expect(step_generator_rate_floor_address, 8590);
    expect(step_generator_override_address, 65536);
    expect(step_generator_scale_address, 65536);
    expect(step_generator_errors_address, 0);
    assert queue_interrupt = '0' and stop_interrupt = '0' and enable = "00" severity failure;

    -- Settings read as they were written; at rest the scale follows at once.
    write(step_generator_control_address, 16#1234# * one_of_threshold + both_interrupts);
    expect(step_generator_control_address, 16#1234# * one_of_threshold + both_interrupts);
    assert queue_interrupt = '1' severity failure;
    write(step_generator_motor_enable_address, 3);
    expect(step_generator_motor_enable_address, 3);
    assert enable = "11" severity failure;
    write(step_generator_rate_floor_address, 4321);
    expect(step_generator_rate_floor_address, 4321);
    write(step_generator_override_address, 16#23456#);
    expect(step_generator_override_address, 16#23456#);
    expect(step_generator_scale_address, 16#23456#);
    write(step_generator_override_address, 65536);
    write(step_generator_override_slope_address, 2 ** 26);
    write(step_generator_brake_slope_address, 2 ** 24);
    bus_write(clk, request, response, step_generator_position_address, x"FFFFFFFB");
    write(step_generator_position_address + 4, 1000);
    write(step_generator_pulse_guard_address, pulse_guard(high => 4, low => 9));
    write(step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 40));
    write(step_generator_direction_guard_address, direction_guard(setup => 3, hold => 2));
    write(step_generator_direction_guard_address + 4, direction_guard(setup => 3, hold => 2));
    expect(step_generator_errors_address, 0);

    -- What is queued waits for `run`; the queue asks for more at its threshold.
    write(step_generator_control_address, one_of_threshold + both_interrupts);
    append(2, 1, 8, 0);
    assert queue_interrupt = '1' severity failure;
    for i in 2 to depth loop
      append(2, 1, 8, 2 * one_backward);
    end loop;
    assert queue_interrupt = '0' severity failure;
    expect(step_generator_status_address, depth * one_queued);
    expect(step_generator_max_level_address, depth);
    put(2, 1, 8);
    write(step_generator_segment_commit_address, 0);
    expect_error(step_generator_errors_queue_full_bit);
    write(step_generator_position_address, 0);
    expect_error(step_generator_errors_position_bit);
    write(step_generator_rate_floor_address, 1);
    expect_error(step_generator_errors_settings_bit);
    write(step_generator_motor_enable_address, 1);
    expect_error(step_generator_errors_settings_bit);
    assert enable = "11" and moving = '0' and pulses = (0, 0) severity failure;
    write(step_generator_control_address, one_of_threshold + both_interrupts + run);
    clocks(4);
    assert moving = '1' severity failure;
    wait_until_idle(clk, idle);
    assert pulses = (2 * depth, depth) and direction = "10" severity failure;
    assert high_clocks = (4, 6) report to_string(high_clocks(0)) & " " & to_string(high_clocks(1))
      severity failure;
    expect(step_generator_position_address, 2 * depth - 5);
    expect(step_generator_position_address + 4, 1000 + 1 - (depth - 1));
    expect(step_generator_position_address + 4 * axes, 0);
    expect(step_generator_segments_executed_address, depth);
    expect(step_generator_underruns_address, 1);
    expect(step_generator_stalls_address, 0);
    assert queue_interrupt = '1' severity failure;

    -- Steps faster than the second axis can: it stalls both.
    append(20, 20, 20);
    wait_until_idle(clk, idle);
    assert period_clocks(1) = 46 report to_string(period_clocks(1)) & " clocks" severity failure;
    read(step_generator_axis_stalls_address + 4);
    other := number;
    assert other > 19 * 25 severity failure;
    expect(step_generator_axis_stalls_address, 0);
    expect(step_generator_axis_stalls_address + 8, 0);
    read(step_generator_stalls_address);
    assert number >= other severity failure;
    expect(step_generator_underruns_address, 1);
    write(step_generator_pulse_guard_address + 4, pulse_guard(high => 6, low => 4));

    -- Each refusal has its own bit; what is half written goes with a flush.
    write(step_generator_segment_flags_address, 0);
    write(step_generator_segment_commit_address, 0);
    expect_error(step_generator_errors_incomplete_bit);
    append(9, 0, 8);
    expect_error(step_generator_errors_illegal_bit);
    append(4, 0, 8, ends_motion + one_ahead + one_behind);
    expect_error(step_generator_errors_illegal_bit);
    write(step_generator_motor_enable_address, 1);
    append(0, 1, 8);
    expect_error(step_generator_errors_disabled_bit);
    write(step_generator_motor_enable_address, 3);
    write(step_generator_rate_floor_address, 0);
    expect_error(step_generator_errors_settings_bit);
    put(4, 4, 8);
    write(step_generator_command_address, flush_command);
    write(step_generator_segment_commit_address, 0);
    expect_error(step_generator_errors_incomplete_bit);

    -- Ahead comes earlier, behind later than the axis without either.
    for i in 0 to 3 loop
      wait_for_first <= true;
      append(1, 1, 8, ends_motion + shifts(i));
      wait_until_idle(clk, idle);
      -- Axis 0 ahead of axis 1 where it is ahead itself, or axis 1 behind.
      assert (first_rise_at(0) < first_rise_at(1)) = (i = 0 or i = 3) severity failure;
      assert (first_rise_at(0) > first_rise_at(1)) = (i = 1 or i = 2) severity failure;
      wait_for_first <= false;
      clocks(2);
    end loop;

    -- The start: as a command, and at the pin; only where a segment waits.
    write(step_generator_command_address, start_command);
    append(2, 2, 8, ends_motion + waits);
    clocks(20);
    expect(step_generator_status_address, (depth - 1) * one_free + one_queued + waiting_status);
    write(step_generator_command_address, start_command);
    clocks(3);
    assert moving = '1' severity failure;
    wait_until_idle(clk, idle);
    for i in 1 to 2 loop
      append(2, 2, 8, ends_motion + waits);
      -- Long enough for a rest, before and while it is high.
      clocks(30);
      start <= '1';
      clocks(4);
      assert moving = '1' severity failure;
      wait_until_idle(clk, idle);
      -- It rests all the same.
      other := clocks_left_out;
      clocks(30);
      assert clocks_left_out - other > 10 severity failure;
      start <= '0';
      clocks(30);
    end loop;
    append(2, 2, 8, ends_motion + waits);
    write(step_generator_command_address, flush_command);
    expect(step_generator_status_address, depth * one_free + idle_status);

    -- A reset forgets all of it, and rest was worth the trouble.
    write(step_generator_motor_enable_address, 3);
    write(step_generator_position_address, 77);
    write(step_generator_position_address, 78);
    clocks(300);
    assert clocks_left_out > 200 report to_string(clocks_left_out) & " clocks left out" severity failure;
    write(step_generator_segment_flags_address, 0);
    write(step_generator_segment_commit_address, 0);
    clocks(3);
    reset <= '1';
    clocks(3);
    reset <= '0';
    clocks(2);
    expect(step_generator_control_address, 0);
    expect(step_generator_errors_address, 0);
    expect(step_generator_position_address, 0);
    expect(step_generator_rate_floor_address, 8590);
    expect(step_generator_status_address, depth * one_free + idle_status);
    assert queue_interrupt = '0' and stop_interrupt = '0' and enable = "00" severity failure;

    finish;
  end process;

end architecture;
