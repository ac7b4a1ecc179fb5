-- SPDX-License-Identifier: Apache-2.0
-- What the parts of the step generator pass to each other: segments, guard times, positions.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_generator_pkg is

  -- Axes that the registers have room for.
  constant axis_limit : positive := 8;

  -- Ticks and steps of a line.
  subtype ticks_t is unsigned(30 downto 0);
  type ticks_array_t is array (natural range <>) of ticks_t;

  subtype position_t is signed(31 downto 0);
  type position_array_t is array (natural range <>) of position_t;

  -- Clocks since reset.
  subtype time_t is unsigned(63 downto 0);

  -- Event counters, modulo 2^32.
  subtype count_t is unsigned(31 downto 0);
  type count_array_t is array (natural range <>) of count_t;

  -- Least times of one axis in clocks; 0 counts as 1.
  subtype guard_clocks_t is unsigned(11 downto 0);
  type guard_t is record
    high : guard_clocks_t;
    low : guard_clocks_t;
    direction_setup : guard_clocks_t;
    direction_hold : guard_clocks_t;
  end record;
  type guard_array_t is array (natural range <>) of guard_t;

  -- After reset: slow enough for an A4988 at 50 MHz.
  constant guard_after_reset : guard_t := (
    high => to_unsigned(50, 12), low => to_unsigned(50, 12),
    direction_setup => to_unsigned(10, 12), direction_hold => to_unsigned(10, 12));

  -- In 2^-32 ticks per clock; 100 ticks/s at 50 MHz.
  constant rate_floor_after_reset : unsigned(30 downto 0) := to_unsigned(8590, 31);

  -- Part of real time at which the base runs: 0 stands still, 2^32 is the rate that segments request.
  subtype scale_t is unsigned(33 downto 0);
  constant scale_of_one : scale_t := (32 => '1', others => '0');
  -- By which the scale changes in a clock.
  subtype slope_t is unsigned(31 downto 0);
  -- Base clocks executed in one clock, as a power of two: a leap of 1, 2 or 4.
  subtype leap_t is unsigned(1 downto 0);

  -- What ends a segment.
  type stop_condition_t is record
    -- These end stops.
    mask : std_ulogic_vector(7 downto 0);
    -- Only by becoming so while the segment is executed.
    on_change : std_ulogic;
    -- When released, not when triggered.
    on_release : std_ulogic;
    -- Along the brake's ramp, not at once.
    brakes : std_ulogic;
  end record;
  constant stop_condition_none : stop_condition_t := (mask => x"00", others => '0');

  -- A segment without its steps.
  type segment_t is record
    -- Direction of each axis, 1 = negative.
    backward : std_ulogic_vector(axis_limit - 1 downto 0);
    -- Axes whose steps come a quarter of a step early or late, never both.
    ahead : std_ulogic_vector(axis_limit - 1 downto 0);
    behind : std_ulogic_vector(axis_limit - 1 downto 0);
    continues_line : std_ulogic;
    ends_motion : std_ulogic;
    -- Begins from rest, and only at a start.
    waits_for_start : std_ulogic;
    stop_on : stop_condition_t;
    line_ticks : ticks_t;
    ticks : ticks_t;
    -- In 2^-64 ticks per clock, at most 1/2 tick per clock.
    rate : unsigned(63 downto 0);
    -- In 2^-84 ticks per clock^2 and clock^3.
    acceleration : signed(63 downto 0);
    jerk : signed(63 downto 0);
  end record;

  -- A segment is stored as words side by side, one memory (lane) for each, so that all are read at once.
  -- The flags as in the register segment_flags.
  constant flags_lane : natural := 0;
  constant line_ticks_lane : natural := 1;
  constant ticks_lane : natural := 2;
  constant rate_low_lane : natural := 3;
  constant rate_high_lane : natural := 4;
  constant acceleration_low_lane : natural := 5;
  constant acceleration_high_lane : natural := 6;
  constant jerk_low_lane : natural := 7;
  constant jerk_high_lane : natural := 8;
  -- And one for each axis from here on.
  constant steps_lane : natural := 9;
  subtype lane_t is natural range 0 to steps_lane + axis_limit - 1;

  -- One word that software writes.
  type lane_write_t is record
    valid : std_ulogic;
    lane : lane_t;
    data : std_ulogic_vector(31 downto 0);
  end record;

  -- Why a commit was refused; high for one clock.
  type refusal_t is record
    queue_full : std_ulogic;
    incomplete : std_ulogic;
    illegal : std_ulogic;
    while_stopped : std_ulogic;
    disabled : std_ulogic;
  end record;
  constant refusal_none : refusal_t := (others => '0');

  -- Why motion was stopped.
  type stop_cause_t is record
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_input : std_ulogic;
    software : std_ulogic;
    watchdog : std_ulogic;
    software_brake : std_ulogic;
  end record;
  constant stop_cause_none : stop_cause_t := (end_stops => x"00", others => '0');

end package;
