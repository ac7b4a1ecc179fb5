-- SPDX-License-Identifier: Apache-2.0
-- In a co-simulated board the reference is the clock, and locked after some clocks.

library ieee;
use ieee.std_logic_1164.all;

entity phase_locked_loop is
  generic (
    device_family : string;
    reference_period_ps : positive;
    multiply : positive;
    divide : positive
  );
  port (
    reference_clk : in std_ulogic;
    clk : out std_ulogic;
    locked : out std_ulogic
  );
end entity;

architecture bypass of phase_locked_loop is

  -- As low as they are after configuration.
  signal passed : std_ulogic_vector(7 downto 0) := (others => '0');

begin

  same_frequency : assert multiply = divide report "the bypass changes no frequency" severity failure;

  count : process
  begin
    wait until rising_edge(reference_clk);
    passed <= passed(6 downto 0) & '1';
  end process;

  clk <= reference_clk;
  locked <= passed(7);

end architecture;
