-- SPDX-License-Identifier: Apache-2.0
-- Two heater controls of two channels with the same inputs. The second gets no clock edge that may be
-- left out, and must do as the first.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.heater_control_bench_pkg.all;
use work.thermal_pkg.all;

entity heater_control_twins is
  port (
    clk : out std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    readings : in sensor_reading_array_t(0 to 1);
    inputs : in heater_inputs_t;
    outputs : out heater_outputs_t;
    at_rest : out std_ulogic;
    clocks_left_out : out natural
  );
end entity;

architecture simulation of heater_control_twins is

  constant frequency : unsigned(31 downto 0) := to_unsigned(clock_frequency_hz, 32);
  constant more_charges : unsigned(7 downto 0) := to_unsigned(charges - 1, 8);

  signal resting_clk, resting_bus_clk : std_ulogic;
  signal pins : std_ulogic_vector(1 downto 0);
  signal rested : heater_outputs_t;
  signal rested_response : bus_response_t;

begin

  pins <= inputs.emergency_stop & inputs.veto;

  clocks : entity work.resting_clocks
    generic map (period => 250 ns)
    port map (
      reset => reset, strobe => request.strobe, at_rest => at_rest, pins => pins,
      clk => clk, resting_clk => resting_clk, resting_bus_clk => resting_bus_clk,
      clocks_left_out => clocks_left_out);

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, clock_frequency_hz => frequency,
      reset => reset, request => request, response => response, readings => readings,
      more_charges => more_charges, limits_locked => outputs.limits_locked,
      emergency_stop => inputs.emergency_stop, veto => inputs.veto, gates => outputs.gates,
      supply => outputs.supply, interrupt => outputs.interrupt, at_rest => open);

  resting_control : entity work.heater_control
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk,
      clock_frequency_hz => frequency, reset => reset, request => request,
      response => rested_response, readings => readings, more_charges => more_charges,
      limits_locked => rested.limits_locked, emergency_stop => inputs.emergency_stop,
      veto => inputs.veto, gates => rested.gates, supply => rested.supply,
      interrupt => rested.interrupt, at_rest => at_rest);

  compare : process
  begin
    wait until falling_edge(clk);
    assert rested = outputs and rested_response = response
      report "a rest has changed something" severity failure;
  end process;

end architecture;
