-- SPDX-License-Identifier: Apache-2.0
-- The step generator on the bus: from segments in registers to step, direction and enable pins.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator is
  generic (
    axes : positive range 1 to axis_limit := 5;
    -- Segments that fit into the queue.
    queue_depth : positive range 2 to 255 := 32
  );
  port (
    -- May be gated while `at_rest` is high.
    clk : in std_ulogic;
    -- The same clock, never gated.
    always_clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;

    request : in bus_request_t;
    response : out bus_response_t;

    -- Synchronous to clk, filtered, 1 = triggered.
    end_stops : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    -- A rising edge starts a segment that waits for it: the same for several generators. Synchronous to clk.
    start : in std_ulogic;

    step : out std_ulogic_vector(axes - 1 downto 0);
    -- 1 = negative.
    direction : out std_ulogic_vector(axes - 1 downto 0);
    -- Of the motor drivers, 1 = enabled.
    enable : out std_ulogic_vector(axes - 1 downto 0);

    -- A segment is executed.
    moving : out std_ulogic;
    -- None is, none is queued, and every pulse is finished.
    idle : out std_ulogic;
    -- The queue is at or below its threshold.
    queue_interrupt : out std_ulogic := '0';
    -- A stop waits for its acknowledgement.
    stop_interrupt : out std_ulogic := '0';
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of step_generator is

  constant control_after_reset : step_generator_control_t := (
    queue_threshold => (others => '0'), others => '0');

  signal from_software : step_generator_from_software_t;
  signal to_software : step_generator_to_software_t;

  signal write : lane_write_t;
  signal guards : guard_array_t(axes - 1 downto 0);
  signal both_edges : std_ulogic_vector(axes - 1 downto 0);
  signal control : step_generator_control_t := control_after_reset;
  signal rate_floor : unsigned(30 downto 0);
  signal setting_refused, motor_refused : std_ulogic;
  signal enabled : std_ulogic_vector(axes - 1 downto 0);
  signal in_motion : std_ulogic;
  signal positions_lost : std_ulogic;
  signal refused : refusal_t;
  signal position_refused : std_ulogic;

  signal level : natural range 0 to queue_depth;
  signal max_level : natural range 0 to queue_depth;
  signal waiting : std_ulogic;
  signal held : std_ulogic;
  signal scale : scale_t;
  signal braking : std_ulogic;
  signal stopped : std_ulogic;
  signal stop_cause : stop_cause_t;
  signal segments : count_t;
  signal underruns : count_t;
  signal stalls : count_t;
  signal axis_stalls : count_array_t(axes - 1 downto 0);
  signal positions : position_array_t(axes - 1 downto 0);
  signal stop_positions : position_array_t(axes - 1 downto 0);
  signal snapshot_positions : position_array_t(axes - 1 downto 0);
  signal stop_time : time_t;
  signal snapshot_time : time_t;

  signal working, alarm, motor_alarm : std_ulogic;

  signal set_position : std_ulogic_vector(axes - 1 downto 0);
  signal new_position : position_t;

  -- A bit of the register command, for the clock in which it is written.
  signal command : step_generator_command_t;

begin

  registers : entity work.step_generator_registers
    port map (
      clk => bus_clk, reset => reset, request => request, response => response,
      from_software => from_software, to_software => to_software);

  watch_rest : entity work.rest_watch
    port map (
      clk => clk, bus_clk => bus_clk, reset => reset, strobe => request.strobe, working => working,
      alarm => alarm or motor_alarm, at_rest => at_rest);

  command <= from_software.command when from_software.command_written = '1' else (others => '0');

  core : entity work.step_generator_core
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clk => clk, always_clk => always_clk, bus_clk => bus_clk, reset => reset, guards => guards,
      both_edges => both_edges, rate_floor => rate_floor, enabled => enabled,
      run => control.run, start => start, software_start => command.start, waiting => waiting,
      override => from_software.override.scale,
      override_slope => from_software.override_slope.slope,
      brake_slope => from_software.brake_slope.slope, scale => scale, held => held,
      write => write, commit => from_software.segment_commit_written, refused => refused,
      flush => command.flush, level => level, max_level => max_level, moving => moving,
      idle => idle, segments => segments, underruns => underruns, stalls => stalls,
      axis_stalls => axis_stalls, end_stops => end_stops, emergency_stop => emergency_stop,
      software_stop => command.stop, software_brake => command.brake,
      acknowledge_stop => command.acknowledge_stop,
      watchdog_limit => from_software.watchdog.clocks, feed_watchdog => command.feed_watchdog,
      braking => braking, stopped => stopped, stop_cause => stop_cause,
      stop_positions => stop_positions, stop_time => stop_time, positions => positions,
      set_position => set_position, new_position => new_position,
      position_refused => position_refused, snapshot => command.snapshot,
      snapshot_positions => snapshot_positions, snapshot_time => snapshot_time, step => step,
      direction => direction, working => working, alarm => alarm);

  settings : entity work.motion_settings
    generic map (axes => axes)
    port map (
      clk => bus_clk, reset => reset, from_software => from_software, idle => idle, step => step,
      guards => guards, both_edges => both_edges, rate_floor => rate_floor,
      refused => setting_refused);

  in_motion <= moving when level = 0 else '1';

  motors : entity work.motor_switch
    generic map (axes => axes)
    port map (
      clk => clk, reset => reset, written => from_software.motor_enable_written,
      wanted => from_software.motor_enable.axes(axes - 1 downto 0),
      positions_known => command.positions_known, moving => in_motion,
      emergency_stop => emergency_stop, stopped => stopped, enabled => enabled, pins => enable,
      positions_lost => positions_lost, refused => motor_refused, alarm => motor_alarm);

  words : entity work.segment_words
    generic map (axes => axes)
    port map (from_software => from_software, write => write);

  new_position <= from_software.position(0).steps;
  positions_from_software : for axis in 0 to axes - 1 generate
    set_position(axis) <= from_software.position_written(axis);
  end generate;

  keep_control : process
  begin
    wait until rising_edge(bus_clk);
    if from_software.control_written then
      control <= from_software.control;
    end if;
    if reset then
      control <= control_after_reset;
    end if;
  end process;

  errors : entity work.error_latch
    port map (
      clk => bus_clk, reset => reset, clear => command.clear_errors, segment_refused => refused,
      position_refused => position_refused, setting_refused => setting_refused or motor_refused,
      errors => to_software.errors);

  interrupt : process
  begin
    wait until rising_edge(clk);
    queue_interrupt <= '0';
    if level <= control.queue_threshold then
      queue_interrupt <= control.queue_interrupt_enable;
    end if;
    stop_interrupt <= stopped and control.stop_interrupt_enable;
    if reset then
      queue_interrupt <= '0';
      stop_interrupt <= '0';
    end if;
  end process;

  to_software.build <= (
    axes => to_unsigned(axes, 4), queue_depth => to_unsigned(queue_depth, 16));
  to_software.control <= control;
  to_software.rate_floor.rate <= rate_floor;
  motors_to_software : process (all)
  begin
    to_software.motor_enable.axes <= (others => '0');
    to_software.motor_enable.axes(axes - 1 downto 0) <= enabled;
  end process;
  to_software.status <= (
    moving => moving, idle => idle, stopped => stopped, held => held, braking => braking,
    waiting => waiting, positions_lost => positions_lost, level => to_unsigned(level, 8),
    free => to_unsigned(queue_depth - level, 8));
  to_software.snapshot_time_low.clocks <= snapshot_time(31 downto 0);
  to_software.snapshot_time_high.clocks <= snapshot_time(63 downto 32);
  to_software.stop_cause <= (
    end_stops => stop_cause.end_stops, emergency_input => stop_cause.emergency_input,
    software => stop_cause.software, watchdog => stop_cause.watchdog,
    software_brake => stop_cause.software_brake);
  to_software.stop_time_low.clocks <= stop_time(31 downto 0);
  to_software.stop_time_high.clocks <= stop_time(63 downto 32);
  to_software.segments_executed.count <= segments;
  to_software.underruns.count <= underruns;
  to_software.max_level.segments <= to_unsigned(max_level, 16);
  to_software.stalls.clocks <= stalls;
  to_software.scale.scale <= scale(33 downto 16);

  axes_to_software : for axis in 0 to axis_limit - 1 generate
    present : if axis < axes generate
      to_software.position(axis).steps <= positions(axis);
      to_software.snapshot_position(axis).steps <= snapshot_positions(axis);
      to_software.stop_position(axis).steps <= stop_positions(axis);
      to_software.axis_stalls(axis).clocks <= axis_stalls(axis);
    else generate
      to_software.position(axis).steps <= (others => '0');
      to_software.snapshot_position(axis).steps <= (others => '0');
      to_software.stop_position(axis).steps <= (others => '0');
      to_software.axis_stalls(axis).clocks <= (others => '0');
    end generate;
  end generate;

end architecture;
