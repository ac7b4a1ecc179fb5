-- SPDX-License-Identifier: Apache-2.0
-- End stop inputs: from bouncing, asynchronous switches of either polarity to clean active-high levels.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.end_stops_registers_pkg.all;

entity end_stops is
  port (
    -- May be gated while `at_rest` is high, except for the edge after a change of `switches`.
    clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- The pins, asynchronous.
    switches : in std_ulogic_vector(7 downto 0);
    -- '1' while the switch is triggered, 3 clocks and the filter's time after the pin.
    triggered : out std_ulogic_vector(7 downto 0) := (others => '0');
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of end_stops is

  signal from_software : end_stops_from_software_t;
  signal to_software : end_stops_to_software_t;

  signal switches_synchronized : std_ulogic_vector(7 downto 0);
  signal filtered : std_ulogic_vector(7 downto 0);
  signal settling, filtering : std_ulogic;

begin

  registers : entity work.end_stops_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software
    );

  to_software.status <= (
    raw => switches_synchronized, filtered => filtered, triggered => triggered);

  synchronize : entity work.synchronizer
    generic map (width => 8)
    port map (
      clk => clk, asynchronous => switches, synchronous => switches_synchronized,
      settling => settling);

  filtering <= '1' when filtered /= switches_synchronized else '0';

  watch_rest : entity work.rest_watch
    port map (
      clk => clk, bus_clk => bus_clk, reset => reset, strobe => request.strobe, working => filtering,
      alarm => settling, at_rest => at_rest);

  each_switch : for input in switches'range generate
    filter : entity work.input_filter
      generic map (width => 16)
      port map (
        clk => clk,
        reset => reset,
        stable_cycles => from_software.filter.cycles,
        level => switches_synchronized(input),
        filtered => filtered(input)
      );
  end generate;

  judge : process
  begin
    wait until rising_edge(clk);
    triggered <= (filtered xor from_software.polarity.active_low) and from_software.enable.inputs;
    if reset then
      triggered <= (others => '0');
    end if;
  end process;

end architecture;
