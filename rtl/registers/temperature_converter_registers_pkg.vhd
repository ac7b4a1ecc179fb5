-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `temperature_converter`. Generated from rtl/thermal/temperature_converter.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package temperature_converter_registers_pkg is

  constant temperature_converter_address : unsigned(31 downto 0) := x"F0005000";

  -- How conversions are made. A change of settings, here or below, begins a new conversion; until it has ended the state is `never`. All but `enable` lock with the limits of the heaters.
  constant temperature_converter_control_address : unsigned(31 downto 0) := x"F0005000";
  constant temperature_converter_control_enable_bit : natural := 0;
  constant temperature_converter_control_references_bit : natural := 1;
  subtype temperature_converter_control_dither_cycles_bits is natural range 15 downto 8;
  subtype temperature_converter_control_more_charges_bits is natural range 23 downto 16;
  type temperature_converter_control_t is record
    enable : std_ulogic;
    references : std_ulogic;
    dither_cycles : unsigned(7 downto 0);
    more_charges : unsigned(7 downto 0);
  end record;
  function to_word(value : temperature_converter_control_t) return std_ulogic_vector;
  function to_temperature_converter_control(word : std_ulogic_vector(31 downto 0)) return temperature_converter_control_t;

  -- Time to discharge the capacitor before each charge.
  constant temperature_converter_discharge_address : unsigned(31 downto 0) := x"F0005004";
  subtype temperature_converter_discharge_cycles_bits is natural range 23 downto 0;
  type temperature_converter_discharge_t is record
    cycles : unsigned(23 downto 0);
  end record;
  function to_word(value : temperature_converter_discharge_t) return std_ulogic_vector;
  function to_temperature_converter_discharge(word : std_ulogic_vector(31 downto 0)) return temperature_converter_discharge_t;

  -- Longest time that one charge may take.
  constant temperature_converter_timeout_address : unsigned(31 downto 0) := x"F0005008";
  subtype temperature_converter_timeout_cycles_bits is natural range 23 downto 0;
  type temperature_converter_timeout_t is record
    cycles : unsigned(23 downto 0);
  end record;
  function to_word(value : temperature_converter_timeout_t) return std_ulogic_vector;
  function to_temperature_converter_timeout(word : std_ulogic_vector(31 downto 0)) return temperature_converter_timeout_t;

  -- Time between conversions, with the capacitor discharged.
  constant temperature_converter_pause_address : unsigned(31 downto 0) := x"F000500C";
  subtype temperature_converter_pause_cycles_bits is natural range 23 downto 0;
  type temperature_converter_pause_t is record
    cycles : unsigned(23 downto 0);
  end record;
  function to_word(value : temperature_converter_pause_t) return std_ulogic_vector;
  function to_temperature_converter_pause(word : std_ulogic_vector(31 downto 0)) return temperature_converter_pause_t;

  -- Below this thermistor count the thermistor is taken as shorted.
  constant temperature_converter_short_limit_address : unsigned(31 downto 0) := x"F0005010";
  subtype temperature_converter_short_limit_cycles_bits is natural range 31 downto 0;
  type temperature_converter_short_limit_t is record
    cycles : unsigned(31 downto 0);
  end record;
  function to_word(value : temperature_converter_short_limit_t) return std_ulogic_vector;
  function to_temperature_converter_short_limit(word : std_ulogic_vector(31 downto 0)) return temperature_converter_short_limit_t;

  -- Outcome of the channel's newest conversion.
  constant temperature_converter_status_address : unsigned(31 downto 0) := x"F0005014";  -- of the first
  subtype temperature_converter_status_state_bits is natural range 2 downto 0;
  subtype temperature_converter_status_conversions_bits is natural range 15 downto 8;
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
  function to_word(value : temperature_converter_status_t) return std_ulogic_vector;
  function to_temperature_converter_status(word : std_ulogic_vector(31 downto 0)) return temperature_converter_status_t;

  -- Time since the channel's newest conversion.
  constant temperature_converter_age_address : unsigned(31 downto 0) := x"F0005024";  -- of the first
  subtype temperature_converter_age_ticks_bits is natural range 19 downto 0;
  type temperature_converter_age_t is record
    ticks : unsigned(19 downto 0);
  end record;
  type temperature_converter_age_array_t is array (0 to 3) of temperature_converter_age_t;
  function to_word(value : temperature_converter_age_t) return std_ulogic_vector;
  function to_temperature_converter_age(word : std_ulogic_vector(31 downto 0)) return temperature_converter_age_t;

  -- Clocks of all charges through the thermistor.
  constant temperature_converter_thermistor_address : unsigned(31 downto 0) := x"F0005034";  -- of the first
  subtype temperature_converter_thermistor_cycles_bits is natural range 31 downto 0;
  type temperature_converter_thermistor_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_thermistor_array_t is array (0 to 3) of temperature_converter_thermistor_t;
  function to_word(value : temperature_converter_thermistor_t) return std_ulogic_vector;
  function to_temperature_converter_thermistor(word : std_ulogic_vector(31 downto 0)) return temperature_converter_thermistor_t;

  -- Clocks of all charges through the low reference resistor.
  constant temperature_converter_reference_low_address : unsigned(31 downto 0) := x"F0005044";  -- of the first
  subtype temperature_converter_reference_low_cycles_bits is natural range 31 downto 0;
  type temperature_converter_reference_low_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_low_array_t is array (0 to 3) of temperature_converter_reference_low_t;
  function to_word(value : temperature_converter_reference_low_t) return std_ulogic_vector;
  function to_temperature_converter_reference_low(word : std_ulogic_vector(31 downto 0)) return temperature_converter_reference_low_t;

  -- Clocks of all charges through the high reference resistor.
  constant temperature_converter_reference_high_address : unsigned(31 downto 0) := x"F0005054";  -- of the first
  subtype temperature_converter_reference_high_cycles_bits is natural range 31 downto 0;
  type temperature_converter_reference_high_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_high_array_t is array (0 to 3) of temperature_converter_reference_high_t;
  function to_word(value : temperature_converter_reference_high_t) return std_ulogic_vector;
  function to_temperature_converter_reference_high(word : std_ulogic_vector(31 downto 0)) return temperature_converter_reference_high_t;

  -- The settings are locked while any limit of a heater is: they are the scale of the limits.
  constant temperature_converter_settings_lock_address : unsigned(31 downto 0) := x"F0005064";
  constant temperature_converter_settings_lock_locked_bit : natural := 0;
  constant temperature_converter_settings_lock_refused_bit : natural := 1;
  type temperature_converter_settings_lock_t is record
    locked : std_ulogic;
    refused : std_ulogic;
  end record;
  function to_word(value : temperature_converter_settings_lock_t) return std_ulogic_vector;
  function to_temperature_converter_settings_lock(word : std_ulogic_vector(31 downto 0)) return temperature_converter_settings_lock_t;

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

package body temperature_converter_registers_pkg is

  function to_word(value : temperature_converter_control_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.more_charges) & std_ulogic_vector(value.dither_cycles) & "000000" & value.references & value.enable;
  end function;

  function to_temperature_converter_control(word : std_ulogic_vector(31 downto 0)) return temperature_converter_control_t is
  begin
    return (
      enable => word(temperature_converter_control_enable_bit),
  references => word(temperature_converter_control_references_bit),
  dither_cycles => unsigned(word(temperature_converter_control_dither_cycles_bits)),
  more_charges => unsigned(word(temperature_converter_control_more_charges_bits)));
  end function;

  function to_word(value : temperature_converter_discharge_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_discharge(word : std_ulogic_vector(31 downto 0)) return temperature_converter_discharge_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_discharge_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_timeout_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_timeout(word : std_ulogic_vector(31 downto 0)) return temperature_converter_timeout_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_timeout_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_pause_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_pause(word : std_ulogic_vector(31 downto 0)) return temperature_converter_pause_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_pause_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_short_limit_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_short_limit(word : std_ulogic_vector(31 downto 0)) return temperature_converter_short_limit_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_short_limit_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_status_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.conversions) & "00000" & std_ulogic_vector(value.state);
  end function;

  function to_temperature_converter_status(word : std_ulogic_vector(31 downto 0)) return temperature_converter_status_t is
  begin
    return (
      state => unsigned(word(temperature_converter_status_state_bits)),
  conversions => unsigned(word(temperature_converter_status_conversions_bits)));
  end function;

  function to_word(value : temperature_converter_age_t) return std_ulogic_vector is
  begin
    return "000000000000" & std_ulogic_vector(value.ticks);
  end function;

  function to_temperature_converter_age(word : std_ulogic_vector(31 downto 0)) return temperature_converter_age_t is
  begin
    return (
      ticks => unsigned(word(temperature_converter_age_ticks_bits)));
  end function;

  function to_word(value : temperature_converter_thermistor_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_thermistor(word : std_ulogic_vector(31 downto 0)) return temperature_converter_thermistor_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_thermistor_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_reference_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_reference_low(word : std_ulogic_vector(31 downto 0)) return temperature_converter_reference_low_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_reference_low_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_reference_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_temperature_converter_reference_high(word : std_ulogic_vector(31 downto 0)) return temperature_converter_reference_high_t is
  begin
    return (
      cycles => unsigned(word(temperature_converter_reference_high_cycles_bits)));
  end function;

  function to_word(value : temperature_converter_settings_lock_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000000000" & value.refused & value.locked;
  end function;

  function to_temperature_converter_settings_lock(word : std_ulogic_vector(31 downto 0)) return temperature_converter_settings_lock_t is
  begin
    return (
      locked => word(temperature_converter_settings_lock_locked_bit),
  refused => word(temperature_converter_settings_lock_refused_bit));
  end function;

end package body;
