-- SPDX-License-Identifier: Apache-2.0
-- Types that temperature converter and heater control share, and the signals between them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.heater_control_registers_pkg.all;

package thermal_pkg is

  -- The resistors through which a channel charges its capacitor: bit numbers of its drive pins.
  constant thermistor : natural := 0;
  constant reference_low : natural := 1;
  constant reference_high : natural := 2;
  constant resistors : positive := 3;

  -- One clock of all time-outs and ages of the thermal part.
  constant tick_cycles : positive := heater_control_tick_cycles;
  constant tick_count_bits : positive := 20;
  subtype tick_count_t is unsigned(tick_count_bits - 1 downto 0);

  -- Times within a conversion, modulo 2^24 clocks.
  subtype cycles_t is unsigned(23 downto 0);

  -- The newest conversion of a sensor channel.
  type sensor_reading_t is record
    -- '1' for the one clock in which the rest is new.
    updated : std_ulogic;
    -- It was made under the present settings throughout and found nothing wrong.
    valid : std_ulogic;
    -- Clocks of all charges through the thermistor: small is hot.
    count : unsigned(31 downto 0);
  end record;

  -- How a conversion is made: the scale of all counts. Names and units as in the converter's registers.
  type converter_settings_t is record
    references : std_ulogic;
    dither_cycles : unsigned(7 downto 0);
    more_charges : unsigned(7 downto 0);
    discharge_cycles : cycles_t;
    timeout_cycles : cycles_t;
    pause_cycles : cycles_t;
    short_limit : unsigned(31 downto 0);
  end record;

  constant converter_settings_none : converter_settings_t := (
    references => '0', dither_cycles => (others => '0'), more_charges => (others => '0'),
    discharge_cycles => (others => '0'), timeout_cycles => (others => '0'),
    pause_cycles => (others => '0'), short_limit => (others => '0'));

  -- How long a gate has been closed; how long it must have been before a rise is not residual heat.
  subtype settle_t is unsigned(23 downto 0);

  type sensor_reading_array_t is array (natural range <>) of sensor_reading_t;

  constant sensor_reading_none : sensor_reading_t := (
    updated => '0', valid => '0', count => (others => '0'));

  -- What closed a heater's gate, latched until software clears it.
  type heater_trips_t is record
    watchdog : std_ulogic;
    sensor_invalid : std_ulogic;
    sensor_stale : std_ulogic;
    too_hot : std_ulogic;
    too_cold : std_ulogic;
    limits_missing : std_ulogic;
    emergency_stop : std_ulogic;
    heats_unasked : std_ulogic;
  end record;

  constant heater_trips_none : heater_trips_t := (others => '0');

  function any_of(trips : heater_trips_t) return std_ulogic;

end package;

package body thermal_pkg is

  function any_of(trips : heater_trips_t) return std_ulogic is
  begin
    return trips.watchdog or trips.sensor_invalid or trips.sensor_stale or trips.too_hot
      or trips.too_cold or trips.limits_missing or trips.emergency_stop
      or trips.heats_unasked;
  end function;

end package body;
