-- SPDX-License-Identifier: Apache-2.0
-- Registers of `step_generator`. Generated from rtl/motion/step_generator.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_generator_registers_pkg is

  constant step_generator_address : unsigned(31 downto 0) := x"F0003000";

  -- What this build of the step generator has.
  type step_generator_build_t is record
    axes : unsigned(3 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;

  -- What software permits.
  type step_generator_control_t is record
    run : std_ulogic;
    queue_interrupt_enable : std_ulogic;
    stop_interrupt_enable : std_ulogic;
    queue_threshold : unsigned(15 downto 0);
  end record;

  -- Each bit written as 1 does one thing at once.
  type step_generator_command_t is record
    flush : std_ulogic;
    stop : std_ulogic;
    acknowledge_stop : std_ulogic;
    snapshot : std_ulogic;
    clear_errors : std_ulogic;
  end record;

  -- What the step generator is doing.
  type step_generator_status_t is record
    moving : std_ulogic;
    idle : std_ulogic;
    stopped : std_ulogic;
    level : unsigned(7 downto 0);
    free : unsigned(7 downto 0);
  end record;

  -- What was refused since the last clear_errors.
  type step_generator_errors_t is record
    queue_full : std_ulogic;
    incomplete : std_ulogic;
    illegal : std_ulogic;
    while_stopped : std_ulogic;
    position : std_ulogic;
  end record;

  -- Enable pins of the motor drivers.
  type step_generator_motor_enable_t is record
    axes : std_ulogic_vector(7 downto 0);
  end record;

  -- The tick rate is never integrated below this.
  type step_generator_rate_floor_t is record
    rate : unsigned(30 downto 0);
  end record;

  -- First word of a segment: begins a new one and forgets words written before.
  type step_generator_segment_flags_t is record
    backward : std_ulogic_vector(7 downto 0);
    continues_line : std_ulogic;
    ends_motion : std_ulogic;
    stop_mask : std_ulogic_vector(7 downto 0);
  end record;

  -- Ticks of the whole line, 1 .. 2^31 - 1; to be written before ticks and steps.
  type step_generator_segment_line_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;

  -- Ticks of this segment, 1 .. what is left of the line.
  type step_generator_segment_ticks_t is record
    ticks : unsigned(31 downto 0);
  end record;

  -- Tick rate at the start of the segment, low word, in 2^-64 ticks per clock.
  type step_generator_segment_rate_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Tick rate, high word. The rate is at most 1/2 tick per clock.
  type step_generator_segment_rate_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the rate per clock, signed, low word, in 2^-84 ticks per clock^2.
  type step_generator_segment_acceleration_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the rate per clock, high word.
  type step_generator_segment_acceleration_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the acceleration per clock, signed, low word, in 2^-84 ticks per clock^3.
  type step_generator_segment_jerk_low_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Change of the acceleration per clock, high word.
  type step_generator_segment_jerk_high_t is record
    word : unsigned(31 downto 0);
  end record;

  -- Steps of each axis in the whole line, without sign, 0 .. line_ticks.
  type step_generator_segment_steps_t is record
    steps : unsigned(31 downto 0);
  end record;
  type step_generator_segment_steps_array_t is array (0 to 7) of step_generator_segment_steps_t;

  -- Any write appends the segment to the queue, or refuses it and says why in errors.
  type step_generator_segment_commit_t is record
    any : unsigned(31 downto 0);
  end record;

  -- Width of the step pulse and of the pause after it, per axis.
  type step_generator_pulse_guard_t is record
    high : unsigned(11 downto 0);
    low : unsigned(11 downto 0);
  end record;
  type step_generator_pulse_guard_array_t is array (0 to 7) of step_generator_pulse_guard_t;

  -- Distance between a change of direction and the rising edges of step, per axis.
  type step_generator_direction_guard_t is record
    setup : unsigned(11 downto 0);
    hold : unsigned(11 downto 0);
  end record;
  type step_generator_direction_guard_array_t is array (0 to 7) of step_generator_direction_guard_t;

  -- Pulses given, forward less backward. Written only when idle, refused otherwise.
  type step_generator_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_position_array_t is array (0 to 7) of step_generator_position_t;

  -- Positions of all axes in the clock of the last snapshot.
  type step_generator_snapshot_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_snapshot_position_array_t is array (0 to 7) of step_generator_snapshot_position_t;

  -- Time of the last snapshot, low word.
  type step_generator_snapshot_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Time of the last snapshot, high word.
  type step_generator_snapshot_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Why motion was stopped; valid while stopped.
  type step_generator_stop_cause_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_input : std_ulogic;
    software : std_ulogic;
  end record;

  -- Positions of all axes in the clock of the last stop.
  type step_generator_stop_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_stop_position_array_t is array (0 to 7) of step_generator_stop_position_t;

  -- Time of the last stop, low word.
  type step_generator_stop_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Time of the last stop, high word.
  type step_generator_stop_time_high_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Segments begun since reset.
  type step_generator_segments_executed_t is record
    count : unsigned(31 downto 0);
  end record;

  -- Times that the queue was empty at the end of a segment without ends_motion.
  type step_generator_underruns_t is record
    count : unsigned(31 downto 0);
  end record;

  -- The fullest that the queue has been since reset.
  type step_generator_max_level_t is record
    segments : unsigned(15 downto 0);
  end record;

  -- Clocks by which the guards of all axes have delayed the common base.
  type step_generator_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Clocks in which the guard of an axis delayed the common base.
  type step_generator_axis_stalls_t is record
    clocks : unsigned(31 downto 0);
  end record;
  type step_generator_axis_stalls_array_t is array (0 to 7) of step_generator_axis_stalls_t;

  type step_generator_from_software_t is record
    control : step_generator_control_t;
    command : step_generator_command_t;
    command_written : std_ulogic;
    motor_enable : step_generator_motor_enable_t;
    rate_floor : step_generator_rate_floor_t;
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
    status : step_generator_status_t;
    errors : step_generator_errors_t;
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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out step_generator_from_software_t;
    to_software : in step_generator_to_software_t
  );
end entity;

architecture rtl of step_generator_registers is

  signal answered : std_ulogic := '0';
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal control_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal motor_enable_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal rate_floor_stored : std_ulogic_vector(31 downto 0) := x"0000218E";

begin

  -- Answers in the clock after the strobe: whole words only, errors for everything not described.
  answer : process
    variable word : std_ulogic_vector(31 downto 0);
    variable known : boolean;
  begin
    wait until rising_edge(clk);
    if answered then
      response <= bus_response_idle;
      answered <= '0';
      from_software.command_written <= '0';
      from_software.segment_flags_written <= '0';
      from_software.segment_line_ticks_written <= '0';
      from_software.segment_ticks_written <= '0';
      from_software.segment_rate_low_written <= '0';
      from_software.segment_rate_high_written <= '0';
      from_software.segment_acceleration_low_written <= '0';
      from_software.segment_acceleration_high_written <= '0';
      from_software.segment_jerk_low_written <= '0';
      from_software.segment_jerk_high_written <= '0';
      from_software.segment_steps_written <= (others => '0');
      from_software.segment_commit_written <= '0';
      from_software.pulse_guard_written <= (others => '0');
      from_software.direction_guard_written <= (others => '0');
      from_software.position_written <= (others => '0');
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      written_data <= request.data;
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if not request.write then
            known := true;
            word(3 downto 0) := std_ulogic_vector(to_software.build.axes);
            word(23 downto 8) := std_ulogic_vector(to_software.build.queue_depth);
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(0 downto 0) := control_stored(0 downto 0);
            word(1 downto 1) := control_stored(1 downto 1);
            word(2 downto 2) := control_stored(2 downto 2);
            word(31 downto 16) := control_stored(31 downto 16);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            control_stored(0 downto 0) <= request.data(0 downto 0);
            control_stored(1 downto 1) <= request.data(1 downto 1);
            control_stored(2 downto 2) <= request.data(2 downto 2);
            control_stored(31 downto 16) <= request.data(31 downto 16);
          end if;
        when 2 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.command_written <= '1';
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(0) := to_software.status.moving;
            word(1) := to_software.status.idle;
            word(2) := to_software.status.stopped;
            word(15 downto 8) := std_ulogic_vector(to_software.status.level);
            word(23 downto 16) := std_ulogic_vector(to_software.status.free);
          end if;
        when 4 =>
          if not request.write then
            known := true;
            word(0) := to_software.errors.queue_full;
            word(1) := to_software.errors.incomplete;
            word(2) := to_software.errors.illegal;
            word(3) := to_software.errors.while_stopped;
            word(4) := to_software.errors.position;
          end if;
        when 5 =>
          if not request.write then
            known := true;
            word(7 downto 0) := motor_enable_stored(7 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            motor_enable_stored(7 downto 0) <= request.data(7 downto 0);
          end if;
        when 6 =>
          if not request.write then
            known := true;
            word(30 downto 0) := rate_floor_stored(30 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            rate_floor_stored(30 downto 0) <= request.data(30 downto 0);
          end if;
        when 7 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_flags_written <= '1';
          end if;
        when 8 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_line_ticks_written <= '1';
          end if;
        when 9 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_ticks_written <= '1';
          end if;
        when 10 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_rate_low_written <= '1';
          end if;
        when 11 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_rate_high_written <= '1';
          end if;
        when 12 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_acceleration_low_written <= '1';
          end if;
        when 13 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_acceleration_high_written <= '1';
          end if;
        when 14 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_jerk_low_written <= '1';
          end if;
        when 15 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_jerk_high_written <= '1';
          end if;
        when 16 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(0) <= '1';
          end if;
        when 17 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(1) <= '1';
          end if;
        when 18 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(2) <= '1';
          end if;
        when 19 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(3) <= '1';
          end if;
        when 20 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(4) <= '1';
          end if;
        when 21 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(5) <= '1';
          end if;
        when 22 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(6) <= '1';
          end if;
        when 23 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_steps_written(7) <= '1';
          end if;
        when 24 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.segment_commit_written <= '1';
          end if;
        when 25 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(0) <= '1';
          end if;
        when 26 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(1) <= '1';
          end if;
        when 27 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(2) <= '1';
          end if;
        when 28 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(3) <= '1';
          end if;
        when 29 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(4) <= '1';
          end if;
        when 30 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(5) <= '1';
          end if;
        when 31 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(6) <= '1';
          end if;
        when 32 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.pulse_guard_written(7) <= '1';
          end if;
        when 33 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(0) <= '1';
          end if;
        when 34 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(1) <= '1';
          end if;
        when 35 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(2) <= '1';
          end if;
        when 36 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(3) <= '1';
          end if;
        when 37 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(4) <= '1';
          end if;
        when 38 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(5) <= '1';
          end if;
        when 39 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(6) <= '1';
          end if;
        when 40 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.direction_guard_written(7) <= '1';
          end if;
        when 41 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(0).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(0) <= '1';
          end if;
        when 42 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(1).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(1) <= '1';
          end if;
        when 43 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(2).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(2) <= '1';
          end if;
        when 44 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(3).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(3) <= '1';
          end if;
        when 45 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(4).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(4) <= '1';
          end if;
        when 46 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(5).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(5) <= '1';
          end if;
        when 47 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(6).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(6) <= '1';
          end if;
        when 48 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.position(7).steps);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.position_written(7) <= '1';
          end if;
        when 49 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(0).steps);
          end if;
        when 50 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(1).steps);
          end if;
        when 51 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(2).steps);
          end if;
        when 52 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(3).steps);
          end if;
        when 53 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(4).steps);
          end if;
        when 54 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(5).steps);
          end if;
        when 55 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(6).steps);
          end if;
        when 56 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_position(7).steps);
          end if;
        when 57 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_time_low.clocks);
          end if;
        when 58 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.snapshot_time_high.clocks);
          end if;
        when 59 =>
          if not request.write then
            known := true;
            word(7 downto 0) := to_software.stop_cause.end_stops;
            word(8) := to_software.stop_cause.emergency_input;
            word(9) := to_software.stop_cause.software;
          end if;
        when 60 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(0).steps);
          end if;
        when 61 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(1).steps);
          end if;
        when 62 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(2).steps);
          end if;
        when 63 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(3).steps);
          end if;
        when 64 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(4).steps);
          end if;
        when 65 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(5).steps);
          end if;
        when 66 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(6).steps);
          end if;
        when 67 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_position(7).steps);
          end if;
        when 68 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_time_low.clocks);
          end if;
        when 69 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stop_time_high.clocks);
          end if;
        when 70 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.segments_executed.count);
          end if;
        when 71 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.underruns.count);
          end if;
        when 72 =>
          if not request.write then
            known := true;
            word(15 downto 0) := std_ulogic_vector(to_software.max_level.segments);
          end if;
        when 73 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.stalls.clocks);
          end if;
        when 74 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(0).clocks);
          end if;
        when 75 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(1).clocks);
          end if;
        when 76 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(2).clocks);
          end if;
        when 77 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(3).clocks);
          end if;
        when 78 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(4).clocks);
          end if;
        when 79 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(5).clocks);
          end if;
        when 80 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(6).clocks);
          end if;
        when 81 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.axis_stalls(7).clocks);
          end if;
        when others =>
          null;
      end case;
      if known then
        response.acknowledge <= '1';
        response.data <= word;
      else
        response.error <= '1';
      end if;
    end if;
    if reset then
      response <= bus_response_idle;
      answered <= '0';
      from_software.command_written <= '0';
      from_software.segment_flags_written <= '0';
      from_software.segment_line_ticks_written <= '0';
      from_software.segment_ticks_written <= '0';
      from_software.segment_rate_low_written <= '0';
      from_software.segment_rate_high_written <= '0';
      from_software.segment_acceleration_low_written <= '0';
      from_software.segment_acceleration_high_written <= '0';
      from_software.segment_jerk_low_written <= '0';
      from_software.segment_jerk_high_written <= '0';
      from_software.segment_steps_written <= (others => '0');
      from_software.segment_commit_written <= '0';
      from_software.pulse_guard_written <= (others => '0');
      from_software.direction_guard_written <= (others => '0');
      from_software.position_written <= (others => '0');
      control_stored <= x"00000000";
      motor_enable_stored <= x"00000000";
      rate_floor_stored <= x"0000218E";
    end if;
  end process;

  from_software.control.run <= control_stored(0);
  from_software.control.queue_interrupt_enable <= control_stored(1);
  from_software.control.stop_interrupt_enable <= control_stored(2);
  from_software.control.queue_threshold <= unsigned(control_stored(31 downto 16));

  from_software.command.flush <= written_data(0);
  from_software.command.stop <= written_data(1);
  from_software.command.acknowledge_stop <= written_data(2);
  from_software.command.snapshot <= written_data(3);
  from_software.command.clear_errors <= written_data(4);

  from_software.motor_enable.axes <= motor_enable_stored(7 downto 0);

  from_software.rate_floor.rate <= unsigned(rate_floor_stored(30 downto 0));

  from_software.segment_flags.backward <= written_data(7 downto 0);
  from_software.segment_flags.continues_line <= written_data(8);
  from_software.segment_flags.ends_motion <= written_data(9);
  from_software.segment_flags.stop_mask <= written_data(23 downto 16);

  from_software.segment_line_ticks.ticks <= unsigned(written_data(31 downto 0));

  from_software.segment_ticks.ticks <= unsigned(written_data(31 downto 0));

  from_software.segment_rate_low.word <= unsigned(written_data(31 downto 0));

  from_software.segment_rate_high.word <= unsigned(written_data(31 downto 0));

  from_software.segment_acceleration_low.word <= unsigned(written_data(31 downto 0));

  from_software.segment_acceleration_high.word <= unsigned(written_data(31 downto 0));

  from_software.segment_jerk_low.word <= unsigned(written_data(31 downto 0));

  from_software.segment_jerk_high.word <= unsigned(written_data(31 downto 0));

  from_software.segment_steps(0).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(1).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(2).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(3).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(4).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(5).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(6).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps(7).steps <= unsigned(written_data(31 downto 0));

  from_software.segment_commit.any <= unsigned(written_data(31 downto 0));

  from_software.pulse_guard(0).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(0).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(1).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(1).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(2).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(2).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(3).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(3).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(4).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(4).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(5).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(5).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(6).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(6).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(7).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(7).low <= unsigned(written_data(27 downto 16));

  from_software.direction_guard(0).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(0).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(1).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(1).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(2).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(2).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(3).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(3).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(4).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(4).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(5).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(5).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(6).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(6).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard(7).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(7).hold <= unsigned(written_data(27 downto 16));

  from_software.position(0).steps <= signed(written_data(31 downto 0));
  from_software.position(1).steps <= signed(written_data(31 downto 0));
  from_software.position(2).steps <= signed(written_data(31 downto 0));
  from_software.position(3).steps <= signed(written_data(31 downto 0));
  from_software.position(4).steps <= signed(written_data(31 downto 0));
  from_software.position(5).steps <= signed(written_data(31 downto 0));
  from_software.position(6).steps <= signed(written_data(31 downto 0));
  from_software.position(7).steps <= signed(written_data(31 downto 0));

end architecture;
