-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `step_generator`. Generated from rtl/motion/step_generator.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_generator_registers_pkg is

  constant step_generator_address : unsigned(31 downto 0) := x"F0003000";

  -- What this build of the step generator has.
  constant step_generator_build_address : unsigned(31 downto 0) := x"F0003000";
  type step_generator_build_t is record
    axes : unsigned(3 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;

  -- What software permits.
  constant step_generator_control_address : unsigned(31 downto 0) := x"F0003004";
  type step_generator_control_t is record
    run : std_ulogic;
    queue_interrupt_enable : std_ulogic;
    stop_interrupt_enable : std_ulogic;
    queue_threshold : unsigned(15 downto 0);
  end record;

  -- Each bit written as 1 does one thing at once.
  constant step_generator_command_address : unsigned(31 downto 0) := x"F0003008";
  type step_generator_command_t is record
    flush : std_ulogic;
    stop : std_ulogic;
    acknowledge_stop : std_ulogic;
    snapshot : std_ulogic;
    clear_errors : std_ulogic;
    start : std_ulogic;
    brake : std_ulogic;
    feed_watchdog : std_ulogic;
    positions_known : std_ulogic;
  end record;

  -- What the step generator is doing.
  constant step_generator_status_address : unsigned(31 downto 0) := x"F000300C";
  type step_generator_status_t is record
    moving : std_ulogic;
    idle : std_ulogic;
    stopped : std_ulogic;
    held : std_ulogic;
    braking : std_ulogic;
    waiting : std_ulogic;
    positions_lost : std_ulogic;
    level : unsigned(7 downto 0);
    free : unsigned(7 downto 0);
  end record;

  -- What was refused since the last clear_errors.
  constant step_generator_errors_address : unsigned(31 downto 0) := x"F0003010";
  type step_generator_errors_t is record
    queue_full : std_ulogic;
    incomplete : std_ulogic;
    illegal : std_ulogic;
    while_stopped : std_ulogic;
    position : std_ulogic;
    settings : std_ulogic;
    disabled : std_ulogic;
  end record;

  -- Enable pins of the motor drivers. Switched off only while no segment is executed or queued; the emergency stop input switches all off at once, and they stay so until the stop is acknowledged and this is written again.
  constant step_generator_motor_enable_address : unsigned(31 downto 0) := x"F0003014";
  type step_generator_motor_enable_t is record
    axes : std_ulogic_vector(7 downto 0);
  end record;

  -- The tick rate is never integrated below this. Written only when idle, and never 0.
  constant step_generator_rate_floor_address : unsigned(31 downto 0) := x"F0003018";
  type step_generator_rate_floor_t is record
    rate : unsigned(30 downto 0);
  end record;

  -- The scale of time that is aimed at while segments are executed; the path stays.
  constant step_generator_override_address : unsigned(31 downto 0) := x"F000301C";
  type step_generator_override_t is record
    scale : unsigned(17 downto 0);
  end record;

  -- How fast the scale changes while a segment is executed; at rest it changes at once.
  constant step_generator_override_slope_address : unsigned(31 downto 0) := x"F0003020";
  type step_generator_override_slope_t is record
    slope : unsigned(31 downto 0);
  end record;

  -- How fast the scale falls to 0 in a stop by braking: a deceleration of tick rate times slope.
  constant step_generator_brake_slope_address : unsigned(31 downto 0) := x"F0003024";
  type step_generator_brake_slope_t is record
    slope : unsigned(31 downto 0);
  end record;

  -- The scale of time at this moment.
  constant step_generator_scale_address : unsigned(31 downto 0) := x"F0003028";
  type step_generator_scale_t is record
    scale : unsigned(17 downto 0);
  end record;

  -- Stops motion when software does not feed it.
  constant step_generator_watchdog_address : unsigned(31 downto 0) := x"F000302C";
  type step_generator_watchdog_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- First word of a segment: begins a new one and forgets words written before.
  constant step_generator_segment_flags_address : unsigned(31 downto 0) := x"F0003030";
  type step_generator_segment_flags_t is record
    backward : std_ulogic_vector(7 downto 0);
    continues_line : std_ulogic;
    ends_motion : std_ulogic;
    stop_on_change : std_ulogic;
    stop_on_release : std_ulogic;
    stop_brakes : std_ulogic;
    waits_for_start : std_ulogic;
    stop_mask : std_ulogic_vector(7 downto 0);
    ahead : std_ulogic_vector(3 downto 0);
    behind : std_ulogic_vector(3 downto 0);
  end record;

  -- Ticks of the whole line, 1 .. 2^31 - 1; to be written before ticks and steps.
  constant step_generator_segment_line_ticks_address : unsigned(31 downto 0) := x"F0003034";
  type step_generator_segment_line_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;

  -- Ticks of this segment, 1 .. what is left of the line.
  constant step_generator_segment_ticks_address : unsigned(31 downto 0) := x"F0003038";
  type step_generator_segment_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;

  -- Tick rate at the start of the segment, low word, in 2^-64 ticks per clock.
  constant step_generator_segment_rate_low_address : unsigned(31 downto 0) := x"F000303C";
  type step_generator_segment_rate_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Tick rate, high word. The rate is at most 1/2 tick per clock.
  constant step_generator_segment_rate_high_address : unsigned(31 downto 0) := x"F0003040";
  type step_generator_segment_rate_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the rate per clock, signed, low word, in 2^-84 ticks per clock^2.
  constant step_generator_segment_acceleration_low_address : unsigned(31 downto 0) := x"F0003044";
  type step_generator_segment_acceleration_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the rate per clock, high word.
  constant step_generator_segment_acceleration_high_address : unsigned(31 downto 0) := x"F0003048";
  type step_generator_segment_acceleration_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the acceleration per clock, signed, low word, in 2^-84 ticks per clock^3.
  constant step_generator_segment_jerk_low_address : unsigned(31 downto 0) := x"F000304C";
  type step_generator_segment_jerk_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the acceleration per clock, high word. The acceleration stays where the change would take it out of its 64 bits.
  constant step_generator_segment_jerk_high_address : unsigned(31 downto 0) := x"F0003050";
  type step_generator_segment_jerk_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Steps of each axis in the whole line, without sign, 0 .. line_ticks.
  constant step_generator_segment_steps_address : unsigned(31 downto 0) := x"F0003054";  -- of the first
  type step_generator_segment_steps_t is record
    steps : unsigned(31 downto 0);
  end record;
  type step_generator_segment_steps_array_t is array (0 to 7) of step_generator_segment_steps_t;

  -- Any write appends the segment to the queue, or refuses it and says why in errors.
  constant step_generator_segment_commit_address : unsigned(31 downto 0) := x"F0003074";
  type step_generator_segment_commit_t is record
    any : unsigned(31 downto 0);
  end record;

  -- Width of the step pulse and of the pause after it, per axis. Written only when idle.
  constant step_generator_pulse_guard_address : unsigned(31 downto 0) := x"F0003078";  -- of the first
  type step_generator_pulse_guard_t is record
    high : unsigned(11 downto 0);
    low : unsigned(11 downto 0);
    both_edges : std_ulogic;
  end record;
  type step_generator_pulse_guard_array_t is array (0 to 7) of step_generator_pulse_guard_t;

  -- Distance between a change of direction and the steps, per axis. Written only when idle.
  constant step_generator_direction_guard_address : unsigned(31 downto 0) := x"F0003098";  -- of the first
  type step_generator_direction_guard_t is record
    setup : unsigned(11 downto 0);
    hold : unsigned(11 downto 0);
  end record;
  type step_generator_direction_guard_array_t is array (0 to 7) of step_generator_direction_guard_t;

  -- Steps given, forward less backward. Written only when idle, refused otherwise.
  constant step_generator_position_address : unsigned(31 downto 0) := x"F00030B8";  -- of the first
  type step_generator_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_position_array_t is array (0 to 7) of step_generator_position_t;

  -- Positions of all axes in the clock of the last snapshot.
  constant step_generator_snapshot_position_address : unsigned(31 downto 0) := x"F00030D8";  -- of the first
  type step_generator_snapshot_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_snapshot_position_array_t is array (0 to 7) of step_generator_snapshot_position_t;

  -- Time of the last snapshot, low word.
  constant step_generator_snapshot_time_low_address : unsigned(31 downto 0) := x"F00030F8";
  type step_generator_snapshot_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Time of the last snapshot, high word.
  constant step_generator_snapshot_time_high_address : unsigned(31 downto 0) := x"F00030FC";
  type step_generator_snapshot_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Why motion was stopped; valid while braking or stopped. What cuts braking short is added.
  constant step_generator_stop_cause_address : unsigned(31 downto 0) := x"F0003100";
  type step_generator_stop_cause_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_input : std_ulogic;
    software : std_ulogic;
    watchdog : std_ulogic;
    software_brake : std_ulogic;
  end record;

  -- Positions of all axes in the clock in which the last stop was asked for.
  constant step_generator_stop_position_address : unsigned(31 downto 0) := x"F0003104";  -- of the first
  type step_generator_stop_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_stop_position_array_t is array (0 to 7) of step_generator_stop_position_t;

  -- Time at which the last stop was asked for, low word.
  constant step_generator_stop_time_low_address : unsigned(31 downto 0) := x"F0003124";
  type step_generator_stop_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Time at which the last stop was asked for, high word.
  constant step_generator_stop_time_high_address : unsigned(31 downto 0) := x"F0003128";
  type step_generator_stop_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Segments begun since reset.
  constant step_generator_segments_executed_address : unsigned(31 downto 0) := x"F000312C";
  type step_generator_segments_executed_t is record
    count : unsigned(31 downto 0);
  end record;

  -- Times that the queue was empty at the end of a segment without ends_motion.
  constant step_generator_underruns_address : unsigned(31 downto 0) := x"F0003130";
  type step_generator_underruns_t is record
    count : unsigned(31 downto 0);
  end record;

  -- The fullest that the queue has been since reset.
  constant step_generator_max_level_address : unsigned(31 downto 0) := x"F0003134";
  type step_generator_max_level_t is record
    segments : unsigned(15 downto 0);
  end record;

  -- Clocks by which the guards of all axes have delayed the common base.
  constant step_generator_stalls_address : unsigned(31 downto 0) := x"F0003138";
  type step_generator_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Clocks in which the guard of an axis delayed the common base.
  constant step_generator_axis_stalls_address : unsigned(31 downto 0) := x"F000313C";  -- of the first
  type step_generator_axis_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;
  type step_generator_axis_stalls_array_t is array (0 to 7) of step_generator_axis_stalls_t;

  type step_generator_from_software_t is record
    control : step_generator_control_t;
    control_written : std_ulogic;
    command : step_generator_command_t;
    command_written : std_ulogic;
    motor_enable : step_generator_motor_enable_t;
    motor_enable_written : std_ulogic;
    rate_floor : step_generator_rate_floor_t;
    rate_floor_written : std_ulogic;
    override : step_generator_override_t;
    override_slope : step_generator_override_slope_t;
    brake_slope : step_generator_brake_slope_t;
    watchdog : step_generator_watchdog_t;
    segment_flags : step_generator_segment_flags_t;
    segment_flags_written : std_ulogic;
    segment_line_ticks : step_generator_segment_line_ticks_t;
    segment_line_ticks_written : std_ulogic;
    segment_ticks : step_generator_segment_ticks_t;
    segment_ticks_written : std_ulogic;
    segment_rate_low : step_generator_segment_rate_low_t;
    segment_rate_low_written : std_ulogic;
    segment_rate_high : step_generator_segment_rate_high_t;
    segment_rate_high_written : std_ulogic;
    segment_acceleration_low : step_generator_segment_acceleration_low_t;
    segment_acceleration_low_written : std_ulogic;
    segment_acceleration_high : step_generator_segment_acceleration_high_t;
    segment_acceleration_high_written : std_ulogic;
    segment_jerk_low : step_generator_segment_jerk_low_t;
    segment_jerk_low_written : std_ulogic;
    segment_jerk_high : step_generator_segment_jerk_high_t;
    segment_jerk_high_written : std_ulogic;
    segment_steps : step_generator_segment_steps_array_t;
    segment_steps_written : std_ulogic_vector(0 to 7);
    segment_commit : step_generator_segment_commit_t;
    segment_commit_written : std_ulogic;
    pulse_guard : step_generator_pulse_guard_array_t;
    pulse_guard_written : std_ulogic_vector(0 to 7);
    direction_guard : step_generator_direction_guard_array_t;
    direction_guard_written : std_ulogic_vector(0 to 7);
    position : step_generator_position_array_t;
    position_written : std_ulogic_vector(0 to 7);
  end record;

  type step_generator_to_software_t is record
    build : step_generator_build_t;
    control : step_generator_control_t;
    status : step_generator_status_t;
    errors : step_generator_errors_t;
    motor_enable : step_generator_motor_enable_t;
    rate_floor : step_generator_rate_floor_t;
    scale : step_generator_scale_t;
    position : step_generator_position_array_t;
    snapshot_position : step_generator_snapshot_position_array_t;
    snapshot_time_low : step_generator_snapshot_time_low_t;
    snapshot_time_high : step_generator_snapshot_time_high_t;
    stop_cause : step_generator_stop_cause_t;
    stop_position : step_generator_stop_position_array_t;
    stop_time_low : step_generator_stop_time_low_t;
    stop_time_high : step_generator_stop_time_high_t;
    segments_executed : step_generator_segments_executed_t;
    underruns : step_generator_underruns_t;
    max_level : step_generator_max_level_t;
    stalls : step_generator_stalls_t;
    axis_stalls : step_generator_axis_stalls_array_t;
  end record;

end package;
