-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `step_generator`. Generated from rtl/motion/step_generator.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_generator_registers_pkg is

  constant step_generator_address : unsigned(31 downto 0) := x"F0003000";

  -- What this build of the step generator has.
  constant step_generator_build_address : unsigned(31 downto 0) := x"F0003000";
  subtype step_generator_build_axes_bits is natural range 3 downto 0;
  subtype step_generator_build_queue_depth_bits is natural range 23 downto 8;
  type step_generator_build_t is record
    axes : unsigned(3 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;
  function to_word(value : step_generator_build_t) return std_ulogic_vector;
  function to_step_generator_build(word : std_ulogic_vector(31 downto 0)) return step_generator_build_t;

  -- What software permits.
  constant step_generator_control_address : unsigned(31 downto 0) := x"F0003004";
  constant step_generator_control_run_bit : natural := 0;
  constant step_generator_control_queue_interrupt_enable_bit : natural := 1;
  constant step_generator_control_stop_interrupt_enable_bit : natural := 2;
  subtype step_generator_control_queue_threshold_bits is natural range 31 downto 16;
  type step_generator_control_t is record
    run : std_ulogic;
    queue_interrupt_enable : std_ulogic;
    stop_interrupt_enable : std_ulogic;
    queue_threshold : unsigned(15 downto 0);
  end record;
  function to_word(value : step_generator_control_t) return std_ulogic_vector;
  function to_step_generator_control(word : std_ulogic_vector(31 downto 0)) return step_generator_control_t;

  -- Each bit written as 1 does one thing at once.
  constant step_generator_command_address : unsigned(31 downto 0) := x"F0003008";
  constant step_generator_command_flush_bit : natural := 0;
  constant step_generator_command_stop_bit : natural := 1;
  constant step_generator_command_acknowledge_stop_bit : natural := 2;
  constant step_generator_command_snapshot_bit : natural := 3;
  constant step_generator_command_clear_errors_bit : natural := 4;
  constant step_generator_command_start_bit : natural := 5;
  constant step_generator_command_brake_bit : natural := 6;
  constant step_generator_command_feed_watchdog_bit : natural := 7;
  constant step_generator_command_positions_known_bit : natural := 8;
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
  function to_word(value : step_generator_command_t) return std_ulogic_vector;
  function to_step_generator_command(word : std_ulogic_vector(31 downto 0)) return step_generator_command_t;

  -- What the step generator is doing.
  constant step_generator_status_address : unsigned(31 downto 0) := x"F000300C";
  constant step_generator_status_moving_bit : natural := 0;
  constant step_generator_status_idle_bit : natural := 1;
  constant step_generator_status_stopped_bit : natural := 2;
  constant step_generator_status_held_bit : natural := 3;
  constant step_generator_status_braking_bit : natural := 4;
  constant step_generator_status_waiting_bit : natural := 5;
  constant step_generator_status_positions_lost_bit : natural := 6;
  subtype step_generator_status_level_bits is natural range 15 downto 8;
  subtype step_generator_status_free_bits is natural range 23 downto 16;
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
  function to_word(value : step_generator_status_t) return std_ulogic_vector;
  function to_step_generator_status(word : std_ulogic_vector(31 downto 0)) return step_generator_status_t;

  -- What was refused since the last clear_errors.
  constant step_generator_errors_address : unsigned(31 downto 0) := x"F0003010";
  constant step_generator_errors_queue_full_bit : natural := 0;
  constant step_generator_errors_incomplete_bit : natural := 1;
  constant step_generator_errors_illegal_bit : natural := 2;
  constant step_generator_errors_while_stopped_bit : natural := 3;
  constant step_generator_errors_position_bit : natural := 4;
  constant step_generator_errors_settings_bit : natural := 5;
  constant step_generator_errors_disabled_bit : natural := 6;
  type step_generator_errors_t is record
    queue_full : std_ulogic;
    incomplete : std_ulogic;
    illegal : std_ulogic;
    while_stopped : std_ulogic;
    position : std_ulogic;
    settings : std_ulogic;
    disabled : std_ulogic;
  end record;
  function to_word(value : step_generator_errors_t) return std_ulogic_vector;
  function to_step_generator_errors(word : std_ulogic_vector(31 downto 0)) return step_generator_errors_t;

  -- Enable pins of the motor drivers. Switched off only while no segment is executed or queued; the emergency stop input switches all off at once, and they stay so until the stop is acknowledged and this is written again.
  constant step_generator_motor_enable_address : unsigned(31 downto 0) := x"F0003014";
  subtype step_generator_motor_enable_axes_bits is natural range 7 downto 0;
  type step_generator_motor_enable_t is record
    axes : std_ulogic_vector(7 downto 0);
  end record;
  function to_word(value : step_generator_motor_enable_t) return std_ulogic_vector;
  function to_step_generator_motor_enable(word : std_ulogic_vector(31 downto 0)) return step_generator_motor_enable_t;

  -- The tick rate is never integrated below this. Written only when idle, and never 0.
  constant step_generator_rate_floor_address : unsigned(31 downto 0) := x"F0003018";
  subtype step_generator_rate_floor_rate_bits is natural range 30 downto 0;
  type step_generator_rate_floor_t is record
    rate : unsigned(30 downto 0);
  end record;
  function to_word(value : step_generator_rate_floor_t) return std_ulogic_vector;
  function to_step_generator_rate_floor(word : std_ulogic_vector(31 downto 0)) return step_generator_rate_floor_t;

  -- The scale of time that is aimed at while segments are executed; the path stays.
  constant step_generator_override_address : unsigned(31 downto 0) := x"F000301C";
  subtype step_generator_override_scale_bits is natural range 17 downto 0;
  type step_generator_override_t is record
    scale : unsigned(17 downto 0);
  end record;
  constant step_generator_override_after_reset : step_generator_override_t := (scale => 18x"10000");
  function to_word(value : step_generator_override_t) return std_ulogic_vector;
  function to_step_generator_override(word : std_ulogic_vector(31 downto 0)) return step_generator_override_t;

  -- How fast the scale changes while a segment is executed; at rest it changes at once.
  constant step_generator_override_slope_address : unsigned(31 downto 0) := x"F0003020";
  subtype step_generator_override_slope_slope_bits is natural range 31 downto 0;
  type step_generator_override_slope_t is record
    slope : unsigned(31 downto 0);
  end record;
  constant step_generator_override_slope_after_reset : step_generator_override_slope_t := (slope => 32x"6B6");
  function to_word(value : step_generator_override_slope_t) return std_ulogic_vector;
  function to_step_generator_override_slope(word : std_ulogic_vector(31 downto 0)) return step_generator_override_slope_t;

  -- How fast the scale falls to 0 in a stop by braking: a deceleration of tick rate times slope.
  constant step_generator_brake_slope_address : unsigned(31 downto 0) := x"F0003024";
  subtype step_generator_brake_slope_slope_bits is natural range 31 downto 0;
  type step_generator_brake_slope_t is record
    slope : unsigned(31 downto 0);
  end record;
  constant step_generator_brake_slope_after_reset : step_generator_brake_slope_t := (slope => 32x"6B6");
  function to_word(value : step_generator_brake_slope_t) return std_ulogic_vector;
  function to_step_generator_brake_slope(word : std_ulogic_vector(31 downto 0)) return step_generator_brake_slope_t;

  -- The scale of time at this moment.
  constant step_generator_scale_address : unsigned(31 downto 0) := x"F0003028";
  subtype step_generator_scale_scale_bits is natural range 17 downto 0;
  type step_generator_scale_t is record
    scale : unsigned(17 downto 0);
  end record;
  function to_word(value : step_generator_scale_t) return std_ulogic_vector;
  function to_step_generator_scale(word : std_ulogic_vector(31 downto 0)) return step_generator_scale_t;

  -- Stops motion when software does not feed it.
  constant step_generator_watchdog_address : unsigned(31 downto 0) := x"F000302C";
  subtype step_generator_watchdog_clocks_bits is natural range 31 downto 0;
  type step_generator_watchdog_t is record
    clocks : unsigned(31 downto 0);
  end record;
  constant step_generator_watchdog_after_reset : step_generator_watchdog_t := (clocks => 32x"0");
  function to_word(value : step_generator_watchdog_t) return std_ulogic_vector;
  function to_step_generator_watchdog(word : std_ulogic_vector(31 downto 0)) return step_generator_watchdog_t;

  -- First word of a segment: begins a new one and forgets words written before.
  constant step_generator_segment_flags_address : unsigned(31 downto 0) := x"F0003030";
  subtype step_generator_segment_flags_backward_bits is natural range 7 downto 0;
  constant step_generator_segment_flags_continues_line_bit : natural := 8;
  constant step_generator_segment_flags_ends_motion_bit : natural := 9;
  constant step_generator_segment_flags_stop_on_change_bit : natural := 10;
  constant step_generator_segment_flags_stop_on_release_bit : natural := 11;
  constant step_generator_segment_flags_stop_brakes_bit : natural := 12;
  constant step_generator_segment_flags_waits_for_start_bit : natural := 13;
  subtype step_generator_segment_flags_stop_mask_bits is natural range 23 downto 16;
  subtype step_generator_segment_flags_ahead_bits is natural range 27 downto 24;
  subtype step_generator_segment_flags_behind_bits is natural range 31 downto 28;
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
  function to_word(value : step_generator_segment_flags_t) return std_ulogic_vector;
  function to_step_generator_segment_flags(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_flags_t;

  -- Ticks of the whole line, 1 .. 2^31 - 1; to be written before ticks and steps.
  constant step_generator_segment_line_ticks_address : unsigned(31 downto 0) := x"F0003034";
  subtype step_generator_segment_line_ticks_ticks_bits is natural range 31 downto 0;
  type step_generator_segment_line_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_line_ticks_t) return std_ulogic_vector;
  function to_step_generator_segment_line_ticks(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_line_ticks_t;

  -- Ticks of this segment, 1 .. what is left of the line.
  constant step_generator_segment_ticks_address : unsigned(31 downto 0) := x"F0003038";
  subtype step_generator_segment_ticks_ticks_bits is natural range 31 downto 0;
  type step_generator_segment_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_ticks_t) return std_ulogic_vector;
  function to_step_generator_segment_ticks(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_ticks_t;

  -- Low word: Tick rate at the start of the segment, at most 1/2 tick per clock.
  constant step_generator_segment_rate_low_address : unsigned(31 downto 0) := x"F000303C";
  subtype step_generator_segment_rate_low_rate_bits is natural range 31 downto 0;
  type step_generator_segment_rate_low_t is record
    rate : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_rate_low_t) return std_ulogic_vector;
  function to_step_generator_segment_rate_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_rate_low_t;

  -- High word: Tick rate at the start of the segment, at most 1/2 tick per clock.
  constant step_generator_segment_rate_high_address : unsigned(31 downto 0) := x"F0003040";
  subtype step_generator_segment_rate_high_rate_bits is natural range 31 downto 0;
  type step_generator_segment_rate_high_t is record
    rate : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_rate_high_t) return std_ulogic_vector;
  function to_step_generator_segment_rate_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_rate_high_t;

  -- Low word: Change of the rate per clock.
  constant step_generator_segment_acceleration_low_address : unsigned(31 downto 0) := x"F0003044";
  subtype step_generator_segment_acceleration_low_acceleration_bits is natural range 31 downto 0;
  type step_generator_segment_acceleration_low_t is record
    acceleration : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_acceleration_low_t) return std_ulogic_vector;
  function to_step_generator_segment_acceleration_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_acceleration_low_t;

  -- High word: Change of the rate per clock.
  constant step_generator_segment_acceleration_high_address : unsigned(31 downto 0) := x"F0003048";
  subtype step_generator_segment_acceleration_high_acceleration_bits is natural range 31 downto 0;
  type step_generator_segment_acceleration_high_t is record
    acceleration : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_acceleration_high_t) return std_ulogic_vector;
  function to_step_generator_segment_acceleration_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_acceleration_high_t;

  -- Low word: Change of the acceleration per clock. The acceleration stays where the change would take it out of its 64 bits.
  constant step_generator_segment_jerk_low_address : unsigned(31 downto 0) := x"F000304C";
  subtype step_generator_segment_jerk_low_jerk_bits is natural range 31 downto 0;
  type step_generator_segment_jerk_low_t is record
    jerk : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_jerk_low_t) return std_ulogic_vector;
  function to_step_generator_segment_jerk_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_jerk_low_t;

  -- High word: Change of the acceleration per clock. The acceleration stays where the change would take it out of its 64 bits.
  constant step_generator_segment_jerk_high_address : unsigned(31 downto 0) := x"F0003050";
  subtype step_generator_segment_jerk_high_jerk_bits is natural range 31 downto 0;
  type step_generator_segment_jerk_high_t is record
    jerk : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_jerk_high_t) return std_ulogic_vector;
  function to_step_generator_segment_jerk_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_jerk_high_t;

  -- Steps of each axis in the whole line, without sign, 0 .. line_ticks.
  constant step_generator_segment_steps_address : unsigned(31 downto 0) := x"F0003054";  -- of the first
  subtype step_generator_segment_steps_steps_bits is natural range 31 downto 0;
  type step_generator_segment_steps_t is record
    steps : unsigned(31 downto 0);
  end record;
  type step_generator_segment_steps_array_t is array (0 to 7) of step_generator_segment_steps_t;
  function to_word(value : step_generator_segment_steps_t) return std_ulogic_vector;
  function to_step_generator_segment_steps(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_steps_t;

  -- Any write appends the segment to the queue, or refuses it and says why in errors.
  constant step_generator_segment_commit_address : unsigned(31 downto 0) := x"F0003074";
  subtype step_generator_segment_commit_any_bits is natural range 31 downto 0;
  type step_generator_segment_commit_t is record
    any : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segment_commit_t) return std_ulogic_vector;
  function to_step_generator_segment_commit(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_commit_t;

  -- Width of the step pulse and of the pause after it, per axis. Written only when idle.
  constant step_generator_pulse_guard_address : unsigned(31 downto 0) := x"F0003078";  -- of the first
  subtype step_generator_pulse_guard_high_bits is natural range 11 downto 0;
  subtype step_generator_pulse_guard_low_bits is natural range 27 downto 16;
  constant step_generator_pulse_guard_both_edges_bit : natural := 31;
  type step_generator_pulse_guard_t is record
    high : unsigned(11 downto 0);
    low : unsigned(11 downto 0);
    both_edges : std_ulogic;
  end record;
  type step_generator_pulse_guard_array_t is array (0 to 7) of step_generator_pulse_guard_t;
  function to_word(value : step_generator_pulse_guard_t) return std_ulogic_vector;
  function to_step_generator_pulse_guard(word : std_ulogic_vector(31 downto 0)) return step_generator_pulse_guard_t;

  -- Distance between a change of direction and the steps, per axis. Written only when idle.
  constant step_generator_direction_guard_address : unsigned(31 downto 0) := x"F0003098";  -- of the first
  subtype step_generator_direction_guard_setup_bits is natural range 11 downto 0;
  subtype step_generator_direction_guard_hold_bits is natural range 27 downto 16;
  type step_generator_direction_guard_t is record
    setup : unsigned(11 downto 0);
    hold : unsigned(11 downto 0);
  end record;
  type step_generator_direction_guard_array_t is array (0 to 7) of step_generator_direction_guard_t;
  function to_word(value : step_generator_direction_guard_t) return std_ulogic_vector;
  function to_step_generator_direction_guard(word : std_ulogic_vector(31 downto 0)) return step_generator_direction_guard_t;

  -- Steps given, forward less backward. Written only when idle, refused otherwise.
  constant step_generator_position_address : unsigned(31 downto 0) := x"F00030B8";  -- of the first
  subtype step_generator_position_steps_bits is natural range 31 downto 0;
  type step_generator_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_position_array_t is array (0 to 7) of step_generator_position_t;
  function to_word(value : step_generator_position_t) return std_ulogic_vector;
  function to_step_generator_position(word : std_ulogic_vector(31 downto 0)) return step_generator_position_t;

  -- Positions of all axes in the clock of the last snapshot.
  constant step_generator_snapshot_position_address : unsigned(31 downto 0) := x"F00030D8";  -- of the first
  subtype step_generator_snapshot_position_steps_bits is natural range 31 downto 0;
  type step_generator_snapshot_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_snapshot_position_array_t is array (0 to 7) of step_generator_snapshot_position_t;
  function to_word(value : step_generator_snapshot_position_t) return std_ulogic_vector;
  function to_step_generator_snapshot_position(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_position_t;

  -- Low word: Time of the last snapshot.
  constant step_generator_snapshot_time_low_address : unsigned(31 downto 0) := x"F00030F8";
  subtype step_generator_snapshot_time_low_clocks_bits is natural range 31 downto 0;
  type step_generator_snapshot_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_snapshot_time_low_t) return std_ulogic_vector;
  function to_step_generator_snapshot_time_low(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_time_low_t;

  -- High word: Time of the last snapshot.
  constant step_generator_snapshot_time_high_address : unsigned(31 downto 0) := x"F00030FC";
  subtype step_generator_snapshot_time_high_clocks_bits is natural range 31 downto 0;
  type step_generator_snapshot_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_snapshot_time_high_t) return std_ulogic_vector;
  function to_step_generator_snapshot_time_high(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_time_high_t;

  -- Why motion was stopped; valid while braking or stopped. What cuts braking short is added.
  constant step_generator_stop_cause_address : unsigned(31 downto 0) := x"F0003100";
  subtype step_generator_stop_cause_end_stops_bits is natural range 7 downto 0;
  constant step_generator_stop_cause_emergency_input_bit : natural := 8;
  constant step_generator_stop_cause_software_bit : natural := 9;
  constant step_generator_stop_cause_watchdog_bit : natural := 10;
  constant step_generator_stop_cause_software_brake_bit : natural := 11;
  type step_generator_stop_cause_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_input : std_ulogic;
    software : std_ulogic;
    watchdog : std_ulogic;
    software_brake : std_ulogic;
  end record;
  function to_word(value : step_generator_stop_cause_t) return std_ulogic_vector;
  function to_step_generator_stop_cause(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_cause_t;

  -- Positions of all axes when the last stop was requested, after the tick of the clock before.
  constant step_generator_stop_position_address : unsigned(31 downto 0) := x"F0003104";  -- of the first
  subtype step_generator_stop_position_steps_bits is natural range 31 downto 0;
  type step_generator_stop_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_stop_position_array_t is array (0 to 7) of step_generator_stop_position_t;
  function to_word(value : step_generator_stop_position_t) return std_ulogic_vector;
  function to_step_generator_stop_position(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_position_t;

  -- Low word: Time at which the last stop was requested.
  constant step_generator_stop_time_low_address : unsigned(31 downto 0) := x"F0003124";
  subtype step_generator_stop_time_low_clocks_bits is natural range 31 downto 0;
  type step_generator_stop_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_stop_time_low_t) return std_ulogic_vector;
  function to_step_generator_stop_time_low(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_time_low_t;

  -- High word: Time at which the last stop was requested.
  constant step_generator_stop_time_high_address : unsigned(31 downto 0) := x"F0003128";
  subtype step_generator_stop_time_high_clocks_bits is natural range 31 downto 0;
  type step_generator_stop_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_stop_time_high_t) return std_ulogic_vector;
  function to_step_generator_stop_time_high(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_time_high_t;

  -- Segments begun since reset.
  constant step_generator_segments_executed_address : unsigned(31 downto 0) := x"F000312C";
  subtype step_generator_segments_executed_count_bits is natural range 31 downto 0;
  type step_generator_segments_executed_t is record
    count : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_segments_executed_t) return std_ulogic_vector;
  function to_step_generator_segments_executed(word : std_ulogic_vector(31 downto 0)) return step_generator_segments_executed_t;

  -- Times that the queue was empty at the end of a segment without ends_motion.
  constant step_generator_underruns_address : unsigned(31 downto 0) := x"F0003130";
  subtype step_generator_underruns_count_bits is natural range 31 downto 0;
  type step_generator_underruns_t is record
    count : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_underruns_t) return std_ulogic_vector;
  function to_step_generator_underruns(word : std_ulogic_vector(31 downto 0)) return step_generator_underruns_t;

  -- The fullest that the queue has been since reset.
  constant step_generator_max_level_address : unsigned(31 downto 0) := x"F0003134";
  subtype step_generator_max_level_segments_bits is natural range 15 downto 0;
  type step_generator_max_level_t is record
    segments : unsigned(15 downto 0);
  end record;
  function to_word(value : step_generator_max_level_t) return std_ulogic_vector;
  function to_step_generator_max_level(word : std_ulogic_vector(31 downto 0)) return step_generator_max_level_t;

  -- Clocks by which the guards of all axes have delayed the common base.
  constant step_generator_stalls_address : unsigned(31 downto 0) := x"F0003138";
  subtype step_generator_stalls_clocks_bits is natural range 31 downto 0;
  type step_generator_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;
  function to_word(value : step_generator_stalls_t) return std_ulogic_vector;
  function to_step_generator_stalls(word : std_ulogic_vector(31 downto 0)) return step_generator_stalls_t;

  -- Clocks in which the guard of an axis delayed the common base.
  constant step_generator_axis_stalls_address : unsigned(31 downto 0) := x"F000313C";  -- of the first
  subtype step_generator_axis_stalls_clocks_bits is natural range 31 downto 0;
  type step_generator_axis_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;
  type step_generator_axis_stalls_array_t is array (0 to 7) of step_generator_axis_stalls_t;
  function to_word(value : step_generator_axis_stalls_t) return std_ulogic_vector;
  function to_step_generator_axis_stalls(word : std_ulogic_vector(31 downto 0)) return step_generator_axis_stalls_t;

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

package body step_generator_registers_pkg is

  function to_word(value : step_generator_build_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.queue_depth) & "0000" & std_ulogic_vector(value.axes);
  end function;

  function to_step_generator_build(word : std_ulogic_vector(31 downto 0)) return step_generator_build_t is
  begin
    return (
      axes => unsigned(word(step_generator_build_axes_bits)),
  queue_depth => unsigned(word(step_generator_build_queue_depth_bits)));
  end function;

  function to_word(value : step_generator_control_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.queue_threshold) & "0000000000000" & value.stop_interrupt_enable & value.queue_interrupt_enable & value.run;
  end function;

  function to_step_generator_control(word : std_ulogic_vector(31 downto 0)) return step_generator_control_t is
  begin
    return (
      run => word(step_generator_control_run_bit),
  queue_interrupt_enable => word(step_generator_control_queue_interrupt_enable_bit),
  stop_interrupt_enable => word(step_generator_control_stop_interrupt_enable_bit),
  queue_threshold => unsigned(word(step_generator_control_queue_threshold_bits)));
  end function;

  function to_word(value : step_generator_command_t) return std_ulogic_vector is
  begin
    return "00000000000000000000000" & value.positions_known & value.feed_watchdog & value.brake & value.start & value.clear_errors & value.snapshot & value.acknowledge_stop & value.stop & value.flush;
  end function;

  function to_step_generator_command(word : std_ulogic_vector(31 downto 0)) return step_generator_command_t is
  begin
    return (
      flush => word(step_generator_command_flush_bit),
  stop => word(step_generator_command_stop_bit),
  acknowledge_stop => word(step_generator_command_acknowledge_stop_bit),
  snapshot => word(step_generator_command_snapshot_bit),
  clear_errors => word(step_generator_command_clear_errors_bit),
  start => word(step_generator_command_start_bit),
  brake => word(step_generator_command_brake_bit),
  feed_watchdog => word(step_generator_command_feed_watchdog_bit),
  positions_known => word(step_generator_command_positions_known_bit));
  end function;

  function to_word(value : step_generator_status_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.free) & std_ulogic_vector(value.level) & '0' & value.positions_lost & value.waiting & value.braking & value.held & value.stopped & value.idle & value.moving;
  end function;

  function to_step_generator_status(word : std_ulogic_vector(31 downto 0)) return step_generator_status_t is
  begin
    return (
      moving => word(step_generator_status_moving_bit),
  idle => word(step_generator_status_idle_bit),
  stopped => word(step_generator_status_stopped_bit),
  held => word(step_generator_status_held_bit),
  braking => word(step_generator_status_braking_bit),
  waiting => word(step_generator_status_waiting_bit),
  positions_lost => word(step_generator_status_positions_lost_bit),
  level => unsigned(word(step_generator_status_level_bits)),
  free => unsigned(word(step_generator_status_free_bits)));
  end function;

  function to_word(value : step_generator_errors_t) return std_ulogic_vector is
  begin
    return "0000000000000000000000000" & value.disabled & value.settings & value.position & value.while_stopped & value.illegal & value.incomplete & value.queue_full;
  end function;

  function to_step_generator_errors(word : std_ulogic_vector(31 downto 0)) return step_generator_errors_t is
  begin
    return (
      queue_full => word(step_generator_errors_queue_full_bit),
  incomplete => word(step_generator_errors_incomplete_bit),
  illegal => word(step_generator_errors_illegal_bit),
  while_stopped => word(step_generator_errors_while_stopped_bit),
  position => word(step_generator_errors_position_bit),
  settings => word(step_generator_errors_settings_bit),
  disabled => word(step_generator_errors_disabled_bit));
  end function;

  function to_word(value : step_generator_motor_enable_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & value.axes;
  end function;

  function to_step_generator_motor_enable(word : std_ulogic_vector(31 downto 0)) return step_generator_motor_enable_t is
  begin
    return (
      axes => word(step_generator_motor_enable_axes_bits));
  end function;

  function to_word(value : step_generator_rate_floor_t) return std_ulogic_vector is
  begin
    return '0' & std_ulogic_vector(value.rate);
  end function;

  function to_step_generator_rate_floor(word : std_ulogic_vector(31 downto 0)) return step_generator_rate_floor_t is
  begin
    return (
      rate => unsigned(word(step_generator_rate_floor_rate_bits)));
  end function;

  function to_word(value : step_generator_override_t) return std_ulogic_vector is
  begin
    return "00000000000000" & std_ulogic_vector(value.scale);
  end function;

  function to_step_generator_override(word : std_ulogic_vector(31 downto 0)) return step_generator_override_t is
  begin
    return (
      scale => unsigned(word(step_generator_override_scale_bits)));
  end function;

  function to_word(value : step_generator_override_slope_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.slope);
  end function;

  function to_step_generator_override_slope(word : std_ulogic_vector(31 downto 0)) return step_generator_override_slope_t is
  begin
    return (
      slope => unsigned(word(step_generator_override_slope_slope_bits)));
  end function;

  function to_word(value : step_generator_brake_slope_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.slope);
  end function;

  function to_step_generator_brake_slope(word : std_ulogic_vector(31 downto 0)) return step_generator_brake_slope_t is
  begin
    return (
      slope => unsigned(word(step_generator_brake_slope_slope_bits)));
  end function;

  function to_word(value : step_generator_scale_t) return std_ulogic_vector is
  begin
    return "00000000000000" & std_ulogic_vector(value.scale);
  end function;

  function to_step_generator_scale(word : std_ulogic_vector(31 downto 0)) return step_generator_scale_t is
  begin
    return (
      scale => unsigned(word(step_generator_scale_scale_bits)));
  end function;

  function to_word(value : step_generator_watchdog_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_watchdog(word : std_ulogic_vector(31 downto 0)) return step_generator_watchdog_t is
  begin
    return (
      clocks => unsigned(word(step_generator_watchdog_clocks_bits)));
  end function;

  function to_word(value : step_generator_segment_flags_t) return std_ulogic_vector is
  begin
    return value.behind & value.ahead & value.stop_mask & "00" & value.waits_for_start & value.stop_brakes & value.stop_on_release & value.stop_on_change & value.ends_motion & value.continues_line & value.backward;
  end function;

  function to_step_generator_segment_flags(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_flags_t is
  begin
    return (
      backward => word(step_generator_segment_flags_backward_bits),
  continues_line => word(step_generator_segment_flags_continues_line_bit),
  ends_motion => word(step_generator_segment_flags_ends_motion_bit),
  stop_on_change => word(step_generator_segment_flags_stop_on_change_bit),
  stop_on_release => word(step_generator_segment_flags_stop_on_release_bit),
  stop_brakes => word(step_generator_segment_flags_stop_brakes_bit),
  waits_for_start => word(step_generator_segment_flags_waits_for_start_bit),
  stop_mask => word(step_generator_segment_flags_stop_mask_bits),
  ahead => word(step_generator_segment_flags_ahead_bits),
  behind => word(step_generator_segment_flags_behind_bits));
  end function;

  function to_word(value : step_generator_segment_line_ticks_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.ticks);
  end function;

  function to_step_generator_segment_line_ticks(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_line_ticks_t is
  begin
    return (
      ticks => unsigned(word(step_generator_segment_line_ticks_ticks_bits)));
  end function;

  function to_word(value : step_generator_segment_ticks_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.ticks);
  end function;

  function to_step_generator_segment_ticks(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_ticks_t is
  begin
    return (
      ticks => unsigned(word(step_generator_segment_ticks_ticks_bits)));
  end function;

  function to_word(value : step_generator_segment_rate_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.rate);
  end function;

  function to_step_generator_segment_rate_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_rate_low_t is
  begin
    return (
      rate => unsigned(word(step_generator_segment_rate_low_rate_bits)));
  end function;

  function to_word(value : step_generator_segment_rate_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.rate);
  end function;

  function to_step_generator_segment_rate_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_rate_high_t is
  begin
    return (
      rate => unsigned(word(step_generator_segment_rate_high_rate_bits)));
  end function;

  function to_word(value : step_generator_segment_acceleration_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.acceleration);
  end function;

  function to_step_generator_segment_acceleration_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_acceleration_low_t is
  begin
    return (
      acceleration => unsigned(word(step_generator_segment_acceleration_low_acceleration_bits)));
  end function;

  function to_word(value : step_generator_segment_acceleration_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.acceleration);
  end function;

  function to_step_generator_segment_acceleration_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_acceleration_high_t is
  begin
    return (
      acceleration => unsigned(word(step_generator_segment_acceleration_high_acceleration_bits)));
  end function;

  function to_word(value : step_generator_segment_jerk_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.jerk);
  end function;

  function to_step_generator_segment_jerk_low(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_jerk_low_t is
  begin
    return (
      jerk => unsigned(word(step_generator_segment_jerk_low_jerk_bits)));
  end function;

  function to_word(value : step_generator_segment_jerk_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.jerk);
  end function;

  function to_step_generator_segment_jerk_high(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_jerk_high_t is
  begin
    return (
      jerk => unsigned(word(step_generator_segment_jerk_high_jerk_bits)));
  end function;

  function to_word(value : step_generator_segment_steps_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.steps);
  end function;

  function to_step_generator_segment_steps(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_steps_t is
  begin
    return (
      steps => unsigned(word(step_generator_segment_steps_steps_bits)));
  end function;

  function to_word(value : step_generator_segment_commit_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.any);
  end function;

  function to_step_generator_segment_commit(word : std_ulogic_vector(31 downto 0)) return step_generator_segment_commit_t is
  begin
    return (
      any => unsigned(word(step_generator_segment_commit_any_bits)));
  end function;

  function to_word(value : step_generator_pulse_guard_t) return std_ulogic_vector is
  begin
    return value.both_edges & "000" & std_ulogic_vector(value.low) & "0000" & std_ulogic_vector(value.high);
  end function;

  function to_step_generator_pulse_guard(word : std_ulogic_vector(31 downto 0)) return step_generator_pulse_guard_t is
  begin
    return (
      high => unsigned(word(step_generator_pulse_guard_high_bits)),
  low => unsigned(word(step_generator_pulse_guard_low_bits)),
  both_edges => word(step_generator_pulse_guard_both_edges_bit));
  end function;

  function to_word(value : step_generator_direction_guard_t) return std_ulogic_vector is
  begin
    return "0000" & std_ulogic_vector(value.hold) & "0000" & std_ulogic_vector(value.setup);
  end function;

  function to_step_generator_direction_guard(word : std_ulogic_vector(31 downto 0)) return step_generator_direction_guard_t is
  begin
    return (
      setup => unsigned(word(step_generator_direction_guard_setup_bits)),
  hold => unsigned(word(step_generator_direction_guard_hold_bits)));
  end function;

  function to_word(value : step_generator_position_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.steps);
  end function;

  function to_step_generator_position(word : std_ulogic_vector(31 downto 0)) return step_generator_position_t is
  begin
    return (
      steps => signed(word(step_generator_position_steps_bits)));
  end function;

  function to_word(value : step_generator_snapshot_position_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.steps);
  end function;

  function to_step_generator_snapshot_position(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_position_t is
  begin
    return (
      steps => signed(word(step_generator_snapshot_position_steps_bits)));
  end function;

  function to_word(value : step_generator_snapshot_time_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_snapshot_time_low(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_time_low_t is
  begin
    return (
      clocks => unsigned(word(step_generator_snapshot_time_low_clocks_bits)));
  end function;

  function to_word(value : step_generator_snapshot_time_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_snapshot_time_high(word : std_ulogic_vector(31 downto 0)) return step_generator_snapshot_time_high_t is
  begin
    return (
      clocks => unsigned(word(step_generator_snapshot_time_high_clocks_bits)));
  end function;

  function to_word(value : step_generator_stop_cause_t) return std_ulogic_vector is
  begin
    return "00000000000000000000" & value.software_brake & value.watchdog & value.software & value.emergency_input & value.end_stops;
  end function;

  function to_step_generator_stop_cause(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_cause_t is
  begin
    return (
      end_stops => word(step_generator_stop_cause_end_stops_bits),
  emergency_input => word(step_generator_stop_cause_emergency_input_bit),
  software => word(step_generator_stop_cause_software_bit),
  watchdog => word(step_generator_stop_cause_watchdog_bit),
  software_brake => word(step_generator_stop_cause_software_brake_bit));
  end function;

  function to_word(value : step_generator_stop_position_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.steps);
  end function;

  function to_step_generator_stop_position(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_position_t is
  begin
    return (
      steps => signed(word(step_generator_stop_position_steps_bits)));
  end function;

  function to_word(value : step_generator_stop_time_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_stop_time_low(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_time_low_t is
  begin
    return (
      clocks => unsigned(word(step_generator_stop_time_low_clocks_bits)));
  end function;

  function to_word(value : step_generator_stop_time_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_stop_time_high(word : std_ulogic_vector(31 downto 0)) return step_generator_stop_time_high_t is
  begin
    return (
      clocks => unsigned(word(step_generator_stop_time_high_clocks_bits)));
  end function;

  function to_word(value : step_generator_segments_executed_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.count);
  end function;

  function to_step_generator_segments_executed(word : std_ulogic_vector(31 downto 0)) return step_generator_segments_executed_t is
  begin
    return (
      count => unsigned(word(step_generator_segments_executed_count_bits)));
  end function;

  function to_word(value : step_generator_underruns_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.count);
  end function;

  function to_step_generator_underruns(word : std_ulogic_vector(31 downto 0)) return step_generator_underruns_t is
  begin
    return (
      count => unsigned(word(step_generator_underruns_count_bits)));
  end function;

  function to_word(value : step_generator_max_level_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.segments);
  end function;

  function to_step_generator_max_level(word : std_ulogic_vector(31 downto 0)) return step_generator_max_level_t is
  begin
    return (
      segments => unsigned(word(step_generator_max_level_segments_bits)));
  end function;

  function to_word(value : step_generator_stalls_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_stalls(word : std_ulogic_vector(31 downto 0)) return step_generator_stalls_t is
  begin
    return (
      clocks => unsigned(word(step_generator_stalls_clocks_bits)));
  end function;

  function to_word(value : step_generator_axis_stalls_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.clocks);
  end function;

  function to_step_generator_axis_stalls(word : std_ulogic_vector(31 downto 0)) return step_generator_axis_stalls_t is
  begin
    return (
      clocks => unsigned(word(step_generator_axis_stalls_clocks_bits)));
  end function;

end package body;
