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
    -- The error term before its first tick (0 .. line_ticks - 1).
    first_error : in ticks_t;
    -- Of the line that begins, otherwise of the line being executed.
    line_ticks : in ticks_t;

    -- If the next tick brings a step of this axis that will not be legal in the next clock, `ready` is low.
    ready : out std_ulogic;
    -- A tick was due in the clock before. If `ready` was low, it has to wait.
    was_due : in std_ulogic;
    -- The tick is made, as `ready` was high in the clock before; at least two clocks after the tick before
    -- and after begin_line.
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

    -- Clocks in which a tick was due but this axis not ready.
    stalls : out count_t := (others => '0')
  );
end entity;

architecture rtl of axis_stepper is

  signal line_steps : ticks_t := (others => '0');
  signal wanted_direction : std_ulogic := '0';
  -- Error term after the next tick, and whether that tick brings a step.
  signal error_term : ticks_t := (others => '0');
  signal step_wanted : std_ulogic := '0';
  signal was_ready : std_ulogic := '1';

  signal present_error, present_steps : ticks_t;
  signal error_without_step : unsigned(31 downto 0);
  signal error_with_step : unsigned(32 downto 0);

  -- a + b - c in two's complement. Three numbers become two without a carry: one carry chain is enough.
  function difference_of(a, b, c : ticks_t) return unsigned is
    constant less_c : unsigned(32 downto 0) := not ("00" & c);
    constant sums : unsigned(32 downto 0) := ("00" & a) xor ("00" & b) xor less_c;
    constant carries : unsigned(32 downto 0) := (("00" & a) and ("00" & b)) or
      (("00" & a) and less_c) or (("00" & b) and less_c);
  begin
    return sums + (carries(31 downto 0) & '1');
  end function;

  -- Of the pulse (step = 1) or of the pause after it (step = 0).
  signal pulse_left, pulse_clocks : guard_clocks_t;
  signal pulse_begins, pulse_over, pulse_ending : std_ulogic;
  -- Of the direction's set-up (setting_up = 1) or hold time.
  signal direction_left, direction_clocks : guard_clocks_t;
  signal direction_begins, direction_over, direction_ending : std_ulogic;
  signal setting_up : std_ulogic := '0';
  signal turns : std_ulogic;
  -- A time of one clock. Settings of the clock before: they change at rest.
  signal low_is_short, setup_is_short : std_ulogic := '0';
  -- Pulse and direction allow a step in the next clock.
  signal pulse_allows, direction_allows : std_ulogic;
  signal makes_step : std_ulogic;
  -- Whether a step is legal in this clock, for the properties.
  signal legal : std_ulogic;

begin

  turns <= direction xor wanted_direction;
  legal <= (not step or both_edges) and pulse_over and not turns and (not setting_up or direction_over);
  -- At most one clock is left of the pulse and of the pause after it, and at most one of the direction's hold
  -- and set-up times.
  pulse_allows <= pulse_ending and (not step or both_edges or (pulse_over and low_is_short));
  direction_allows <= (not turns and (not setting_up or direction_ending)) or
                      (turns and direction_over and setup_is_short);
  ready <= (pulse_allows and direction_allows) or not step_wanted;
  busy <= (step and not both_edges) or not pulse_over;
  working <= busy or not direction_over or turns;

  makes_step <= tick and step_wanted;
  pulse_begins <= makes_step or (pulse_over and step and not both_edges);
  pulse_clocks <= guard.low when step = '1' else guard.high;
  direction_begins <= makes_step or (direction_over and turns);
  direction_clocks <= guard.direction_hold when makes_step = '1' else guard.direction_setup;

  pulse_timer : entity work.guard_timer
    port map (
      clk => clk, reset => reset, start => pulse_begins, clocks => pulse_clocks,
      left => pulse_left, over => pulse_over, ending => pulse_ending);

  direction_timer : entity work.guard_timer
    port map (
      clk => clk, reset => reset, start => direction_begins, clocks => direction_clocks,
      left => direction_left, over => direction_over, ending => direction_ending);

  present_error <= first_error when begin_line = '1' else error_term;
  -- Gates, since Yosys would share a multiplexer with the register and take its enable away.
  present_steps <= (steps and (30 downto 0 => begin_line)) or
    (line_steps and (30 downto 0 => not begin_line));
  error_without_step <= ('0' & present_error) + present_steps;
  error_with_step <= difference_of(present_error, present_steps, line_ticks);

  -- Computes the next tick in the clock of a tick.
  share_ticks : process
  begin
    wait until rising_edge(clk);
    if begin_line or tick then
      -- Not negative: the tick brings a step.
      step_wanted <= not error_with_step(32);
      error_term <= error_with_step(30 downto 0) when error_with_step(32) = '0' else
                    error_without_step(30 downto 0);
    end if;
    if begin_line then
      line_steps <= steps;
      if steps /= 0 then
        wanted_direction <= backward;
      end if;
    end if;
    if reset then
      wanted_direction <= '0';
    end if;
  end process;

  make_pulses : process
  begin
    wait until rising_edge(clk);

    low_is_short <= guard.low ?<= 1;
    setup_is_short <= guard.direction_setup ?<= 1;

    if makes_step then
      step <= not step;
    elsif pulse_begins then
      step <= '0';
    end if;

    if makes_step then
      setting_up <= '0';
    elsif direction_begins then
      direction <= wanted_direction;
      setting_up <= '1';
    end if;

    if makes_step then
      if direction then
        position <= position - 1;
      else
        position <= position + 1;
      end if;
    end if;

    if set_position then
      position <= new_position;
    end if;
    was_ready <= ready;
    if was_due and not was_ready then
      stalls <= stalls + 1;
    end if;

    if reset then
      step <= '0';
      direction <= '0';
      position <= (others => '0');
      stalls <= (others => '0');
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl every_step_is_legal : assert always (makes_step -> legal) abort reset;
  -- psl an_idle_axis_makes_no_step : assert always (makes_step -> line_steps /= 0) abort reset;
  -- psl direction_stands_still_forward : assert always
  --   ((step = '0' and direction = '0') -> next (step = '0' or direction = '0')) abort reset;
  -- psl direction_stands_still_backward : assert always
  --   ((step = '0' and direction = '1') -> next (step = '0' or direction = '1')) abort reset;
  -- psl a_step_comes_of_a_tick : assert always
  --   ((step = '0' and tick = '0') -> next (step = '0')) abort reset;

end architecture;
