-- SPDX-License-Identifier: Apache-2.0
-- Watches one axis' pins: the guard times hold at every edge, and the position is the steps counted here.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

-- Knows nothing of how the pulses are made, and is synthesisable, so that proofs can use it too.
entity pulse_monitor is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    guard : in guard_t;
    both_edges : in std_ulogic := '0';
    step : in std_ulogic;
    direction : in std_ulogic;
    position : in position_t;
    -- The position is set by software: counting goes on from there.
    set_position : in std_ulogic;
    new_position : in position_t;
    -- Steps, whatever their direction: rising edges, with `both_edges` falling ones too.
    pulses : out natural;
    -- Clocks since the pins did it last, for the invariants of proofs. A new guard counts from the next edge
    -- on: those before have kept the old one, and are long ago.
    since_rise : out natural range 0 to 8191;
    since_fall : out natural range 0 to 8191;
    since_step : out natural range 0 to 8191;
    since_turn : out natural range 0 to 8191
  );
end entity;

architecture rtl of pulse_monitor is

  constant long_ago : natural := 8191;
  subtype age_t is natural range 0 to long_ago;

  signal rise_age, fall_age, step_age, turn_age : age_t := long_ago;
  signal guard_known : std_ulogic := '0';
  signal last_guard : guard_t := guard_after_reset;
  signal last_both_edges : std_ulogic := '0';
  signal guard_is_new : std_ulogic;
  signal last_step : std_ulogic := '0';
  signal last_direction : std_ulogic := '0';
  signal rises : std_ulogic;
  signal falls : std_ulogic;
  signal steps : std_ulogic;
  signal turns : std_ulogic;
  signal expected_position : position_t;
  signal counted_position : position_t := (others => '0');
  signal counted_pulses : natural := 0;

  function older(age : age_t) return age_t is
  begin
    if age = long_ago then
      return age;
    end if;
    return age + 1;
  end function;

  function at_least(age : age_t; clocks : guard_clocks_t) return boolean is
  begin
    -- As integers: GHDL 5.0.1 synthesises natural >= unsigned with the natural cut to the width of the other.
    return age >= 1 and age >= to_integer(clocks);
  end function;

begin

  pulses <= counted_pulses;

  guard_is_new <= '0' when guard_known = '0' or (guard = last_guard and both_edges = last_both_edges) else
    '1';
  since_rise <= long_ago when guard_is_new = '1' else rise_age;
  since_fall <= long_ago when guard_is_new = '1' else fall_age;
  since_step <= long_ago when guard_is_new = '1' else step_age;
  since_turn <= long_ago when guard_is_new = '1' else turn_age;

  rises <= step and not last_step;
  falls <= not step and last_step;
  steps <= rises or (falls and both_edges);
  turns <= direction xor last_direction;
  expected_position <= counted_position when steps = '0' else
    counted_position - 1 when direction = '1' else
    counted_position + 1;

  watch : process
  begin
    wait until rising_edge(clk);
    last_step <= step;
    last_direction <= direction;
    guard_known <= '1';
    last_guard <= guard;
    last_both_edges <= both_edges;
    rise_age <= older(since_rise);
    fall_age <= older(since_fall);
    step_age <= older(since_step);
    turn_age <= older(since_turn);
    if rises then
      rise_age <= 1;
    end if;
    if falls then
      fall_age <= 1;
    end if;
    if steps then
      step_age <= 1;
      counted_pulses <= counted_pulses + 1;
    end if;
    if turns then
      turn_age <= 1;
    end if;
    counted_position <= expected_position;
    if set_position then
      counted_position <= new_position;
    end if;

    if reset then
      last_step <= '0';
      last_direction <= '0';
      rise_age <= long_ago;
      fall_age <= long_ago;
      step_age <= long_ago;
      turn_age <= long_ago;
      counted_position <= (others => '0');
      counted_pulses <= 0;
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl high_time_is_kept : assert always (falls -> (reset or at_least(since_rise, guard.high)));
  -- psl high_time_is_exact : assert always (falls -> (reset or both_edges or
  --   since_rise = to_integer(guard.high) or (since_rise = 1 and guard.high = 0)));
  -- psl low_time_is_kept : assert always (rises -> (reset or at_least(since_fall, guard.low)));
  -- psl direction_set_up_time_is_kept : assert always
  --   (steps -> (reset or (not turns and at_least(since_turn, guard.direction_setup))));
  -- psl direction_hold_time_is_kept : assert always
  --   (turns -> (reset or at_least(since_step, guard.direction_hold)));
  -- psl position_is_pulses : assert always (reset or position = expected_position);

end architecture;
