-- SPDX-License-Identifier: Apache-2.0
-- The chip on a Radiona ULX3S: which of its pins goes where, with 3.3 V everywhere. See README.md.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ulx3s is
  generic (
    -- With the debug port. Its clock has not been tried.
    has_debug : boolean := false;
    -- The processor has extension Zbb.
    has_zbb : boolean := false
  );
  port (
    clk_25mhz : in std_ulogic;
    -- Serial line of the USB bridge, named from its side.
    ftdi_txd : in std_ulogic;
    ftdi_rxd : out std_ulogic;
    -- High, or the board's radio module takes over.
    wifi_gpio0 : out std_ulogic;
    led : out std_ulogic_vector(7 downto 0);
    -- Low through a closed switch, high by its pull: stops when the switch opens or its wire breaks.
    emergency_stop : in std_ulogic;
    -- From the chip that starts several at once.
    motion_start : in std_ulogic;
    -- X Y Z E0 E1; motor drivers are enabled by a low level.
    step : out std_ulogic_vector(4 downto 0);
    direction : out std_ulogic_vector(4 downto 0);
    motor_enable_n : out std_ulogic_vector(4 downto 0);
    end_stop : in std_ulogic_vector(7 downto 0);
    -- Hotend, bed.
    heater_gate : out std_ulogic_vector(1 downto 0);
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

architecture rtl of ulx3s is

  -- clock_50mhz.v
  component clock_50mhz is
    port (
      clk_25mhz : in std_ulogic;
      clk : out std_ulogic;
      locked : out std_ulogic
    );
  end component;

  constant clock_frequency_hz : positive := 50_000_000;

  signal clk, locked : std_ulogic;
  signal reset_done : std_ulogic_vector(15 downto 0) := (others => '0');
  signal motor_enable : std_ulogic_vector(4 downto 0);
  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal fault, sleeping : std_ulogic;

begin

  clock : component clock_50mhz
    port map (clk_25mhz => clk_25mhz, clk => clk, locked => locked);

  wait_for_clock : process
  begin
    wait until rising_edge(clk);
    reset_done <= reset_done(14 downto 0) & locked;
  end process;

  chip : entity work.printer_controller
    generic map (axes => 5, heaters => 2, has_debug => has_debug, has_zbb => has_zbb)
    port map (
      clk => clk,
      processor_clk => clk,
      bus_clk => clk,
      axes_clk => clk,
      peripheral_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32),
      reset => not reset_done(15),
      receive => ftdi_txd,
      transmit => ftdi_rxd,
      step => step,
      direction => direction,
      motor_enable => motor_enable,
      end_stop => end_stop,
      emergency_stop => emergency_stop,
      motion_start => motion_start,
      sensor_drive_enable => drive_enable,
      sensor_drive_level => drive_level,
      sensor_discharging => open,
      sensor_sense => sensor_sense,
      heater_gate => heater_gate,
      fan_gate => fan_gate,
      fault => fault,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo,
      sleeping => sleeping,
      retired => open,
      processor_at_rest => open,
      bus_at_rest => open,
      axes_at_rest => open,
      peripherals_at_rest => open
    );

  motor_enable_n <= not motor_enable;
  drive_resistors : for pin in sensor_resistor'range generate
    sensor_resistor(pin) <= drive_level(pin) when drive_enable(pin) else 'Z';
  end generate;

  led <= (0 => fault, 1 => not sleeping, 6 downto 2 => motor_enable, 7 => locked);
  wifi_gpio0 <= '1';

end architecture;
