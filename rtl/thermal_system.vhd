-- SPDX-License-Identifier: Apache-2.0
-- Heat: the temperature sensors, the heaters that they guard, and the fan.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.clocks_pkg.all;
use work.thermal_pkg.all;

entity thermal_system is
  generic (
    -- Temperature sensors, each with its heater.
    heaters : positive range 1 to 4
  );
  port (
    clocks : in clocks_t;
    resets : in resets_t;
    clock_frequency_hz : in unsigned(31 downto 0);
    converter_request : in bus_request_t;
    converter_response : out bus_response_t;
    heaters_request : in bus_request_t;
    heaters_response : out bus_response_t;
    fan_request : in bus_request_t;
    fan_response : out bus_response_t;
    -- The chip's pins; the inputs are asynchronous.
    sensor_drive_enable : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_drive_level : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_discharging : out std_ulogic_vector(heaters - 1 downto 0);
    sensor_sense : in std_ulogic_vector(heaters - 1 downto 0);
    heater_gate : out std_ulogic_vector(heaters - 1 downto 0);
    heater_supply : out std_ulogic;
    heater_supply_veto : in std_ulogic;
    emergency_stop : in std_ulogic;
    fan_gate : out std_ulogic;
    heater_interrupt : out std_ulogic;
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of thermal_system is

  signal readings : sensor_reading_array_t(0 to heaters - 1);
  signal more_charges : unsigned(7 downto 0);
  signal limits_locked : std_ulogic;
  signal converter_rests, heater_control_rests : std_ulogic;

begin

  at_rest <= converter_rests and heater_control_rests;

  sensors : entity work.temperature_converter
    generic map (channels => heaters)
    port map (
      clk => clocks.peripherals,
      always_clk => clocks.free_running,
      bus_clk => clocks.registers,
      clock_frequency_hz => clock_frequency_hz,
      reset => resets.peripherals,
      request => converter_request,
      response => converter_response,
      drive_enable => sensor_drive_enable,
      drive_level => sensor_drive_level,
      discharging => sensor_discharging,
      sense => sensor_sense,
      readings => readings,
      more_charges => more_charges,
      limits_locked => limits_locked,
      at_rest => converter_rests);

  heat : entity work.heater_control
    generic map (channels => heaters)
    port map (
      clk => clocks.peripherals,
      always_clk => clocks.free_running,
      bus_clk => clocks.registers,
      clock_frequency_hz => clock_frequency_hz,
      reset => resets.peripherals,
      request => heaters_request,
      response => heaters_response,
      readings => readings,
      more_charges => more_charges,
      limits_locked => limits_locked,
      emergency_stop => emergency_stop,
      veto => heater_supply_veto,
      gates => heater_gate,
      supply => heater_supply,
      interrupt => heater_interrupt,
      at_rest => heater_control_rests);

  cooling_fan : entity work.fan
    port map (
      clk => clocks.free_running,
      bus_clk => clocks.registers,
      reset => resets.free_running,
      request => fan_request,
      response => fan_response,
      level => fan_gate);

end architecture;
