-- SPDX-License-Identifier: Apache-2.0
-- The chip on a Terasic DE2-70 with the pins of the RepRap of 2012: two Z motors, RESET as enable.

library ieee;
use ieee.std_logic_1164.all;

entity de2_70_reprap_2012 is
  generic (
    -- Of the board's oscillator; co-simulation has a slower one.
    reference_clock_hz : positive := 50_000_000;
    -- Of the chip's memory: of at most three binary digits 1.
    memory_size_bytes : positive := 106496;
    -- With the debug port. Its clock has not been tried.
    has_debug : boolean := false;
    -- The processor has extension Zbb.
    has_zbb : boolean := false
  );
  port (
    clock_50mhz : in std_ulogic;
    -- Of the video decoders, from an oscillator of its own.
    clock_28mhz : in std_ulogic;
    -- Serial line, named from the FPGA's side.
    uart_rxd : in std_ulogic;
    uart_txd : out std_ulogic;
    led : out std_ulogic_vector(7 downto 0);
    -- Low through a closed switch, high by its pull: stops when the switch opens or its wire breaks.
    emergency_stop : in std_ulogic;
    -- X Y Za E Zb; a motor driver in reset has no current.
    step : out std_ulogic_vector(4 downto 0);
    direction : out std_ulogic_vector(4 downto 0);
    motor_reset_n : out std_ulogic_vector(4 downto 0);
    -- X Y Z.
    end_stop : in std_ulogic_vector(2 downto 0);
    -- Hotend, bed.
    heater_gate : out std_ulogic_vector(1 downto 0);
    -- Relay or contactor in front of all heaters.
    heater_supply : out std_ulogic;
    fan_gate : out std_ulogic;
    -- Three resistors of each sensor, driven or left open, and its capacitor's level.
    sensor_resistor : out std_logic_vector(5 downto 0);
    sensor_sense : in std_ulogic_vector(1 downto 0);
    -- JTAG of the chip (not of the FPGA), for an external adapter; pulled up, so at rest without one.
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic
  );
end entity;

architecture rtl of de2_70_reprap_2012 is

  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal switches : std_ulogic_vector(7 downto 0);

begin

  board : entity work.cyclone_board
    generic map (
      device_family => "Cyclone II", enable_level => '1', has_second_z => true,
      reference_clock_hz => reference_clock_hz, memory_size_bytes => memory_size_bytes,
      has_debug => has_debug, has_zbb => has_zbb)
    port map (
      reference_clk => clock_50mhz,
      watch_clk => clock_28mhz,
      receive => uart_rxd,
      transmit => uart_txd,
      led => led,
      emergency_stop => emergency_stop,
      step => step,
      direction => direction,
      motor_enable_pin => motor_reset_n,
      end_stop => switches,
      heater_gate => heater_gate,
      heater_supply => heater_supply,
      fan_gate => fan_gate,
      sensor_drive_enable => drive_enable,
      sensor_drive_level => drive_level,
      sensor_sense => sensor_sense,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo);

  -- Those that there were not rest like open ones.
  switches <= (2 => end_stop(2), 1 => end_stop(1), 0 => end_stop(0), others => '1');

  drive_resistors : for pin in sensor_resistor'range generate
    sensor_resistor(pin) <= drive_level(pin) when drive_enable(pin) else 'Z';
  end generate;

end architecture;
