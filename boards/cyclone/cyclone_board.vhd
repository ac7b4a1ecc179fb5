-- SPDX-License-Identifier: Apache-2.0
-- The chip on a board with a Cyclone: clock, reset, clock watch, and outputs that are safe from power-up on.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- A board's top entity adds its pins' names. See README.md.
entity cyclone_board is
  generic (
    -- As Quartus calls it.
    device_family : string;
    reference_clock_hz : positive := 50_000_000;
    -- The chip's clock is the reference multiplied and divided by these.
    multiply : positive := 1;
    divide : positive := 1;
    -- Clocks of `watch_clk` without a sign of the chip's clock after which the heaters' supply opens.
    patience_clocks : positive range 4 to 4095 := 1024;
    -- Of the pins that enable the motor drivers.
    enable_level : std_ulogic := '0';
    -- The fifth motor is a second one of Z, not E1.
    has_second_z : boolean := false;
    -- Of the chip's memory: of at most three binary digits 1.
    memory_size_bytes : positive := 106496;
    has_debug : boolean := false;
    has_zbb : boolean := false
  );
  port (
    reference_clk : in std_ulogic;
    -- Of another oscillator.
    watch_clk : in std_ulogic;
    receive : in std_ulogic;
    transmit : out std_ulogic;
    -- Fault, busy, five motors, a blink that shows the clock.
    led : out std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    -- X Y Z E0 E1; motor drivers are enabled by `enable_level`.
    step : out std_ulogic_vector(4 downto 0);
    direction : out std_ulogic_vector(4 downto 0);
    motor_enable_pin : out std_ulogic_vector(4 downto 0);
    end_stop : in std_ulogic_vector(7 downto 0);
    -- Hotend, bed.
    heater_gate : out std_ulogic_vector(1 downto 0);
    heater_supply : out std_ulogic;
    fan_gate : out std_ulogic;
    -- Three resistors of each sensor, driven or left open, and its capacitor's level.
    sensor_drive_enable : out std_ulogic_vector(5 downto 0);
    sensor_drive_level : out std_ulogic_vector(5 downto 0);
    sensor_sense : in std_ulogic_vector(1 downto 0);
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic
  );
end entity;

architecture rtl of cyclone_board is

  -- phase_locked_loop.v
  component phase_locked_loop is
    generic (
      device_family : string;
      reference_period_ps : positive;
      multiply : positive;
      divide : positive
    );
    port (
      reference_clk : in std_ulogic;
      clk : out std_ulogic;
      -- The clock is steady.
      locked : out std_ulogic
    );
  end component;

  constant reference_period_ps : positive := 1_000_000 / (reference_clock_hz / 1_000_000);
  constant clock_frequency_hz : positive := reference_clock_hz / divide * multiply;

  signal clk, locked : std_ulogic;
  -- A Cyclone's registers hold these values after configuration.
  signal reset_done : std_ulogic_vector(15 downto 0) := (others => '0');
  signal blink : unsigned(24 downto 0) := (others => '0');
  signal step_level, direction_level, motor_enable : std_ulogic_vector(4 downto 0);
  signal heater_level : std_ulogic_vector(1 downto 0);
  signal drive_enable : std_ulogic_vector(5 downto 0);
  signal fan_level, transmit_level : std_ulogic;
  signal supply_closed, supply_wanted, supply_veto : std_ulogic;
  -- The last registers before the pins. What they hold here they hold after configuration.
  signal step_pin, direction_pin : std_ulogic_vector(4 downto 0) := (others => '0');
  signal motor_enable_pin_level : std_ulogic_vector(4 downto 0) := (others => not enable_level);
  signal heater_pin : std_ulogic_vector(1 downto 0) := (others => '0');
  signal fan_pin : std_ulogic := '0';
  signal released, fault, sleeping : std_ulogic;

begin

  frequency_is_exact : assert reference_clock_hz mod 1_000_000 = 0 and reference_clock_hz mod divide = 0
    report "the clock's frequency would be rounded" severity failure;

  clock : component phase_locked_loop
    generic map (
      device_family => device_family, reference_period_ps => reference_period_ps,
      multiply => multiply, divide => divide)
    port map (reference_clk => reference_clk, clk => clk, locked => locked);

  wait_for_clock : process
  begin
    wait until rising_edge(clk);
    reset_done <= reset_done(14 downto 0) & locked;
    blink <= blink + 1;
  end process;
  released <= reset_done(15);

  watch_clock : entity work.clock_watch
    generic map (patience_clocks => patience_clocks)
    port map (
      clk => clk,
      watch_clk => watch_clk,
      wanted => supply_wanted,
      closed => heater_supply,
      veto => supply_veto);

  chip : entity work.printer_controller
    generic map (
      memory_size_bytes => memory_size_bytes, axes => 5, heaters => 2, has_debug => has_debug,
      has_zbb => has_zbb, clock_frequency_hz => clock_frequency_hz)
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
      -- A Cyclone cannot hold an open input low, and a start must not come by itself.
      motion_start => '0',
      sensor_drive_enable => drive_enable,
      sensor_drive_level => sensor_drive_level,
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

  -- Before its reset the chip's registers may hold anything, which no pin shows. All is a clock later here.
  drive_pins : process
  begin
    wait until rising_edge(clk);
    if released then
      step_pin <= step_level;
      direction_pin <= direction_level;
      for axis in motor_enable'range loop
        motor_enable_pin_level(axis) <= enable_level when motor_enable(axis) else not enable_level;
      end loop;
      if has_second_z then
        step_pin(4) <= step_level(2);
        direction_pin(4) <= direction_level(2);
        motor_enable_pin_level(4) <= enable_level when motor_enable(2) else not enable_level;
      end if;
      heater_pin <= heater_level;
      fan_pin <= fan_level;
    else
      step_pin <= (others => '0');
      direction_pin <= (others => '0');
      motor_enable_pin_level <= (others => not enable_level);
      heater_pin <= (others => '0');
      fan_pin <= '0';
    end if;
  end process;

  step <= step_pin;
  direction <= direction_pin;
  motor_enable_pin <= motor_enable_pin_level;
  heater_gate <= heater_pin;
  fan_gate <= fan_pin;
  supply_wanted <= supply_closed and released;
  transmit <= transmit_level or not released;

  open_resistors : for pin in drive_enable'range generate
    sensor_drive_enable(pin) <= drive_enable(pin) and released;
  end generate;

  led <= (0 => fault, 1 => not sleeping, 6 downto 2 => motor_enable, 7 => blink(24));

end architecture;
