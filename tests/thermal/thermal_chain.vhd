-- SPDX-License-Identifier: Apache-2.0
-- Temperature converter and heater control wired as in the chip, on one bus, to test the whole chain.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.thermal_pkg.all;

entity thermal_chain is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    clock_frequency_hz : in unsigned(31 downto 0);
    -- Bit 12 of the address selects one of the two peripherals.
    request : in bus_request_t;
    response : out bus_response_t;
    sense : in std_ulogic_vector(1 downto 0);
    drive_enable : out std_ulogic_vector(5 downto 0);
    drive_level : out std_ulogic_vector(5 downto 0);
    gates : out std_ulogic_vector(1 downto 0);
    supply : out std_ulogic
  );
end entity;

architecture rtl of thermal_chain is

  signal converter_request, heater_request : bus_request_t;
  signal converter_response, heater_response : bus_response_t;
  signal more_charges : unsigned(7 downto 0);
  signal limits_locked : std_ulogic;
  signal readings : sensor_reading_array_t(0 to 1);

begin

  select_peripheral : process (all)
  begin
    converter_request <= request;
    heater_request <= request;
    converter_request.strobe <= request.strobe and request.address(12);
    heater_request.strobe <= request.strobe and not request.address(12);
    response.acknowledge <= converter_response.acknowledge or heater_response.acknowledge;
    response.error <= converter_response.error or heater_response.error;
    response.data <= converter_response.data or heater_response.data;
  end process;

  converter : entity work.temperature_converter
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, clock_frequency_hz => clock_frequency_hz,
      reset => reset, request => converter_request, response => converter_response,
      drive_enable => drive_enable, drive_level => drive_level, discharging => open, sense => sense,
      readings => readings, more_charges => more_charges, limits_locked => limits_locked);

  heaters : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => clock_frequency_hz, reset => reset,
      request => heater_request, response => heater_response, readings => readings,
      more_charges => more_charges, limits_locked => limits_locked, emergency_stop => '0', veto => '0',
      gates => gates, supply => supply, interrupt => open);

end architecture;
