-- SPDX-License-Identifier: Apache-2.0
-- What goes into step_generator_core and comes out of it in its benches, and the calls that they share.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

package step_generator_core_bench_pkg is

  constant axes : positive := 3;
  constant depth : positive := 4;

  type naturals_t is array (natural range <>) of natural;

  type core_inputs_t is record
    -- The bus gets no edge.
    bus_rests : boolean;
    reset : std_ulogic;
    write : lane_write_t;
    commit, flush : std_ulogic;
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_stop, software_stop, software_brake, acknowledge_stop : std_ulogic;
    start, software_start, run : std_ulogic;
    enabled : std_ulogic_vector(axes - 1 downto 0);
    watchdog_limit : natural;
    feed_watchdog : std_ulogic;
    override : unsigned(17 downto 0);
    set_position : std_ulogic_vector(axes - 1 downto 0);
    new_position : position_t;
    snapshot : std_ulogic;
  end record;

  constant inputs_in_reset : core_inputs_t := (
    bus_rests => false, reset => '1', write => (valid => '0', lane => 0, data => (others => '0')),
    end_stops => x"00", run => '1', enabled => (others => '1'), watchdog_limit => 0,
    override => to_unsigned(65536, 18), set_position => (others => '0'),
    new_position => (others => '0'), others => '0');

  type core_outputs_t is record
    -- Clocks since the reset.
    clocks_run : natural;
    refused : refusal_t;
    level, max_level : natural range 0 to depth;
    moving, idle, waiting, held, braking, stopped : std_ulogic;
    segments, underruns, stalls : count_t;
    axis_stalls : count_array_t(axes - 1 downto 0);
    scale : scale_t;
    stop_cause : stop_cause_t;
    stop_positions, positions, snapshot_positions : position_array_t(axes - 1 downto 0);
    stop_time, snapshot_time : time_t;
    position_refused : std_ulogic;
    step, direction : std_ulogic_vector(axes - 1 downto 0);
    pulses : naturals_t(axes - 1 downto 0);
  end record;

  -- Why a commit is refused.
  type reason_t is (incomplete, queue_full, while_stopped, disabled);

  procedure wait_clocks (signal clk : in std_ulogic; number : in natural);
  procedure pulse (signal clk : in std_ulogic; signal command : out std_ulogic);
  procedure acknowledge (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t);
  procedure wait_until_idle (signal clk : in std_ulogic; signal seen : in core_outputs_t);

  procedure put (
    signal clk : in std_ulogic; signal write : out lane_write_t; lane : in lane_t;
    data : in std_ulogic_vector(31 downto 0));
  procedure put (
    signal clk : in std_ulogic; signal write : out lane_write_t; lane : in lane_t; data : in natural);
  -- The rest of a segment whose line is written, and its commit.
  procedure put_course (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks, rate_high : in natural);
  -- The end of a segment: a step of each axis every tick, of which each takes 16 clocks.
  procedure put_steps (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks : in natural);
  -- All words but the commit.
  procedure put_words (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks : in natural;
    flags : in natural := 0);
  procedure put_line (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t;
    ticks : in natural; flags : in natural := 0);

  -- The commit that is due is refused for this reason alone.
  procedure expect_refusal (
    signal clk : in std_ulogic; signal commit : out std_ulogic; signal seen : in core_outputs_t;
    reason : in reason_t);
  procedure expect_stop (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t;
    cause : in stop_cause_t);

end package;

package body step_generator_core_bench_pkg is

  procedure wait_clocks (signal clk : in std_ulogic; number : in natural) is
  begin
    for i in 1 to number loop
      wait until rising_edge(clk);
    end loop;
  end procedure;

  procedure pulse (signal clk : in std_ulogic; signal command : out std_ulogic) is
  begin
    command <= '1';
    wait_clocks(clk, 1);
    command <= '0';
  end procedure;

  procedure acknowledge (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t) is
  begin
    pulse(clk, drive.acknowledge_stop);
    wait_clocks(clk, 1);
    assert seen.stopped = '0' severity failure;
  end procedure;

  procedure wait_until_idle (signal clk : in std_ulogic; signal seen : in core_outputs_t) is
  begin
    wait until rising_edge(clk) and seen.idle = '1' for 1 ms;
    assert seen.idle = '1' severity failure;
  end procedure;

  procedure put (
    signal clk : in std_ulogic; signal write : out lane_write_t; lane : in lane_t;
    data : in std_ulogic_vector(31 downto 0)) is
  begin
    write <= (valid => '1', lane => lane, data => data);
    wait until rising_edge(clk);
    write.valid <= '0';
  end procedure;

  procedure put (
    signal clk : in std_ulogic; signal write : out lane_write_t; lane : in lane_t; data : in natural) is
  begin
    put(clk, write, lane, std_ulogic_vector(to_unsigned(data, 32)));
  end procedure;

  procedure put_rate (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks, rate_high : in natural) is
  begin
    put(clk, drive.write, ticks_lane, ticks);
    put(clk, drive.write, rate_low_lane, 0);
    put(clk, drive.write, rate_high_lane, rate_high);
    for lane in acceleration_low_lane to jerk_high_lane loop
      put(clk, drive.write, lane, 0);
    end loop;
    wait_clocks(clk, 1);
  end procedure;

  procedure put_course (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks, rate_high : in natural) is
  begin
    put_rate(clk, drive, ticks, rate_high);
    pulse(clk, drive.commit);
    wait_clocks(clk, 1);
  end procedure;

  procedure put_steps (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks : in natural) is
  begin
    for axis in 0 to axes - 1 loop
      put(clk, drive.write, steps_lane + axis, ticks);
    end loop;
    put_rate(clk, drive, ticks, 2 ** 28);
  end procedure;

  procedure put_words (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; ticks : in natural;
    flags : in natural := 0) is
  begin
    put(clk, drive.write, flags_lane, flags);
    put(clk, drive.write, line_ticks_lane, ticks);
    put_steps(clk, drive, ticks);
  end procedure;

  procedure put_line (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t;
    ticks : in natural; flags : in natural := 0) is
  begin
    put_words(clk, drive, ticks, flags);
    pulse(clk, drive.commit);
    assert seen.refused = refusal_none severity failure;
    wait_clocks(clk, 1);
  end procedure;

  procedure expect_refusal (
    signal clk : in std_ulogic; signal commit : out std_ulogic; signal seen : in core_outputs_t;
    reason : in reason_t) is
    variable expected : refusal_t := refusal_none;
  begin
    case reason is
      when incomplete => expected.incomplete := '1';
      when queue_full => expected.queue_full := '1';
      when while_stopped => expected.while_stopped := '1';
      when disabled => expected.disabled := '1';
    end case;
    pulse(clk, commit);
    assert seen.refused = expected report "a commit is not refused as " & reason_t'image(reason)
      severity failure;
    wait_clocks(clk, 1);
  end procedure;

  procedure expect_stop (
    signal clk : in std_ulogic; signal drive : inout core_inputs_t; signal seen : in core_outputs_t;
    cause : in stop_cause_t) is
  begin
    wait_clocks(clk, 3);
    assert seen.stopped = '1' and seen.moving = '0' and seen.level = 0 and seen.braking = '0'
      severity failure;
    assert seen.stop_cause = cause severity failure;
    acknowledge(clk, drive, seen);
  end procedure;

end package body;
