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
    start : std_ulogic;
    brake : std_ulogic;
    feed_watchdog : std_ulogic;
  end record;

  -- What the step generator is doing.
  type step_generator_status_t is record
    moving : std_ulogic;
    idle : std_ulogic;
    stopped : std_ulogic;
    held : std_ulogic;
    braking : std_ulogic;
    waiting : std_ulogic;
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

  -- The scale of time that is aimed at while segments are executed; the path stays.
  type step_generator_override_t is record
    scale : unsigned(17 downto 0);
  end record;

  -- How fast the scale changes while a segment is executed; at rest it changes at once.
  type step_generator_override_slope_t is record
    slope : unsigned(31 downto 0);
  end record;

  -- How fast the scale falls to 0 in a stop by braking: a deceleration of tick rate times slope.
  type step_generator_brake_slope_t is record
    slope : unsigned(31 downto 0);
  end record;

  -- The scale of time at this moment.
  type step_generator_scale_t is record
    scale : unsigned(17 downto 0);
  end record;

  -- Stops motion when software does not feed it.
  type step_generator_watchdog_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- First word of a segment: begins a new one and forgets words written before.
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
    both_edges : std_ulogic;
  end record;
  type step_generator_pulse_guard_array_t is array (0 to 7) of step_generator_pulse_guard_t;

  -- Distance between a change of direction and the steps, per axis.
  type step_generator_direction_guard_t is record
    setup : unsigned(11 downto 0);
    hold : unsigned(11 downto 0);
  end record;
  type step_generator_direction_guard_array_t is array (0 to 7) of step_generator_direction_guard_t;

  -- Steps given, forward less backward. Written only when idle, refused otherwise.
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

  -- Why motion was stopped; valid while braking or stopped. What cuts braking short is added.
  type step_generator_stop_cause_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_input : std_ulogic;
    software : std_ulogic;
    watchdog : std_ulogic;
    software_brake : std_ulogic;
  end record;

  -- Positions of all axes in the clock in which the last stop was asked for.
  type step_generator_stop_position_t is record
    steps : signed(31 downto 0);
  end record;
  type step_generator_stop_position_array_t is array (0 to 7) of step_generator_stop_position_t;

  -- Time at which the last stop was asked for, low word.
  type step_generator_stop_time_low_t is record
    clocks : unsigned(31 downto 0);
  end record;

  -- Time at which the last stop was asked for, high word.
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
    control_written : std_ulogic;
    command : step_generator_command_t;
    command_written : std_ulogic;
    motor_enable : step_generator_motor_enable_t;
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

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, reading, writing : std_ulogic := '0';
  signal register_index : unsigned(9 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal build_word : std_ulogic_vector(31 downto 0);
  signal control_word : std_ulogic_vector(31 downto 0);
  signal status_word : std_ulogic_vector(31 downto 0);
  signal errors_word : std_ulogic_vector(31 downto 0);
  signal motor_enable_word : std_ulogic_vector(31 downto 0);
  signal motor_enable_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal rate_floor_word : std_ulogic_vector(31 downto 0);
  signal override_word : std_ulogic_vector(31 downto 0);
  signal override_stored : std_ulogic_vector(31 downto 0) := x"00010000";
  signal override_slope_word : std_ulogic_vector(31 downto 0);
  signal override_slope_stored : std_ulogic_vector(31 downto 0) := x"000006B6";
  signal brake_slope_word : std_ulogic_vector(31 downto 0);
  signal brake_slope_stored : std_ulogic_vector(31 downto 0) := x"000006B6";
  signal scale_word : std_ulogic_vector(31 downto 0);
  signal watchdog_word : std_ulogic_vector(31 downto 0);
  signal watchdog_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal position_0_word : std_ulogic_vector(31 downto 0);
  signal position_1_word : std_ulogic_vector(31 downto 0);
  signal position_2_word : std_ulogic_vector(31 downto 0);
  signal position_3_word : std_ulogic_vector(31 downto 0);
  signal position_4_word : std_ulogic_vector(31 downto 0);
  signal position_5_word : std_ulogic_vector(31 downto 0);
  signal position_6_word : std_ulogic_vector(31 downto 0);
  signal position_7_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_0_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_1_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_2_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_3_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_4_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_5_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_6_word : std_ulogic_vector(31 downto 0);
  signal snapshot_position_7_word : std_ulogic_vector(31 downto 0);
  signal snapshot_time_low_word : std_ulogic_vector(31 downto 0);
  signal snapshot_time_high_word : std_ulogic_vector(31 downto 0);
  signal stop_cause_word : std_ulogic_vector(31 downto 0);
  signal stop_position_0_word : std_ulogic_vector(31 downto 0);
  signal stop_position_1_word : std_ulogic_vector(31 downto 0);
  signal stop_position_2_word : std_ulogic_vector(31 downto 0);
  signal stop_position_3_word : std_ulogic_vector(31 downto 0);
  signal stop_position_4_word : std_ulogic_vector(31 downto 0);
  signal stop_position_5_word : std_ulogic_vector(31 downto 0);
  signal stop_position_6_word : std_ulogic_vector(31 downto 0);
  signal stop_position_7_word : std_ulogic_vector(31 downto 0);
  signal stop_time_low_word : std_ulogic_vector(31 downto 0);
  signal stop_time_high_word : std_ulogic_vector(31 downto 0);
  signal segments_executed_word : std_ulogic_vector(31 downto 0);
  signal underruns_word : std_ulogic_vector(31 downto 0);
  signal max_level_word : std_ulogic_vector(31 downto 0);
  signal stalls_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_0_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_1_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_2_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_3_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_4_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_5_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_6_word : std_ulogic_vector(31 downto 0);
  signal axis_stalls_7_word : std_ulogic_vector(31 downto 0);

begin

  access_begins <= request.strobe and not answered;

  -- Answers in the clock after the strobe; an error for everything that is not described.
  answer : process
  begin
    wait until rising_edge(clk);
    answered <= access_begins;
    reading <= access_begins and known and not request.write;
    writing <= access_begins and known and request.write;
    response.acknowledge <= access_begins and known;
    response.error <= access_begins and not known;
    response.data <= (others => '0');
    if access_begins then
      response.data <= read_word;
      written_data <= request.data;
      register_index <= request.address(11 downto 2);
    end if;
    if reset then
      answered <= '0';
      reading <= '0';
      writing <= '0';
      response <= bus_response_idle;
    end if;
  end process;

  -- Whole words only.
  known <= writable and (and request.select_bytes) when request.write = '1' else readable;

  readable <= '1' when request.address(11 downto 2) <= 1
      or (request.address(11 downto 2) >= 3 and request.address(11 downto 2) <= 11)
      or (request.address(11 downto 2) >= 46 and request.address(11 downto 2) <= 86) else '0';

  writable <= '1' when (request.address(11 downto 2) >= 1 and request.address(11 downto 2) <= 2)
      or (request.address(11 downto 2) >= 5 and request.address(11 downto 2) <= 9)
      or (request.address(11 downto 2) >= 11 and request.address(11 downto 2) <= 53) else '0';

  build_word <= "00000000" & std_ulogic_vector(to_software.build.queue_depth) & "0000" & std_ulogic_vector(to_software.build.axes)
    when request.address(11 downto 2) = 0 else (others => '0');
  control_word <= std_ulogic_vector(to_software.control.queue_threshold) & "0000000000000" & to_software.control.stop_interrupt_enable & to_software.control.queue_interrupt_enable & to_software.control.run
    when request.address(11 downto 2) = 1 else (others => '0');
  status_word <= "00000000" & std_ulogic_vector(to_software.status.free) & std_ulogic_vector(to_software.status.level) & "00" & to_software.status.waiting & to_software.status.braking & to_software.status.held & to_software.status.stopped & to_software.status.idle & to_software.status.moving
    when request.address(11 downto 2) = 3 else (others => '0');
  errors_word <= "000000000000000000000000000" & to_software.errors.position & to_software.errors.while_stopped & to_software.errors.illegal & to_software.errors.incomplete & to_software.errors.queue_full
    when request.address(11 downto 2) = 4 else (others => '0');
  motor_enable_word <= "000000000000000000000000" & motor_enable_stored(7 downto 0)
    when request.address(11 downto 2) = 5 else (others => '0');
  rate_floor_word <= '0' & std_ulogic_vector(to_software.rate_floor.rate)
    when request.address(11 downto 2) = 6 else (others => '0');
  override_word <= "00000000000000" & override_stored(17 downto 0)
    when request.address(11 downto 2) = 7 else (others => '0');
  override_slope_word <= override_slope_stored(31 downto 0)
    when request.address(11 downto 2) = 8 else (others => '0');
  brake_slope_word <= brake_slope_stored(31 downto 0)
    when request.address(11 downto 2) = 9 else (others => '0');
  scale_word <= "00000000000000" & std_ulogic_vector(to_software.scale.scale)
    when request.address(11 downto 2) = 10 else (others => '0');
  watchdog_word <= watchdog_stored(31 downto 0)
    when request.address(11 downto 2) = 11 else (others => '0');
  position_0_word <= std_ulogic_vector(to_software.position(0).steps)
    when request.address(11 downto 2) = 46 else (others => '0');
  position_1_word <= std_ulogic_vector(to_software.position(1).steps)
    when request.address(11 downto 2) = 47 else (others => '0');
  position_2_word <= std_ulogic_vector(to_software.position(2).steps)
    when request.address(11 downto 2) = 48 else (others => '0');
  position_3_word <= std_ulogic_vector(to_software.position(3).steps)
    when request.address(11 downto 2) = 49 else (others => '0');
  position_4_word <= std_ulogic_vector(to_software.position(4).steps)
    when request.address(11 downto 2) = 50 else (others => '0');
  position_5_word <= std_ulogic_vector(to_software.position(5).steps)
    when request.address(11 downto 2) = 51 else (others => '0');
  position_6_word <= std_ulogic_vector(to_software.position(6).steps)
    when request.address(11 downto 2) = 52 else (others => '0');
  position_7_word <= std_ulogic_vector(to_software.position(7).steps)
    when request.address(11 downto 2) = 53 else (others => '0');
  snapshot_position_0_word <= std_ulogic_vector(to_software.snapshot_position(0).steps)
    when request.address(11 downto 2) = 54 else (others => '0');
  snapshot_position_1_word <= std_ulogic_vector(to_software.snapshot_position(1).steps)
    when request.address(11 downto 2) = 55 else (others => '0');
  snapshot_position_2_word <= std_ulogic_vector(to_software.snapshot_position(2).steps)
    when request.address(11 downto 2) = 56 else (others => '0');
  snapshot_position_3_word <= std_ulogic_vector(to_software.snapshot_position(3).steps)
    when request.address(11 downto 2) = 57 else (others => '0');
  snapshot_position_4_word <= std_ulogic_vector(to_software.snapshot_position(4).steps)
    when request.address(11 downto 2) = 58 else (others => '0');
  snapshot_position_5_word <= std_ulogic_vector(to_software.snapshot_position(5).steps)
    when request.address(11 downto 2) = 59 else (others => '0');
  snapshot_position_6_word <= std_ulogic_vector(to_software.snapshot_position(6).steps)
    when request.address(11 downto 2) = 60 else (others => '0');
  snapshot_position_7_word <= std_ulogic_vector(to_software.snapshot_position(7).steps)
    when request.address(11 downto 2) = 61 else (others => '0');
  snapshot_time_low_word <= std_ulogic_vector(to_software.snapshot_time_low.clocks)
    when request.address(11 downto 2) = 62 else (others => '0');
  snapshot_time_high_word <= std_ulogic_vector(to_software.snapshot_time_high.clocks)
    when request.address(11 downto 2) = 63 else (others => '0');
  stop_cause_word <= "00000000000000000000" & to_software.stop_cause.software_brake & to_software.stop_cause.watchdog & to_software.stop_cause.software & to_software.stop_cause.emergency_input & to_software.stop_cause.end_stops
    when request.address(11 downto 2) = 64 else (others => '0');
  stop_position_0_word <= std_ulogic_vector(to_software.stop_position(0).steps)
    when request.address(11 downto 2) = 65 else (others => '0');
  stop_position_1_word <= std_ulogic_vector(to_software.stop_position(1).steps)
    when request.address(11 downto 2) = 66 else (others => '0');
  stop_position_2_word <= std_ulogic_vector(to_software.stop_position(2).steps)
    when request.address(11 downto 2) = 67 else (others => '0');
  stop_position_3_word <= std_ulogic_vector(to_software.stop_position(3).steps)
    when request.address(11 downto 2) = 68 else (others => '0');
  stop_position_4_word <= std_ulogic_vector(to_software.stop_position(4).steps)
    when request.address(11 downto 2) = 69 else (others => '0');
  stop_position_5_word <= std_ulogic_vector(to_software.stop_position(5).steps)
    when request.address(11 downto 2) = 70 else (others => '0');
  stop_position_6_word <= std_ulogic_vector(to_software.stop_position(6).steps)
    when request.address(11 downto 2) = 71 else (others => '0');
  stop_position_7_word <= std_ulogic_vector(to_software.stop_position(7).steps)
    when request.address(11 downto 2) = 72 else (others => '0');
  stop_time_low_word <= std_ulogic_vector(to_software.stop_time_low.clocks)
    when request.address(11 downto 2) = 73 else (others => '0');
  stop_time_high_word <= std_ulogic_vector(to_software.stop_time_high.clocks)
    when request.address(11 downto 2) = 74 else (others => '0');
  segments_executed_word <= std_ulogic_vector(to_software.segments_executed.count)
    when request.address(11 downto 2) = 75 else (others => '0');
  underruns_word <= std_ulogic_vector(to_software.underruns.count)
    when request.address(11 downto 2) = 76 else (others => '0');
  max_level_word <= "0000000000000000" & std_ulogic_vector(to_software.max_level.segments)
    when request.address(11 downto 2) = 77 else (others => '0');
  stalls_word <= std_ulogic_vector(to_software.stalls.clocks)
    when request.address(11 downto 2) = 78 else (others => '0');
  axis_stalls_0_word <= std_ulogic_vector(to_software.axis_stalls(0).clocks)
    when request.address(11 downto 2) = 79 else (others => '0');
  axis_stalls_1_word <= std_ulogic_vector(to_software.axis_stalls(1).clocks)
    when request.address(11 downto 2) = 80 else (others => '0');
  axis_stalls_2_word <= std_ulogic_vector(to_software.axis_stalls(2).clocks)
    when request.address(11 downto 2) = 81 else (others => '0');
  axis_stalls_3_word <= std_ulogic_vector(to_software.axis_stalls(3).clocks)
    when request.address(11 downto 2) = 82 else (others => '0');
  axis_stalls_4_word <= std_ulogic_vector(to_software.axis_stalls(4).clocks)
    when request.address(11 downto 2) = 83 else (others => '0');
  axis_stalls_5_word <= std_ulogic_vector(to_software.axis_stalls(5).clocks)
    when request.address(11 downto 2) = 84 else (others => '0');
  axis_stalls_6_word <= std_ulogic_vector(to_software.axis_stalls(6).clocks)
    when request.address(11 downto 2) = 85 else (others => '0');
  axis_stalls_7_word <= std_ulogic_vector(to_software.axis_stalls(7).clocks)
    when request.address(11 downto 2) = 86 else (others => '0');

  read_word <= build_word
    or control_word
    or status_word
    or errors_word
    or motor_enable_word
    or rate_floor_word
    or override_word
    or override_slope_word
    or brake_slope_word
    or scale_word
    or watchdog_word
    or position_0_word
    or position_1_word
    or position_2_word
    or position_3_word
    or position_4_word
    or position_5_word
    or position_6_word
    or position_7_word
    or snapshot_position_0_word
    or snapshot_position_1_word
    or snapshot_position_2_word
    or snapshot_position_3_word
    or snapshot_position_4_word
    or snapshot_position_5_word
    or snapshot_position_6_word
    or snapshot_position_7_word
    or snapshot_time_low_word
    or snapshot_time_high_word
    or stop_cause_word
    or stop_position_0_word
    or stop_position_1_word
    or stop_position_2_word
    or stop_position_3_word
    or stop_position_4_word
    or stop_position_5_word
    or stop_position_6_word
    or stop_position_7_word
    or stop_time_low_word
    or stop_time_high_word
    or segments_executed_word
    or underruns_word
    or max_level_word
    or stalls_word
    or axis_stalls_0_word
    or axis_stalls_1_word
    or axis_stalls_2_word
    or axis_stalls_3_word
    or axis_stalls_4_word
    or axis_stalls_5_word
    or axis_stalls_6_word
    or axis_stalls_7_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 5 then
      motor_enable_stored <= written_data;
    end if;
    if writing = '1' and register_index = 7 then
      override_stored <= written_data;
    end if;
    if writing = '1' and register_index = 8 then
      override_slope_stored <= written_data;
    end if;
    if writing = '1' and register_index = 9 then
      brake_slope_stored <= written_data;
    end if;
    if writing = '1' and register_index = 11 then
      watchdog_stored <= written_data;
    end if;
    if reset then
      motor_enable_stored <= x"00000000";
      override_stored <= x"00010000";
      override_slope_stored <= x"000006B6";
      brake_slope_stored <= x"000006B6";
      watchdog_stored <= x"00000000";
    end if;
  end process;

  from_software.control_written <= '1' when writing = '1' and register_index = 1 else '0';
  from_software.control.run <= written_data(0);
  from_software.control.queue_interrupt_enable <= written_data(1);
  from_software.control.stop_interrupt_enable <= written_data(2);
  from_software.control.queue_threshold <= unsigned(written_data(31 downto 16));
  from_software.command_written <= '1' when writing = '1' and register_index = 2 else '0';
  from_software.command.flush <= written_data(0);
  from_software.command.stop <= written_data(1);
  from_software.command.acknowledge_stop <= written_data(2);
  from_software.command.snapshot <= written_data(3);
  from_software.command.clear_errors <= written_data(4);
  from_software.command.start <= written_data(5);
  from_software.command.brake <= written_data(6);
  from_software.command.feed_watchdog <= written_data(7);
  from_software.motor_enable.axes <= motor_enable_stored(7 downto 0);
  from_software.rate_floor_written <= '1' when writing = '1' and register_index = 6 else '0';
  from_software.rate_floor.rate <= unsigned(written_data(30 downto 0));
  from_software.override.scale <= unsigned(override_stored(17 downto 0));
  from_software.override_slope.slope <= unsigned(override_slope_stored(31 downto 0));
  from_software.brake_slope.slope <= unsigned(brake_slope_stored(31 downto 0));
  from_software.watchdog.clocks <= unsigned(watchdog_stored(31 downto 0));
  from_software.segment_flags_written <= '1' when writing = '1' and register_index = 12 else '0';
  from_software.segment_flags.backward <= written_data(7 downto 0);
  from_software.segment_flags.continues_line <= written_data(8);
  from_software.segment_flags.ends_motion <= written_data(9);
  from_software.segment_flags.stop_on_change <= written_data(10);
  from_software.segment_flags.stop_on_release <= written_data(11);
  from_software.segment_flags.stop_brakes <= written_data(12);
  from_software.segment_flags.waits_for_start <= written_data(13);
  from_software.segment_flags.stop_mask <= written_data(23 downto 16);
  from_software.segment_flags.ahead <= written_data(27 downto 24);
  from_software.segment_flags.behind <= written_data(31 downto 28);
  from_software.segment_line_ticks_written <= '1' when writing = '1' and register_index = 13 else '0';
  from_software.segment_line_ticks.ticks <= unsigned(written_data(31 downto 0));
  from_software.segment_ticks_written <= '1' when writing = '1' and register_index = 14 else '0';
  from_software.segment_ticks.ticks <= unsigned(written_data(31 downto 0));
  from_software.segment_rate_low_written <= '1' when writing = '1' and register_index = 15 else '0';
  from_software.segment_rate_low.word <= unsigned(written_data(31 downto 0));
  from_software.segment_rate_high_written <= '1' when writing = '1' and register_index = 16 else '0';
  from_software.segment_rate_high.word <= unsigned(written_data(31 downto 0));
  from_software.segment_acceleration_low_written <= '1' when writing = '1' and register_index = 17 else '0';
  from_software.segment_acceleration_low.word <= unsigned(written_data(31 downto 0));
  from_software.segment_acceleration_high_written <= '1' when writing = '1' and register_index = 18 else '0';
  from_software.segment_acceleration_high.word <= unsigned(written_data(31 downto 0));
  from_software.segment_jerk_low_written <= '1' when writing = '1' and register_index = 19 else '0';
  from_software.segment_jerk_low.word <= unsigned(written_data(31 downto 0));
  from_software.segment_jerk_high_written <= '1' when writing = '1' and register_index = 20 else '0';
  from_software.segment_jerk_high.word <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(0) <= '1' when writing = '1' and register_index = 21 else '0';
  from_software.segment_steps(0).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(1) <= '1' when writing = '1' and register_index = 22 else '0';
  from_software.segment_steps(1).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(2) <= '1' when writing = '1' and register_index = 23 else '0';
  from_software.segment_steps(2).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(3) <= '1' when writing = '1' and register_index = 24 else '0';
  from_software.segment_steps(3).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(4) <= '1' when writing = '1' and register_index = 25 else '0';
  from_software.segment_steps(4).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(5) <= '1' when writing = '1' and register_index = 26 else '0';
  from_software.segment_steps(5).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(6) <= '1' when writing = '1' and register_index = 27 else '0';
  from_software.segment_steps(6).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_steps_written(7) <= '1' when writing = '1' and register_index = 28 else '0';
  from_software.segment_steps(7).steps <= unsigned(written_data(31 downto 0));
  from_software.segment_commit_written <= '1' when writing = '1' and register_index = 29 else '0';
  from_software.segment_commit.any <= unsigned(written_data(31 downto 0));
  from_software.pulse_guard_written(0) <= '1' when writing = '1' and register_index = 30 else '0';
  from_software.pulse_guard(0).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(0).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(0).both_edges <= written_data(31);
  from_software.pulse_guard_written(1) <= '1' when writing = '1' and register_index = 31 else '0';
  from_software.pulse_guard(1).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(1).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(1).both_edges <= written_data(31);
  from_software.pulse_guard_written(2) <= '1' when writing = '1' and register_index = 32 else '0';
  from_software.pulse_guard(2).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(2).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(2).both_edges <= written_data(31);
  from_software.pulse_guard_written(3) <= '1' when writing = '1' and register_index = 33 else '0';
  from_software.pulse_guard(3).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(3).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(3).both_edges <= written_data(31);
  from_software.pulse_guard_written(4) <= '1' when writing = '1' and register_index = 34 else '0';
  from_software.pulse_guard(4).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(4).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(4).both_edges <= written_data(31);
  from_software.pulse_guard_written(5) <= '1' when writing = '1' and register_index = 35 else '0';
  from_software.pulse_guard(5).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(5).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(5).both_edges <= written_data(31);
  from_software.pulse_guard_written(6) <= '1' when writing = '1' and register_index = 36 else '0';
  from_software.pulse_guard(6).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(6).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(6).both_edges <= written_data(31);
  from_software.pulse_guard_written(7) <= '1' when writing = '1' and register_index = 37 else '0';
  from_software.pulse_guard(7).high <= unsigned(written_data(11 downto 0));
  from_software.pulse_guard(7).low <= unsigned(written_data(27 downto 16));
  from_software.pulse_guard(7).both_edges <= written_data(31);
  from_software.direction_guard_written(0) <= '1' when writing = '1' and register_index = 38 else '0';
  from_software.direction_guard(0).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(0).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(1) <= '1' when writing = '1' and register_index = 39 else '0';
  from_software.direction_guard(1).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(1).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(2) <= '1' when writing = '1' and register_index = 40 else '0';
  from_software.direction_guard(2).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(2).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(3) <= '1' when writing = '1' and register_index = 41 else '0';
  from_software.direction_guard(3).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(3).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(4) <= '1' when writing = '1' and register_index = 42 else '0';
  from_software.direction_guard(4).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(4).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(5) <= '1' when writing = '1' and register_index = 43 else '0';
  from_software.direction_guard(5).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(5).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(6) <= '1' when writing = '1' and register_index = 44 else '0';
  from_software.direction_guard(6).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(6).hold <= unsigned(written_data(27 downto 16));
  from_software.direction_guard_written(7) <= '1' when writing = '1' and register_index = 45 else '0';
  from_software.direction_guard(7).setup <= unsigned(written_data(11 downto 0));
  from_software.direction_guard(7).hold <= unsigned(written_data(27 downto 16));
  from_software.position_written(0) <= '1' when writing = '1' and register_index = 46 else '0';
  from_software.position(0).steps <= signed(written_data(31 downto 0));
  from_software.position_written(1) <= '1' when writing = '1' and register_index = 47 else '0';
  from_software.position(1).steps <= signed(written_data(31 downto 0));
  from_software.position_written(2) <= '1' when writing = '1' and register_index = 48 else '0';
  from_software.position(2).steps <= signed(written_data(31 downto 0));
  from_software.position_written(3) <= '1' when writing = '1' and register_index = 49 else '0';
  from_software.position(3).steps <= signed(written_data(31 downto 0));
  from_software.position_written(4) <= '1' when writing = '1' and register_index = 50 else '0';
  from_software.position(4).steps <= signed(written_data(31 downto 0));
  from_software.position_written(5) <= '1' when writing = '1' and register_index = 51 else '0';
  from_software.position(5).steps <= signed(written_data(31 downto 0));
  from_software.position_written(6) <= '1' when writing = '1' and register_index = 52 else '0';
  from_software.position(6).steps <= signed(written_data(31 downto 0));
  from_software.position_written(7) <= '1' when writing = '1' and register_index = 53 else '0';
  from_software.position(7).steps <= signed(written_data(31 downto 0));
end architecture;
