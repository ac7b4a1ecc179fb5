-- SPDX-License-Identifier: Apache-2.0
-- Every register of the step generator by what it does: each setting, command, error, cause and counter leads
-- to its own place. A second generator, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_words_tb is
end entity;

architecture simulation of step_generator_words_tb is

  constant clock_period : time := 20 ns;
  constant axes : positive := 2;
  constant depth : positive := 4;

  -- In the order of the register description.
  constant build : natural := 16#000#;
  constant control : natural := 16#004#;
  constant command : natural := 16#008#;
  constant status : natural := 16#00C#;
  constant errors : natural := 16#010#;
  constant motor_enable : natural := 16#014#;
  constant rate_floor : natural := 16#018#;
  constant override : natural := 16#01C#;
  constant override_slope : natural := 16#020#;
  constant brake_slope : natural := 16#024#;
  constant scale : natural := 16#028#;
  constant watchdog : natural := 16#02C#;
  constant segment_flags : natural := 16#030#;
  constant segment_line_ticks : natural := 16#034#;
  constant segment_ticks : natural := 16#038#;
  constant segment_rate_low : natural := 16#03C#;
  constant segment_rate_high : natural := 16#040#;
  constant segment_jerk_high : natural := 16#050#;
  constant segment_steps : natural := 16#054#;
  constant segment_commit : natural := 16#074#;
  constant pulse_guard : natural := 16#078#;
  constant direction_guard : natural := 16#098#;
  constant position : natural := 16#0B8#;
  constant snapshot_position : natural := 16#0D8#;
  constant snapshot_time : natural := 16#0F8#;
  constant stop_cause : natural := 16#100#;
  constant stop_position : natural := 16#104#;
  constant stop_time : natural := 16#124#;
  constant segments_executed : natural := 16#12C#;
  constant underruns : natural := 16#130#;
  constant max_level : natural := 16#134#;
  constant stalls : natural := 16#138#;
  constant axis_stalls : natural := 16#13C#;

  constant flush_command : natural := 2 ** 0;
  constant stop_command : natural := 2 ** 1;
  constant acknowledge_command : natural := 2 ** 2;
  constant snapshot_command : natural := 2 ** 3;
  constant clear_errors_command : natural := 2 ** 4;
  constant start_command : natural := 2 ** 5;
  constant brake_command : natural := 2 ** 6;
  constant feed_command : natural := 2 ** 7;
  constant positions_known_command : natural := 2 ** 8;

  constant ends_motion : natural := 2 ** 9;
  constant on_change : natural := 2 ** 10;
  constant on_release : natural := 2 ** 11;
  constant brakes : natural := 2 ** 12;
  constant waits : natural := 2 ** 13;
  constant mask_of_3 : natural := 2 ** 19;

  type outputs_t is record
    step, direction, enable : std_ulogic_vector(axes - 1 downto 0);
    moving, idle, queue_interrupt, stop_interrupt : std_ulogic;
    response : bus_response_t;
  end record;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal made, rested : outputs_t;
  signal end_stops, seen_end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop, start, seen_emergency_stop, seen_start : std_ulogic := '0';

  signal resting_clk, resting_bus_clk, at_rest : std_ulogic := '0';
  signal edge_is_left_out, bus_edge_is_left_out : std_ulogic := '0';
  signal clocks_run, clocks_left_out : natural := 0;

  type naturals_t is array (0 to axes - 1) of natural;
  signal pulses, rose_at, first_rise_at, high_clocks, period_clocks : naturals_t := (others => 0);
  signal wait_for_first : boolean := false;

begin

  -- All in one moment, as from one clock tree.
  make_clocks : process
  begin
    wait for clock_period / 2;
    clk <= '1';
    resting_clk <= not edge_is_left_out;
    resting_bus_clk <= not bus_edge_is_left_out;
    wait for clock_period / 2;
    clk <= '0';
    resting_clk <= '0';
    resting_bus_clk <= '0';
  end process;

  generator : entity work.step_generator
    generic map (axes => axes, queue_depth => depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset, request => request,
      response => made.response, end_stops => end_stops, emergency_stop => emergency_stop,
      start => start,
      step => made.step, direction => made.direction, enable => made.enable, moving => made.moving,
      idle => made.idle, queue_interrupt => made.queue_interrupt, stop_interrupt => made.stop_interrupt,
      at_rest => open);

  resting_generator : entity work.step_generator
    generic map (axes => axes, queue_depth => depth)
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk, reset => reset, request => request,
      response => rested.response, end_stops => end_stops, emergency_stop => emergency_stop, start => start,
      step => rested.step, direction => rested.direction, enable => rested.enable, moving => rested.moving,
      idle => rested.idle, queue_interrupt => rested.queue_interrupt, stop_interrupt => rested.stop_interrupt,
      at_rest => at_rest);

  leave_out_edges : process
    constant access_clocks : positive := 4;
    variable clocks_without_access : natural := 0;
  begin
    wait until rising_edge(clk);
    clocks_without_access := 0 when (request.strobe or reset) = '1' else clocks_without_access + 1;
    wait until falling_edge(clk);
    wait for clock_period / 4;
    edge_is_left_out <= at_rest;
    bus_edge_is_left_out <= '1' when clocks_without_access > access_clocks and request.strobe = '0'
      and reset = '0' else '0';
    if at_rest then
      clocks_left_out <= clocks_left_out + 1;
    end if;
  end process;

  compare : process
  begin
    wait until falling_edge(clk);
    assert rested = made
      report "a rest has changed step, direction, enable, moving, idle, interrupts or data: " &
      to_string(rested.step & rested.direction & rested.enable & rested.moving & rested.idle &
        rested.queue_interrupt & rested.stop_interrupt) & " " & to_hstring(rested.response.data) & ", not " &
      to_string(made.step & made.direction & made.enable & made.moving & made.idle & made.queue_interrupt &
        made.stop_interrupt) & " " & to_hstring(made.response.data) severity failure;
  end process;

  watch_pins : process
    variable before : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  begin
    wait until rising_edge(clk);
    clocks_run <= 0 when reset else clocks_run + 1;
    for axis in 0 to axes - 1 loop
      if made.step(axis) = '1' and before(axis) = '0' then
        pulses(axis) <= pulses(axis) + 1;
        rose_at(axis) <= clocks_run;
        period_clocks(axis) <= clocks_run - rose_at(axis);
        if wait_for_first and first_rise_at(axis) = 0 then
          first_rise_at(axis) <= clocks_run;
        end if;
      elsif made.step(axis) = '0' and before(axis) = '1' then
        high_clocks(axis) <= clocks_run - rose_at(axis);
      end if;
      if not wait_for_first then
        first_rise_at(axis) <= 0;
      end if;
    end loop;
    before := made.step;
  end process;

  test : process
    variable word, kept : word_t;
    variable number, other : natural;
    -- Ahead in the lower four bits, behind in the upper ones.
    type shifts_t is array (0 to 3) of natural;
    constant shifts : shifts_t := (16#01#, 16#02#, 16#10#, 16#20#);

    procedure write(offset : natural; data : word_t) is
    begin
      bus_write(clk, request, made.response, step_generator_address + offset, data);
    end procedure;

    procedure write(offset : natural; data : natural) is
    begin
      write(offset, word_t(to_unsigned(data, 32)));
    end procedure;

    procedure read(offset : natural) is
    begin
      bus_read(clk, request, made.response, step_generator_address + offset, word);
      number := to_integer(unsigned(word(30 downto 0)));
    end procedure;

    procedure expect(offset : natural; data : word_t) is
    begin
      read(offset);
      assert word = data report to_hstring(to_unsigned(offset, 12)) & " is " & to_hstring(word) &
        " instead of " & to_hstring(data) severity failure;
    end procedure;

    procedure expect(offset : natural; data : natural) is
    begin
      expect(offset, word_t(to_unsigned(data, 32)));
    end procedure;

    procedure clocks(count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
      wait for 1 ns;
    end procedure;

    -- All words but the commit: 16 clocks a tick.
    procedure put(x, y, ticks : natural; flags : natural := ends_motion; high : natural := 0) is
    begin
      write(segment_flags, word_t(shift_left(to_unsigned(high, 32), 24) or to_unsigned(flags, 32)));
      write(segment_line_ticks, ticks);
      write(segment_steps, x);
      write(segment_steps + 4, y);
      write(segment_ticks, ticks);
      for i in 0 to (segment_jerk_high - segment_rate_low) / 4 loop
        write(segment_rate_low + 4 * i, 0);
      end loop;
      write(segment_rate_high, 2 ** 28);
    end procedure;

    procedure append(x, y, ticks : natural; flags : natural := ends_motion; high : natural := 0) is
    begin
      put(x, y, ticks, flags, high);
      write(segment_commit, 0);
    end procedure;

    -- It is the only one since they were cleared.
    procedure expect_error(bit_number : natural) is
    begin
      expect(errors, 2 ** bit_number);
      write(command, clear_errors_command);
      expect(errors, 0);
    end procedure;

    procedure wait_until_idle is
    begin
      wait until rising_edge(clk) and made.idle = '1' for 100 us;
      assert made.idle = '1' report "does not come to rest" severity failure;
      clocks(3);
    end procedure;

    procedure expect_stop(cause : natural) is
    begin
      clocks(4);
      assert made.stop_interrupt = '1' and made.moving = '0' severity failure;
      expect(stop_cause, cause);
      read(status);
      assert word(4 downto 2) = "001" and word(15 downto 8) = x"00" severity failure;
      end_stops <= x"00";
      write(command, acknowledge_command);
      clocks(3);
      assert made.stop_interrupt = '0' report "the stop is not acknowledged" severity failure;
      wait_until_idle;
    end procedure;

    -- An end stop of the mask ends a segment in its middle.
    procedure stop_by_switch(flags : natural; levels, new_levels : std_ulogic_vector(7 downto 0)) is
    begin
      end_stops <= levels;
      append(90, 90, 100, ends_motion + mask_of_3 + flags);
      clocks(150);
      assert made.moving = '1' report "stopped before its switch" severity failure;
      other := clocks_run;
      end_stops <= new_levels;
    end procedure;
  begin
    clocks(2);
    reset <= '0';
    clocks(2);

    -- After reset.
    expect(build, x"00000402");
    expect(control, 0);
    expect(status, x"00040002");
    expect(motor_enable, 0);
    expect(rate_floor, 8590);
    expect(override, 65536);
    expect(scale, 65536);
    expect(errors, 0);
    assert made.queue_interrupt = '0' and made.stop_interrupt = '0' and made.enable = "00" severity failure;

    -- Settings read as they were written; at rest the scale follows at once.
    write(control, x"12340006");
    expect(control, x"12340006");
    assert made.queue_interrupt = '1' severity failure;
    write(motor_enable, 3);
    expect(motor_enable, 3);
    assert made.enable = "11" severity failure;
    write(rate_floor, 4321);
    expect(rate_floor, 4321);
    write(override, 16#23456#);
    expect(override, 16#23456#);
    expect(scale, 16#23456#);
    write(override, 65536);
    write(override_slope, 2 ** 26);
    write(brake_slope, 2 ** 24);
    write(position, x"FFFFFFFB");
    write(position + 4, 1000);
    write(pulse_guard, 9 * 2 ** 16 + 4);
    write(pulse_guard + 4, 40 * 2 ** 16 + 6);
    write(direction_guard, 2 * 2 ** 16 + 3);
    write(direction_guard + 4, 2 * 2 ** 16 + 3);
    expect(errors, 0);

    -- What is queued waits for `run`; the queue asks for more at its threshold.
    write(control, x"00010006");
    append(2, 1, 8, 0);
    assert made.queue_interrupt = '1' severity failure;
    for i in 2 to depth loop
      append(2, 1, 8, 2);
    end loop;
    assert made.queue_interrupt = '0' severity failure;
    expect(status, x"00000400");
    expect(max_level, depth);
    put(2, 1, 8);
    write(segment_commit, 0);
    expect_error(0);
    write(position, 0);
    expect_error(4);
    write(rate_floor, 1);
    expect_error(5);
    write(motor_enable, 1);
    expect_error(5);
    assert made.enable = "11" and made.moving = '0' and pulses = (0, 0) severity failure;
    write(control, x"00010007");
    clocks(4);
    assert made.moving = '1' severity failure;
    wait_until_idle;
    assert pulses = (2 * depth, depth) and made.direction = "10" severity failure;
    assert high_clocks = (4, 6) report to_string(high_clocks(0)) & " " & to_string(high_clocks(1))
      severity failure;
    expect(position, 2 * depth - 5);
    expect(position + 4, 1000 + 1 - (depth - 1));
    expect(position + 4 * axes, 0);
    expect(segments_executed, depth);
    expect(underruns, 1);
    expect(stalls, 0);
    assert made.queue_interrupt = '1' severity failure;

    -- Steps faster than the second axis can: it stalls both.
    append(20, 20, 20);
    wait_until_idle;
    assert period_clocks(1) = 46 report to_string(period_clocks(1)) & " clocks" severity failure;
    read(axis_stalls + 4);
    other := number;
    assert other > 19 * 25 severity failure;
    expect(axis_stalls, 0);
    expect(axis_stalls + 8, 0);
    read(stalls);
    assert number >= other severity failure;
    expect(underruns, 1);
    write(pulse_guard + 4, 4 * 2 ** 16 + 6);

    -- Each refusal has its own bit; what is half written goes with a flush.
    write(segment_flags, 0);
    write(segment_commit, 0);
    expect_error(1);
    append(9, 0, 8);
    expect_error(2);
    append(4, 0, 8, ends_motion, 16#11#);
    expect_error(2);
    write(motor_enable, 1);
    append(0, 1, 8);
    expect_error(6);
    write(motor_enable, 3);
    write(rate_floor, 0);
    expect_error(5);
    put(4, 4, 8);
    write(command, flush_command);
    write(segment_commit, 0);
    expect_error(1);

    -- Ahead comes earlier, behind later than the axis without either.
    for i in 0 to 3 loop
      wait_for_first <= true;
      append(1, 1, 8, ends_motion, shifts(i));
      wait_until_idle;
      -- Axis 0 ahead of axis 1 where it is ahead itself, or axis 1 behind.
      assert (first_rise_at(0) < first_rise_at(1)) = (i = 0 or i = 3) severity failure;
      assert (first_rise_at(0) > first_rise_at(1)) = (i = 1 or i = 2) severity failure;
      wait_for_first <= false;
      clocks(2);
    end loop;

    -- The start: as a command, and at the pin; only where a segment waits.
    write(command, start_command);
    append(2, 2, 8, ends_motion + waits);
    clocks(20);
    expect(status, x"00030120");
    write(command, start_command);
    clocks(3);
    assert made.moving = '1' severity failure;
    wait_until_idle;
    for i in 1 to 2 loop
      append(2, 2, 8, ends_motion + waits);
      -- Long enough for a rest, before and while it is high.
      clocks(30);
      start <= '1';
      clocks(4);
      assert made.moving = '1' severity failure;
      wait_until_idle;
      -- It rests all the same.
      other := clocks_left_out;
      clocks(30);
      assert clocks_left_out - other > 10 severity failure;
      start <= '0';
      clocks(30);
    end loop;
    append(2, 2, 8, ends_motion + waits);
    write(command, flush_command);
    expect(status, x"00040002");

    -- A snapshot takes one clock; a hold stands still, and the override is a scale of time.
    write(watchdog, 400);
    expect(watchdog, 400);
    append(50, 25, 100);
    clocks(100);
    write(override, 0);
    clocks(80);
    read(status);
    assert word(6 downto 0) = "0001001" report to_hstring(word) severity failure;
    expect(scale, 0);
    write(command, snapshot_command);
    read(snapshot_time);
    assert clocks_run - number < 12 severity failure;
    expect(snapshot_time + 4, 0);
    read(position);
    expect(snapshot_position, word);
    read(position + 4);
    expect(snapshot_position + 4, word);
    expect(snapshot_position + 8, 0);
    write(override, 65536);

    -- The watchdog: fed it lets motion be.
    write(command, feed_command);
    for i in 1 to 3 loop
      clocks(300);
      write(command, feed_command);
    end loop;
    clocks(390);
    assert made.moving = '1' severity failure;
    clocks(15);
    expect_stop(2 ** 10);
    write(watchdog, 0);
    read(position);
    expect(stop_position, word);
    read(position + 4);
    expect(stop_position + 4, word);
    kept := word;
    expect(stop_position + 8, 0);
    append(8, 8, 8);
    wait_until_idle;
    expect(stop_position + 4, kept);
    read(position + 4);
    assert word /= kept severity failure;
    read(stop_time);
    assert number < clocks_run and number > clocks_run - 1000 severity failure;
    expect(stop_time + 4, 0);

    -- Software stops and brakes.
    append(90, 90, 100);
    clocks(150);
    write(command, stop_command);
    append(1, 1, 8);
    expect_error(3);
    expect_stop(2 ** 9);
    append(90, 90, 100);
    clocks(150);
    write(command, brake_command);
    read(status);
    assert word(4) = '1' and word(0) = '1' and word(2) = '0' report to_hstring(word) severity failure;
    clocks(260);
    expect_stop(2 ** 11);

    -- Each switch flag.
    stop_by_switch(0, x"F7", x"08");
    expect_stop(2 ** 3);
    stop_by_switch(on_change, x"08", x"00");
    clocks(10);
    end_stops <= x"08";
    expect_stop(2 ** 3);
    stop_by_switch(on_release, x"08", x"F7");
    expect_stop(2 ** 3);
    stop_by_switch(brakes, x"00", x"08");
    clocks(2);
    read(status);
    assert word(4) = '1' and word(0) = '1' and word(2) = '0' report to_hstring(word) severity failure;
    read(stop_time);
    assert number >= other and number <= other + 1 severity failure;
    clocks(260);
    expect_stop(2 ** 3);

    -- Without its bit no interrupt.
    write(control, 1);
    clocks(2);
    assert made.queue_interrupt = '0' severity failure;
    append(90, 90, 100);
    clocks(100);
    wait until falling_edge(clk);
    emergency_stop <= '1';
    wait for 1 ns;
    assert made.enable = "00" report "a driver is enabled in an emergency" severity failure;
    clocks(2);
    emergency_stop <= '0';
    clocks(2);
    assert made.stop_interrupt = '0' and made.moving = '0' severity failure;
    expect(motor_enable, 0);
    read(status);
    assert word(6) = '1' and word(2) = '1' severity failure;
    write(motor_enable, 3);
    expect_error(5);
    write(control, 5);
    clocks(2);
    expect_stop(2 ** 8);
    expect(status, x"00040042");
    write(command, positions_known_command);
    expect(status, x"00040002");

    -- A reset forgets all of it, and rest was worth the trouble.
    write(motor_enable, 3);
    write(position, 77);
    write(position, 78);
    clocks(300);
    assert clocks_left_out > 200 report to_string(clocks_left_out) & " clocks left out" severity failure;
    write(segment_flags, 0);
    write(segment_commit, 0);
    clocks(3);
    reset <= '1';
    clocks(3);
    reset <= '0';
    clocks(2);
    expect(control, 0);
    expect(errors, 0);
    expect(position, 0);
    expect(rate_floor, 8590);
    expect(status, x"00040002");
    assert made.queue_interrupt = '0' and made.stop_interrupt = '0' and made.enable = "00" severity failure;

    finish;
  end process;

end architecture;
