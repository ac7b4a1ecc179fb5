-- SPDX-License-Identifier: Apache-2.0
-- The whole chip: processor and memory, and on the bus everything that must be exact.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.end_stops_registers_pkg.all;
use work.fan_registers_pkg.all;
use work.heater_control_registers_pkg.all;
use work.identity_registers_pkg.all;
use work.interrupts_pkg.all;
use work.step_generator_registers_pkg.all;
use work.step_pins_registers_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;
use work.timer_registers_pkg.all;
use work.uart_registers_pkg.all;

entity printer_controller is
  generic (
    -- RAM for the firmware with its data and stack: 32 to 256 KiB, a power of two or three quarters of one.
    memory_size_bytes : positive := 98304;
    -- X Y Z E0 E1.
    axes : positive range 1 to 8 := 5;
    -- Segments that wait in the step generator; a power of two.
    queue_depth : positive := 32;
    -- Temperature sensors, each with its heater: hotend, bed.
    heaters : positive range 1 to 4 := 2;
    -- A debugger can halt the processor and reach the memory over JTAG; the processor's clock never rests.
    has_debug : boolean := false;
    -- The processor has extension Zbb.
    has_zbb : boolean := false
  );
  port (
    -- The one clock, 4 to 100 MHz.
    clk : in std_ulogic;
    -- The same clock for parts that are often at rest: processor and memory; the registers of the bus but
    -- for the timer's; the step generator between steps; uart, end stops and heaters. A model may leave out
    -- their edges while the outputs `..._at_rest` are high, since they change nothing, but for the edge after
    -- an input has changed. On a board all are `clk`.
    processor_clk : in std_ulogic;
    bus_clk : in std_ulogic;
    axes_clk : in std_ulogic;
    peripheral_clk : in std_ulogic;
    -- Its frequency: a constant on a board, chosen for each run in co-simulation.
    clock_frequency_hz : in unsigned(31 downto 0);
    -- Software may drive the step and direction pins: '0' on a board, chosen for each run in co-simulation.
    software_stepping : in std_ulogic;
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
    -- Relay or contactor in front of all heaters, active high; something outside forbids it, asynchronous.
    heater_supply : out std_ulogic;
    heater_supply_veto : in std_ulogic := '0';
    fan_gate : out std_ulogic;
    -- A lamp: heat has been cut off until software clears the cause.
    fault : out std_ulogic;
    -- JTAG, asynchronous; of no effect without `has_debug`.
    tck : in std_ulogic := '0';
    tms : in std_ulogic := '0';
    tdi : in std_ulogic := '0';
    tdo : out std_ulogic;
    -- The processor waits for an interrupt; it has completed an instruction.
    sleeping : out std_ulogic;
    retired : out std_ulogic;
    processor_at_rest : out std_ulogic;
    bus_at_rest : out std_ulogic;
    axes_at_rest : out std_ulogic;
    peripherals_at_rest : out std_ulogic
  );
end entity;

architecture rtl of printer_controller is

  constant base_addresses : bus_address_array_t(0 to 8) := (
    identity_address, uart_address, timer_address, step_generator_address, end_stops_address,
    temperature_converter_address, heater_control_address, fan_address, step_pins_address);

  constant identity_slave : natural := 0;
  constant uart_slave : natural := 1;
  constant timer_slave : natural := 2;
  constant step_generator_slave : natural := 3;
  constant end_stops_slave : natural := 4;
  constant temperature_converter_slave : natural := 5;
  constant heater_control_slave : natural := 6;
  constant fan_slave : natural := 7;
  constant step_pins_slave : natural := 8;

  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t;
  signal requests : bus_request_array_t(base_addresses'range);
  signal responses : bus_response_array_t(base_addresses'range);

  signal chip_reset : std_ulogic := '0';

  signal timer_interrupt : std_ulogic;
  signal uart_receive_interrupt, uart_transmit_interrupt : std_ulogic;
  signal queue_interrupt, stop_interrupt : std_ulogic;
  signal heater_interrupt : std_ulogic;
  signal interrupts : std_ulogic_vector(31 downto 16);

  signal generated_step, generated_direction : std_ulogic_vector(axes - 1 downto 0);
  signal generator_idle : std_ulogic;

  -- Each clock has its own, so that nothing behind the registers of a clock at rest is driven by another.
  signal reset_registered, processor_reset, axes_reset, peripheral_reset : std_ulogic := '1';
  signal processor_rests, axes_rest, step_pins_rest, timer_alarm : std_ulogic;
  signal uart_rests, end_stops_rest, converter_rests, heater_control_rests : std_ulogic;

  signal end_stops_triggered : std_ulogic_vector(7 downto 0);
  signal emergency_stop_synchronized : std_ulogic_vector(0 downto 0);
  signal emergency_stop_settling : std_ulogic;
  signal motion_start_synchronized : std_ulogic_vector(0 downto 0);
  signal motion_start_settling : std_ulogic;
  signal readings : sensor_reading_array_t(0 to heaters - 1);
  signal more_charges : unsigned(7 downto 0);
  signal limits_locked : std_ulogic;

  -- Nothing but a register stands behind an input pin: timing is simple on a board, and the model has no
  -- logic to evaluate when an input changes between clocks.
  signal clock_frequency : unsigned(31 downto 0) := (others => '0');
  signal software_stepping_registered : std_ulogic := '0';

begin

  fault <= heater_interrupt;

  register_inputs : process
  begin
    wait until rising_edge(clk);
    reset_registered <= reset or chip_reset;
  end process;

  register_processor_inputs : process
  begin
    wait until rising_edge(processor_clk);
    processor_reset <= reset or chip_reset;
  end process;

  register_axes_inputs : process
  begin
    wait until rising_edge(axes_clk);
    axes_reset <= reset or chip_reset;
    software_stepping_registered <= software_stepping;
  end process;

  register_peripheral_inputs : process
  begin
    wait until rising_edge(peripheral_clk);
    peripheral_reset <= reset or chip_reset;
    clock_frequency <= clock_frequency_hz;
  end process;

  processor_at_rest <= processor_rests and not (timer_alarm or processor_reset) when not has_debug else '0';
  axes_at_rest <= axes_rest and step_pins_rest and
    not (emergency_stop_settling or motion_start_settling or chip_reset);
  peripherals_at_rest <= uart_rests and end_stops_rest and converter_rests and heater_control_rests and
    not chip_reset;

  -- The lower the number, the higher the priority.
  interrupts <= (
    uart_receive_interrupt_number => uart_receive_interrupt,
    queue_threshold_interrupt_number => queue_interrupt,
    motion_stopped_interrupt_number => stop_interrupt,
    heater_trip_interrupt_number => heater_interrupt,
    uart_transmit_interrupt_number => uart_transmit_interrupt,
    others => '0');

  computing : entity work.computer
    generic map (
      memory_size_bytes => memory_size_bytes,
      has_debug => has_debug,
      has_zbb => has_zbb
    )
    port map (
      clk => processor_clk,
      always_clk => clk,
      external_reset => reset,
      reset => processor_reset,
      chip_reset => chip_reset,
      bus_request => bus_request,
      bus_response => bus_response,
      timer_interrupt => timer_interrupt,
      interrupts => interrupts,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo,
      sleeping => sleeping,
      retired => retired,
      at_rest => processor_rests
    );

  fabric : entity work.bus_interconnect
    generic map (
      base_addresses => base_addresses
    )
    port map (
      clk => processor_clk,
      reset => processor_reset,
      request => bus_request,
      response => bus_response,
      slave_requests => requests,
      slave_responses => responses
    );

  -- What an access sets off is over, in the registers themselves and in what watches for accesses, before as
  -- many clocks have passed.
  watch_bus : entity work.rest_watch
    generic map (
      settling_clocks => 6
    )
    port map (
      clk => bus_clk,
      bus_clk => bus_clk,
      reset => processor_reset,
      strobe => bus_request.strobe,
      working => '0',
      alarm => bus_request.strobe,
      at_rest => bus_at_rest
    );

  identity_block : entity work.identity
    generic map (
      memory_size_bytes => memory_size_bytes,
      axes => axes,
      queue_depth => queue_depth,
      sensors => heaters,
      heaters => heaters
    )
    port map (
      clk => clk,
      bus_clk => bus_clk,
      clock_frequency_hz => clock_frequency,
      reset => processor_reset,
      request => requests(identity_slave),
      response => responses(identity_slave)
    );

  serial_line : entity work.uart
    port map (
      clk => peripheral_clk,
      bus_clk => bus_clk,
      reset => peripheral_reset,
      request => requests(uart_slave),
      response => responses(uart_slave),
      receive => receive,
      transmit => transmit,
      receive_interrupt => uart_receive_interrupt,
      transmit_interrupt => uart_transmit_interrupt,
      at_rest => uart_rests
    );

  machine_timer : entity work.timer
    port map (
      clk => clk,
      bus_clk => processor_clk,
      reset => processor_reset,
      request => requests(timer_slave),
      response => responses(timer_slave),
      timer_interrupt => timer_interrupt,
      alarm => timer_alarm
    );

  end_stop_inputs : entity work.end_stops
    port map (
      clk => peripheral_clk,
      bus_clk => bus_clk,
      reset => peripheral_reset,
      request => requests(end_stops_slave),
      response => responses(end_stops_slave),
      switches => end_stop,
      triggered => end_stops_triggered,
      at_rest => end_stops_rest
    );

  synchronize_emergency_stop : entity work.synchronizer
    generic map (
      width => 1
    )
    port map (
      clk => axes_clk,
      asynchronous => (0 => emergency_stop),
      synchronous => emergency_stop_synchronized,
      settling => emergency_stop_settling
    );

  synchronize_motion_start : entity work.synchronizer
    generic map (
      width => 1
    )
    port map (
      clk => axes_clk,
      asynchronous => (0 => motion_start),
      synchronous => motion_start_synchronized,
      settling => motion_start_settling
    );

  pins : entity work.step_pins
    generic map (
      axes => axes
    )
    port map (
      clk => axes_clk,
      bus_clk => bus_clk,
      reset => axes_reset,
      request => requests(step_pins_slave),
      response => responses(step_pins_slave),
      software_stepping => software_stepping_registered,
      emergency_stop => emergency_stop_synchronized(0),
      generated_step => generated_step,
      generated_direction => generated_direction,
      generator_idle => generator_idle,
      step => step,
      direction => direction,
      at_rest => step_pins_rest
    );

  sensors : entity work.temperature_converter
    generic map (
      channels => heaters
    )
    port map (
      clk => peripheral_clk,
      always_clk => clk,
      bus_clk => bus_clk,
      clock_frequency_hz => clock_frequency,
      reset => peripheral_reset,
      request => requests(temperature_converter_slave),
      response => responses(temperature_converter_slave),
      drive_enable => sensor_drive_enable,
      drive_level => sensor_drive_level,
      discharging => sensor_discharging,
      sense => sensor_sense,
      readings => readings,
      more_charges => more_charges,
      limits_locked => limits_locked,
      at_rest => converter_rests
    );

  heat : entity work.heater_control
    generic map (
      channels => heaters
    )
    port map (
      clk => peripheral_clk,
      always_clk => clk,
      bus_clk => bus_clk,
      clock_frequency_hz => clock_frequency,
      reset => peripheral_reset,
      request => requests(heater_control_slave),
      response => responses(heater_control_slave),
      readings => readings,
      more_charges => more_charges,
      limits_locked => limits_locked,
      emergency_stop => emergency_stop,
      veto => heater_supply_veto,
      gates => heater_gate,
      supply => heater_supply,
      interrupt => heater_interrupt,
      at_rest => heater_control_rests
    );

  cooling_fan : entity work.fan
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset_registered,
      request => requests(fan_slave),
      response => responses(fan_slave),
      level => fan_gate
    );

  motion : entity work.step_generator
    generic map (
      axes => axes,
      queue_depth => queue_depth
    )
    port map (
      clk => axes_clk,
      always_clk => clk,
      bus_clk => bus_clk,
      reset => axes_reset,
      request => requests(step_generator_slave),
      response => responses(step_generator_slave),
      end_stops => end_stops_triggered,
      emergency_stop => emergency_stop_synchronized(0),
      start => motion_start_synchronized(0),
      step => generated_step,
      direction => generated_direction,
      enable => motor_enable,
      moving => open,
      idle => generator_idle,
      queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt,
      at_rest => axes_rest
    );

end architecture;
