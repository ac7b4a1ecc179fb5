-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `heater_control`. Generated from rtl/thermal/heater_control.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package heater_control_registers_pkg is

  constant heater_control_address : unsigned(31 downto 0) := x"F0006000";

  -- Feeds the watchdog, by two keys in turn. Anything else, the same key again or `first` too early trips all channels.
  constant heater_control_feed_address : unsigned(31 downto 0) := x"F0006000";
  type heater_control_feed_t is record
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_feed_key_second : natural := 24301;
  constant heater_control_feed_key_first : natural := 65261;

  -- Time without a complete feed after which all gates close.
  constant heater_control_watchdog_address : unsigned(31 downto 0) := x"F0006004";
  type heater_control_watchdog_t is record
    ticks : unsigned(19 downto 0);
  end record;

  -- Time without a valid conversion after which a channel's gate closes for good.
  constant heater_control_sensor_timeout_address : unsigned(31 downto 0) := x"F0006008";
  type heater_control_sensor_timeout_t is record
    ticks : unsigned(19 downto 0);
  end record;

  -- Shortest time that a gate keeps its level when it is modulated.
  constant heater_control_slot_address : unsigned(31 downto 0) := x"F000600C";
  type heater_control_slot_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Clears the trips of channels whose duty is 0, and `refused` of all channels named.
  constant heater_control_clear_address : unsigned(31 downto 0) := x"F0006010";
  type heater_control_clear_t is record
    channels : std_ulogic_vector(3 downto 0);
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_clear_key_clear_trips : natural := 49642;

  -- How much of the time the channel heats. A request: the hardware decides.
  constant heater_control_duty_address : unsigned(31 downto 0) := x"F0006014";  -- of the first
  type heater_control_duty_t is record
    density : unsigned(15 downto 0);
  end record;
  type heater_control_duty_array_t is array (0 to 3) of heater_control_duty_t;

  -- Smallest thermistor count at which the channel may heat: the cut-off temperature. Locks when written, and the converter's settings with it.
  constant heater_control_minimum_count_address : unsigned(31 downto 0) := x"F0006024";  -- of the first
  type heater_control_minimum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_minimum_count_array_t is array (0 to 3) of heater_control_minimum_count_t;

  -- Largest thermistor count at which the channel may heat: too cold or open. Locks when written.
  constant heater_control_maximum_count_address : unsigned(31 downto 0) := x"F0006034";  -- of the first
  type heater_control_maximum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_maximum_count_array_t is array (0 to 3) of heater_control_maximum_count_t;

  -- What the channel does, and what tripped it since its trips were cleared.
  constant heater_control_status_address : unsigned(31 downto 0) := x"F0006044";  -- of the first
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

  -- Below this thermistor count heat that is not asked for is a trip. Locks when written.
  constant heater_control_hot_count_address : unsigned(31 downto 0) := x"F0006054";  -- of the first
  type heater_control_hot_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_hot_count_array_t is array (0 to 3) of heater_control_hot_count_t;

  -- Time for which a gate must be closed before rising heat is not its own. Locks when written.
  constant heater_control_settle_address : unsigned(31 downto 0) := x"F0006064";  -- of the first
  type heater_control_settle_t is record
    ticks : unsigned(23 downto 0);
  end record;
  type heater_control_settle_array_t is array (0 to 3) of heater_control_settle_t;

  -- The relay that gives all heaters their power. Open after reset; any trip, the watchdog or the emergency stop opens it until it is closed again.
  constant heater_control_supply_address : unsigned(31 downto 0) := x"F0006074";
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
