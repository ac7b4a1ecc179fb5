-- SPDX-License-Identifier: Apache-2.0
-- Two step generators of 2 axes with the same inputs. The clock of the second is gated wherever it
-- may be, and it must behave as the first.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.step_generator_bench_pkg.all;

entity step_generator_twins is
  generic (
    queue_depth : positive
  );
  port (
    clk : out std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    inputs : in generator_inputs_t;
    outputs : out generator_outputs_t;
    clocks_run, clocks_left_out : out natural := 0
  );
end entity;

architecture simulation of step_generator_twins is

  signal resting_clk, resting_bus_clk, at_rest : std_ulogic;
  signal rested : generator_outputs_t;
  signal rested_response : bus_response_t;

begin

  clocks : entity work.resting_clocks
    generic map (period => 20 ns)
    port map (
      reset => reset, strobe => request.strobe, at_rest => at_rest, pins => "0", clk => clk,
      resting_clk => resting_clk, resting_bus_clk => resting_bus_clk,
      clocks_left_out => clocks_left_out);

  generator : entity work.step_generator
    generic map (axes => 2, queue_depth => queue_depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset, request => request,
      response => response, end_stops => inputs.end_stops,
      emergency_stop => inputs.emergency_stop, start => inputs.start, step => outputs.step,
      direction => outputs.direction, enable => outputs.enable, moving => outputs.moving,
      idle => outputs.idle, queue_interrupt => outputs.queue_interrupt,
      stop_interrupt => outputs.stop_interrupt, at_rest => open);

  resting_generator : entity work.step_generator
    generic map (axes => 2, queue_depth => queue_depth)
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk, reset => reset,
      request => request, response => rested_response, end_stops => inputs.end_stops,
      emergency_stop => inputs.emergency_stop, start => inputs.start, step => rested.step,
      direction => rested.direction, enable => rested.enable, moving => rested.moving,
      idle => rested.idle, queue_interrupt => rested.queue_interrupt,
      stop_interrupt => rested.stop_interrupt, at_rest => at_rest);

  compare : process

    function bits (pins : generator_outputs_t) return string is
    begin
      return to_string(pins.step & pins.direction & pins.enable & pins.moving & pins.idle
        & pins.queue_interrupt & pins.stop_interrupt);
    end function;

  begin
    wait until falling_edge(clk);
    clocks_run <= 0 when reset else clocks_run + 1;
    assert rested = outputs
      report "a rest has changed step, direction, enable, moving, idle or the interrupts: "
      & bits(rested) & ", not " & bits(outputs) severity failure;
    assert rested_response = response
      report "a rest has changed an answer: " & to_hstring(rested_response.data) & ", not " &
      to_hstring(response.data) severity failure;
  end process;

end architecture;
