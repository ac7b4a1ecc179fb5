-- SPDX-License-Identifier: Apache-2.0
-- The base ticks at the asked rate, joins segments without a dead clock, freezes, floors and stops.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

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
  signal advance : std_ulogic;
  signal leap : leap_t;
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
  signal axes_ready : std_ulogic;
  signal tick : std_ulogic;
  signal stalled : std_ulogic;
  signal active : std_ulogic;
  signal stop_on : stop_condition_t;
  signal waiting : std_ulogic;
  signal segments : count_t;
  signal underruns : count_t;
  signal stalls : count_t;
  signal accelerating, decelerating : std_ulogic;

  -- The longest leap that the random part takes, where the base permits it.
  signal wanted_leap : natural range 0 to 2 := 0;
  signal leaps_by_itself : boolean := false;
  signal fixed_advance, random_advance, fixed_axes_ready, random_axes_ready : std_ulogic := '1';
  signal fixed_leap, random_leap : leap_t := (others => '0');

  -- Counted here.
  signal ticks : natural := 0;
  signal clocks_between_ticks : natural := 0;
  signal since_tick : natural := 0;
  signal clock_number : natural := 0;

begin

  clk <= not clk after 10 ns;
  leap <= random_leap when leaps_by_itself else fixed_leap;
  advance <= random_advance when leaps_by_itself else fixed_advance;
  axes_ready <= random_axes_ready when leaps_by_itself else fixed_axes_ready;

  disturb : process
    variable seed_1, seed_2 : positive := 11;
    variable chance : real;
  begin
    wait until rising_edge(clk) and leaps_by_itself;
    uniform(seed_1, seed_2, chance);
    random_advance <= '0' when chance < 0.15 else '1';
    uniform(seed_1, seed_2, chance);
    random_axes_ready <= '0' when chance < 0.25 else '1';
  end process;

  base : entity work.time_base
    port map (
      clk => clk, always_clk => clk, reset => reset,
      advance => advance, leap => leap, longest_leap => longest_leap,
      run => run, start => start, stop => stop, rate_floor => rate_floor,
      head_valid => head_valid, head => head, take => take, due => due,
      axes_ready => axes_ready, tick => tick, stalled => stalled, active => active,
      accelerating => accelerating, decelerating => decelerating,
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

  -- What the header of the entity says of a clock, in real numbers: ticks, ticks per clock, and so on.
  follow : process
    constant unit : real := 2.0 ** (-84);
    -- Roundings: of this model, and those that the header gives.
    constant tolerance : real := 1.0e-9;
    variable phase, rate, acceleration, jerk, sum, change, factor, floor_rate : real := 0.0;
    variable was_positive, was_negative, is_moving, is_due : boolean := false;

    function to_real (value : signed(63 downto 0)) return real is
    begin
      return real(to_integer(value(63 downto 32))) * 2.0 ** 32
        + real(to_integer(unsigned(value(31 downto 16)))) * 2.0 ** 16
        + real(to_integer(unsigned(value(15 downto 0))));
    end function;
    -- Of a whole tick.
    function to_real (value : unsigned(63 downto 0)) return real is
    begin
      return real(to_integer(value(63 downto 40))) * 2.0 ** (-24)
        + real(to_integer(value(39 downto 16))) * 2.0 ** (-48)
        + real(to_integer(value(15 downto 0))) * 2.0 ** (-64);
    end function;
  begin
    wait until rising_edge(clk);
    reports_what_the_rate_does : assert not is_moving or
      ((accelerating = '1') = was_positive and (decelerating = '1') = was_negative)
      report "accelerating " & to_string(accelerating) & " decelerating " & to_string(decelerating)
        & " at " & to_string(acceleration) & " after leaps of " & to_string(to_integer(leap))
        & " by " & to_string(jerk)
      severity failure;
    is_stalled_by_an_axis : assert stalled = (due and not axes_ready) severity failure;
    ticks_when_due : assert tick = (due and axes_ready) severity failure;

    was_positive := acceleration > 0.0;
    was_negative := acceleration < 0.0;
    floor_rate := real(to_integer(rate_floor)) * 2.0 ** (-32);
    is_moving := active = '1';
    if active = '1' and advance = '1' and stop = '0' then
      factor := 2.0 ** to_integer(leap);
      sum := phase + factor * rate;
      is_due := due = '1';
      ticks_at_its_instant : assert (sum >= 1.0) = is_due or abs (sum - 1.0) < tolerance
        report "at " & to_string(sum) & " ticks due is " & to_string(due) severity failure;
      if not is_due or axes_ready = '1' then
        phase := sum - 1.0 when is_due else sum;
        rate := rate + factor * acceleration * unit;
        rate := realmax(realmin(rate, 0.5), floor_rate);
        change := jerk;
        for i in 1 to to_integer(leap) loop
          if change * 2.0 < 2.0 ** 63 and change * 2.0 >= -2.0 ** 63 then
            change := change * 2.0;
          end if;
        end loop;
        if acceleration + change < 2.0 ** 63 and acceleration + change >= -2.0 ** 63 then
          acceleration := acceleration + change;
        end if;
      end if;
    end if;
    if take = '1' then
      if active = '0' then
        phase := 0.0;
      end if;
      rate := realmax(to_real(head.rate), floor_rate);
      acceleration := to_real(head.acceleration);
      jerk := to_real(head.jerk);
    end if;
    keeps_the_rate_within_a_half : assert longest_leap = 0 or not (active = '1' or take = '1')
      or rate * 2.0 ** to_integer(longest_leap) <= 0.5
      report "leap of " & to_string(to_integer(longest_leap)) & " at " & to_string(rate) severity failure;
    takes_with_a_tick_or_from_rest : assert take = '0' or active = '0' or tick = '1' severity failure;
    if leaps_by_itself then
      random_leap <= longest_leap when longest_leap < wanted_leap else to_unsigned(wanted_leap, 2);
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
    variable seed_1, seed_2 : positive := 7;
    variable random_acceleration : signed(63 downto 0);
    variable ends : std_ulogic;

    -- At a rate in 64ths.
    function leap_below (rate : natural) return natural is
    begin
      if rate < 7 then
        return 2;
      elsif rate < 15 then
        return 1;
      end if;
      return 0;
    end function;

    impure function random (below : positive) return natural is
      variable number : real;
    begin
      uniform(seed_1, seed_2, number);
      return natural(floor(number * real(below)));
    end function;

    -- Of any size up to 2^`bits`, of both signs.
    impure function random_change (bits : natural) return signed is
      variable value : signed(63 downto 0);
    begin
      value := signed(std_ulogic_vector'(std_ulogic_vector(to_unsigned(random(2 ** 16), 16))
        & std_ulogic_vector(to_unsigned(random(2 ** 24), 24))
        & std_ulogic_vector(to_unsigned(random(2 ** 24), 24))));
      return shift_right(value, 63 - bits);
    end function;

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
    fixed_axes_ready <= '0';
    clocks(20);
    assert ticks = ticks_before severity failure;
    assert stalls = 18 report to_string(to_integer(stalls)) & " stalls" severity failure;
    fixed_axes_ready <= '1';
    fixed_advance <= '0';
    clocks(20);
    assert ticks = ticks_before severity failure;
    fixed_advance <= '1';
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
      fixed_leap <= to_unsigned(leaps, 2);
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
    fixed_leap <= "00";
    for sixty_fourths in 1 to 32 loop
      offer(100, to_unsigned(sixty_fourths, 6) & (57 downto 0 => '0'));
      clocks(2);
      assert longest_leap = leap_below(sixty_fourths) severity failure;
      wait_for_rest;
    end loop;
    rate_floor <= (28 => '1', others => '0');
    wait for 1 ns;
    assert longest_leap = 0 report "the floor is at 1/4, the leap too long" severity failure;
    rate_floor <= to_unsigned(1, 31);

    -- In the clock of the take the head decides, whatever the rate was.
    for sixty_fourths in 1 to 32 loop
      offer(2, to_unsigned(33 - sixty_fourths, 6) & (57 downto 0 => '0'));
      wait_for_rest;
      head.rate <= to_unsigned(sixty_fourths, 6) & (57 downto 0 => '0');
      head.ticks <= to_unsigned(2, 31);
      head_valid <= '1';
      wait until rising_edge(clk) and take = '1';
      assert longest_leap = leap_below(sixty_fourths) severity failure;
      head_valid <= '0';
      wait_for_rest;
    end loop;
    -- And so does the floor, where it is higher.
    offer(1, half / 32);
    wait_for_rest;
    for sixty_fourths in 0 to 31 loop
      rate_floor <= to_unsigned(sixty_fourths, 5) & (25 downto 0 => '1');
      wait for 1 ns;
      assert longest_leap = leap_below(sixty_fourths) severity failure;
    end loop;

    -- Ramps of every shape, with leaps, stalls and pauses: `follow` looks at each clock.
    leaps_by_itself <= true;
    for i in 1 to 300 loop
      wanted_leap <= random(3);
      if random(4) = 0 then
        rate_floor <= shift_right(to_unsigned(random(2 ** 30), 30) & '1', random(24));
      else
        rate_floor <= to_unsigned(1 + random(2 ** 24), 31);
      end if;
      head.jerk <= random_change(random(64)) when random(3) /= 0 else (others => '0');
      random_acceleration := random_change(40 + random(24)) when random(5) /= 0 else (others => '0');
      ends := '0' when random(2) = 0 else '1';
      offer(1 + random(30),
        shift_right(to_unsigned(random(2 ** 24), 24) & (39 downto 0 => '1'), 1 + random(7)),
        ends, random_acceleration);
      clocks(random(30));
      -- To its end, or to the next segment; a slow one is stopped.
      for k in 1 to 150 loop
        exit when active = '0' or random(100) = 0;
        clocks(1);
      end loop;
      if active = '1' and (rate_floor < 2 ** 24 or random(4) = 0) then
        stop <= '1';
        clocks(1);
        stop <= '0';
      end if;
    end loop;
    wait until rising_edge(clk) and active = '0';
    leaps_by_itself <= false;
    head.jerk <= (others => '0');

    -- A rate that would fall below 0 in one clock is held at the floor, too: the tick comes in time.
    rate_floor <= to_unsigned(6144, 31);
    fixed_leap <= "10";
    offer(1, shift_right(x"FE00000000000000", 10), '1', x"8000000000000000");
    wait until rising_edge(clk) and active = '0' for 1 ms;
    assert active = '0' report "stands still at the floor" severity failure;
    rate_floor <= to_unsigned(1, 31);

    -- A jerk so large that a leap of it does not fit is taken with a shorter one.
    for size in 1 to 9 loop
      for leaps in 0 to 2 loop
        for signs in 0 to 3 loop
          fixed_leap <= to_unsigned(leaps, 2);
          random_acceleration := shift_left(to_signed(size, 64), 59);
          head.jerk <= random_acceleration when signs mod 2 = 0 else -random_acceleration;
          random_acceleration := x"A000000000000000" when signs / 2 = 0 else x"5FFFFFFF00000000";
          offer(100, half / 8, '1', random_acceleration);
          clocks(12);
          stop <= '1';
          clocks(1);
          stop <= '0';
          clocks(2);
        end loop;
      end loop;
    end loop;
    fixed_leap <= "00";
    head.jerk <= (others => '0');

    -- An acceleration near its bounds stays there, and does not change its sign.
    rate_floor <= to_unsigned(1000, 31);
    for sign in 0 to 1 loop
      head.jerk <= x"1100000000000000" when sign = 0 else x"EF00000000000000";
      random_acceleration := x"6000000000000000" when sign = 0 else x"A000000000000000";
      offer(200, quarter / 64, '1', random_acceleration);
      clocks(1000);
      assert (accelerating = '1') = (sign = 0) and (decelerating = '1') = (sign = 1) severity failure;
      stop <= '1';
      clocks(1);
      stop <= '0';
    end loop;
    head.jerk <= (others => '0');
    rate_floor <= to_unsigned(1, 31);

    -- A reset ends the segment and forgets what was counted.
    offer(100, quarter, '0');
    fixed_axes_ready <= '0';
    clocks(20);
    assert segments /= 0 and underruns /= 0 and stalls /= 0 and active = '1' severity failure;
    reset <= '1';
    clocks(1);
    reset <= '0';
    fixed_axes_ready <= '1';
    wait for 1 ns;
    assert segments = 0 and underruns = 0 and stalls = 0 and active = '0' severity failure;
    clocks(20);
    assert active = '0' and segments = 0 severity failure;

    finish;
  end process;

end architecture;
