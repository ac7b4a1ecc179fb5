-- SPDX-License-Identifier: Apache-2.0
-- A clock, and the same clock gated: at rest, and for the registers without an access. For a second
-- unit, which must behave as the first one on the gated clocks.

library ieee;
use ieee.std_logic_1164.all;

entity resting_clocks is
  generic (
    period : time
  );
  port (
    reset : in std_ulogic;
    strobe : in std_ulogic;
    at_rest : in std_ulogic;
    -- The edge after a change of these comes also at rest.
    pins : in std_ulogic_vector;
    clk : out std_ulogic := '0';
    resting_clk : out std_ulogic := '0';
    resting_bus_clk : out std_ulogic := '0';
    clocks_left_out : out natural := 0
  );
end entity;

architecture simulation of resting_clocks is

  -- An access and its answer take fewer.
  constant access_clocks : positive := 4;

  signal seen_pins : std_ulogic_vector(pins'range) := (others => '0');
  signal edge_is_left_out, bus_edge_is_left_out : std_ulogic := '0';

begin

  -- All in one moment, as from one clock tree.
  make_clocks : process
  begin
    wait for period / 2;
    clk <= '1';
    resting_clk <= not edge_is_left_out;
    resting_bus_clk <= not bus_edge_is_left_out;
    wait for period / 2;
    clk <= '0';
    resting_clk <= '0';
    resting_bus_clk <= '0';
  end process;

  leave_out_edges : process
    variable clocks_without_access : natural := 0;
  begin
    wait until rising_edge(clk);
    seen_pins <= pins;
    clocks_without_access := 0 when (strobe or reset) = '1' else clocks_without_access + 1;
    wait until falling_edge(clk);
    wait for period / 4;
    edge_is_left_out <= '0';
    if at_rest = '1' and pins = seen_pins then
      edge_is_left_out <= '1';
      clocks_left_out <= clocks_left_out + 1;
    end if;
    bus_edge_is_left_out <= '1' when clocks_without_access > access_clocks and strobe = '0'
      and reset = '0' else '0';
  end process;

end architecture;
