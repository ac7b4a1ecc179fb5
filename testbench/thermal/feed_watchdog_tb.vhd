-- SPDX-License-Identifier: Apache-2.0
-- Two keys in turn keep the watchdog alive; anything else, or nothing, makes it expire at the
-- specified tick.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.thermal_pkg.all;

entity feed_watchdog_tb is
end entity;

architecture simulation of feed_watchdog_tb is

  constant timeout : positive := 64;
  -- A sixteenth of it: the first key may come so many ticks after the last one.
  constant window : positive := 4;

  type key_t is (first, second, wrong);

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal tick, fed, first_key, second_key : std_ulogic := '0';
  signal timeout_ticks : tick_count_t := to_unsigned(timeout, tick_count_bits);
  signal alive, violated : std_ulogic;

begin

  clk <= not clk after 10 ns;

  watchdog : entity work.feed_watchdog
    port map (
      clk => clk, reset => reset, tick => tick, timeout_ticks => timeout_ticks, fed => fed,
      first_key => first_key, second_key => second_key, alive => alive, violated => violated);

  test : process

    procedure feed (key : key_t; is_mistake : boolean := false; with_tick : std_ulogic := '0') is
    begin
      fed <= '1';
      first_key <= '1' when key = first else '0';
      second_key <= '1' when key = second else '0';
      tick <= with_tick;
      wait_for_clock(clk);
      fed <= '0';
      tick <= '0';
      first_key <= '0';
      second_key <= '0';
      finds_mistakes : assert (violated = '1') = is_mistake
        report key_t'image(key) & ": violated is " & to_string(violated) severity error;
      is_dead_at_once : assert alive = '0' or not is_mistake report "alive" severity error;
      wait_for_clock(clk);
      says_it_once : assert violated = '0' report "violated for two clocks" severity error;
    end procedure;

    procedure expect_alive (expected : std_ulogic; why : string) is
    begin
      wait_for_clock(clk);
      lives_as_it_should : assert alive = expected
        report why & ": alive is " & to_string(alive) severity error;
    end procedure;

    procedure feed_both is
    begin
      feed(first);
      feed(second);
      expect_alive('1', "fed");
    end procedure;

    procedure restart is
    begin
      reset <= '1';
      wait_for_clock(clk);
      reset <= '0';
    end procedure;

  begin
    wait_for_clock(clk);
    restart;
    expect_alive('0', "after reset");
    give_ticks(clk, tick, 3);
    expect_alive('0', "never fed");

    -- The first feed after reset waits for no window, however late it comes, and lasts for the time-out to
    -- the tick.
    feed_both;
    give_ticks(clk, tick, timeout - 1);
    expect_alive('1', "a tick before the time-out");
    give_ticks(clk, tick, 1);
    expect_alive('0', "at the time-out");
    give_ticks(clk, tick, 2);
    expect_alive('0', "after the time-out");
    no_mistake_was_made : assert violated = '0' report "violated" severity error;

    -- A feed restarts the time, also in the clock of a tick.
    feed_both;
    give_ticks(clk, tick, timeout - 1);
    feed(first);
    feed(second, with_tick => '1');
    give_ticks(clk, tick, timeout - 1);
    expect_alive('1', "fed in the clock of a tick");
    give_ticks(clk, tick, 1);
    expect_alive('0', "at the time-out of the second feed");

    -- Half a feed is none, and the second key may come at any later time.
    feed_both;
    give_ticks(clk, tick, window);
    feed(first);
    give_ticks(clk, tick, timeout - window);
    expect_alive('0', "only the first key");
    give_ticks(clk, tick, 10);
    feed(second);
    expect_alive('1', "the second key comes late");

    -- The window opens a sixteenth of the time-out after the last first key.
    give_ticks(clk, tick, timeout);
    feed_both;
    give_ticks(clk, tick, window - 1);
    feed(first, is_mistake => true);
    expect_alive('0', "too early");
    -- After a mistake, too.
    give_ticks(clk, tick, window - 1);
    feed(first, is_mistake => true);
    give_ticks(clk, tick, window);
    feed(first);
    feed(second);
    expect_alive('1', "after the window has opened");
    give_ticks(clk, tick, window);
    feed_both;
    feed(first, is_mistake => true);

    -- Wrong keys, and the right ones out of turn.
    give_ticks(clk, tick, window);
    feed(second, is_mistake => true);
    give_ticks(clk, tick, window);
    feed_both;
    give_ticks(clk, tick, 1);
    feed(second, is_mistake => true);
    give_ticks(clk, tick, window);
    feed_both;
    feed(wrong, is_mistake => true);
    -- It has forgotten the first key: the second alone is a mistake again.
    give_ticks(clk, tick, window);
    feed(first);
    feed(wrong, is_mistake => true);
    feed(second, is_mistake => true);
    expect_alive('0', "after mistakes");
    give_ticks(clk, tick, window);
    feed(first);
    give_ticks(clk, tick, window);
    feed(first, is_mistake => true);
    give_ticks(clk, tick, window);
    feed(second, is_mistake => true);
    give_ticks(clk, tick, window);
    feed_both;

    -- What software does not feed is no key.
    first_key <= '1';
    second_key <= '1';
    wait_for_clock(clk);
    wait_for_clock(clk);
    is_no_feed : assert violated = '0' and alive = '1' report "key without a write" severity error;
    first_key <= '0';
    second_key <= '0';

    -- Reset clears the first key, the window and the alive state.
    give_ticks(clk, tick, window);
    feed(first);
    restart;
    is_dead_in_reset : assert alive = '0' report "alive" severity error;
    expect_alive('0', "after a later reset");
    give_ticks(clk, tick, 2);
    expect_alive('0', "some ticks after a later reset");
    feed_both;
    restart;
    feed(second, is_mistake => true);
    restart;
    feed(wrong, is_mistake => true);
    restart;
    feed_both;
    fed <= '1';
    wait_for_clock(clk);
    restart;
    mistakes_end_with_reset : assert violated = '0' report "violated in reset" severity error;
    fed <= '0';
    wait_for_clock(clk);

    -- Another time-out, with another window.
    restart;
    timeout_ticks <= to_unsigned(160, tick_count_bits);
    feed_both;
    give_ticks(clk, tick, 9);
    feed(first, is_mistake => true);
    give_ticks(clk, tick, 10);
    feed_both;
    give_ticks(clk, tick, 159);
    expect_alive('1', "longer time-out");
    give_ticks(clk, tick, 1);
    expect_alive('0', "longer time-out");
    finish;
  end process;

end architecture;
