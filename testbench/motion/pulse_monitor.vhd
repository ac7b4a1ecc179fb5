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
    pulses : out natural
  );
end entity;

architecture rtl of pulse_monitor is

  constant long_ago : natural := 8191;
  subtype age_t is natural range 0 to long_ago;

  signal last_step : std_ulogic := '0';
  signal last_direction : std_ulogic := '0';
  -- Clocks since the pins did it last.
  signal since_rise : age_t := long_ago;
  signal since_fall : age_t := long_ago;
  signal since_step : age_t := long_ago;
  signal since_turn : age_t := long_ago;
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
    return age >= 1 and age >= clocks;
  end function;

begin

  pulses <= counted_pulses;

  watch : process
    variable expected_position : position_t;
    variable steps : boolean;
  begin
    wait until rising_edge(clk);
    last_step <= step;
    last_direction <= direction;
    since_rise <= older(since_rise);
    since_fall <= older(since_fall);
    since_step <= older(since_step);
    since_turn <= older(since_turn);
    steps := step /= last_step and (step or both_edges) = '1';
    expected_position := counted_position;

    if steps then
      since_step <= 1;
      counted_pulses <= counted_pulses + 1;
      if direction = '1' then
        expected_position := expected_position - 1;
      else
        expected_position := expected_position + 1;
      end if;
      direction_set_up_time_is_kept : assert reset = '1' or
        (direction = last_direction and at_least(since_turn, guard.direction_setup))
        severity failure;
    end if;
    if step = '1' and last_step = '0' then
      since_rise <= 1;
      low_time_is_kept : assert reset = '1' or at_least(since_fall, guard.low) severity failure;
    end if;
    if step = '0' and last_step = '1' then
      since_fall <= 1;
      high_time_is_kept : assert reset = '1' or at_least(since_rise, guard.high) severity failure;
      high_time_is_exact : assert reset = '1' or both_edges = '1' or
        since_rise = guard.high or (since_rise = 1 and guard.high = 0) severity failure;
    end if;
    if direction /= last_direction then
      since_turn <= 1;
      direction_hold_time_is_kept : assert reset = '1' or
        at_least(since_step, guard.direction_hold) severity failure;
    end if;

    position_is_pulses : assert reset = '1' or position = expected_position severity failure;
    counted_position <= expected_position;
    if set_position then
      counted_position <= new_position;
    end if;

    if reset then
      last_step <= '0';
      last_direction <= '0';
      since_rise <= long_ago;
      since_fall <= long_ago;
      since_step <= long_ago;
      since_turn <= long_ago;
      counted_position <= (others => '0');
      counted_pulses <= 0;
    end if;
  end process;

end architecture;
