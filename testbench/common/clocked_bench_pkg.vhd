-- SPDX-License-Identifier: Apache-2.0
-- Time as benches of clocked parts see it: clocks, after which outputs have settled, and ticks of a base.

library ieee;
use ieee.std_logic_1164.all;

package clocked_bench_pkg is

  -- Past the next edge, and until what it has changed is to be seen.
  procedure wait_for_clock (signal clk : in std_ulogic);

  -- The same after so many.
  procedure wait_clocks (signal clk : in std_ulogic; count : in natural);

  -- So many pulses of a clock, each with a clock after it.
  procedure give_ticks (signal clk : in std_ulogic; signal tick : out std_ulogic; count : in natural);

end package;

package body clocked_bench_pkg is

  procedure wait_for_clock (signal clk : in std_ulogic) is
  begin
    wait until rising_edge(clk);
    wait for 1 ns;
  end procedure;

  procedure wait_clocks (signal clk : in std_ulogic; count : in natural) is
  begin
    for i in 1 to count loop
      wait until rising_edge(clk);
    end loop;
    wait for 1 ns;
  end procedure;

  procedure give_ticks (signal clk : in std_ulogic; signal tick : out std_ulogic; count : in natural) is
  begin
    for i in 1 to count loop
      tick <= '1';
      wait_for_clock(clk);
      tick <= '0';
      wait_for_clock(clk);
    end loop;
  end procedure;

end package body;
