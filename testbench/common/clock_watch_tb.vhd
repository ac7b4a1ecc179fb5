-- SPDX-License-Identifier: Apache-2.0
-- The supply opens when the clock stands still, and stays open until the chip has requested that itself.

library ieee;
use ieee.std_logic_1164.all;

entity clock_watch_tb is
end entity;

architecture simulation of clock_watch_tb is

  -- 50 MHz, and 310 MHz / 128 off by 15 %.
  constant period : time := 20 ns;

  signal clk, watch_clk : std_ulogic := '0';
  signal runs : boolean := true;
  signal watch_period : time := 413 ns;
  signal wanted : std_ulogic := '0';
  signal closed, veto : std_ulogic;

begin

  clk <= not clk after period / 2 when runs else clk;
  watch_clk <= not watch_clk after watch_period / 2;

  watch : entity work.clock_watch
    port map (clk => clk, watch_clk => watch_clk, wanted => wanted, closed => closed, veto => veto);

  check : process
    variable stopped_at : time;
  begin
    for slowness in 0 to 1 loop
      watch_period <= 351 ns when slowness = 0 else 486 ns;
      wait for 100 us;
      is_open : assert closed = '0' and veto = '0' report "closed without a wish" severity error;
      wanted <= '1';
      wait for 1 ns;
      closes : assert closed = '1' report "does not close" severity error;
      for i in 1 to 1_000 loop
        wait for 1 us;
        accepts_a_running_clock : assert closed = '1' and veto = '0' report "opens" severity error;
      end loop;
      runs <= false;
      stopped_at := now;
      wait until closed = '0' for 1 ms;
      opens : assert closed = '0' and veto = '1' and now - stopped_at < 40 us
        report "opens after " & to_string(now - stopped_at) severity error;
      wait for 50 us;
      runs <= true;
      wait for 100 us;
      stays_open : assert closed = '0' and veto = '1' report "closes by itself" severity error;
      wanted <= '0';
      wait for 10 us;
      forgets : assert veto = '0' report "never forgets" severity error;
      wanted <= '1';
      wait for 10 us;
      closes_again : assert closed = '1' report "does not close again" severity error;
      wanted <= '0';
      wait for 1 ns;
      opens_at_once : assert closed = '0' report "closed" severity error;
    end loop;
    std.env.finish;
  end process;

end architecture;
