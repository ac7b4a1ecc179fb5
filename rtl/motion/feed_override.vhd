-- SPDX-License-Identifier: Apache-2.0
-- Stretches and compresses the time of the common base: override, feed hold and braking, each along a ramp.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

-- In each clock the base is owed `scale` base clocks (0 = hold, 1 = as segments ask, below 4), and
-- `scale` moves towards its target by the slope. Owed base clocks are executed in leaps of 1, 2 or
-- 4: the base's increments are shifted left for a leap of n, and without a leap the base stands
-- still. So no multiplier is needed, a scale of exactly 1 leaves the base as it is, and the ticks
-- and their order are the same at any scale, since the base counts them.
--
-- Bounds. Up to a scale of 1 leaps are of 1, and the base's own arithmetic is exact; a tick is late by less
-- than a base clock, that is 1/scale clocks: against the stretched distance of steps the same part as at
-- scale 1. Above it, base time lags behind the sum of the scale by less than 4 base clocks; and a leap of n
-- uses the rate of its first base clock for all, which is wrong by (n-1)/2 of the change of rate in it:
-- over a ramp by at most 3/2 * 7/64 + 1/2 * 8/64, less than a quarter of a tick.
--
-- Two ticks stay two clocks apart: the base says which leap leaves its rate below 1/2 tick per
-- clock. Base clocks that cannot be executed are dropped beyond 3, so that motion goes on at the
-- longest leap and nothing is caught up later: from 7/64 tick per clock on the scale is at most 2,
-- from 15/64 on at most 1.
--
-- Accelerations. At a scale of s the base's acceleration a and tick rate r become s^2*a +
-- (ds/dt)*r. Where |ds/dt|*r is not more than the largest |a|, the sum exceeds it only where both
-- terms have one sign: where the scale rises while the base accelerates, or falls while it
-- decelerates. Then the slope is cut to what s^2 leaves of 1: a half of it for s below 1/2 (1/4 +
-- 1/2), a quarter below 3/4 (9/16 + 1/4), an eighth below 7/8 (49/64 + 1/8), and nothing from there
-- on. So a scale of 7/8 or more waits until the ramp of the base is over; a lower one always
-- changes, however long the base takes to end its ramp. The brake does not wait.
entity feed_override is
  port (
    -- May be gated while the inputs stay and not `working`, from 3 clocks on.
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- A segment is executed. Without motion the scale takes its target at once.
    moving : in std_ulogic;
    -- In 2^-16, below 4.
    target : in unsigned(17 downto 0);
    -- In 2^-32 per clock.
    slope : in slope_t;
    -- The tick rate of the base rises, falls.
    accelerating : in std_ulogic;
    decelerating : in std_ulogic;
    -- The target is 0, and this the slope.
    braking : in std_ulogic;
    brake_slope : in slope_t;

    -- The base comes to a tick that an axis is not ready for: the leap is repeated.
    stalled : in std_ulogic;
    -- The longest leap that the base can do in the next clock.
    longest_leap : in leap_t;

    -- The base advances in this clock, by this leap.
    advance : out std_ulogic := '0';
    leap : out leap_t := (others => '0');
    scale : out scale_t := scale_of_one;
    -- One clock later: the scale is 0 and no leap is left.
    standing : out std_ulogic := '0';
    -- Something may change in each clock.
    working : out std_ulogic
  );
end entity;

architecture rtl of feed_override is

  constant unity : unsigned(17 downto 0) := scale_of_one(33 downto 16);

  -- Base clocks that are owed beyond the leap being done, in 2^-32.
  signal owed : unsigned(33 downto 0) := (others => '0');

  -- For this many whole base clocks: what is executed in the next clock, and what stays owed.
  type share_t is record
    advance : std_ulogic;
    leap : leap_t;
    rest : unsigned(1 downto 0);
  end record;

  function share_of(whole : unsigned(2 downto 0); longest : leap_t) return share_t is
  begin
    if whole(2) = '1' and longest(1) = '1' then
      return (advance => '1', leap => "10", rest => whole(1 downto 0));
    elsif whole(2 downto 1) /= 0 and longest /= 0 then
      if whole > 5 then
        return (advance => '1', leap => "01", rest => "11");
      end if;
      return (advance => '1', leap => "01", rest => whole(1 downto 0) - 2);
    elsif whole > 4 then
      return (advance => '1', leap => "00", rest => "11");
    elsif whole /= 0 then
      return (advance => '1', leap => "00", rest => whole(1 downto 0) - 1);
    end if;
    return (advance => '0', leap => "00", rest => "00");
  end function;

  -- How much of the slope remains at a scale where the base's own acceleration adds to that of the scale:
  -- a half, a quarter, an eighth, nothing.
  type cut_t is record
    to_quarter : std_ulogic;
    to_eighth : std_ulogic;
    to_nothing : std_ulogic;
  end record;

  function cut_at(at_scale : scale_t) return cut_t is
    variable to_nothing : std_ulogic := '0';
  begin
    if at_scale(33 downto 29) >= 7 then
      to_nothing := '1';
    end if;
    return (
      to_quarter => at_scale(31) and not at_scale(30), to_eighth => at_scale(31) and at_scale(30),
      to_nothing => to_nothing);
  end function;

  -- That of the scale, known from the clock before.
  signal cut_of_scale : cut_t := cut_at(scale_of_one);

  function cut(full : slope_t; by : cut_t) return slope_t is
  begin
    if by.to_nothing then
      return to_unsigned(0, full'length);
    elsif by.to_eighth then
      return shift_right(full, 3);
    elsif by.to_quarter then
      return shift_right(full, 2);
    end if;
    return shift_right(full, 1);
  end function;

  -- Whether a + b + carry - 2^16 * c is negative in two's complement. In the upper bits three numbers become
  -- two without a carry, so that one carry chain is enough; in the lower ones, where it begins, nothing lies
  -- before it.
  function sum_is_negative(a, b : unsigned(35 downto 0); carry : std_ulogic; c : unsigned(19 downto 0))
    return std_ulogic is
    constant upper_a : unsigned(19 downto 0) := a(35 downto 16);
    constant upper_b : unsigned(19 downto 0) := b(35 downto 16);
    constant carries : unsigned(19 downto 0) :=
      (upper_a and upper_b) or (upper_a and not c) or (upper_b and not c);
    variable total : unsigned(36 downto 0);
  begin
    -- An extra lowest bit is the carry in.
    total := ((upper_a xor upper_b xor not c) & a(15 downto 0) & '1') +
             (carries(18 downto 0) & '1' & b(15 downto 0) & carry);
    return total(36);
  end function;

  -- One clock nearer to the target. Both directions are computed before it is known which one is
  -- taken and whether the target is passed: only one sum follows the slope.
  signal to_target : scale_t;
  signal rises : std_ulogic;
  signal slope_up, slope_down : slope_t;
  signal up, down, moved : scale_t;
  signal up_stays_below, down_passes, passes, arrives : std_ulogic;

begin

  -- At scale 1 one base clock is owed and done in every clock; at rest nothing is owed that is not
  -- forgotten. But a change of scale may have to wait.
  working <= '1' when moving = '1' and (scale /= scale_of_one or owed /= 0 or target /= unity) else '0';

  to_target <= (others => '0') when braking = '1' else target & x"0000";
  -- The target has no lower bits.
  rises <= '1' when scale(33 downto 16) < to_target(33 downto 16) else '0';
  slope_up <= cut(slope, cut_of_scale) when accelerating = '1' else slope;
  slope_down <= brake_slope when braking = '1' else
                cut(slope, cut_of_scale) when decelerating = '1' else slope;
  up <= scale + slope_up;
  down <= scale - slope_down;
  -- scale + slope_up - to_target, scale - slope_down - to_target.
  up_stays_below <= sum_is_negative("00" & scale, x"0" & slope_up, '0', "00" & to_target(33 downto 16));
  down_passes <= sum_is_negative("00" & scale, not (x"0" & slope_down), '1', "00" & to_target(33 downto 16));

  moved <= up when rises = '1' else down;
  passes <= not up_stays_below when rises = '1' else down_passes;
  -- Settles last: one multiplexer follows.
  arrives <= passes or not moving;

  approach : process
  begin
    wait until rising_edge(clk);
    scale(33 downto 16) <= to_target(33 downto 16) when arrives = '1' else moved(33 downto 16);
    -- Gates: a synchronous reset would lie behind a longer wire.
    scale(15 downto 0) <= moved(15 downto 0) and (15 downto 0 => not arrives);
    if arrives then
      cut_of_scale <= cut_at(to_target);
    elsif rises then
      cut_of_scale <= cut_at(up);
    else
      cut_of_scale <= cut_at(down);
    end if;
    standing <= '1' when scale = 0 and advance = '0' else '0';
    if reset then
      scale <= scale_of_one;
      cut_of_scale <= cut_at(scale_of_one);
      standing <= '0';
    end if;
  end process;

  share_out : process
    variable sum : unsigned(34 downto 0);
    variable share : share_t;
  begin
    wait until rising_edge(clk);
    sum := '0' & scale;
    if moving then
      sum := sum + owed;
    end if;
    share := share_of(sum(34 downto 32), longest_leap);
    if not stalled then
      advance <= share.advance;
      leap <= share.leap;
      owed <= share.rest & sum(31 downto 0);
    end if;
    if reset then
      advance <= '0';
      leap <= (others => '0');
      owed <= (others => '0');
    end if;
  end process;

end architecture;
