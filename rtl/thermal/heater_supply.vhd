-- SPDX-License-Identifier: Apache-2.0
-- The relay in the supply of all heaters: software closes it, any danger opens it until software
-- closes it again.

library ieee;
use ieee.std_logic_1164.all;

-- A second cut-off: closing a gate does not help where its transistor conducts by itself.
entity heater_supply is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Requests of software, for one clock each.
    close : in std_ulogic;
    open_again : in std_ulogic;
    -- No channel is asked to heat.
    all_at_rest : in std_ulogic;
    -- Causes to open it; it stays open while one lasts.
    tripped : in std_ulogic;
    watchdog_alive : in std_ulogic;
    emergency_stop : in std_ulogic;
    veto : in std_ulogic;
    closed : out std_ulogic := '0';
    -- What has opened it since software last closed it.
    trip_opened : out std_ulogic := '0';
    watchdog_opened : out std_ulogic := '0';
    emergency_stop_opened : out std_ulogic := '0';
    veto_opened : out std_ulogic := '0';
    -- The last request to close it was refused.
    refused : out std_ulogic := '0'
  );
end entity;

architecture rtl of heater_supply is

  signal danger : std_ulogic;

begin

  danger <= tripped or not watchdog_alive or emergency_stop or veto;

  hold : process
  begin
    wait until rising_edge(clk);
    if closed then
      trip_opened <= tripped;
      watchdog_opened <= not watchdog_alive;
      emergency_stop_opened <= emergency_stop;
      veto_opened <= veto;
    end if;
    if danger then
      closed <= '0';
    end if;
    if close then
      refused <= danger or not all_at_rest;
      if danger = '0' and all_at_rest = '1' then
        closed <= '1';
        trip_opened <= '0';
        watchdog_opened <= '0';
        emergency_stop_opened <= '0';
        veto_opened <= '0';
      end if;
    end if;
    if open_again then
      closed <= '0';
    end if;
    if reset then
      closed <= '0';
      trip_opened <= '0';
      watchdog_opened <= '0';
      emergency_stop_opened <= '0';
      veto_opened <= '0';
      refused <= '0';
    end if;
  end process;

end architecture;
