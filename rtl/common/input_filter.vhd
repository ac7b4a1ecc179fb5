-- SPDX-License-Identifier: Apache-2.0
-- Ignores pulses that are too short: a new level counts only after it was stable for some clocks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity input_filter is
  generic (
    -- Bits of the stable time.
    width : positive := 16;
    -- Level of the output after reset.
    idle_level : std_ulogic := '0'
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Clocks for which a new level must have been seen without a break; 0 acts as 1.
    stable_cycles : in unsigned(width - 1 downto 0);
    -- Already synchronous to clk.
    level : in std_ulogic;
    filtered : out std_ulogic := idle_level
  );
end entity;

architecture rtl of input_filter is

  -- Clocks for which `level` has differed from `filtered` so far.
  signal differing_cycles : unsigned(width - 1 downto 0) := (others => '0');
  -- `stable_cycles` less one, registered, so that no sum is compared.
  signal last_cycle : unsigned(width - 1 downto 0) := (others => '0');

begin

  filter : process
  begin
    wait until rising_edge(clk);
    last_cycle <= (others => '0');
    if stable_cycles /= 0 then
      last_cycle <= stable_cycles - 1;
    end if;
    if level = filtered then
      differing_cycles <= (others => '0');
    elsif differing_cycles >= last_cycle then
      filtered <= level;
      differing_cycles <= (others => '0');
    else
      differing_cycles <= differing_cycles + 1;
    end if;
    if reset then
      filtered <= idle_level;
      differing_cycles <= (others => '0');
    end if;
  end process;

end architecture;
