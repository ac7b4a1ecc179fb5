-- SPDX-License-Identifier: Apache-2.0
-- The base gets as much time as the scale says, in leaps that it can do, and the scale keeps to its ramp.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.random_source_pkg.all;
use work.step_generator_pkg.all;

entity feed_override_tb is
end entity;

architecture simulation of feed_override_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal moving : std_ulogic := '0';
  signal target : unsigned(17 downto 0) := to_unsigned(65536, 18);
  signal slope : slope_t := (others => '0');
  signal accelerating, decelerating : std_ulogic := '0';
  signal braking : std_ulogic := '0';
  signal brake_slope : slope_t := (others => '0');
  signal stalled : std_ulogic := '0';
  signal longest_leap : leap_t := to_unsigned(2, 2);
  signal advance : std_ulogic;
  signal leap : leap_t;
  signal scale : scale_t;
  signal standing : std_ulogic;
  signal working : std_ulogic;

  -- Base clocks done and owed, see the watch.
  signal done : natural;
  signal owed : unsigned(63 downto 0);
  signal clear : boolean := false;

begin

  clk <= not clk after 10 ns;

  pace : entity work.feed_override
    port map (
      clk => clk, reset => reset, moving => moving, target => target, slope => slope,
      accelerating => accelerating, decelerating => decelerating, braking => braking,
      brake_slope => brake_slope, stalled => stalled, longest_leap => longest_leap,
      advance => advance, leap => leap, scale => scale, standing => standing, working => working);

  watch : entity work.feed_override_watch
    port map (
      clk => clk, reset => reset, moving => moving, target => target, slope => slope,
      accelerating => accelerating, decelerating => decelerating, braking => braking,
      brake_slope => brake_slope, stalled => stalled, longest_leap => longest_leap,
      advance => advance, leap => leap, scale => scale, standing => standing, working => working,
      done => done, owed => owed, clear => clear);

  test : process
    variable random : random_source_t;

    -- The base lags by less than `most` base clocks, and never leads by more than the clock in hand.
    procedure expect_lag_below(most : positive) is
      variable lag : integer;
    begin
      lag := to_integer(owed(62 downto 32)) - done;
      assert lag < most and lag >= -4
        report "base time lags by " & to_string(lag) severity failure;
    end procedure;

    procedure rest_at(value : natural) is
    begin
      moving <= '0';
      target <= to_unsigned(value, 18);
      longest_leap <= to_unsigned(0, 2);
      clear <= true;
      wait_clocks(clk, 3);
      longest_leap <= to_unsigned(2, 2);
      assert scale = (to_unsigned(value, 18) & x"0000") report "not at once at rest" severity failure;
      clear <= false;
    end procedure;

    -- The way of the scale in 1000 clocks from `from` in 2^-16 to `towards`, in 2^-32: a slope of 2^12 is
    -- less than 1/1000 of 1.
    procedure expect_change(from, towards : natural; per_clock : natural) is
      variable begun : scale_t;
      variable change : integer;
    begin
      rest_at(from);
      slope <= x"00001000";
      moving <= '1';
      wait_clocks(clk, 10);
      begun := scale;
      target <= to_unsigned(towards, 18);
      wait_clocks(clk, 1000);
      change := to_integer(signed(scale(33 downto 2)) - signed(begun(33 downto 2))) * 4;
      assert abs change = 1000 * per_clock
        report "from " & to_string(from) & ": " & to_string(change) severity failure;
      assert per_clock = 0 or (change > 0) = (towards > from) severity failure;
    end procedure;

    variable done_before : natural;
  begin
    random.seed(3, 4);
    wait_clocks(clk, 2);
    reset <= '0';
    wait_clocks(clk, 1);

    -- A scale of 1 is an advance in every clock, from the first on.
    rest_at(65536);
    moving <= '1';
    for i in 1 to 100 loop
      assert advance = '1' and leap = 0 severity failure;
      wait_clocks(clk, 1);
    end loop;
    assert done = 100 severity failure;
    assert working = '0' report "works at a scale of 1" severity failure;
    moving <= '0';
    wait_clocks(clk, 3);
    assert working = '0' report "works at rest" severity failure;
    target <= to_unsigned(40000, 18);
    wait_clocks(clk, 3);
    assert working = '0' report "works at rest" severity failure;
    moving <= '1';
    wait_clocks(clk, 3);
    assert working = '1' severity failure;

    -- Any constant scale, with and without stalls: 1000 clocks of it are owed and done.
    for run in 1 to 60 loop
      rest_at(random.between(0, 2 ** 18 - 1));
      moving <= '1';
      for i in 1 to 1000 loop
        wait_clocks(clk, 1);
        stalled <= '1' when run mod 2 = 0 and random.between(0, 3) = 0 else '0';
        expect_lag_below(4);
      end loop;
      stalled <= '0';
    end loop;

    -- 2.5 is done as leaps of 2 and 4, or of 2 only where no longer ones are possible: then it is 2.
    rest_at(163840);
    moving <= '1';
    wait_clocks(clk, 1000);
    assert abs (done - 2500) <= 4 report to_string(done) severity failure;
    longest_leap <= to_unsigned(1, 2);
    wait_clocks(clk, 2);
    done_before := done;
    wait_clocks(clk, 1000);
    assert done - done_before = 2000 severity failure;
    longest_leap <= to_unsigned(0, 2);
    wait_clocks(clk, 2);
    done_before := done;
    wait_clocks(clk, 1000);
    assert done - done_before = 1000 severity failure;
    -- What was not possible is not caught up, but for three.
    longest_leap <= to_unsigned(2, 2);
    wait_clocks(clk, 2);
    done_before := done;
    wait_clocks(clk, 1000);
    assert abs (done - done_before - 2500) <= 5 severity failure;

    -- The ramp: from 1 to 0 in 1000 clocks are 500 base clocks, then nothing, and back.
    rest_at(65536);
    slope <= to_unsigned(4294968, 32);
    moving <= '1';
    wait_clocks(clk, 10);
    target <= to_unsigned(0, 18);
    wait_clocks(clk, 990);
    assert standing = '0' and scale /= 0 severity failure;
    wait_clocks(clk, 20);
    assert standing = '1' and scale = 0 severity failure;
    assert abs (done - 510) <= 1 report to_string(done) severity failure;
    done_before := done;
    wait_clocks(clk, 5000);
    assert done = done_before and standing = '1' severity failure;
    target <= to_unsigned(3 * 65536, 18);
    wait_clocks(clk, 2990);
    assert scale < 3 * scale_of_one severity failure;
    wait_clocks(clk, 20);
    assert scale = (to_unsigned(3 * 65536, 18) & x"0000") severity failure;
    expect_lag_below(4);

    -- A slope of 0 keeps the scale; the brake has its own, and its target is 0.
    slope <= (others => '0');
    target <= to_unsigned(65536, 18);
    wait_clocks(clk, 1000);
    assert scale = (to_unsigned(3 * 65536, 18) & x"0000") severity failure;
    brake_slope <= x"80000000";
    braking <= '1';
    wait_clocks(clk, 5);
    assert scale /= 0 severity failure;
    wait_clocks(clk, 3);
    assert scale = 0 severity failure;
    wait_clocks(clk, 3);
    assert standing = '1' severity failure;
    moving <= '0';
    braking <= '0';
    wait_clocks(clk, 2);
    assert scale = scale_of_one severity failure;

    -- Where the base accelerates while the scale rises, or decelerates while it falls, what both do adds up:
    -- the scale is left (1 - s^2) of its slope or less, and waits from 7/8 on.
    accelerating <= '1';
    expect_change(from => 0, towards => 65536, per_clock => 2048);
    expect_change(from => 32000, towards => 65536, per_clock => 2048);
    expect_change(from => 33000, towards => 65536, per_clock => 1024);
    expect_change(from => 50000, towards => 65536, per_clock => 512);
    expect_change(from => 57344, towards => 65536, per_clock => 0);
    expect_change(from => 65536, towards => 131072, per_clock => 0);
    expect_change(from => 57000, towards => 0, per_clock => 4096);
    accelerating <= '0';
    decelerating <= '1';
    expect_change(from => 65536, towards => 0, per_clock => 0);
    expect_change(from => 57000, towards => 0, per_clock => 512);
    expect_change(from => 40000, towards => 0, per_clock => 1024);
    expect_change(from => 30000, towards => 0, per_clock => 2048);
    expect_change(from => 57344, towards => 65536, per_clock => 4096);

    -- A hold that waits begins with the end of the ramp, and the brake waits for nothing.
    rest_at(65536);
    moving <= '1';
    wait_clocks(clk, 5);
    target <= to_unsigned(0, 18);
    wait_clocks(clk, 1000);
    assert scale = scale_of_one severity failure;
    decelerating <= '0';
    wait_clocks(clk, 11);
    assert scale = scale_of_one - 10 * 4096 or scale = scale_of_one - 11 * 4096 severity failure;
    decelerating <= '1';
    wait_clocks(clk, 3);
    done_before := to_integer(scale(31 downto 12));
    wait_clocks(clk, 100);
    assert to_integer(scale(31 downto 12)) = done_before severity failure;
    braking <= '1';
    wait_clocks(clk, 5);
    assert scale = 0 severity failure;
    braking <= '0';
    decelerating <= '0';

    -- Steps of the ramp that overshoot end at the target.
    slope <= x"FFFFFFFF";
    moving <= '1';
    target <= to_unsigned(65537, 18);
    wait_clocks(clk, 2);
    assert scale = (to_unsigned(65537, 18) & x"0000") severity failure;
    target <= to_unsigned(65530, 18);
    wait_clocks(clk, 2);
    assert scale = (to_unsigned(65530, 18) & x"0000") severity failure;

    -- A reset in motion: the scale is 1, nothing is owed, no leap is left.
    for from in 0 to 3 loop
      rest_at(3 * 65536 - from * 60000);
      moving <= '1';
      wait_clocks(clk, 20 + from);
      reset <= '1';
      target <= to_unsigned(65536, 18);
      wait_clocks(clk, 1);
      assert scale = scale_of_one and advance = '0' and leap = 0 and standing = '0' severity failure;
      reset <= '0';
      clear <= true;
      wait_clocks(clk, 1);
      clear <= false;
      longest_leap <= "10";
      done_before := done;
      for i in 1 to 20 loop
        wait_clocks(clk, 1);
        assert advance = '1' and leap = 0 and working = '0'
          report "owed from before a reset" severity failure;
      end loop;
    end loop;
    rest_at(0);
    moving <= '1';
    wait_clocks(clk, 5);
    assert standing = '1' severity failure;
    reset <= '1';
    wait_clocks(clk, 1);
    assert standing = '0' and scale = scale_of_one severity failure;

    finish;
  end process;

end architecture;
