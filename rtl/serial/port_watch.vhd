-- SPDX-License-Identifier: Apache-2.0
-- Inserts a break when a host closes its port, which the USB bridge signals by DTR: software then
-- discards the host's incomplete line (`firmware/host_link`, rule 9).
--
-- Only the change to "closed" counts, not the level: a host that never raises DTR is heard like any other.

library ieee;
use ieee.std_logic_1164.all;

entity port_watch is
  generic (
    -- The line must have been idle for this time: bytes still on their way from the bridge arrive.
    quiet_clocks : positive;
    -- Length of the break.
    break_clocks : positive
  );
  port (
    clk : in std_ulogic;
    -- From the bridge, at any time: its bytes, and high where no host has the port open.
    line : in std_ulogic;
    closed : in std_ulogic;
    -- To the chip, which synchronizes it.
    receive : out std_ulogic
  );
end entity;

architecture rtl of port_watch is

  type state_t is (
    open_or_unknown,
    -- Closed, but bytes may still arrive.
    waiting,
    breaking
  );

  signal state : state_t := open_or_unknown;
  signal clocks : natural range 0 to quiet_clocks + break_clocks := 0;
  signal samples : std_ulogic_vector(1 downto 0);
  signal was_closed : std_ulogic := '1';
  signal hold : std_ulogic := '0';

begin

  synchronize : entity work.synchronizer
    generic map (width => 2, idle_level => '1')
    port map (
      clk => clk,
      asynchronous => closed & line,
      synchronous => samples,
      settling => open);

  watch : process
  begin
    wait until rising_edge(clk);
    was_closed <= samples(1);
    case state is
      when open_or_unknown =>
        clocks <= 0;
        if samples(1) and not was_closed then
          state <= waiting;
        end if;
      when waiting =>
        clocks <= clocks + 1;
        if not samples(0) then
          clocks <= 0;
        elsif clocks = quiet_clocks - 1 then
          clocks <= 0;
          hold <= '1';
          state <= breaking;
        end if;
      when breaking =>
        clocks <= clocks + 1;
        if clocks = break_clocks - 1 then
          hold <= '0';
          state <= open_or_unknown;
        end if;
    end case;
    -- The next host has opened the port: none of its bits is held back.
    if not samples(1) then
      hold <= '0';
      state <= open_or_unknown;
    end if;
  end process;

  receive <= line and not hold;

end architecture;
