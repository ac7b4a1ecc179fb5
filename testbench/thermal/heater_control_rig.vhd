-- SPDX-License-Identifier: Apache-2.0
-- A heater control with two sensors that are converted all the time, watched at rest: an edge then
-- changes nothing.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.thermal_pkg.all;

entity heater_control_rig is
  generic (
    clock_frequency_hz : positive;
    charges : positive;
    -- Clocks from one reading of both sensors to the next.
    conversion : positive
  );
  port (
    clk : out std_ulogic := '0';
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    sensors_work : in boolean;
    present_count : in natural;
    emergency_stop, veto : in std_ulogic;
    gates : out std_ulogic_vector(1 downto 0);
    supply, interrupt, limits_locked : out std_ulogic;
    gate_0_edges, clocks_at_rest : out natural := 0
  );
end entity;

architecture simulation of heater_control_rig is

  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal at_rest : std_ulogic;

begin

  clk <= not clk after 125 ns;

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => response, readings => readings,
      more_charges => to_unsigned(charges - 1, 8), limits_locked => limits_locked,
      emergency_stop => emergency_stop, veto => veto, gates => gates, supply => supply,
      interrupt => interrupt, at_rest => at_rest);

  convert : process
  begin
    for i in 1 to conversion - 1 loop
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
    variable outputs, outputs_before : std_ulogic_vector(4 downto 0) := (others => '0');
    variable rested : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    outputs := gates & supply & interrupt & limits_locked;
    changes_nothing_at_rest : assert rested = '0' or outputs = outputs_before
      report "changes at rest" severity error;
    is_awake_for_a_reading : assert at_rest = '0' or (readings(0).updated = '0' and readings(1).updated = '0')
      report "rests while a reading comes" severity error;
    rested := at_rest and not emergency_stop;
    outputs_before := outputs;
    if at_rest then
      clocks_at_rest <= clocks_at_rest + 1;
    end if;
  end process;

  watch_gate : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    if gates(0) /= before then
      gate_0_edges <= gate_0_edges + 1;
    end if;
    before := gates(0);
  end process;

end architecture;
