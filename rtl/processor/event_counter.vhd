-- SPDX-License-Identifier: Apache-2.0
-- 64-bit event counter (mcycle, minstret), read and written by software in halves.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity event_counter is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- An event in this clock.
    increment : in std_ulogic;
    -- A written half does not count in this clock.
    write_low : in std_ulogic;
    write_high : in std_ulogic;
    write_data : in word_t;
    -- Including the event of this clock; the value in the next clock, without reset.
    count : out unsigned(63 downto 0);
    next_count : out unsigned(63 downto 0)
  );
end entity;

architecture rtl of event_counter is

  signal counted : unsigned(63 downto 0);

begin

  count <= counted + unsigned'(0 => increment);
  next_count(31 downto 0) <= unsigned(write_data) when write_low else count(31 downto 0);
  next_count(63 downto 32) <= unsigned(write_data) when write_high else count(63 downto 32);

  count_events : process
  begin
    wait until rising_edge(clk);
    counted <= next_count;
    if reset then
      counted <= (others => '0');
    end if;
  end process;

end architecture;
