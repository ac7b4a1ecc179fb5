-- SPDX-License-Identifier: Apache-2.0
-- Two step generators of 2 axes with the same inputs. The second gets no clock edge that may be left out,
-- and must do as the first.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;

entity step_generator_twins is
  generic (
    queue_depth : positive
  );
  port (
    clk : out std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    end_stops : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    start : in std_ulogic;
    step, direction, enable : out std_ulogic_vector(1 downto 0);
    moving, idle, queue_interrupt, stop_interrupt : out std_ulogic;
    clocks_run, clocks_left_out : out natural := 0
  );
end entity;

architecture simulation of step_generator_twins is

  constant axes : positive := 2;

  signal resting_clk, resting_bus_clk, at_rest : std_ulogic;
  signal rested_step, rested_direction, rested_enable : std_ulogic_vector(axes - 1 downto 0);
  signal rested_moving, rested_idle, rested_queue_interrupt, rested_stop_interrupt : std_ulogic;
  signal rested_response : bus_response_t;

  subtype flags_t is std_ulogic_vector(3 downto 0);

begin

  clocks : entity work.resting_clocks
    generic map (period => 20 ns)
    port map (
      reset => reset, strobe => request.strobe, at_rest => at_rest, pins => "0", clk => clk,
      resting_clk => resting_clk, resting_bus_clk => resting_bus_clk,
      clocks_left_out => clocks_left_out);

  generator : entity work.step_generator
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset, request => request,
      response => response, end_stops => end_stops, emergency_stop => emergency_stop, start => start,
      step => step, direction => direction, enable => enable, moving => moving, idle => idle,
      queue_interrupt => queue_interrupt, stop_interrupt => stop_interrupt, at_rest => open);

  resting_generator : entity work.step_generator
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk, reset => reset,
      request => request, response => rested_response, end_stops => end_stops,
      emergency_stop => emergency_stop, start => start, step => rested_step,
      direction => rested_direction, enable => rested_enable, moving => rested_moving,
      idle => rested_idle, queue_interrupt => rested_queue_interrupt,
      stop_interrupt => rested_stop_interrupt, at_rest => at_rest);

  compare : process
  begin
    wait until falling_edge(clk);
    clocks_run <= 0 when reset else clocks_run + 1;
    assert rested_step = step and rested_direction = direction and rested_enable = enable
      report "a rest has changed step, direction or enable: " &
      to_string(rested_step & rested_direction & rested_enable) & ", not " &
      to_string(step & direction & enable) severity failure;
    assert rested_moving = moving and rested_idle = idle and rested_queue_interrupt = queue_interrupt
      and rested_stop_interrupt = stop_interrupt
      report "a rest has changed moving, idle or the interrupts: " &
      to_string(flags_t'(rested_moving, rested_idle, rested_queue_interrupt, rested_stop_interrupt)) &
      ", not " & to_string(flags_t'(moving, idle, queue_interrupt, stop_interrupt)) severity failure;
    assert rested_response = response
      report "a rest has changed an answer: " & to_hstring(rested_response.data) & ", not " &
      to_hstring(response.data) severity failure;
  end process;

end architecture;
