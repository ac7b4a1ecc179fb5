-- SPDX-License-Identifier: Apache-2.0
-- Watchdog: detects that motion has gone on for too long without being fed by software.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity motion_watchdog is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Clocks of motion without feeding, 0 = never expires. One that is changed in motion holds from then on.
    limit : in unsigned(31 downto 0);
    moving : in std_ulogic;
    feed : in std_ulogic;
    -- While moving, from `limit` clocks after the last feeding or the beginning on.
    expired : out std_ulogic := '0'
  );
end entity;

architecture rtl of motion_watchdog is

  signal left : unsigned(31 downto 0) := (others => '1');

begin

  count : process
  begin
    wait until rising_edge(clk);
    expired <= '0';
    if limit = 0 then
      left <= (others => '1');
    elsif feed = '1' or moving = '0' or left > limit then
      left <= limit;
    elsif left <= 1 then
      expired <= '1';
    else
      left <= left - 1;
    end if;
    if reset then
      expired <= '0';
    end if;
  end process;

end architecture;
