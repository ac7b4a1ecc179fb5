-- SPDX-License-Identifier: Apache-2.0
-- Integrates the tick rate of the segment being executed and makes the ticks that all axes share.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.carries_pkg.all;
use work.step_generator_pkg.all;

-- Each clock: phase += rate; rate += acceleration; acceleration += jerk; a carry of phase is a tick. None of
-- them wraps but the phase: the rate ends at the floor and at 1/2, the acceleration within a jerk of its
-- 64 bits.
-- The rate is at most 1/2, so two ticks are at least two clocks apart: what depends on the tick before
-- is worked out in the clock between. The end of a segment passes the rest of its phase to the next one.
--
-- Exactness. n clocks add up to n*r + n(n-1)/2*a + n(n-1)(n-2)/6*j: Newton's form of a cubic. A ramp
-- R + A*t + J*t^2/2 written as r = R + A/2 + J/6, a = A + J, j = J is therefore met at every clock edge,
-- and a tick comes with the first edge at or after its exact instant. What is left are roundings:
--   the acceleration's last 20 bits do not reach the rate: below 2^-64 a clock;
--   r, a, j themselves: 2^-65, 2^-85, 2^-85.
-- After n clocks the rate is off by less than 2^-65 + n*(2^-64 + 2^-85) + n^2/2*2^-85, and the phase by
-- less than n*2^-65 + n^2/2*(2^-64 + 2^-85) + n^3/6*2^-85 ticks. For n = 10^8 that is 0.007 ticks/s at
-- 50 MHz, and 0.005 ticks; for n = 10^6 the phase is off by 4*10^-8 ticks, a thousandth of a clock at
-- 2000 ticks/s and 50 MHz. The number of ticks is counted, and exact.
entity time_base is
  port (
    -- May be gated without `due`, `take` and `stop`, except for the edge after `due` or `take`.
    clk : in std_ulogic;
    -- The same clock for what moves between ticks, never gated.
    always_clk : in std_ulogic;
    reset : in std_ulogic;

    -- Time passes for the base, by `leap` base clocks: stretches the motion without changing its path.
    advance : in std_ulogic;
    leap : in leap_t;
    -- A leap of the next clock that keeps the rate within 1/2: the longest, but with one tick left as short
    -- as the next segment may need it.
    longest_leap : out leap_t;
    -- Motion may begin from rest.
    run : in std_ulogic;
    -- A segment that waits for it may begin now.
    start : in std_ulogic;
    -- No tick in this clock, and back to rest.
    stop : in std_ulogic;
    -- In 2^-32 ticks per clock.
    rate_floor : in unsigned(30 downto 0);

    head_valid : in std_ulogic;
    head : in segment_t;
    -- The head becomes the segment being executed with the next clock.
    take : out std_ulogic;

    -- A tick is due. It is made unless an axis is not ready for its step: then the base stalls.
    due : out std_ulogic;
    axes_ready : in std_ulogic;
    tick : out std_ulogic;

    -- It stalls for an axis; also with `stop`.
    stalled : out std_ulogic;

    -- A clock later: the rate rises, falls, as far as the segment says.
    accelerating : out std_ulogic := '0';
    decelerating : out std_ulogic := '0';

    -- A segment is being executed, and ends by this.
    active : out std_ulogic := '0';
    stop_on : out stop_condition_t := stop_condition_none;
    -- At rest, with a segment that waits for its start.
    waiting : out std_ulogic;

    segments : out count_t := (others => '0');
    underruns : out count_t := (others => '0');
    -- Clocks in which an axis was not ready.
    stalls : out count_t := (others => '0')
  );
end entity;

architecture rtl of time_base is

  constant highest_rate : unsigned(63 downto 0) := (63 => '1', others => '0');

  signal phase : unsigned(63 downto 0) := (others => '0');
  signal rate : unsigned(63 downto 0) := (others => '0');
  signal acceleration : signed(63 downto 0) := (others => '0');
  signal jerk : signed(63 downto 0) := (others => '0');
  signal ends_motion : std_ulogic := '0';
  signal ticks_left : ticks_t := (others => '0');
  -- The next tick is the segment's last; and known from the clock after a tick on.
  signal one_left, last, count_changed : std_ulogic := '0';

  -- The sum after this leap, and after leaps of 1, 2 and 4.
  signal phase_sum, single_sum, double_sum, fourfold_sum : unsigned(63 downto 0);
  -- For each leap: it is this one, and may bring a carry; it brings one if it may.
  signal chosen, possible, comes : std_ulogic_vector(2 downto 0);
  signal next_rate : unsigned(63 downto 0);
  signal acceleration_change, next_acceleration : signed(63 downto 0);
  signal carry, acceleration_fits : std_ulogic;
  -- As if there were no stop: a tick is possible, or would wait; the head would follow it, begins from rest.
  signal may_tick, would_stall, would_follow, starts : std_ulogic;
  -- The same with the carry: the base goes on, makes a tick or starts, loads the head.
  signal goes_on, counts, loads : std_ulogic;
  -- The longest leaps that rates, floor and jerk permit.
  signal leap_of_head, leap_of_rate, leap_of_floor, leap_of_jerk : leap_t;

  -- What a leap makes of a change per clock.
  function doubled(value : unsigned(63 downto 0); times : leap_t) return unsigned is
  begin
    if times(1) then
      return value(61 downto 0) & "00";
    elsif times(0) then
      return value(62 downto 0) & '0';
    end if;
    return value;
  end function;

  -- The longest leap at a rate in 1/64: the next clock's rate is higher by less than 2^-18.
  function longest(rate_64ths : unsigned(5 downto 0)) return leap_t is
  begin
    if rate_64ths < 7 then
      return to_unsigned(2, 2);
    elsif rate_64ths < 15 then
      return to_unsigned(1, 2);
    end if;
    return to_unsigned(0, 2);
  end function;

  function shorter(one, other : leap_t) return leap_t is
  begin
    if one < other then
      return one;
    end if;
    return other;
  end function;

  -- The longest leap by which a change can be shifted. Larger changes are far beyond any machine.
  function longest(change : signed(63 downto 0)) return leap_t is
  begin
    if change(62) /= change(63) then
      return to_unsigned(0, 2);
    elsif change(61) /= change(63) then
      return to_unsigned(1, 2);
    end if;
    return to_unsigned(2, 2);
  end function;

  -- A rate below the floor is held at it.
  function floored(value : unsigned(63 downto 0); floor : unsigned(30 downto 0)) return unsigned is
  begin
    if value(63 downto 32) < floor then
      return '0' & floor & x"00000000";
    end if;
    return value;
  end function;

  -- A sum above the highest rate is one below 3/4.
  function integrated(value : unsigned(63 downto 0); change : unsigned(63 downto 0);
    floor : unsigned(30 downto 0)) return unsigned is
    constant sum : unsigned(63 downto 0) := value + change;
  begin
    if falls_below(value, change, floor) then
      return '0' & floor & x"00000000";
    elsif sum(63 downto 62) = "10" then
      return highest_rate;
    end if;
    return sum;
  end function;

begin

  -- The carry decides everything else, so all sums are made before it is known which one counts. Gates
  -- choose: of a multiplexer synthesis would make one sum behind it again.
  single_sum <= phase + rate;
  double_sum <= phase + doubled(rate, "01");
  fourfold_sum <= phase + doubled(rate, "10");
  chosen <= leap(1) & (not leap(1) and leap(0)) & (leap(1) nor leap(0));
  phase_sum <= (fourfold_sum and chosen(2)) or (double_sum and chosen(1)) or (single_sum and chosen(0));
  -- With a rate of at most 1/2 a carry only comes from a phase of at least 1/2.
  possible <= chosen and phase(63);
  comes <= reaches_half(phase(62 downto 0), doubled(rate, "10")) &
           reaches_half(phase(62 downto 0), doubled(rate, "01")) &
           reaches_half(phase(62 downto 0), rate);
  carry <= or (possible and comes);
  next_rate <= integrated(rate,
    doubled(unsigned(resize(acceleration(63 downto 20), 64)), leap), rate_floor);

  -- It stays where the change would take it out of its range.
  acceleration_change <= signed(doubled(unsigned(jerk), leap_of_jerk));
  leap_of_jerk <= shorter(leap, longest(jerk));
  next_acceleration <= acceleration + acceleration_change;
  acceleration_fits <= (acceleration(63) xor acceleration_change(63)) or
    (reaches_half(unsigned(acceleration(62 downto 0)), '0' & unsigned(acceleration_change(62 downto 0))) xnor
     acceleration(63));

  leap_of_head <= longest(head.rate(63 downto 58));
  leap_of_rate <= longest(rate(63 downto 58));
  leap_of_floor <= longest('0' & rate_floor(30 downto 26));
  -- Before the last tick both rates count: the carry settles too late to choose.
  longest_leap <= shorter(leap_of_head, leap_of_floor) when active = '0' else
    shorter(shorter(leap_of_rate, leap_of_head), leap_of_floor) when one_left = '1' and head_valid = '1' else
    shorter(leap_of_rate, leap_of_floor);

  -- Carry and stop settle last in the clock: everything else is computed before, and what a stop makes void
  -- anyway does not wait for it. After a stop the base is not active, and begins with a head.
  may_tick <= active and advance and axes_ready;
  would_stall <= active and advance and not axes_ready;
  would_follow <= may_tick and last and head_valid and not head.waits_for_start;
  starts <= head_valid and not active and run and (start or not head.waits_for_start);
  goes_on <= active and advance and not stalled;
  counts <= starts or (or (possible and may_tick and comes));
  loads <= starts or (or (possible and would_follow and comes));
  stalled <= or (possible and would_stall and comes);
  due <= active and advance and carry and not stop;
  tick <= may_tick and carry and not stop;
  take <= loads and not stop;
  waiting <= head_valid and head.waits_for_start and not active;

  integrate : process
  begin
    wait until rising_edge(always_clk);

    accelerating <= '1' when acceleration > 0 else '0';
    decelerating <= acceleration(63);

    if goes_on then
      phase <= phase_sum;
    end if;
    if starts then
      phase <= (others => '0');
    end if;
    if goes_on or starts then
      rate <= floored(head.rate, rate_floor) when loads = '1' else next_rate;
    end if;
    if loads then
      acceleration <= head.acceleration;
    elsif goes_on and acceleration_fits then
      acceleration <= next_acceleration;
    end if;
  end process;

  count_ticks : process
  begin
    wait until rising_edge(clk);

    count_changed <= tick or take;
    if count_changed then
      last <= one_left;
    end if;

    if counts then
      ticks_left <= head.ticks when loads = '1' else ticks_left - 1;
      one_left <= head.ticks ?= 1 when loads = '1' else ticks_left ?= 2;
      active <= loads or not last;
    end if;

    if loads then
      jerk <= head.jerk;
      ends_motion <= head.ends_motion;
      stop_on <= head.stop_on;
    end if;

    if stop then
      active <= '0';
    elsif loads then
      segments <= segments + 1;
    end if;
    if tick = '1' and last = '1' and head_valid = '0' and ends_motion = '0' then
      underruns <= underruns + 1;
    end if;
    if stalled and not stop then
      stalls <= stalls + 1;
    end if;

    if reset then
      active <= '0';
      segments <= (others => '0');
      underruns <= (others => '0');
      stalls <= (others => '0');
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl ticks_are_two_clocks_apart : assert always (not (tick and count_changed)) abort reset;
  -- psl no_tick_is_made_when_stopped : assert always (not (tick and stop));

end architecture;
