-- SPDX-License-Identifier: Apache-2.0
-- The pins of the ULX3S's top entity are safe from power-up on.

library ieee;
use ieee.std_logic_1164.all;

entity ulx3s_tb is
end entity;

architecture simulation of ulx3s_tb is

  signal reference_clk, transmit : std_ulogic;
  signal step, direction, motor_enable_n : std_ulogic_vector(4 downto 0);
  signal heater_gate : std_ulogic_vector(1 downto 0);
  signal heater_supply, fan_gate, radio_enable : std_ulogic;
  signal sensor_resistor : std_logic_vector(5 downto 0);

begin

  board : entity work.ulx3s
    port map (
      clk_25mhz => reference_clk,
      ftdi_txd => '1', ftdi_rxd => transmit, ftdi_ndtr => '0', led => open,
      wifi_en => radio_enable, wifi_gpio0 => open,
      emergency_stop => '0', motion_start => '0', step => step, direction => direction,
      motor_enable_n => motor_enable_n,
      end_stop => x"00", heater_gate => heater_gate, heater_supply => heater_supply, fan_gate => fan_gate,
      sensor_resistor => sensor_resistor, sensor_sense => "00",
      tck => '1', tms => '1', tdi => '1', tdo => open);

  sensor_resistor <= (others => 'L');

  -- Until its reset has ended the chip's registers may hold anything; its properties do not hold then.
  disturb : process
    alias released is << signal board.released : std_ulogic >>;
    alias heater_level is << signal board.heater_level : std_ulogic_vector(1 downto 0) >>;
    alias supply_closed is << signal board.supply_closed : std_ulogic >>;
    alias fan_level is << signal board.fan_level : std_ulogic >>;
    alias motor_enable is << signal board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias step_level is << signal board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias direction_level is << signal board.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias drive_enable is << signal board.drive_enable : std_ulogic_vector(5 downto 0) >>;
    alias transmit_level is << signal board.transmit_level : std_ulogic >>;
  begin
    heater_level <= force "11";
    supply_closed <= force '1';
    fan_level <= force '1';
    motor_enable <= force "11111";
    step_level <= force "11111";
    direction_level <= force "11111";
    drive_enable <= force "111111";
    transmit_level <= force '0';
    wait for 35 us;
    heater_level <= release;
    supply_closed <= release;
    fan_level <= release;
    motor_enable <= release;
    step_level <= release;
    direction_level <= release;
    drive_enable <= release;
    transmit_level <= release;
    not_yet : assert released = '0' report "the reset is too short" severity error;
    wait for 15 us;
    ends : assert released = '1' report "the reset does not end" severity error;
    wait;
  end process;

  radio : process
  begin
    wait for 1 ns;
    is_off : assert radio_enable = '0' report "the radio module is not in reset" severity error;
    wait on radio_enable;
    stays_off : assert false report "the radio module comes out of its reset" severity error;
  end process;

  -- The oscillator that watches the clock is inside the FPGA.
  pins : entity work.safe_pins
    generic map (reference_period => 40 ns, watch_period => 413 ns)
    port map (
      reference_clk => reference_clk, watch_clk => open, transmit => transmit, step => step,
      direction => direction, motor_enable_n => motor_enable_n, heater_gate => heater_gate,
      heater_supply => heater_supply, fan_gate => fan_gate, sensor_resistor => sensor_resistor);

end architecture;
