-- SPDX-License-Identifier: Apache-2.0
-- The chip on a Radiona ULX3S: which of its pins goes where, with 3.3 V everywhere. See README.md.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ulx3s is
  generic (
    -- Of the phase-locked loop's output; co-simulation has a slower one.
    clock_frequency_hz : positive := 50_000_000;
    -- Of the chip's memory.
    memory_size_bytes : positive := 106496;
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
    -- Its DTR: low while a host that raises DTR has the port open.
    ftdi_ndtr : in std_ulogic;
    -- Low keeps the board's radio module in reset: it could load another bitstream.
    wifi_en : out std_ulogic;
    -- High: where it is not in reset, its old firmware takes the board over at a low level.
    wifi_gpio0 : out std_ulogic;
    -- Fault, busy, five motors, a blink that shows the clock.
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

architecture rtl of ulx3s is

  -- clock_50mhz.v
  component clock_50mhz is
    port (
      clk_25mhz : in std_ulogic;
      clk : out std_ulogic;
      locked : out std_ulogic
    );
  end component;

  -- output_register.v: a register in the pad, low or high after configuration.
  component output_register is
    port (
      clk : in std_ulogic;
      level : in std_ulogic;
      pin : out std_ulogic
    );
  end component;

  component output_register_high is
    port (
      clk : in std_ulogic;
      level : in std_ulogic;
      pin : out std_ulogic
    );
  end component;

  -- internal_oscillator.v
  component internal_oscillator is
    port (
      clk : out std_ulogic
    );
  end component;

  -- 2 ms, two frames at 9600 baud: the bridge has sent all that it has.
  constant quiet_clocks : positive := clock_frequency_hz / 500;
  -- 20 ms, as long as the simulated port: a break at any rate.
  constant break_clocks : positive := clock_frequency_hz / 50;

  signal clk, locked : std_ulogic;
  -- From the host, with a break behind one that has closed its port.
  signal receive : std_ulogic;
  signal reset_done : std_ulogic_vector(15 downto 0) := (others => '0');
  signal released : std_ulogic;
  -- The chip's pins, a clock before the board's. Before its reset it may hold anything, which no pin shows.
  signal step_level, direction_level, motor_enable : std_ulogic_vector(4 downto 0);
  signal heater_level : std_ulogic_vector(1 downto 0);
  signal fan_level, transmit_level : std_ulogic;
  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal watch_clk, supply_closed, supply_wanted, supply_veto : std_ulogic;
  signal fault, sleeping : std_ulogic;
  signal blink : unsigned(24 downto 0) := (others => '0');

begin

  clock : component clock_50mhz
    port map (clk_25mhz => clk_25mhz, clk => clk, locked => locked);

  oscillator : component internal_oscillator
    port map (clk => watch_clk);

  -- A clock that stands still opens the supply within 64 clocks of the oscillator, 0.03 ms.
  watch_clock : entity work.clock_watch
    port map (
      clk => clk,
      watch_clk => watch_clk,
      wanted => supply_wanted,
      closed => heater_supply,
      veto => supply_veto);

  wait_for_clock : process
  begin
    wait until rising_edge(clk);
    reset_done <= reset_done(14 downto 0) & locked;
    blink <= blink + 1;
  end process;
  released <= reset_done(15);

  watch_port : entity work.port_watch
    generic map (quiet_clocks => quiet_clocks, break_clocks => break_clocks)
    port map (clk => clk, line => ftdi_txd, closed => ftdi_ndtr, receive => receive);

  chip : entity work.printer_controller
    generic map (
      memory_size_bytes => memory_size_bytes, axes => 5, heaters => 2, has_debug => has_debug,
      has_zbb => has_zbb, memory_shows_clear => true, clock_frequency_hz => clock_frequency_hz)
    port map (
      clk => clk,
      reset => not released,
      receive => receive,
      transmit => transmit_level,
      step => step_level,
      direction => direction_level,
      motor_enable => motor_enable,
      end_stop => end_stop,
      emergency_stop => emergency_stop,
      motion_start => motion_start,
      sensor_drive_enable => drive_enable,
      sensor_drive_level => drive_level,
      sensor_discharging => open,
      sensor_sense => sensor_sense,
      heater_gate => heater_level,
      heater_supply => supply_closed,
      heater_supply_veto => supply_veto,
      fan_gate => fan_level,
      fault => fault,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo,
      sleeping => sleeping);

  -- What drives power leaves the chip from registers in the pads, all a clock later: step and direction keep
  -- their distance whatever the layout.
  each_axis : for axis in step'range generate
    step_register : component output_register
      port map (clk => clk, level => step_level(axis) and released, pin => step(axis));
    direction_register : component output_register
      port map (clk => clk, level => direction_level(axis) and released, pin => direction(axis));
    enable_register : component output_register_high
      port map (clk => clk, level => not (motor_enable(axis) and released), pin => motor_enable_n(axis));
  end generate;
  each_heater : for heater in heater_gate'range generate
    gate_register : component output_register
      port map (clk => clk, level => heater_level(heater) and released, pin => heater_gate(heater));
  end generate;
  fan_register : component output_register
    port map (clk => clk, level => fan_level and released, pin => fan_gate);
  supply_wanted <= supply_closed and released;
  ftdi_rxd <= transmit_level or not released;

  drive_resistors : for pin in sensor_resistor'range generate
    sensor_resistor(pin) <= drive_level(pin) when drive_enable(pin) and released else 'Z';
  end generate;

  led <= (0 => fault, 1 => not sleeping, 6 downto 2 => motor_enable, 7 => blink(24));
  wifi_en <= '0';
  wifi_gpio0 <= '1';

end architecture;
