-- SPDX-License-Identifier: Apache-2.0
-- The base ticks at the asked rate, joins segments without a dead clock, freezes, floors and stops.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;

entity time_base_tb is
end entity;

architecture simulation of time_base_tb is

  constant half : unsigned(63 downto 0) := x"8000000000000000";
  constant quarter : unsigned(63 downto 0) := x"4000000000000000";

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal advance : std_ulogic := '1';
  signal leap : leap_t := (others => '0');
  signal longest_leap : leap_t;
  signal run : std_ulogic := '0';
  signal start : std_ulogic := '0';
  signal stop : std_ulogic := '0';
  signal rate_floor : unsigned(30 downto 0) := to_unsigned(1, 31);
  signal head_valid : std_ulogic := '0';
  signal head : segment_t := (
    backward => x"00", ahead => x"00", behind => x"00", continues_line => '0',
    ends_motion => '0', waits_for_start => '0', stop_on => stop_condition_none,
    line_ticks => (others => '0'), ticks => (others => '0'),
    rate => (others => '0'), acceleration => (others => '0'), jerk => (others => '0'));
  signal take : std_ulogic;
  signal due : std_ulogic;
  signal axes_ready : std_ulogic := '1';
  signal tick : std_ulogic;
  signal stalled : std_ulogic;
  signal active : std_ulogic;
  signal stop_on : stop_condition_t;
  signal waiting : std_ulogic;
  signal segments : count_t;
  signal underruns : count_t;
  signal stalls : count_t;

  -- Counted here.
  signal ticks : natural := 0;
  signal clocks_between_ticks : natural := 0;
  signal since_tick : natural := 0;
  signal clock_number : natural := 0;

begin

  clk <= not clk after 10 ns;

  base : entity work.time_base
    port map (
      clk => clk, always_clk => clk, reset => reset,
      advance => advance, leap => leap, longest_leap => longest_leap,
      run => run, start => start, stop => stop, rate_floor => rate_floor,
      head_valid => head_valid, head => head, take => take, due => due,
      axes_ready => axes_ready, tick => tick, stalled => stalled, active => active,
      stop_on => stop_on, waiting => waiting, segments => segments, underruns => underruns,
      stalls => stalls);

  count : process
  begin
    wait until rising_edge(clk);
    since_tick <= since_tick + 1;
    clock_number <= clock_number + 1;
    if tick then
      ticks <= ticks + 1;
      clocks_between_ticks <= since_tick;
      since_tick <= 1;
    end if;
  end process;

  test : process
    procedure clocks(number : natural) is
    begin
      for i in 1 to number loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure offer(number : positive; rate : unsigned; ends_motion : std_ulogic := '1';
      acceleration : signed(63 downto 0) := (others => '0')) is
    begin
      head.ticks <= to_unsigned(number, 31);
      head.rate <= rate;
      head.acceleration <= acceleration;
      head.ends_motion <= ends_motion;
      head_valid <= '1';
      wait until rising_edge(clk) and take = '1';
      head_valid <= '0';
    end procedure;

    procedure wait_for_rest is
    begin
      wait until rising_edge(clk) and active = '0';
      clocks(2);
    end procedure;

    variable ticks_before : natural;
    variable ticks_in_between : natural;
    variable began : natural;
    type naturals_t is array (natural range <>) of natural;
    variable clocks_at_leap : naturals_t(0 to 2);
  begin
    clocks(2);
    reset <= '0';
    clocks(2);

    -- Nothing starts before it may.
    head_valid <= '1';
    clocks(5);
    assert active = '0' severity failure;
    head_valid <= '0';
    run <= '1';

    -- From rest the first tick comes after a whole period.
    offer(3, quarter);
    clocks(1);
    ticks_before := ticks;
    clocks(3);
    assert ticks = ticks_before severity failure;
    clocks(1);
    assert ticks = ticks_before + 1 report "first tick not after 4 clocks" severity failure;
    wait_for_rest;
    assert ticks = ticks_before + 3 severity failure;
    assert clocks_between_ticks = 4 severity failure;
    assert underruns = 0 severity failure;

    -- Single ticks at full rate follow each other every second clock.
    ticks_before := ticks;
    offer(1, half, '0');
    for i in 1 to 9 loop
      offer(1, half, '0');
      clocks(1);
      assert i = 1 or clocks_between_ticks = 2 report "dead clock between segments" severity failure;
    end loop;
    wait_for_rest;
    assert ticks = ticks_before + 10 severity failure;
    assert underruns = 1 report "the end of motion was not intended" severity failure;

    -- What is left of the phase goes over to the next segment: 10 ticks at 0.3 take 34 clocks in all.
    ticks_before := ticks;
    offer(1, x"4CCCCCCCCCCCCCCD", '0');
    began := clock_number;
    for i in 2 to 10 loop
      offer(1, x"4CCCCCCCCCCCCCCD", '0');
    end loop;
    wait until rising_edge(clk) and active = '0';
    assert clock_number - began = 35 report to_string(clock_number - began) & " clocks" severity failure;
    clocks(2);

    -- Standing axes and standing time delay, and nothing is lost.
    ticks_before := ticks;
    offer(4, half);
    axes_ready <= '0';
    clocks(20);
    assert ticks = ticks_before severity failure;
    assert stalls = 18 report to_string(to_integer(stalls)) & " stalls" severity failure;
    axes_ready <= '1';
    advance <= '0';
    clocks(20);
    assert ticks = ticks_before severity failure;
    advance <= '1';
    wait_for_rest;
    assert ticks = ticks_before + 4 severity failure;

    -- The rate stays between floor (here 2^-10) and 1/2. 2^62 is a change of 2^-22 per clock.
    rate_floor <= (22 => '1', others => '0');
    offer(40, half / 128, '1', x"C000000000000000");
    wait_for_rest;
    assert clocks_between_ticks = 1024 report to_string(clocks_between_ticks) severity failure;
    offer(10000, half - half / 512, '1', x"4000000000000000");
    clocks(8000);
    ticks_in_between := ticks;
    clocks(8000);
    assert ticks - ticks_in_between = 4000 report "not at a rate of 1/2" severity failure;
    wait_for_rest;
    assert clocks_between_ticks = 2 report to_string(clocks_between_ticks) severity failure;
    assert ticks = ticks_before + 4 + 10040 severity failure;

    -- A stop ends the segment at once, in a clock with a tick or without one.
    head.stop_on <= (mask => x"A5", on_change => '1', on_release => '0', brakes => '1');
    for delay in 10 to 11 loop
      offer(1000, half);
      clocks(delay);
      assert stop_on = head.stop_on severity failure;
      stop <= '1';
      wait for 1 ns;
      assert tick = '0' report "tick in the clock of a stop" severity failure;
      ticks_before := ticks;
      clocks(1);
      stop <= '0';
      clocks(10);
      assert active = '0' and ticks = ticks_before severity failure;
    end loop;
    assert segments = 26 report to_string(to_integer(segments)) & " segments" severity failure;

    -- A segment that waits begins from rest at its start, although it was there in time; this is no
    -- underrun. A start that nothing waits for is not remembered.
    began := to_integer(underruns);
    start <= '1';
    clocks(1);
    start <= '0';
    head.waits_for_start <= '1';
    ticks_before := ticks;
    head_valid <= '1';
    clocks(30);
    assert active = '0' and waiting = '1' report "did not wait" severity failure;
    start <= '1';
    wait until rising_edge(clk) and take = '1';
    start <= '0';
    head.waits_for_start <= '0';
    head.ends_motion <= '0';
    wait until rising_edge(clk) and take = '1';
    head.waits_for_start <= '1';
    clocks(1);
    assert active = '1' and waiting = '0' severity failure;
    wait_for_rest;
    assert ticks = ticks_before + 2000 severity failure;
    clocks(30);
    assert waiting = '1' and ticks = ticks_before + 2000 severity failure;
    head_valid <= '0';
    clocks(1);
    assert waiting = '0' and underruns = began severity failure;
    head.waits_for_start <= '0';
    head.ends_motion <= '1';

    -- Leaps of 4 take a ramp through the same ticks in a quarter of the clocks, and the base asks for
    -- shorter ones where it nears the highest rate.
    rate_floor <= to_unsigned(1, 31);
    for leaps in 0 to 2 loop
      ticks_before := ticks;
      leap <= to_unsigned(leaps, 2);
      offer(100, half / 64, '1', x"0400000000000000");
      began := clock_number;
      clocks(2);
      assert longest_leap = 2 severity failure;
      wait_for_rest;
      assert ticks = ticks_before + 100 severity failure;
      -- Without acceleration it would be 12800 clocks.
      clocks_at_leap(leaps) := clock_number - began - 2;
    end loop;
    assert clocks_at_leap(0) < 12800 and abs (clocks_at_leap(1) * 2 - clocks_at_leap(0)) <= 4 and
      abs (clocks_at_leap(2) * 4 - clocks_at_leap(0)) <= 8
      report to_string(clocks_at_leap(0)) & " " & to_string(clocks_at_leap(1)) & " " &
        to_string(clocks_at_leap(2))
      severity failure;
    leap <= "00";
    for sixty_fourths in 1 to 32 loop
      offer(100, to_unsigned(sixty_fourths, 6) & (57 downto 0 => '0'));
      clocks(2);
      if sixty_fourths < 7 then
        assert longest_leap = 2 severity failure;
      elsif sixty_fourths < 15 then
        assert longest_leap = 1 severity failure;
      else
        assert longest_leap = 0 severity failure;
      end if;
      wait_for_rest;
    end loop;
    rate_floor <= (28 => '1', others => '0');
    wait for 1 ns;
    assert longest_leap = 0 report "the floor is at 1/4, the leap too long" severity failure;

    finish;
  end process;

end architecture;
