-- SPDX-License-Identifier: Apache-2.0
-- The whole chip with its clock for each part: processor and memory, and on the bus everything that must be
-- exact. On a board it lies in printer_controller, which has one clock; a model gates the clocks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.clocks_pkg.all;
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

entity printer_core is
  generic (
    -- As of printer_controller.
    memory_size_bytes : positive := 106496;
    axes : positive range 1 to 8 := 5;
    queue_depth : positive := 32;
    heaters : positive range 1 to 4 := 2;
    has_debug : boolean := false;
    has_zbb : boolean := false;
    memory_shows_clear : boolean := false;
    -- Without it, and without memory, `outer_request` drives the bus: in co-simulation, where a model of the
    -- processor takes its place.
    has_processor : boolean := true
  );
  port (
    clocks : in clocks_t;
    -- Which of them may be gated.
    at_rest : out clocks_at_rest_t;
    -- Of the clock; constant.
    clock_frequency_hz : in unsigned(31 downto 0);
    -- Software may drive the step and direction pins: '1' in the co-simulation that compares the two.
    software_stepping : in std_ulogic;
    -- The processor has completed an instruction.
    retired : out std_ulogic;
    -- For a processor outside: its access, taken over with the processor's clock; what the bus answers; the
    -- interrupts of the timer and from 16 on.
    outer_request : in bus_request_t := bus_request_idle;
    outer_response : out bus_response_t;
    outer_timer_interrupt : out std_ulogic;
    outer_interrupts : out std_ulogic_vector(31 downto 16);
    -- The rest as of printer_controller.
    reset : in std_ulogic;
    receive : in std_ulogic;
    transmit : out std_ulogic;
    step : out std_ulogic_vector(axes - 1 downto 0);
    direction : out std_ulogic_vector(axes - 1 downto 0);
    motor_enable : out std_ulogic_vector(axes - 1 downto 0);
    end_stop : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    motion_start : in std_ulogic;
    sensor_drive_enable : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_drive_level : out std_ulogic_vector(resistors * heaters - 1 downto 0);
    sensor_discharging : out std_ulogic_vector(heaters - 1 downto 0);
    sensor_sense : in std_ulogic_vector(heaters - 1 downto 0);
    heater_gate : out std_ulogic_vector(heaters - 1 downto 0);
    heater_supply : out std_ulogic;
    heater_supply_veto : in std_ulogic;
    fan_gate : out std_ulogic;
    fault : out std_ulogic;
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic;
    sleeping : out std_ulogic
  );
end entity;

architecture rtl of printer_core is

  constant identity_slave : natural := 0;
  constant uart_slave : natural := 1;
  constant timer_slave : natural := 2;
  constant step_generator_slave : natural := 3;
  constant end_stops_slave : natural := 4;
  constant temperature_converter_slave : natural := 5;
  constant heater_control_slave : natural := 6;
  constant fan_slave : natural := 7;
  constant step_pins_slave : natural := 8;

  constant base_addresses : bus_address_array_t(0 to 8) := (
    identity_slave => identity_address, uart_slave => uart_address, timer_slave => timer_address,
    step_generator_slave => step_generator_address, end_stops_slave => end_stops_address,
    temperature_converter_slave => temperature_converter_address,
    heater_control_slave => heater_control_address, fan_slave => fan_address,
    step_pins_slave => step_pins_address);

  signal resets : resets_t;
  signal chip_reset : std_ulogic := '0';

  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t;
  signal requests : bus_request_array_t(base_addresses'range);
  signal responses : bus_response_array_t(base_addresses'range);

  signal timer_interrupt : std_ulogic;
  signal uart_receive_interrupt, uart_transmit_interrupt : std_ulogic;
  signal queue_interrupt, stop_interrupt, heater_interrupt : std_ulogic;
  signal interrupts : std_ulogic_vector(31 downto 16);

  signal processor_rests, timer_alarm, axes_rest : std_ulogic;
  signal uart_rests, end_stops_rest, thermal_rests : std_ulogic;

  -- Every input pin leads to registers only: timing is simple on a board, and the model has no
  -- logic to evaluate when an input changes between clocks.
  signal clock_frequency : unsigned(31 downto 0) := (others => '0');

begin

  fault <= heater_interrupt;

  register_inputs : process
  begin
    wait until rising_edge(clocks.peripherals);
    clock_frequency <= clock_frequency_hz;
  end process;

  gating : entity work.clock_gating
    generic map (has_debug => has_debug)
    port map (
      clocks => clocks,
      reset => reset,
      chip_reset => chip_reset,
      processor_rests => processor_rests,
      timer_alarm => timer_alarm,
      bus_strobe => bus_request.strobe,
      axes_rest => axes_rest,
      peripherals_rest => uart_rests and end_stops_rest and thermal_rests,
      resets => resets,
      at_rest => at_rest);

  -- The lower the number, the higher the priority.
  interrupts <= (
    uart_receive_interrupt_number => uart_receive_interrupt,
    queue_threshold_interrupt_number => queue_interrupt,
    motion_stopped_interrupt_number => stop_interrupt,
    heater_trip_interrupt_number => heater_interrupt,
    uart_transmit_interrupt_number => uart_transmit_interrupt,
    others => '0');

  outer_response <= bus_response;
  outer_timer_interrupt <= timer_interrupt;
  outer_interrupts <= interrupts;

  with_processor : if has_processor generate

    computing : entity work.computer
      generic map (
        memory_size_bytes => memory_size_bytes, has_debug => has_debug, has_zbb => has_zbb,
        memory_shows_clear => memory_shows_clear)
      port map (
        clk => clocks.processor,
        always_clk => clocks.free_running,
        external_reset => reset,
        reset => resets.processor,
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
        at_rest => processor_rests);

  else generate

    take_outer_request : process
    begin
      wait until rising_edge(clocks.processor);
      bus_request <= outer_request;
    end process;

    -- The clock is for the registers of the bus and the timer alone.
    processor_rests <= at_rest.registers;
    chip_reset <= '0';
    tdo <= '0';
    sleeping <= '0';
    retired <= '0';

  end generate;

  fabric : entity work.bus_interconnect
    generic map (base_addresses => base_addresses)
    port map (
      clk => clocks.processor,
      reset => resets.processor,
      request => bus_request,
      response => bus_response,
      slave_requests => requests,
      slave_responses => responses);

  identity_block : entity work.identity
    generic map (
      memory_size_bytes => memory_size_bytes, axes => axes, queue_depth => queue_depth,
      sensors => heaters, heaters => heaters)
    port map (
      clk => clocks.registers,
      clock_frequency_hz => clock_frequency,
      reset => resets.processor,
      request => requests(identity_slave),
      response => responses(identity_slave));

  serial_line : entity work.uart
    port map (
      clk => clocks.peripherals,
      bus_clk => clocks.registers,
      reset => resets.peripherals,
      request => requests(uart_slave),
      response => responses(uart_slave),
      receive => receive,
      transmit => transmit,
      receive_interrupt => uart_receive_interrupt,
      transmit_interrupt => uart_transmit_interrupt,
      at_rest => uart_rests);

  machine_timer : entity work.timer
    port map (
      clk => clocks.free_running,
      bus_clk => clocks.processor,
      reset => resets.processor,
      request => requests(timer_slave),
      response => responses(timer_slave),
      timer_interrupt => timer_interrupt,
      alarm => timer_alarm);

  motion : entity work.motion_system
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clocks => clocks,
      resets => resets,
      step_generator_request => requests(step_generator_slave),
      step_generator_response => responses(step_generator_slave),
      end_stops_request => requests(end_stops_slave),
      end_stops_response => responses(end_stops_slave),
      step_pins_request => requests(step_pins_slave),
      step_pins_response => responses(step_pins_slave),
      software_stepping => software_stepping,
      end_stop => end_stop,
      emergency_stop => emergency_stop,
      motion_start => motion_start,
      step => step,
      direction => direction,
      motor_enable => motor_enable,
      queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt,
      axes_at_rest => axes_rest,
      end_stops_at_rest => end_stops_rest);

  thermal : entity work.thermal_system
    generic map (heaters => heaters)
    port map (
      clocks => clocks,
      resets => resets,
      clock_frequency_hz => clock_frequency,
      converter_request => requests(temperature_converter_slave),
      converter_response => responses(temperature_converter_slave),
      heaters_request => requests(heater_control_slave),
      heaters_response => responses(heater_control_slave),
      fan_request => requests(fan_slave),
      fan_response => responses(fan_slave),
      sensor_drive_enable => sensor_drive_enable,
      sensor_drive_level => sensor_drive_level,
      sensor_discharging => sensor_discharging,
      sensor_sense => sensor_sense,
      heater_gate => heater_gate,
      heater_supply => heater_supply,
      heater_supply_veto => heater_supply_veto,
      emergency_stop => emergency_stop,
      fan_gate => fan_gate,
      heater_interrupt => heater_interrupt,
      at_rest => thermal_rests);

end architecture;
