-- SPDX-License-Identifier: Apache-2.0
-- One axis: picks its steps from the common ticks (Bresenham), guards the driver's timing, counts pulses.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

--               high      low
--             |<---->|<-------->|
--  step     __/------\__________/------\___
--                                   |
--  direction -----------X===============
--             |<- hold ->|<- setup ->|     (the next rising edge comes after setup and low)
--
-- With both edges: step stays as it is after each step, at least for the high or low time of its level,
-- and set-up and hold time count to and from every edge.
entity axis_stepper is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;

    guard : in guard_t;
    -- The falling edge of step is a step as well.
    both_edges : in std_ulogic := '0';

    -- A line begins with the next clock, with these steps (0 .. line_ticks).
    begin_line : in std_ulogic;
    steps : in ticks_t;
    backward : in std_ulogic;
    -- They come a quarter of a step early or late, not both.
    ahead : in std_ulogic;
    behind : in std_ulogic;
    -- Of the line being executed; new from the clock after begin_line on.
    line_ticks : in ticks_t;

    -- A tick is due. If it brings a step of this axis that is not yet legal, `ready` is low.
    due : in std_ulogic;
    ready : out std_ulogic;
    -- The tick is made; at least two clocks after the one before, and after begin_line.
    tick : in std_ulogic;

    step : out std_ulogic := '0';
    -- 1 = negative.
    direction : out std_ulogic := '0';
    -- A pulse or the pause after it is not finished.
    busy : out std_ulogic;
    -- A pulse, pause or guard time is running, or the direction is about to change.
    working : out std_ulogic;

    -- Steps made, forward minus backward. To be set only at rest.
    position : out position_t := (others => '0');
    set_position : in std_ulogic;
    new_position : in position_t;

    -- Clocks in which this axis was due but not ready.
    stalls : out count_t := (others => '0')
  );
end entity;

architecture rtl of axis_stepper is

  signal line_steps : ticks_t := (others => '0');
  signal wanted_direction : std_ulogic := '0';
  signal begins_ahead : std_ulogic := '0';
  signal begins_behind : std_ulogic := '0';
  signal line_begins : std_ulogic := '0';
  signal ticked : std_ulogic := '0';
  -- Error term after the next tick, and whether that tick brings a step.
  signal error_term : ticks_t := (others => '0');
  signal step_wanted : std_ulogic := '0';

  -- Clocks left of the pulse (step = 1) or of the pause after it (step = 0).
  signal pulse_left : guard_clocks_t := (others => '0');
  -- Clocks left of the direction's set-up (setting_up = 1) or hold time.
  signal direction_left : guard_clocks_t := (others => '0');
  signal setting_up : std_ulogic := '0';
  signal legal : std_ulogic;

  -- Where the error term of a line starts. Any start below line_ticks makes exactly the line's steps.
  function first_error(ticks : ticks_t; early, late : std_ulogic) return unsigned is
    constant half : unsigned(31 downto 0) := "00" & ticks(30 downto 1);
    constant quarter : unsigned(31 downto 0) := "000" & ticks(30 downto 2);
  begin
    if early then
      return half + quarter;
    elsif late then
      return quarter;
    end if;
    return half;
  end function;

  function less_one(clocks : guard_clocks_t) return guard_clocks_t is
  begin
    if clocks = 0 then
      return clocks;
    end if;
    return clocks - 1;
  end function;

begin

  legal <= '1' when (step = '0' or both_edges = '1') and pulse_left = 0 and
    direction = wanted_direction and (setting_up = '0' or direction_left = 0) else '0';
  ready <= legal or not step_wanted;
  busy <= '1' when (step = '1' and both_edges = '0') or pulse_left /= 0 else '0';
  working <= '1' when (step = '1' and both_edges = '0') or pulse_left /= 0 or direction_left /= 0 or
    direction /= wanted_direction else '0';

  -- Computes the next tick in the clock after a tick.
  share_ticks : process
    variable sum : unsigned(31 downto 0);
  begin
    wait until rising_edge(clk);
    line_begins <= begin_line;
    ticked <= tick;
    if begin_line then
      line_steps <= steps;
      begins_ahead <= ahead;
      begins_behind <= behind;
      if steps /= 0 then
        wanted_direction <= backward;
      end if;
    end if;
    if line_begins or ticked then
      if line_begins then
        sum := first_error(line_ticks, begins_ahead, begins_behind) + line_steps;
      else
        sum := ('0' & error_term) + line_steps;
      end if;
      step_wanted <= '0';
      if sum >= line_ticks then
        sum := sum - line_ticks;
        step_wanted <= '1';
      end if;
      error_term <= sum(30 downto 0);
    end if;
    if reset then
      line_begins <= '0';
      ticked <= '0';
      wanted_direction <= '0';
    end if;
  end process;

  make_pulses : process
  begin
    wait until rising_edge(clk);

    if pulse_left /= 0 then
      pulse_left <= pulse_left - 1;
    elsif step and not both_edges then
      step <= '0';
      pulse_left <= less_one(guard.low);
    end if;

    if direction_left /= 0 then
      direction_left <= direction_left - 1;
    elsif direction /= wanted_direction then
      direction <= wanted_direction;
      direction_left <= less_one(guard.direction_setup);
      setting_up <= '1';
    end if;

    if tick and step_wanted then
      step <= not step;
      if step then
        pulse_left <= less_one(guard.low);
      else
        pulse_left <= less_one(guard.high);
      end if;
      direction_left <= less_one(guard.direction_hold);
      setting_up <= '0';
      if direction then
        position <= position - 1;
      else
        position <= position + 1;
      end if;
    end if;

    if set_position then
      position <= new_position;
    end if;
    if due and not ready then
      stalls <= stalls + 1;
    end if;

    if reset then
      step <= '0';
      direction <= '0';
      pulse_left <= (others => '0');
      direction_left <= (others => '0');
      position <= (others => '0');
      stalls <= (others => '0');
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl no_line_begins_ahead_and_behind : assert always (not (begin_line and ahead and behind)) abort reset;
  -- psl every_step_is_legal : assert always ((tick and step_wanted) -> legal) abort reset;
  -- psl an_idle_axis_makes_no_step : assert always
  --   ((tick and step_wanted) -> line_steps /= 0) abort reset;
  -- psl direction_stands_still_forward : assert always
  --   ((step = '0' and direction = '0') -> next (step = '0' or direction = '0')) abort reset;
  -- psl direction_stands_still_backward : assert always
  --   ((step = '0' and direction = '1') -> next (step = '0' or direction = '1')) abort reset;
  -- psl a_step_comes_of_a_tick : assert always
  --   ((step = '0' and tick = '0') -> next (step = '0')) abort reset;

end architecture;
