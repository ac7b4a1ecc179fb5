-- SPDX-License-Identifier: Apache-2.0
-- The limits of one heater: each is written once, within built-in bounds, and then stays until reset.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity heater_limits is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Bounds for the present number of charges, all inclusive.
    least_count : in unsigned(31 downto 0);
    most_count : in unsigned(31 downto 0);
    least_hot_count : in unsigned(31 downto 0);
    longest_settle : in settle_t;
    -- What software writes, to whichever limit it is.
    written : in unsigned(31 downto 0);
    minimum_written : in std_ulogic;
    maximum_written : in std_ulogic;
    hot_written : in std_ulogic;
    settle_written : in std_ulogic;
    forget_refused : in std_ulogic;
    -- Before they are set they forbid everything.
    minimum_count : out unsigned(31 downto 0) := (others => '1');
    maximum_count : out unsigned(31 downto 0) := (others => '0');
    hot_count : out unsigned(31 downto 0) := (others => '0');
    settle_ticks : out settle_t := (others => '1');
    minimum_locked : out std_ulogic := '0';
    maximum_locked : out std_ulogic := '0';
    hot_locked : out std_ulogic := '0';
    settle_locked : out std_ulogic := '0';
    -- A write was refused: the limit was locked, or the value out of bounds.
    refused : out std_ulogic := '0'
  );
end entity;

architecture rtl of heater_limits is

  signal long_settle : std_ulogic;

begin

  long_settle <= '1' when written > resize(longest_settle, 32) else '0';

  lock : process
  begin
    wait until rising_edge(clk);
    if forget_refused then
      refused <= '0';
    end if;
    if minimum_written then
      if minimum_locked = '1' or written < least_count then
        refused <= '1';
      else
        minimum_count <= written;
        minimum_locked <= '1';
      end if;
    end if;
    if maximum_written then
      if maximum_locked = '1' or written > most_count then
        refused <= '1';
      else
        maximum_count <= written;
        maximum_locked <= '1';
      end if;
    end if;
    if hot_written then
      if hot_locked = '1' or written < least_hot_count then
        refused <= '1';
      else
        hot_count <= written;
        hot_locked <= '1';
      end if;
    end if;
    if settle_written then
      if settle_locked = '1' or long_settle = '1' then
        refused <= '1';
      else
        settle_ticks <= written(settle_ticks'range);
        settle_locked <= '1';
      end if;
    end if;
    if reset then
      minimum_count <= (others => '1');
      maximum_count <= (others => '0');
      hot_count <= (others => '0');
      settle_ticks <= (others => '1');
      minimum_locked <= '0';
      maximum_locked <= '0';
      hot_locked <= '0';
      settle_locked <= '0';
      refused <= '0';
    end if;
  end process;

end architecture;
