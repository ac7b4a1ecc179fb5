-- SPDX-License-Identifier: Apache-2.0
-- The whole chip, as a board sees it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity printer_controller is
  generic (
    -- RAM for the firmware with its data and stack: 32 to 256 KiB.
    memory_size_bytes : positive := 106496;
    -- X Y Z E0 E1.
    axes : positive range 1 to 8 := 5;
    -- Segments that wait in the step generator; a power of two.
    queue_depth : positive := 32;
    -- Temperature sensors, each with its heater: hotend, bed.
    heaters : positive range 1 to 4 := 2;
    -- A debugger can halt the processor and reach the memory over JTAG.
    has_debug : boolean := false;
    -- The processor has extension Zbb.
    has_zbb : boolean := false;
    -- For devices whose block RAM can clear what it shows (ECP5): faster.
    memory_shows_clear : boolean := false;
    -- Of `clk`, from which software takes all times.
    clock_frequency_hz : positive range 4_000_000 to 100_000_000 := 50_000_000
  );
  port (
    -- The one clock, 4 to 100 MHz.
    clk : in std_ulogic;
    -- Synchronous.
    reset : in std_ulogic;
    -- Serial line, idle high; asynchronous.
    receive : in std_ulogic;
    transmit : out std_ulogic;
    -- Motor drivers, one bit per axis, all active high.
    step : out std_ulogic_vector(axes - 1 downto 0);
    direction : out std_ulogic_vector(axes - 1 downto 0);
    motor_enable : out std_ulogic_vector(axes - 1 downto 0);
    -- End stop switches and probes, one bit per input; asynchronous.
    end_stop : in std_ulogic_vector(7 downto 0);
    -- Stops motion and heat without software; asynchronous.
    emergency_stop : in std_ulogic;
    -- A rising edge starts a segment that waits for it, the same for several chips; asynchronous.
    motion_start : in std_ulogic;
    -- Per sensor: three resistor pins (high-impedance where not enabled) and the capacitor's level.
    sensor_drive_enable : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_drive_level : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_discharging : out std_ulogic_vector(heaters - 1 downto 0);
    sensor_sense : in std_ulogic_vector(heaters - 1 downto 0);
    heater_gate : out std_ulogic_vector(heaters - 1 downto 0);
    -- Relay or contactor in front of all heaters, active high; veto from outside the chip, asynchronous.
    heater_supply : out std_ulogic;
    heater_supply_veto : in std_ulogic := '0';
    fan_gate : out std_ulogic;
    -- Indicator lamp: the heaters are cut off until software clears the cause.
    fault : out std_ulogic;
    -- JTAG, asynchronous; of no effect without `has_debug`.
    tck : in std_ulogic := '0';
    tms : in std_ulogic := '0';
    tdi : in std_ulogic := '0';
    tdo : out std_ulogic;
    -- The processor waits for an interrupt.
    sleeping : out std_ulogic
  );
end entity;

architecture rtl of printer_controller is
begin

  core : entity work.printer_core
    generic map (
      memory_size_bytes => memory_size_bytes, axes => axes, queue_depth => queue_depth,
      heaters => heaters, has_debug => has_debug, has_zbb => has_zbb,
      memory_shows_clear => memory_shows_clear)
    port map (
      -- One clock for all parts, never gated.
      clocks.free_running => clk,
      clocks.processor => clk,
      clocks.registers => clk,
      clocks.axes => clk,
      clocks.peripherals => clk,
      at_rest => open,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32),
      software_stepping => '0',
      retired => open,
      reset => reset,
      receive => receive,
      transmit => transmit,
      step => step,
      direction => direction,
      motor_enable => motor_enable,
      end_stop => end_stop,
      emergency_stop => emergency_stop,
      motion_start => motion_start,
      sensor_drive_enable => sensor_drive_enable,
      sensor_drive_level => sensor_drive_level,
      sensor_discharging => sensor_discharging,
      sensor_sense => sensor_sense,
      heater_gate => heater_gate,
      heater_supply => heater_supply,
      heater_supply_veto => heater_supply_veto,
      fan_gate => fan_gate,
      fault => fault,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo,
      sleeping => sleeping);

end architecture;
