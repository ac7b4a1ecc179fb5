-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `temperature_converter`. Generated from rtl/thermal/temperature_converter.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package temperature_converter_registers_pkg is

  constant temperature_converter_address : unsigned(31 downto 0) := x"F0005000";

  -- How conversions are made. A change of settings, here or below, begins a new conversion; until it has ended the state is `never`. All but `enable` lock with the limits of the heaters.
  constant temperature_converter_control_address : unsigned(31 downto 0) := x"F0005000";
  type temperature_converter_control_t is record
    enable : std_ulogic;
    references : std_ulogic;
    dither_cycles : unsigned(7 downto 0);
    more_charges : unsigned(7 downto 0);
  end record;

  -- Time to discharge the capacitor before each charge.
  constant temperature_converter_discharge_address : unsigned(31 downto 0) := x"F0005004";
  type temperature_converter_discharge_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Longest time that one charge may take.
  constant temperature_converter_timeout_address : unsigned(31 downto 0) := x"F0005008";
  type temperature_converter_timeout_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Time between conversions, with the capacitor discharged.
  constant temperature_converter_pause_address : unsigned(31 downto 0) := x"F000500C";
  type temperature_converter_pause_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Below this thermistor count the thermistor is taken as shorted.
  constant temperature_converter_short_limit_address : unsigned(31 downto 0) := x"F0005010";
  type temperature_converter_short_limit_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- Outcome of the channel's newest conversion.
  constant temperature_converter_status_address : unsigned(31 downto 0) := x"F0005014";  -- of the first
  type temperature_converter_status_t is record
    state : unsigned(2 downto 0);
    conversions : unsigned(7 downto 0);
  end record;
  type temperature_converter_status_array_t is array (0 to 3) of temperature_converter_status_t;
  constant temperature_converter_status_state_never : natural := 0;
  constant temperature_converter_status_state_ok : natural := 1;
  constant temperature_converter_status_state_open : natural := 2;
  constant temperature_converter_status_state_shorted : natural := 3;
  constant temperature_converter_status_state_stuck : natural := 4;
  constant temperature_converter_status_state_time_out : natural := 5;

  -- Time since the channel's newest conversion.
  constant temperature_converter_age_address : unsigned(31 downto 0) := x"F0005024";  -- of the first
  type temperature_converter_age_t is record
    ticks : unsigned(19 downto 0);
  end record;
  type temperature_converter_age_array_t is array (0 to 3) of temperature_converter_age_t;

  -- Clocks of all charges through the thermistor.
  constant temperature_converter_thermistor_address : unsigned(31 downto 0) := x"F0005034";  -- of the first
  type temperature_converter_thermistor_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_thermistor_array_t is array (0 to 3) of temperature_converter_thermistor_t;

  -- Clocks of all charges through the low reference resistor.
  constant temperature_converter_reference_low_address : unsigned(31 downto 0) := x"F0005044";  -- of the first
  type temperature_converter_reference_low_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_low_array_t is array (0 to 3) of temperature_converter_reference_low_t;

  -- Clocks of all charges through the high reference resistor.
  constant temperature_converter_reference_high_address : unsigned(31 downto 0) := x"F0005054";  -- of the first
  type temperature_converter_reference_high_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_high_array_t is array (0 to 3) of temperature_converter_reference_high_t;

  -- The settings are locked while any limit of a heater is: they are the scale of the limits.
  constant temperature_converter_settings_lock_address : unsigned(31 downto 0) := x"F0005064";
  type temperature_converter_settings_lock_t is record
    locked : std_ulogic;
    refused : std_ulogic;
  end record;

  type temperature_converter_from_software_t is record
    control : temperature_converter_control_t;
    control_written : std_ulogic;
    discharge : temperature_converter_discharge_t;
    discharge_written : std_ulogic;
    timeout : temperature_converter_timeout_t;
    timeout_written : std_ulogic;
    pause : temperature_converter_pause_t;
    pause_written : std_ulogic;
    short_limit : temperature_converter_short_limit_t;
    short_limit_written : std_ulogic;
    settings_lock : temperature_converter_settings_lock_t;
    settings_lock_written : std_ulogic;
  end record;

  type temperature_converter_to_software_t is record
    control : temperature_converter_control_t;
    discharge : temperature_converter_discharge_t;
    timeout : temperature_converter_timeout_t;
    pause : temperature_converter_pause_t;
    short_limit : temperature_converter_short_limit_t;
    status : temperature_converter_status_array_t;
    age : temperature_converter_age_array_t;
    thermistor : temperature_converter_thermistor_array_t;
    reference_low : temperature_converter_reference_low_array_t;
    reference_high : temperature_converter_reference_high_array_t;
    settings_lock : temperature_converter_settings_lock_t;
  end record;

end package;
