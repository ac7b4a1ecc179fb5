-- SPDX-License-Identifier: Apache-2.0
-- A 64-bit counter of events, read and written by software in halves (mcycle, minstret).

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity event_counter is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Counts the clocks in which this is high, unless one of its halves is written.
    happens : in std_ulogic;
    -- Takes back the last event counted, in a clock in which none happens and nothing is written.
    take_back : in std_ulogic;
    write_low : in std_ulogic;
    write_high : in std_ulogic;
    write_data : in word_t;
    count : out unsigned(63 downto 0);
    -- In the next clock.
    next_count : out unsigned(63 downto 0)
  );
end entity;

architecture rtl of event_counter is
begin

  choose_next : process (all)
  begin
    next_count <= count;
    if write_low then
      next_count(31 downto 0) <= unsigned(write_data);
    elsif write_high then
      next_count(63 downto 32) <= unsigned(write_data);
    elsif happens or take_back then
      -- One more, or all ones more, which is one less.
      next_count <= count + unsigned'((63 downto 1 => take_back) & '1');
    end if;

    if reset then
      next_count <= (others => '0');
    end if;
  end process;

  count_events : process
  begin
    wait until rising_edge(clk);
    count <= next_count;
  end process;

end architecture;
