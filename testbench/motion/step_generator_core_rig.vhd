-- SPDX-License-Identifier: Apache-2.0
-- The core of the step generator with three axes of different guards, each watched as its driver sees it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_core_bench_pkg.all;
use work.step_generator_pkg.all;

entity step_generator_core_rig is
  port (
    clk : out std_ulogic := '0';
    drive : in core_inputs_t;
    seen : out core_outputs_t
  );
end entity;

architecture simulation of step_generator_core_rig is

  constant guards : guard_array_t(axes - 1 downto 0) := (
    0 => (high => to_unsigned(1, 12), low => to_unsigned(1, 12),
      direction_setup => to_unsigned(1, 12), direction_hold => to_unsigned(1, 12)),
    1 => (high => to_unsigned(3, 12), low => to_unsigned(5, 12),
      direction_setup => to_unsigned(2, 12), direction_hold => to_unsigned(4, 12)),
    2 => (high => to_unsigned(12, 12), low => to_unsigned(9, 12),
      direction_setup => to_unsigned(10, 12), direction_hold => to_unsigned(10, 12)));
  constant both_edges : std_ulogic_vector(axes - 1 downto 0) := "010";

  -- The same edges, or none while it rests.
  signal bus_clk : std_ulogic := '0';
  signal clocks_run : natural := 0;

begin

  -- Both in one moment, as from one clock tree.
  make_clocks : process
  begin
    wait for 10 ns;
    clk <= '1';
    bus_clk <= '0' when drive.bus_rests else '1';
    wait for 10 ns;
    clk <= '0';
    bus_clk <= '0';
  end process;

  count_clocks : process
  begin
    wait until rising_edge(clk);
    clocks_run <= 0 when drive.reset else clocks_run + 1;
  end process;

  seen.clocks_run <= clocks_run;

  core : entity work.step_generator_core
    generic map (axes => axes, queue_depth => depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => bus_clk, reset => drive.reset, guards => guards,
      both_edges => both_edges, rate_floor => to_unsigned(2 ** 20, 31), enabled => drive.enabled,
      run => drive.run, start => drive.start, software_start => drive.software_start,
      waiting => seen.waiting, override => drive.override, override_slope => x"01000000",
      brake_slope => x"00200000", scale => seen.scale, held => seen.held,
      watchdog_limit => to_unsigned(drive.watchdog_limit, 32), feed_watchdog => drive.feed_watchdog,
      braking => seen.braking, software_brake => drive.software_brake, write => drive.write,
      commit => drive.commit, refused => seen.refused, flush => drive.flush, level => seen.level,
      max_level => seen.max_level, moving => seen.moving, idle => seen.idle,
      segments => seen.segments, underruns => seen.underruns, stalls => seen.stalls,
      axis_stalls => seen.axis_stalls, end_stops => drive.end_stops,
      emergency_stop => drive.emergency_stop, software_stop => drive.software_stop,
      acknowledge_stop => drive.acknowledge_stop, stopped => seen.stopped,
      stop_cause => seen.stop_cause, stop_positions => seen.stop_positions,
      stop_time => seen.stop_time, positions => seen.positions, set_position => drive.set_position,
      new_position => drive.new_position, position_refused => seen.position_refused,
      snapshot => drive.snapshot, snapshot_positions => seen.snapshot_positions,
      snapshot_time => seen.snapshot_time, step => seen.step, direction => seen.direction);

  monitors : for axis in 0 to axes - 1 generate
    signal position_is_set : std_ulogic;
  begin
    position_is_set <= drive.set_position(axis) and not seen.position_refused;
    monitor : entity work.pulse_monitor
      port map (
        clk => clk, reset => drive.reset, guard => guards(axis), both_edges => both_edges(axis),
        step => seen.step(axis), direction => seen.direction(axis), position => seen.positions(axis),
        set_position => position_is_set, new_position => drive.new_position,
        pulses => seen.pulses(axis));
  end generate;

end architecture;
