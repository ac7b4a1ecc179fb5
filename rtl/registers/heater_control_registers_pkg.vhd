-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `heater_control`. Generated from rtl/thermal/heater_control.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package heater_control_registers_pkg is

  constant heater_control_address : unsigned(31 downto 0) := x"F0006000";

  -- Clocks of a tick, the unit of all time-outs and ages of the thermal part.
  constant heater_control_tick_cycles : natural := 1024;

  -- Feeds the watchdog, by two keys in turn. Anything else, the same key again or `first` too early trips all channels.
  constant heater_control_feed_address : unsigned(31 downto 0) := x"F0006000";
  subtype heater_control_feed_key_bits is natural range 15 downto 0;
  type heater_control_feed_t is record
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_feed_key_second : natural := 24301;
  constant heater_control_feed_key_first : natural := 65261;
  function to_word(value : heater_control_feed_t) return std_ulogic_vector;
  function to_heater_control_feed(word : std_ulogic_vector(31 downto 0)) return heater_control_feed_t;

  -- Time without a complete feed after which all gates close.
  constant heater_control_watchdog_address : unsigned(31 downto 0) := x"F0006004";
  subtype heater_control_watchdog_ticks_bits is natural range 19 downto 0;
  type heater_control_watchdog_t is record
    ticks : unsigned(19 downto 0);
  end record;
  function to_word(value : heater_control_watchdog_t) return std_ulogic_vector;
  function to_heater_control_watchdog(word : std_ulogic_vector(31 downto 0)) return heater_control_watchdog_t;

  -- Time without a valid conversion after which a channel's gate closes for good.
  constant heater_control_sensor_timeout_address : unsigned(31 downto 0) := x"F0006008";
  subtype heater_control_sensor_timeout_ticks_bits is natural range 19 downto 0;
  type heater_control_sensor_timeout_t is record
    ticks : unsigned(19 downto 0);
  end record;
  function to_word(value : heater_control_sensor_timeout_t) return std_ulogic_vector;
  function to_heater_control_sensor_timeout(word : std_ulogic_vector(31 downto 0)) return heater_control_sensor_timeout_t;

  -- Shortest time that a gate keeps its level when it is modulated.
  constant heater_control_slot_address : unsigned(31 downto 0) := x"F000600C";
  subtype heater_control_slot_cycles_bits is natural range 23 downto 0;
  type heater_control_slot_t is record
    cycles : unsigned(23 downto 0);
  end record;
  constant heater_control_slot_after_reset : heater_control_slot_t := (cycles => 24x"400");
  function to_word(value : heater_control_slot_t) return std_ulogic_vector;
  function to_heater_control_slot(word : std_ulogic_vector(31 downto 0)) return heater_control_slot_t;

  -- Clears the trips of channels whose duty is 0, and `refused` of all channels named.
  constant heater_control_clear_address : unsigned(31 downto 0) := x"F0006010";
  subtype heater_control_clear_channels_bits is natural range 3 downto 0;
  subtype heater_control_clear_key_bits is natural range 31 downto 16;
  type heater_control_clear_t is record
    channels : std_ulogic_vector(3 downto 0);
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_clear_key_clear_trips : natural := 49642;
  function to_word(value : heater_control_clear_t) return std_ulogic_vector;
  function to_heater_control_clear(word : std_ulogic_vector(31 downto 0)) return heater_control_clear_t;

  -- How much of the time the channel heats. A request: the hardware decides.
  constant heater_control_duty_address : unsigned(31 downto 0) := x"F0006014";  -- of the first
  subtype heater_control_duty_density_bits is natural range 15 downto 0;
  type heater_control_duty_t is record
    density : unsigned(15 downto 0);
  end record;
  type heater_control_duty_array_t is array (0 to 3) of heater_control_duty_t;
  constant heater_control_duty_after_reset : heater_control_duty_t := (density => 16x"0");
  function to_word(value : heater_control_duty_t) return std_ulogic_vector;
  function to_heater_control_duty(word : std_ulogic_vector(31 downto 0)) return heater_control_duty_t;

  -- Smallest thermistor count at which the channel may heat: the cut-off temperature. Locks when written, and the converter's settings with it.
  constant heater_control_minimum_count_address : unsigned(31 downto 0) := x"F0006024";  -- of the first
  subtype heater_control_minimum_count_cycles_bits is natural range 31 downto 0;
  type heater_control_minimum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_minimum_count_array_t is array (0 to 3) of heater_control_minimum_count_t;
  function to_word(value : heater_control_minimum_count_t) return std_ulogic_vector;
  function to_heater_control_minimum_count(word : std_ulogic_vector(31 downto 0)) return heater_control_minimum_count_t;

  -- Largest thermistor count at which the channel may heat: too cold or open. Locks when written.
  constant heater_control_maximum_count_address : unsigned(31 downto 0) := x"F0006034";  -- of the first
  subtype heater_control_maximum_count_cycles_bits is natural range 31 downto 0;
  type heater_control_maximum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_maximum_count_array_t is array (0 to 3) of heater_control_maximum_count_t;
  function to_word(value : heater_control_maximum_count_t) return std_ulogic_vector;
  function to_heater_control_maximum_count(word : std_ulogic_vector(31 downto 0)) return heater_control_maximum_count_t;

  -- What the channel does, and what tripped it since its trips were cleared.
  constant heater_control_status_address : unsigned(31 downto 0) := x"F0006044";  -- of the first
  constant heater_control_status_gate_bit : natural := 0;
  constant heater_control_status_permitted_bit : natural := 1;
  constant heater_control_status_minimum_locked_bit : natural := 2;
  constant heater_control_status_maximum_locked_bit : natural := 3;
  constant heater_control_status_hot_locked_bit : natural := 4;
  constant heater_control_status_settle_locked_bit : natural := 5;
  constant heater_control_status_refused_bit : natural := 6;
  constant heater_control_status_tripped_bit : natural := 7;
  constant heater_control_status_watchdog_trip_bit : natural := 8;
  constant heater_control_status_sensor_invalid_trip_bit : natural := 9;
  constant heater_control_status_sensor_stale_trip_bit : natural := 10;
  constant heater_control_status_too_hot_trip_bit : natural := 11;
  constant heater_control_status_too_cold_trip_bit : natural := 12;
  constant heater_control_status_limits_missing_trip_bit : natural := 13;
  constant heater_control_status_emergency_stop_trip_bit : natural := 14;
  constant heater_control_status_heats_unasked_trip_bit : natural := 15;
  type heater_control_status_t is record
    gate : std_ulogic;
    permitted : std_ulogic;
    minimum_locked : std_ulogic;
    maximum_locked : std_ulogic;
    hot_locked : std_ulogic;
    settle_locked : std_ulogic;
    refused : std_ulogic;
    tripped : std_ulogic;
    watchdog_trip : std_ulogic;
    sensor_invalid_trip : std_ulogic;
    sensor_stale_trip : std_ulogic;
    too_hot_trip : std_ulogic;
    too_cold_trip : std_ulogic;
    limits_missing_trip : std_ulogic;
    emergency_stop_trip : std_ulogic;
    heats_unasked_trip : std_ulogic;
  end record;
  type heater_control_status_array_t is array (0 to 3) of heater_control_status_t;
  function to_word(value : heater_control_status_t) return std_ulogic_vector;
  function to_heater_control_status(word : std_ulogic_vector(31 downto 0)) return heater_control_status_t;

  -- Below this thermistor count heat that is not requested is a trip. Locks when written.
  constant heater_control_hot_count_address : unsigned(31 downto 0) := x"F0006054";  -- of the first
  subtype heater_control_hot_count_cycles_bits is natural range 31 downto 0;
  type heater_control_hot_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_hot_count_array_t is array (0 to 3) of heater_control_hot_count_t;
  function to_word(value : heater_control_hot_count_t) return std_ulogic_vector;
  function to_heater_control_hot_count(word : std_ulogic_vector(31 downto 0)) return heater_control_hot_count_t;

  -- Time for which a gate must be closed before rising heat is not its own. Locks when written.
  constant heater_control_settle_address : unsigned(31 downto 0) := x"F0006064";  -- of the first
  subtype heater_control_settle_ticks_bits is natural range 23 downto 0;
  type heater_control_settle_t is record
    ticks : unsigned(23 downto 0);
  end record;
  type heater_control_settle_array_t is array (0 to 3) of heater_control_settle_t;
  function to_word(value : heater_control_settle_t) return std_ulogic_vector;
  function to_heater_control_settle(word : std_ulogic_vector(31 downto 0)) return heater_control_settle_t;

  -- The relay that gives all heaters their power. Open after reset; any trip, the watchdog or the emergency stop opens it until it is closed again.
  constant heater_control_supply_address : unsigned(31 downto 0) := x"F0006074";
  constant heater_control_supply_closed_bit : natural := 0;
  constant heater_control_supply_refused_bit : natural := 1;
  constant heater_control_supply_trip_opened_bit : natural := 4;
  constant heater_control_supply_watchdog_opened_bit : natural := 5;
  constant heater_control_supply_emergency_stop_opened_bit : natural := 6;
  constant heater_control_supply_veto_opened_bit : natural := 7;
  subtype heater_control_supply_key_bits is natural range 31 downto 16;
  type heater_control_supply_t is record
    closed : std_ulogic;
    refused : std_ulogic;
    trip_opened : std_ulogic;
    watchdog_opened : std_ulogic;
    emergency_stop_opened : std_ulogic;
    veto_opened : std_ulogic;
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_supply_key_open : natural := 3042;
  constant heater_control_supply_key_close : natural := 49413;
  function to_word(value : heater_control_supply_t) return std_ulogic_vector;
  function to_heater_control_supply(word : std_ulogic_vector(31 downto 0)) return heater_control_supply_t;

  type heater_control_from_software_t is record
    feed : heater_control_feed_t;
    feed_written : std_ulogic;
    watchdog : heater_control_watchdog_t;
    watchdog_written : std_ulogic;
    sensor_timeout : heater_control_sensor_timeout_t;
    sensor_timeout_written : std_ulogic;
    slot : heater_control_slot_t;
    clear : heater_control_clear_t;
    clear_written : std_ulogic;
    duty : heater_control_duty_array_t;
    minimum_count : heater_control_minimum_count_array_t;
    minimum_count_written : std_ulogic_vector(0 to 3);
    maximum_count : heater_control_maximum_count_array_t;
    maximum_count_written : std_ulogic_vector(0 to 3);
    hot_count : heater_control_hot_count_array_t;
    hot_count_written : std_ulogic_vector(0 to 3);
    settle : heater_control_settle_array_t;
    settle_written : std_ulogic_vector(0 to 3);
    supply : heater_control_supply_t;
    supply_written : std_ulogic;
  end record;

  type heater_control_to_software_t is record
    watchdog : heater_control_watchdog_t;
    sensor_timeout : heater_control_sensor_timeout_t;
    minimum_count : heater_control_minimum_count_array_t;
    maximum_count : heater_control_maximum_count_array_t;
    status : heater_control_status_array_t;
    hot_count : heater_control_hot_count_array_t;
    settle : heater_control_settle_array_t;
    supply : heater_control_supply_t;
  end record;

end package;

package body heater_control_registers_pkg is

  function to_word(value : heater_control_feed_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.key);
  end function;

  function to_heater_control_feed(word : std_ulogic_vector(31 downto 0)) return heater_control_feed_t is
  begin
    return (
      key => unsigned(word(heater_control_feed_key_bits)));
  end function;

  function to_word(value : heater_control_watchdog_t) return std_ulogic_vector is
  begin
    return "000000000000" & std_ulogic_vector(value.ticks);
  end function;

  function to_heater_control_watchdog(word : std_ulogic_vector(31 downto 0)) return heater_control_watchdog_t is
  begin
    return (
      ticks => unsigned(word(heater_control_watchdog_ticks_bits)));
  end function;

  function to_word(value : heater_control_sensor_timeout_t) return std_ulogic_vector is
  begin
    return "000000000000" & std_ulogic_vector(value.ticks);
  end function;

  function to_heater_control_sensor_timeout(word : std_ulogic_vector(31 downto 0)) return heater_control_sensor_timeout_t is
  begin
    return (
      ticks => unsigned(word(heater_control_sensor_timeout_ticks_bits)));
  end function;

  function to_word(value : heater_control_slot_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.cycles);
  end function;

  function to_heater_control_slot(word : std_ulogic_vector(31 downto 0)) return heater_control_slot_t is
  begin
    return (
      cycles => unsigned(word(heater_control_slot_cycles_bits)));
  end function;

  function to_word(value : heater_control_clear_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.key) & "000000000000" & value.channels;
  end function;

  function to_heater_control_clear(word : std_ulogic_vector(31 downto 0)) return heater_control_clear_t is
  begin
    return (
      channels => word(heater_control_clear_channels_bits),
  key => unsigned(word(heater_control_clear_key_bits)));
  end function;

  function to_word(value : heater_control_duty_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.density);
  end function;

  function to_heater_control_duty(word : std_ulogic_vector(31 downto 0)) return heater_control_duty_t is
  begin
    return (
      density => unsigned(word(heater_control_duty_density_bits)));
  end function;

  function to_word(value : heater_control_minimum_count_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_heater_control_minimum_count(word : std_ulogic_vector(31 downto 0)) return heater_control_minimum_count_t is
  begin
    return (
      cycles => unsigned(word(heater_control_minimum_count_cycles_bits)));
  end function;

  function to_word(value : heater_control_maximum_count_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_heater_control_maximum_count(word : std_ulogic_vector(31 downto 0)) return heater_control_maximum_count_t is
  begin
    return (
      cycles => unsigned(word(heater_control_maximum_count_cycles_bits)));
  end function;

  function to_word(value : heater_control_status_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & value.heats_unasked_trip & value.emergency_stop_trip & value.limits_missing_trip & value.too_cold_trip & value.too_hot_trip & value.sensor_stale_trip & value.sensor_invalid_trip & value.watchdog_trip & value.tripped & value.refused & value.settle_locked & value.hot_locked & value.maximum_locked & value.minimum_locked & value.permitted & value.gate;
  end function;

  function to_heater_control_status(word : std_ulogic_vector(31 downto 0)) return heater_control_status_t is
  begin
    return (
      gate => word(heater_control_status_gate_bit),
  permitted => word(heater_control_status_permitted_bit),
  minimum_locked => word(heater_control_status_minimum_locked_bit),
  maximum_locked => word(heater_control_status_maximum_locked_bit),
  hot_locked => word(heater_control_status_hot_locked_bit),
  settle_locked => word(heater_control_status_settle_locked_bit),
  refused => word(heater_control_status_refused_bit),
  tripped => word(heater_control_status_tripped_bit),
  watchdog_trip => word(heater_control_status_watchdog_trip_bit),
  sensor_invalid_trip => word(heater_control_status_sensor_invalid_trip_bit),
  sensor_stale_trip => word(heater_control_status_sensor_stale_trip_bit),
  too_hot_trip => word(heater_control_status_too_hot_trip_bit),
  too_cold_trip => word(heater_control_status_too_cold_trip_bit),
  limits_missing_trip => word(heater_control_status_limits_missing_trip_bit),
  emergency_stop_trip => word(heater_control_status_emergency_stop_trip_bit),
  heats_unasked_trip => word(heater_control_status_heats_unasked_trip_bit));
  end function;

  function to_word(value : heater_control_hot_count_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_heater_control_hot_count(word : std_ulogic_vector(31 downto 0)) return heater_control_hot_count_t is
  begin
    return (
      cycles => unsigned(word(heater_control_hot_count_cycles_bits)));
  end function;

  function to_word(value : heater_control_settle_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.ticks);
  end function;

  function to_heater_control_settle(word : std_ulogic_vector(31 downto 0)) return heater_control_settle_t is
  begin
    return (
      ticks => unsigned(word(heater_control_settle_ticks_bits)));
  end function;

  function to_word(value : heater_control_supply_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.key) & "00000000" & value.veto_opened & value.emergency_stop_opened & value.watchdog_opened & value.trip_opened & "00" & value.refused & value.closed;
  end function;

  function to_heater_control_supply(word : std_ulogic_vector(31 downto 0)) return heater_control_supply_t is
  begin
    return (
      closed => word(heater_control_supply_closed_bit),
  refused => word(heater_control_supply_refused_bit),
  trip_opened => word(heater_control_supply_trip_opened_bit),
  watchdog_opened => word(heater_control_supply_watchdog_opened_bit),
  emergency_stop_opened => word(heater_control_supply_emergency_stop_opened_bit),
  veto_opened => word(heater_control_supply_veto_opened_bit),
  key => unsigned(word(heater_control_supply_key_bits)));
  end function;

end package body;
