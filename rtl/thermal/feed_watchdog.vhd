-- SPDX-License-Identifier: Apache-2.0
-- Watches the software: it must feed two keys in turn, neither too late nor too early.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

-- The keys are sent from different places of the program, so a loop that misses one of them is
-- detected; the window detects a runaway program that feeds as fast as it can.
entity feed_watchdog is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Every tick_cycles clocks.
    tick : in std_ulogic;
    timeout_ticks : in tick_count_t;
    -- Software feeds: this key, or with neither bit a wrong one.
    fed : in std_ulogic;
    first_key : in std_ulogic;
    second_key : in std_ulogic;
    -- The last complete feed is less than the time-out ago.
    alive : out std_ulogic := '0';
    -- For one clock: a wrong key, the same key again, or the first key before the window opens.
    violated : out std_ulogic := '0'
  );
end entity;

architecture rtl of feed_watchdog is

  -- The window opens after so large a part of the time-out: a sixteenth.
  constant window_shift : natural := 4;

  -- Ticks until the watchdog expires; 0 after reset.
  signal ticks_left : tick_count_t := (others => '0');
  -- Since the last first key, or the last violation; stays at its largest value.
  signal ticks_since_first : tick_count_t := (others => '1');
  signal second_is_next : std_ulogic := '0';
  signal window_open : std_ulogic;

begin

  window_open <= '1' when ticks_since_first >= shift_right(timeout_ticks, window_shift) else '0';

  watch : process
  begin
    wait until rising_edge(clk);
    violated <= '0';
    alive <= '1' when ticks_left /= 0 else '0';
    if tick = '1' and ticks_left /= 0 then
      ticks_left <= ticks_left - 1;
    end if;
    if tick = '1' and ticks_since_first /= (ticks_since_first'range => '1') then
      ticks_since_first <= ticks_since_first + 1;
    end if;
    if fed then
      if second_is_next = '0' and first_key = '1' and window_open = '1' then
        second_is_next <= '1';
        ticks_since_first <= (others => '0');
      elsif second_is_next = '1' and second_key = '1' then
        second_is_next <= '0';
        ticks_left <= timeout_ticks;
      else
        second_is_next <= '0';
        ticks_since_first <= (others => '0');
        ticks_left <= (others => '0');
        alive <= '0';
        violated <= '1';
      end if;
    end if;
    if reset then
      ticks_left <= (others => '0');
      ticks_since_first <= (others => '1');
      second_is_next <= '0';
      alive <= '0';
      violated <= '0';
    end if;
  end process;

end architecture;
