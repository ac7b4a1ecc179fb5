-- SPDX-License-Identifier: Apache-2.0
-- A heater control with two sensors that are converted all the time, watched at rest: an edge then
-- changes nothing.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.heater_control_bench_pkg.all;
use work.thermal_pkg.all;

entity heater_control_rig is
  port (
    clk : out std_ulogic := '0';
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    inputs : in heater_inputs_t;
    outputs : out heater_outputs_t;
    sensors_work : in boolean;
    present_count : in natural;
    gate_0_edges, clocks_at_rest : out natural := 0
  );
end entity;

architecture simulation of heater_control_rig is

  -- From one reading of both sensors to the next.
  constant clocks_to_reading : positive := conversion - 49;

  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal at_rest : std_ulogic;

begin

  clk <= not clk after 125 ns;

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => response, readings => readings,
      more_charges => to_unsigned(charges - 1, 8), limits_locked => outputs.limits_locked,
      emergency_stop => inputs.emergency_stop, veto => inputs.veto, gates => outputs.gates,
      supply => outputs.supply, interrupt => outputs.interrupt, at_rest => at_rest);

  convert : process
  begin
    for i in 1 to clocks_to_reading - 1 loop
      wait until rising_edge(clk);
    end loop;
    if sensors_work then
      for channel in readings'range loop
        readings(channel) <= (updated => '1', valid => '1', count => to_unsigned(present_count, 32));
      end loop;
    end if;
    wait until rising_edge(clk);
    for channel in readings'range loop
      readings(channel).updated <= '0';
    end loop;
  end process;

  -- An edge at rest changes nothing, and no reading comes at rest.
  watch_rest : process
    variable outputs_before : heater_outputs_t := (gates => "00", others => '0');
    variable rested : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    changes_nothing_at_rest : assert rested = '0' or outputs = outputs_before
      report "changes at rest" severity error;
    is_awake_for_a_reading : assert at_rest = '0' or (readings(0).updated = '0' and readings(1).updated = '0')
      report "rests while a reading comes" severity error;
    rested := at_rest and not inputs.emergency_stop;
    outputs_before := outputs;
    if at_rest then
      clocks_at_rest <= clocks_at_rest + 1;
    end if;
  end process;

  watch_gate : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    if outputs.gates(0) /= before then
      gate_0_edges <= gate_0_edges + 1;
    end if;
    before := outputs.gates(0);
  end process;

end architecture;
