-- SPDX-License-Identifier: Apache-2.0
-- Motion: the step generator, the end stops that stop it, and the step pins, which software may
-- take over.

library ieee;
use ieee.std_logic_1164.all;

use work.bus_pkg.all;
use work.clocks_pkg.all;

entity motion_system is
  generic (
    axes : positive range 1 to 8;
    -- Segments that wait in the step generator.
    queue_depth : positive
  );
  port (
    clocks : in clocks_t;
    resets : in resets_t;
    step_generator_request : in bus_request_t;
    step_generator_response : out bus_response_t;
    end_stops_request : in bus_request_t;
    end_stops_response : out bus_response_t;
    step_pins_request : in bus_request_t;
    step_pins_response : out bus_response_t;
    -- Software may drive the step and direction pins.
    software_stepping : in std_ulogic;
    -- The chip's pins; the inputs are asynchronous.
    end_stop : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    motion_start : in std_ulogic;
    step : out std_ulogic_vector(axes - 1 downto 0);
    direction : out std_ulogic_vector(axes - 1 downto 0);
    motor_enable : out std_ulogic_vector(axes - 1 downto 0);
    queue_interrupt : out std_ulogic;
    stop_interrupt : out std_ulogic;
    axes_at_rest : out std_ulogic;
    end_stops_at_rest : out std_ulogic
  );
end entity;

architecture rtl of motion_system is

  signal generated_step, generated_direction : std_ulogic_vector(axes - 1 downto 0);
  signal idle, generator_rests, pins_rest, inputs_settle : std_ulogic;
  signal end_stops_triggered : std_ulogic_vector(7 downto 0);
  signal emergency_stop_synchronized, motion_start_synchronized : std_ulogic;
  signal software_stepping_registered : std_ulogic := '0';

begin

  axes_at_rest <= generator_rests and pins_rest and not inputs_settle;

  register_inputs : process
  begin
    wait until rising_edge(clocks.axes);
    software_stepping_registered <= software_stepping;
  end process;

  synchronize_inputs : entity work.synchronizer
    generic map (width => 2)
    port map (
      clk => clocks.axes,
      asynchronous => (0 => emergency_stop, 1 => motion_start),
      synchronous(0) => emergency_stop_synchronized,
      synchronous(1) => motion_start_synchronized,
      settling => inputs_settle);

  end_stop_inputs : entity work.end_stops
    port map (
      clk => clocks.peripherals,
      bus_clk => clocks.registers,
      reset => resets.peripherals,
      request => end_stops_request,
      response => end_stops_response,
      switches => end_stop,
      triggered => end_stops_triggered,
      at_rest => end_stops_at_rest);

  generator : entity work.step_generator
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clk => clocks.axes,
      always_clk => clocks.free_running,
      bus_clk => clocks.registers,
      reset => resets.axes,
      request => step_generator_request,
      response => step_generator_response,
      end_stops => end_stops_triggered,
      emergency_stop => emergency_stop_synchronized,
      start => motion_start_synchronized,
      step => generated_step,
      direction => generated_direction,
      enable => motor_enable,
      moving => open,
      idle => idle,
      queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt,
      at_rest => generator_rests);

  pins : entity work.step_pins
    generic map (axes => axes)
    port map (
      clk => clocks.axes,
      bus_clk => clocks.registers,
      reset => resets.axes,
      request => step_pins_request,
      response => step_pins_response,
      software_stepping => software_stepping_registered,
      emergency_stop => emergency_stop_synchronized,
      generated_step => generated_step,
      generated_direction => generated_direction,
      generator_idle => idle,
      step => step,
      direction => direction,
      at_rest => pins_rest);

end architecture;
