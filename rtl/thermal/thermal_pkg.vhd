-- SPDX-License-Identifier: Apache-2.0
-- What the temperature converter tells the heater control, wire by wire, without software in between.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package thermal_pkg is

  -- The resistors through which a channel charges its capacitor: bit numbers of its drive pins.
  constant thermistor : natural := 0;
  constant reference_low : natural := 1;
  constant reference_high : natural := 2;
  constant resistors : positive := 3;

  -- One clock of all time-outs and ages of the thermal part.
  constant tick_cycles : positive := 1024;
  constant tick_count_bits : positive := 20;
  subtype tick_count_t is unsigned(tick_count_bits - 1 downto 0);

  -- Times within a conversion, modulo 2^24 clocks.
  subtype cycles_t is unsigned(23 downto 0);

  -- The newest conversion of a sensor channel.
  type sensor_reading_t is record
    -- '1' for the one clock in which the rest is new.
    updated : std_ulogic;
    -- The conversion found nothing wrong.
    valid : std_ulogic;
    -- Clocks of all charges through the thermistor: small is hot.
    count : unsigned(31 downto 0);
  end record;

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
  end record;

  constant heater_trips_none : heater_trips_t := (others => '0');

  function any_of(trips : heater_trips_t) return std_ulogic;

end package;

package body thermal_pkg is

  function any_of(trips : heater_trips_t) return std_ulogic is
  begin
    return trips.watchdog or trips.sensor_invalid or trips.sensor_stale or trips.too_hot
      or trips.too_cold or trips.limits_missing or trips.emergency_stop;
  end function;

end package body;
