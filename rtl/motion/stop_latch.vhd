-- SPDX-License-Identifier: Apache-2.0
-- Stops all motion at an end stop, the emergency stop input or software's command, until acknowledged.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity stop_latch is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- A segment is being executed, which these end stops end.
    active : in std_ulogic;
    stop_mask : in std_ulogic_vector(7 downto 0);

    -- Synchronous to clk, filtered, 1 = triggered.
    end_stops : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    software_stop : in std_ulogic;
    -- Without effect while emergency_stop is high.
    acknowledge : in std_ulogic;

    -- No step from this clock on.
    stop : out std_ulogic;
    -- High in the first clock of a stop: the moment to latch positions and time.
    stop_begins : out std_ulogic;
    -- A stop waits for its acknowledgement.
    stopped : out std_ulogic := '0';
    cause : out stop_cause_t := stop_cause_none
  );
end entity;

architecture rtl of stop_latch is

  signal hits : std_ulogic_vector(7 downto 0);
  signal hit : std_ulogic;

begin

  hits <= end_stops and stop_mask when active = '1' else x"00";
  hit <= emergency_stop or software_stop or (or hits);
  stop <= hit or stopped;
  stop_begins <= hit and not stopped;

  latch : process
  begin
    wait until rising_edge(clk);
    if stop_begins then
      stopped <= '1';
      cause <= (end_stops => hits, emergency_input => emergency_stop, software => software_stop);
    elsif acknowledge and not emergency_stop then
      stopped <= '0';
    end if;
    if reset then
      stopped <= '0';
    end if;
  end process;

end architecture;
