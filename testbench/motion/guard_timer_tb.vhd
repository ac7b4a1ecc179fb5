-- SPDX-License-Identifier: Apache-2.0
-- A guard time lasts its clocks, 0 as 1, also if it begins while another runs; both flags say in each clock
-- what is left of it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

library std;
use std.env.finish;

entity guard_timer_tb is
end entity;

architecture simulation of guard_timer_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal start : std_ulogic := '0';
  signal clocks : guard_clocks_t := (others => '0');
  signal left : guard_clocks_t;
  signal over, ending : std_ulogic;

begin

  clk <= not clk after 10 ns;

  timer : entity work.guard_timer
    port map (
      clk => clk, reset => reset, start => start, clocks => clocks, left => left, over => over,
      ending => ending);

  test : process
    procedure expect(expected : natural) is
    begin
      assert left = expected report "left" severity failure;
      assert (over = '1') = (expected = 0) report "over" severity failure;
      assert (ending = '1') = (expected <= 1) report "ending" severity failure;
    end procedure;

    procedure next_clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure begin_time(number : natural) is
    begin
      start <= '1';
      clocks <= to_unsigned(number, clocks'length);
      next_clock;
      start <= '0';
      clocks <= (others => '1');
    end procedure;
  begin
    expect(0);
    next_clock;
    reset <= '0';
    next_clock;
    expect(0);

    -- To its end, and a few clocks beyond.
    for number in 0 to 9 loop
      begin_time(number);
      for passed in 1 to number + 4 loop
        expect(maximum(number - passed, 0));
        next_clock;
      end loop;
    end loop;

    -- The longest time, and one that begins in any clock of another.
    begin_time(4095);
    expect(4094);
    for running in 0 to 6 loop
      for number in 0 to 6 loop
        begin_time(running);
        for passed in 1 to number loop
          next_clock;
        end loop;
        begin_time(number);
        expect(maximum(number - 1, 0));
      end loop;
    end loop;

    -- A reset ends it.
    begin_time(9);
    reset <= '1';
    next_clock;
    expect(0);
    finish;
  end process;

end architecture;
