-- SPDX-License-Identifier: Apache-2.0
-- Counts down one guard time of a motor driver, and knows from the clock before when it is over.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity guard_timer is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- A time of so many clocks begins with the next clock, also while another runs; 0 is 1.
    start : in std_ulogic;
    clocks : in guard_clocks_t;
    -- Clocks left after this one.
    left : out guard_clocks_t := (others => '0');
    -- None is left; at most one is. Registers, because they decide whether a tick is made.
    over : out std_ulogic := '1';
    ending : out std_ulogic := '1'
  );
end entity;

architecture rtl of guard_timer is
begin

  count_down : process
  begin
    wait until rising_edge(clk);
    if start then
      left <= (others => '0');
      if clocks /= 0 then
        left <= clocks - 1;
      end if;
      over <= '1' when clocks <= 1 else '0';
      ending <= '1' when clocks <= 2 else '0';
    elsif not over then
      left <= left - 1;
      over <= ending;
      ending <= '1' when left <= 2 else '0';
    end if;

    if reset then
      left <= (others => '0');
      over <= '1';
      ending <= '1';
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl a_time_that_is_over_has_no_clocks_left : assert always (over = '1') = (left = 0);
  -- psl an_ending_time_has_one_clock_left : assert always (ending = '1') = (left <= 1);

end architecture;
