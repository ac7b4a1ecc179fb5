-- SPDX-License-Identifier: Apache-2.0
-- Switches the motor drivers on and off: never off in motion, all off at once in an emergency.

library ieee;
use ieee.std_logic_1164.all;

entity motor_switch is
  generic (
    axes : positive := 5
  );
  port (
    -- May be gated while nothing is written and not `alarm`.
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- Software wants these drivers enabled.
    written : in std_ulogic;
    wanted : in std_ulogic_vector(axes - 1 downto 0);
    -- Software knows that the positions are lost.
    positions_known : in std_ulogic;

    -- A segment is executed or queued: no driver is switched off.
    moving : in std_ulogic;
    -- Synchronous to clk.
    emergency_stop : in std_ulogic;
    -- A stop waits for its acknowledgement: after an emergency no driver is switched on.
    stopped : in std_ulogic;

    -- As software has them.
    enabled : out std_ulogic_vector(axes - 1 downto 0) := (others => '0');
    -- The drivers' pins.
    pins : out std_ulogic_vector(axes - 1 downto 0);
    -- The motors had no current since software last acknowledged it: they need not be where the
    -- counters say.
    positions_lost : out std_ulogic := '0';
    -- In the clock of the write.
    refused : out std_ulogic;
    -- For a rest_watch.
    alarm : out std_ulogic
  );
end entity;

architecture rtl of motor_switch is

  -- By an emergency that has not been acknowledged.
  signal cut_off : std_ulogic := '0';
  signal switches_off : std_ulogic;

begin

  pins <= enabled when emergency_stop = '0' else (others => '0');
  alarm <= emergency_stop and not cut_off;

  switches_off <= or (enabled and not wanted);
  refused <= written and ((moving and switches_off) or ((cut_off or emergency_stop) and (or wanted)));

  switch : process
  begin
    wait until rising_edge(clk);
    if written and not refused then
      enabled <= wanted;
    end if;
    if positions_known then
      positions_lost <= '0';
    end if;
    if not stopped then
      cut_off <= '0';
    end if;
    if emergency_stop then
      enabled <= (others => '0');
      cut_off <= '1';
      positions_lost <= '1';
    end if;
    if reset then
      enabled <= (others => '0');
      cut_off <= '0';
      positions_lost <= '0';
    end if;
  end process;

end architecture;
