-- SPDX-License-Identifier: Apache-2.0
-- Spreads a density evenly over time: first-order sigma-delta modulator with one output bit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pulse_density is
  generic (
    -- Bits of the density.
    width : positive := 8
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- The output changes only after clocks with '1': a slot lasts from one of them to the next.
    advance : in std_ulogic;
    -- Ones per 2**width - 1 slots: 0 is never on, all ones is always on.
    density : in unsigned(width - 1 downto 0);
    level : out std_ulogic := '0'
  );
end entity;

architecture rtl of pulse_density is

  -- The slots of one round; the error stays below it, so that the count of ones in a round is exact.
  constant full : unsigned(width downto 0) := '0' & (width - 1 downto 0 => '1');

  signal error : unsigned(width downto 0) := (others => '0');

begin

  modulate : process
    variable sum : unsigned(width downto 0);
  begin
    wait until rising_edge(clk);
    if advance then
      sum := error + density;
      if sum >= full then
        level <= '1';
        error <= sum - full;
      else
        level <= '0';
        error <= sum;
      end if;
    end if;
    if reset then
      level <= '0';
      error <= (others => '0');
    end if;
  end process;

end architecture;
