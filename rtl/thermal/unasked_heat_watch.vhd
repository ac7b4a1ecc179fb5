-- SPDX-License-Identifier: Apache-2.0
-- Detects a heater that heats although its gate is closed: a transistor or wire that conducts
-- by itself.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

-- The count of the first conversion after the settling time is the reference. While the part cools the
-- reference
-- follows; where the count falls an eighth below it the part is heated. That is 4 to 7 K at the temperatures
-- of
-- beds and hotends. Heat that was still on its way to the sensor comes within the settling time; a part
-- warmed by
-- its neighbour stays above `hot_count`.
entity unasked_heat_watch is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    tick : in std_ulogic;
    gate : in std_ulogic;
    reading : in sensor_reading_t;
    limits_set : in std_ulogic;
    settle_ticks : in settle_t;
    hot_count : in unsigned(31 downto 0);
    -- For one clock, with every conversion that shows it.
    found : out std_ulogic := '0'
  );
end entity;

architecture rtl of unasked_heat_watch is

  signal closed_ticks : settle_t := (others => '0');
  signal settled : std_ulogic;
  signal has_reference : std_ulogic := '0';
  signal reference : unsigned(31 downto 0) := (others => '0');

begin

  settled <= '1' when closed_ticks >= settle_ticks else '0';

  watch : process
  begin
    wait until rising_edge(clk);
    found <= '0';
    if tick = '1' and closed_ticks /= (closed_ticks'range => '1') then
      closed_ticks <= closed_ticks + 1;
    end if;
    if settled = '1' and reading.updated = '1' and reading.valid = '1' then
      if has_reference = '0' or reading.count > reference then
        has_reference <= '1';
        reference <= reading.count;
      elsif reading.count < reference - shift_right(reference, 3) and reading.count < hot_count then
        found <= '1';
      end if;
    end if;
    if gate = '1' or limits_set = '0' then
      closed_ticks <= (others => '0');
      has_reference <= '0';
      found <= '0';
    end if;
    if reset then
      closed_ticks <= (others => '0');
      has_reference <= '0';
      found <= '0';
    end if;
  end process;

end architecture;
