-- SPDX-License-Identifier: Apache-2.0
-- Eight axes, as many as the registers have room for: each has its own guard, edges, position and driver.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_core_bench_pkg.put;
use work.step_generator_pkg.all;

entity step_generator_core_axes_tb is
end entity;

architecture simulation of step_generator_core_axes_tb is

  constant axes : positive := axis_limit;
  constant steps : positive := 10;

  -- Of each axis longer than of the one before.
  function all_guards return guard_array_t is
    variable guards : guard_array_t(axes - 1 downto 0);
  begin
    for axis in guards'range loop
      guards(axis) := (
        high => to_unsigned(3 + 2 * axis, 12), low => to_unsigned(2 + axis, 12),
        direction_setup => to_unsigned(30 + 5 * axis, 12), direction_hold => to_unsigned(40 + 7 * axis, 12));
    end loop;
    return guards;
  end function;

  constant guards : guard_array_t(axes - 1 downto 0) := all_guards;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal both_edges : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal write : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  signal commit, snapshot, position_refused, idle : std_ulogic := '0';
  signal refused : refusal_t;
  signal enabled : std_ulogic_vector(axes - 1 downto 0) := (others => '1');
  signal set_position : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal new_position : position_t := (others => '0');
  signal positions, snapshot_positions : position_array_t(axes - 1 downto 0);
  signal axis_stalls : count_array_t(axes - 1 downto 0);
  signal step, direction : std_ulogic_vector(axes - 1 downto 0);
  type naturals_t is array (natural range <>) of natural;
  signal pulses : naturals_t(axes - 1 downto 0);

begin

  clk <= not clk after 10 ns;

  core : entity work.step_generator_core
    generic map (axes => axes, queue_depth => 2)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset, guards => guards,
      both_edges => both_edges, rate_floor => to_unsigned(1, 31), enabled => enabled, run => '1',
      start => '0', software_start => '0', waiting => open, override => to_unsigned(65536, 18),
      override_slope => (others => '0'), brake_slope => (others => '0'), scale => open, held => open,
      write => write, commit => commit, refused => refused, flush => '0', level => open,
      max_level => open, moving => open, idle => idle, segments => open,
      underruns => open, stalls => open, axis_stalls => axis_stalls, end_stops => x"00",
      emergency_stop => '0', software_stop => '0', software_brake => '0', acknowledge_stop => '0',
      watchdog_limit => (others => '0'), feed_watchdog => '0', braking => open, stopped => open,
      stop_cause => open, stop_positions => open, stop_time => open, positions => positions,
      set_position => set_position, new_position => new_position, position_refused => position_refused,
      snapshot => snapshot, snapshot_positions => snapshot_positions, snapshot_time => open, step => step,
      direction => direction);

  monitors : for axis in 0 to axes - 1 generate
    monitor : entity work.pulse_monitor
      port map (
        clk => clk, reset => reset, guard => guards(axis), both_edges => both_edges(axis),
        step => step(axis), direction => direction(axis), position => positions(axis),
        set_position => set_position(axis), new_position => new_position, pulses => pulses(axis));
  end generate;

  test : process

    -- A step every second clock of the axes in `moving`, as far as their guards permit.
    procedure move (moving, backward : std_ulogic_vector(7 downto 0); is_refused : std_ulogic := '0') is
    begin
      put(clk, write, flags_lane, x"000000" & backward);
      put(clk, write, line_ticks_lane, steps);
      put(clk, write, ticks_lane, steps);
      for axis in 0 to axes - 1 loop
        if moving(axis) then
          put(clk, write, steps_lane + axis, steps);
        else
          put(clk, write, steps_lane + axis, 0);
        end if;
      end loop;
      for lane in rate_low_lane to jerk_high_lane loop
        put(clk, write, lane, 0);
      end loop;
      put(clk, write, rate_high_lane, x"80000000");
      wait until rising_edge(clk);
      commit <= '1';
      wait until rising_edge(clk);
      commit <= '0';
      is_taken_or_refused : assert refused.disabled = is_refused
        and (refused = refusal_none) = (is_refused = '0') severity failure;
      wait until rising_edge(clk);
      wait until rising_edge(clk) and idle = '1' for 100 us;
      comes_to_its_end : assert idle = '1' severity failure;
    end procedure;

    variable only : std_ulogic_vector(7 downto 0);
    variable before : position_array_t(axes - 1 downto 0);
    variable stalls_before : count_array_t(axes - 1 downto 0);
    variable period : positive;

  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';

    for axis in 0 to axes - 1 loop
      only := (others => '0');
      only(axis) := '1';

      -- Steps as fast as its own guard permits, one way and the other.
      for backward in std_ulogic range '0' to '1' loop
        before := positions;
        stalls_before := axis_stalls;
        move(only, (others => backward));
        for other in 0 to axes - 1 loop
          moves_alone : assert abs (positions(other) - before(other)) = steps * boolean'pos(other = axis)
            report to_string(axis) & " moves " & to_string(other) severity failure;
          stalls_alone : assert (axis_stalls(other) /= stalls_before(other)) = (other = axis)
            report to_string(axis) & " stalls " & to_string(other) severity failure;
        end loop;
        goes_its_way : assert direction(axis) = backward severity failure;
        period := to_integer(guards(axis).high) + to_integer(guards(axis).low);
        -- Of all steps but the first, each with its tick at once.
        stalls_as_its_guard_says : assert
          axis_stalls(axis) - stalls_before(axis) >= (steps - 1) * (period - 2)
          and axis_stalls(axis) - stalls_before(axis) <= (steps - 1) * (period - 2)
            + to_integer(guards(axis).direction_hold) + to_integer(guards(axis).direction_setup)
          report "axis " & to_string(axis) & ": "
            & to_string(to_integer(axis_stalls(axis) - stalls_before(axis))) severity failure;
      end loop;

      -- Its driver, its position.
      enabled <= not only;
      move(only, x"00", is_refused => '1');
      move(not only, x"00");
      move(not only, x"ff");
      enabled <= (others => '1');
      before := positions;
      new_position <= to_signed(1000 * axis - 3000, 32);
      set_position <= only;
      wait until rising_edge(clk);
      set_position <= (others => '0');
      before(axis) := new_position;
      wait until rising_edge(clk);
      snapshot <= '1';
      wait until rising_edge(clk);
      snapshot <= '0';
      wait until rising_edge(clk);
      wait until falling_edge(clk);
      is_set_alone : assert positions = before and snapshot_positions = before
        report "axis " & to_string(axis) severity failure;
    end loop;

    -- All at once, with the monitors as judges, also with both edges.
    for i in 1 to 4 loop
      move(x"ff", std_ulogic_vector(to_unsigned(37 * i mod 256, 8)));
      move(x"ff", not std_ulogic_vector(to_unsigned(37 * i mod 256, 8)));
      both_edges <= std_ulogic_vector(to_unsigned(73 * i mod 256, 8)) and not step;
      wait until rising_edge(clk);
    end loop;
    finish;
  end process;

end architecture;
