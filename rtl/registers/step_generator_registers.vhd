-- SPDX-License-Identifier: Apache-2.0
-- Registers of `step_generator`. Generated from rtl/motion/step_generator.toml: do not edit.

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
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(6 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal build_word : std_ulogic_vector(31 downto 0);
  signal control_word : std_ulogic_vector(31 downto 0);
  signal status_word : std_ulogic_vector(31 downto 0);
  signal errors_word : std_ulogic_vector(31 downto 0);
  signal motor_enable_word : std_ulogic_vector(31 downto 0);
  signal rate_floor_word : std_ulogic_vector(31 downto 0);
  signal override_word : std_ulogic_vector(31 downto 0);
  signal override_stored : step_generator_override_t := step_generator_override_after_reset;
  signal override_slope_word : std_ulogic_vector(31 downto 0);
  signal override_slope_stored : step_generator_override_slope_t := step_generator_override_slope_after_reset;
  signal brake_slope_word : std_ulogic_vector(31 downto 0);
  signal brake_slope_stored : step_generator_brake_slope_t := step_generator_brake_slope_after_reset;
  signal scale_word : std_ulogic_vector(31 downto 0);
  signal watchdog_word : std_ulogic_vector(31 downto 0);
  signal watchdog_stored : step_generator_watchdog_t := step_generator_watchdog_after_reset;
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
  signal control_written : std_ulogic := '0';
  signal command_written : std_ulogic := '0';
  signal motor_enable_written : std_ulogic := '0';
  signal rate_floor_written : std_ulogic := '0';
  signal segment_flags_written : std_ulogic := '0';
  signal segment_line_ticks_written : std_ulogic := '0';
  signal segment_ticks_written : std_ulogic := '0';
  signal segment_rate_low_written : std_ulogic := '0';
  signal segment_rate_high_written : std_ulogic := '0';
  signal segment_acceleration_low_written : std_ulogic := '0';
  signal segment_acceleration_high_written : std_ulogic := '0';
  signal segment_jerk_low_written : std_ulogic := '0';
  signal segment_jerk_high_written : std_ulogic := '0';
  signal segment_steps_0_written : std_ulogic := '0';
  signal segment_steps_1_written : std_ulogic := '0';
  signal segment_steps_2_written : std_ulogic := '0';
  signal segment_steps_3_written : std_ulogic := '0';
  signal segment_steps_4_written : std_ulogic := '0';
  signal segment_steps_5_written : std_ulogic := '0';
  signal segment_steps_6_written : std_ulogic := '0';
  signal segment_steps_7_written : std_ulogic := '0';
  signal segment_commit_written : std_ulogic := '0';
  signal pulse_guard_0_written : std_ulogic := '0';
  signal pulse_guard_1_written : std_ulogic := '0';
  signal pulse_guard_2_written : std_ulogic := '0';
  signal pulse_guard_3_written : std_ulogic := '0';
  signal pulse_guard_4_written : std_ulogic := '0';
  signal pulse_guard_5_written : std_ulogic := '0';
  signal pulse_guard_6_written : std_ulogic := '0';
  signal pulse_guard_7_written : std_ulogic := '0';
  signal direction_guard_0_written : std_ulogic := '0';
  signal direction_guard_1_written : std_ulogic := '0';
  signal direction_guard_2_written : std_ulogic := '0';
  signal direction_guard_3_written : std_ulogic := '0';
  signal direction_guard_4_written : std_ulogic := '0';
  signal direction_guard_5_written : std_ulogic := '0';
  signal direction_guard_6_written : std_ulogic := '0';
  signal direction_guard_7_written : std_ulogic := '0';
  signal position_0_written : std_ulogic := '0';
  signal position_1_written : std_ulogic := '0';
  signal position_2_written : std_ulogic := '0';
  signal position_3_written : std_ulogic := '0';
  signal position_4_written : std_ulogic := '0';
  signal position_5_written : std_ulogic := '0';
  signal position_6_written : std_ulogic := '0';
  signal position_7_written : std_ulogic := '0';

begin

  access_begins <= request.strobe and not answered;

  -- Answers in the clock after the strobe; an error for everything that is not described.
  answer : process
  begin
    wait until rising_edge(clk);
    answered <= access_begins;
    writing <= access_begins and known and request.write;
    response.acknowledge <= access_begins and known;
    response.error <= access_begins and not known;
    response.data <= (others => '0');
    if access_begins then
      response.data <= read_word;
      written_data <= request.data;
      register_index <= request.address(8 downto 2);
    end if;
    if reset then
      answered <= '0';
      writing <= '0';
      response <= bus_response_idle;
    end if;
  end process;

  -- Whole words only.
  whole_write <= request.write and (and request.select_bytes);
  known <= writable and whole_write when request.write = '1' else readable;

  readable <= '1' when request.address(11 downto 2) <= 1
    or (request.address(11 downto 2) >= 3 and request.address(11 downto 2) <= 11)
    or (request.address(11 downto 2) >= 46 and request.address(11 downto 2) <= 86) else '0';

  writable <= '1' when (request.address(11 downto 2) >= 1 and request.address(11 downto 2) <= 2)
    or (request.address(11 downto 2) >= 5 and request.address(11 downto 2) <= 9)
    or (request.address(11 downto 2) >= 11 and request.address(11 downto 2) <= 53) else '0';

  build_word <= to_word(to_software.build)
    when request.address(11 downto 2) = 0 else (others => '0');
  control_word <= to_word(to_software.control)
    when request.address(11 downto 2) = 1 else (others => '0');
  status_word <= to_word(to_software.status)
    when request.address(11 downto 2) = 3 else (others => '0');
  errors_word <= to_word(to_software.errors)
    when request.address(11 downto 2) = 4 else (others => '0');
  motor_enable_word <= to_word(to_software.motor_enable)
    when request.address(11 downto 2) = 5 else (others => '0');
  rate_floor_word <= to_word(to_software.rate_floor)
    when request.address(11 downto 2) = 6 else (others => '0');
  override_word <= to_word(override_stored)
    when request.address(11 downto 2) = 7 else (others => '0');
  override_slope_word <= to_word(override_slope_stored)
    when request.address(11 downto 2) = 8 else (others => '0');
  brake_slope_word <= to_word(brake_slope_stored)
    when request.address(11 downto 2) = 9 else (others => '0');
  scale_word <= to_word(to_software.scale)
    when request.address(11 downto 2) = 10 else (others => '0');
  watchdog_word <= to_word(watchdog_stored)
    when request.address(11 downto 2) = 11 else (others => '0');
  position_0_word <= to_word(to_software.position(0))
    when request.address(11 downto 2) = 46 else (others => '0');
  position_1_word <= to_word(to_software.position(1))
    when request.address(11 downto 2) = 47 else (others => '0');
  position_2_word <= to_word(to_software.position(2))
    when request.address(11 downto 2) = 48 else (others => '0');
  position_3_word <= to_word(to_software.position(3))
    when request.address(11 downto 2) = 49 else (others => '0');
  position_4_word <= to_word(to_software.position(4))
    when request.address(11 downto 2) = 50 else (others => '0');
  position_5_word <= to_word(to_software.position(5))
    when request.address(11 downto 2) = 51 else (others => '0');
  position_6_word <= to_word(to_software.position(6))
    when request.address(11 downto 2) = 52 else (others => '0');
  position_7_word <= to_word(to_software.position(7))
    when request.address(11 downto 2) = 53 else (others => '0');
  snapshot_position_0_word <= to_word(to_software.snapshot_position(0))
    when request.address(11 downto 2) = 54 else (others => '0');
  snapshot_position_1_word <= to_word(to_software.snapshot_position(1))
    when request.address(11 downto 2) = 55 else (others => '0');
  snapshot_position_2_word <= to_word(to_software.snapshot_position(2))
    when request.address(11 downto 2) = 56 else (others => '0');
  snapshot_position_3_word <= to_word(to_software.snapshot_position(3))
    when request.address(11 downto 2) = 57 else (others => '0');
  snapshot_position_4_word <= to_word(to_software.snapshot_position(4))
    when request.address(11 downto 2) = 58 else (others => '0');
  snapshot_position_5_word <= to_word(to_software.snapshot_position(5))
    when request.address(11 downto 2) = 59 else (others => '0');
  snapshot_position_6_word <= to_word(to_software.snapshot_position(6))
    when request.address(11 downto 2) = 60 else (others => '0');
  snapshot_position_7_word <= to_word(to_software.snapshot_position(7))
    when request.address(11 downto 2) = 61 else (others => '0');
  snapshot_time_low_word <= to_word(to_software.snapshot_time_low)
    when request.address(11 downto 2) = 62 else (others => '0');
  snapshot_time_high_word <= to_word(to_software.snapshot_time_high)
    when request.address(11 downto 2) = 63 else (others => '0');
  stop_cause_word <= to_word(to_software.stop_cause)
    when request.address(11 downto 2) = 64 else (others => '0');
  stop_position_0_word <= to_word(to_software.stop_position(0))
    when request.address(11 downto 2) = 65 else (others => '0');
  stop_position_1_word <= to_word(to_software.stop_position(1))
    when request.address(11 downto 2) = 66 else (others => '0');
  stop_position_2_word <= to_word(to_software.stop_position(2))
    when request.address(11 downto 2) = 67 else (others => '0');
  stop_position_3_word <= to_word(to_software.stop_position(3))
    when request.address(11 downto 2) = 68 else (others => '0');
  stop_position_4_word <= to_word(to_software.stop_position(4))
    when request.address(11 downto 2) = 69 else (others => '0');
  stop_position_5_word <= to_word(to_software.stop_position(5))
    when request.address(11 downto 2) = 70 else (others => '0');
  stop_position_6_word <= to_word(to_software.stop_position(6))
    when request.address(11 downto 2) = 71 else (others => '0');
  stop_position_7_word <= to_word(to_software.stop_position(7))
    when request.address(11 downto 2) = 72 else (others => '0');
  stop_time_low_word <= to_word(to_software.stop_time_low)
    when request.address(11 downto 2) = 73 else (others => '0');
  stop_time_high_word <= to_word(to_software.stop_time_high)
    when request.address(11 downto 2) = 74 else (others => '0');
  segments_executed_word <= to_word(to_software.segments_executed)
    when request.address(11 downto 2) = 75 else (others => '0');
  underruns_word <= to_word(to_software.underruns)
    when request.address(11 downto 2) = 76 else (others => '0');
  max_level_word <= to_word(to_software.max_level)
    when request.address(11 downto 2) = 77 else (others => '0');
  stalls_word <= to_word(to_software.stalls)
    when request.address(11 downto 2) = 78 else (others => '0');
  axis_stalls_0_word <= to_word(to_software.axis_stalls(0))
    when request.address(11 downto 2) = 79 else (others => '0');
  axis_stalls_1_word <= to_word(to_software.axis_stalls(1))
    when request.address(11 downto 2) = 80 else (others => '0');
  axis_stalls_2_word <= to_word(to_software.axis_stalls(2))
    when request.address(11 downto 2) = 81 else (others => '0');
  axis_stalls_3_word <= to_word(to_software.axis_stalls(3))
    when request.address(11 downto 2) = 82 else (others => '0');
  axis_stalls_4_word <= to_word(to_software.axis_stalls(4))
    when request.address(11 downto 2) = 83 else (others => '0');
  axis_stalls_5_word <= to_word(to_software.axis_stalls(5))
    when request.address(11 downto 2) = 84 else (others => '0');
  axis_stalls_6_word <= to_word(to_software.axis_stalls(6))
    when request.address(11 downto 2) = 85 else (others => '0');
  axis_stalls_7_word <= to_word(to_software.axis_stalls(7))
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
    if writing = '1' and register_index = 7 then
      override_stored <= to_step_generator_override(written_data);
    end if;
    if writing = '1' and register_index = 8 then
      override_slope_stored <= to_step_generator_override_slope(written_data);
    end if;
    if writing = '1' and register_index = 9 then
      brake_slope_stored <= to_step_generator_brake_slope(written_data);
    end if;
    if writing = '1' and register_index = 11 then
      watchdog_stored <= to_step_generator_watchdog(written_data);
    end if;
    if reset then
      override_stored <= step_generator_override_after_reset;
      override_slope_stored <= step_generator_override_slope_after_reset;
      brake_slope_stored <= step_generator_brake_slope_after_reset;
      watchdog_stored <= step_generator_watchdog_after_reset;
    end if;
  end process;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    control_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 1);
    command_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 2);
    motor_enable_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 5);
    rate_floor_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 6);
    segment_flags_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 12);
    segment_line_ticks_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 13);
    segment_ticks_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 14);
    segment_rate_low_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 15);
    segment_rate_high_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 16);
    segment_acceleration_low_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 17);
    segment_acceleration_high_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 18);
    segment_jerk_low_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 19);
    segment_jerk_high_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 20);
    segment_steps_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 21);
    segment_steps_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 22);
    segment_steps_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 23);
    segment_steps_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 24);
    segment_steps_4_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 25);
    segment_steps_5_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 26);
    segment_steps_6_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 27);
    segment_steps_7_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 28);
    segment_commit_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 29);
    pulse_guard_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 30);
    pulse_guard_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 31);
    pulse_guard_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 32);
    pulse_guard_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 33);
    pulse_guard_4_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 34);
    pulse_guard_5_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 35);
    pulse_guard_6_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 36);
    pulse_guard_7_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 37);
    direction_guard_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 38);
    direction_guard_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 39);
    direction_guard_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 40);
    direction_guard_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 41);
    direction_guard_4_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 42);
    direction_guard_5_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 43);
    direction_guard_6_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 44);
    direction_guard_7_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 45);
    position_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 46);
    position_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 47);
    position_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 48);
    position_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 49);
    position_4_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 50);
    position_5_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 51);
    position_6_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 52);
    position_7_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 53);
    if reset then
      control_written <= '0';
      command_written <= '0';
      motor_enable_written <= '0';
      rate_floor_written <= '0';
      segment_flags_written <= '0';
      segment_line_ticks_written <= '0';
      segment_ticks_written <= '0';
      segment_rate_low_written <= '0';
      segment_rate_high_written <= '0';
      segment_acceleration_low_written <= '0';
      segment_acceleration_high_written <= '0';
      segment_jerk_low_written <= '0';
      segment_jerk_high_written <= '0';
      segment_steps_0_written <= '0';
      segment_steps_1_written <= '0';
      segment_steps_2_written <= '0';
      segment_steps_3_written <= '0';
      segment_steps_4_written <= '0';
      segment_steps_5_written <= '0';
      segment_steps_6_written <= '0';
      segment_steps_7_written <= '0';
      segment_commit_written <= '0';
      pulse_guard_0_written <= '0';
      pulse_guard_1_written <= '0';
      pulse_guard_2_written <= '0';
      pulse_guard_3_written <= '0';
      pulse_guard_4_written <= '0';
      pulse_guard_5_written <= '0';
      pulse_guard_6_written <= '0';
      pulse_guard_7_written <= '0';
      direction_guard_0_written <= '0';
      direction_guard_1_written <= '0';
      direction_guard_2_written <= '0';
      direction_guard_3_written <= '0';
      direction_guard_4_written <= '0';
      direction_guard_5_written <= '0';
      direction_guard_6_written <= '0';
      direction_guard_7_written <= '0';
      position_0_written <= '0';
      position_1_written <= '0';
      position_2_written <= '0';
      position_3_written <= '0';
      position_4_written <= '0';
      position_5_written <= '0';
      position_6_written <= '0';
      position_7_written <= '0';
    end if;
  end process;

  from_software.control_written <= control_written;
  from_software.control <= to_step_generator_control(written_data);
  from_software.command_written <= command_written;
  from_software.command <= to_step_generator_command(written_data);
  from_software.motor_enable_written <= motor_enable_written;
  from_software.motor_enable <= to_step_generator_motor_enable(written_data);
  from_software.rate_floor_written <= rate_floor_written;
  from_software.rate_floor <= to_step_generator_rate_floor(written_data);
  from_software.override <= override_stored;
  from_software.override_slope <= override_slope_stored;
  from_software.brake_slope <= brake_slope_stored;
  from_software.watchdog <= watchdog_stored;
  from_software.segment_flags_written <= segment_flags_written;
  from_software.segment_flags <= to_step_generator_segment_flags(written_data);
  from_software.segment_line_ticks_written <= segment_line_ticks_written;
  from_software.segment_line_ticks <= to_step_generator_segment_line_ticks(written_data);
  from_software.segment_ticks_written <= segment_ticks_written;
  from_software.segment_ticks <= to_step_generator_segment_ticks(written_data);
  from_software.segment_rate_low_written <= segment_rate_low_written;
  from_software.segment_rate_low <= to_step_generator_segment_rate_low(written_data);
  from_software.segment_rate_high_written <= segment_rate_high_written;
  from_software.segment_rate_high <= to_step_generator_segment_rate_high(written_data);
  from_software.segment_acceleration_low_written <= segment_acceleration_low_written;
  from_software.segment_acceleration_low <= to_step_generator_segment_acceleration_low(written_data);
  from_software.segment_acceleration_high_written <= segment_acceleration_high_written;
  from_software.segment_acceleration_high <= to_step_generator_segment_acceleration_high(written_data);
  from_software.segment_jerk_low_written <= segment_jerk_low_written;
  from_software.segment_jerk_low <= to_step_generator_segment_jerk_low(written_data);
  from_software.segment_jerk_high_written <= segment_jerk_high_written;
  from_software.segment_jerk_high <= to_step_generator_segment_jerk_high(written_data);
  from_software.segment_steps_written(0) <= segment_steps_0_written;
  from_software.segment_steps(0) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(1) <= segment_steps_1_written;
  from_software.segment_steps(1) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(2) <= segment_steps_2_written;
  from_software.segment_steps(2) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(3) <= segment_steps_3_written;
  from_software.segment_steps(3) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(4) <= segment_steps_4_written;
  from_software.segment_steps(4) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(5) <= segment_steps_5_written;
  from_software.segment_steps(5) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(6) <= segment_steps_6_written;
  from_software.segment_steps(6) <= to_step_generator_segment_steps(written_data);
  from_software.segment_steps_written(7) <= segment_steps_7_written;
  from_software.segment_steps(7) <= to_step_generator_segment_steps(written_data);
  from_software.segment_commit_written <= segment_commit_written;
  from_software.segment_commit <= to_step_generator_segment_commit(written_data);
  from_software.pulse_guard_written(0) <= pulse_guard_0_written;
  from_software.pulse_guard(0) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(1) <= pulse_guard_1_written;
  from_software.pulse_guard(1) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(2) <= pulse_guard_2_written;
  from_software.pulse_guard(2) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(3) <= pulse_guard_3_written;
  from_software.pulse_guard(3) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(4) <= pulse_guard_4_written;
  from_software.pulse_guard(4) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(5) <= pulse_guard_5_written;
  from_software.pulse_guard(5) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(6) <= pulse_guard_6_written;
  from_software.pulse_guard(6) <= to_step_generator_pulse_guard(written_data);
  from_software.pulse_guard_written(7) <= pulse_guard_7_written;
  from_software.pulse_guard(7) <= to_step_generator_pulse_guard(written_data);
  from_software.direction_guard_written(0) <= direction_guard_0_written;
  from_software.direction_guard(0) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(1) <= direction_guard_1_written;
  from_software.direction_guard(1) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(2) <= direction_guard_2_written;
  from_software.direction_guard(2) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(3) <= direction_guard_3_written;
  from_software.direction_guard(3) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(4) <= direction_guard_4_written;
  from_software.direction_guard(4) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(5) <= direction_guard_5_written;
  from_software.direction_guard(5) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(6) <= direction_guard_6_written;
  from_software.direction_guard(6) <= to_step_generator_direction_guard(written_data);
  from_software.direction_guard_written(7) <= direction_guard_7_written;
  from_software.direction_guard(7) <= to_step_generator_direction_guard(written_data);
  from_software.position_written(0) <= position_0_written;
  from_software.position(0) <= to_step_generator_position(written_data);
  from_software.position_written(1) <= position_1_written;
  from_software.position(1) <= to_step_generator_position(written_data);
  from_software.position_written(2) <= position_2_written;
  from_software.position(2) <= to_step_generator_position(written_data);
  from_software.position_written(3) <= position_3_written;
  from_software.position(3) <= to_step_generator_position(written_data);
  from_software.position_written(4) <= position_4_written;
  from_software.position(4) <= to_step_generator_position(written_data);
  from_software.position_written(5) <= position_5_written;
  from_software.position(5) <= to_step_generator_position(written_data);
  from_software.position_written(6) <= position_6_written;
  from_software.position(6) <= to_step_generator_position(written_data);
  from_software.position_written(7) <= position_7_written;
  from_software.position(7) <= to_step_generator_position(written_data);

end architecture;
