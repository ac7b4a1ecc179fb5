-- SPDX-License-Identifier: Apache-2.0
-- At the pins of the motor drivers, behind step_pins: position = pulses, and what the step generator makes of
-- them unchanged, whatever software stores where, as long as the chip does not permit software stepping.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.step_generator_pkg.all;

entity driver_pins_proof is
  generic (
    axes : positive := 2
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    emergency_stop : in std_ulogic;
    generator_idle : in std_ulogic;
    guards : in guard_array_t(axes - 1 downto 0);
    both_edges : in std_ulogic_vector(axes - 1 downto 0);
    begin_line : in std_ulogic;
    steps : in ticks_array_t(axes - 1 downto 0);
    backward : in std_ulogic_vector(axes - 1 downto 0);
    first_errors : in ticks_array_t(axes - 1 downto 0);
    line_ticks : in ticks_t;
    was_due, tick : in std_ulogic;
    set_position : in std_ulogic_vector(axes - 1 downto 0);
    new_position : in position_t
  );
end entity;

architecture proof of driver_pins_proof is

  signal generated_step, generated_direction : std_ulogic_vector(axes - 1 downto 0);
  signal ready, last_ready : std_ulogic_vector(axes - 1 downto 0);
  signal step, direction : std_ulogic_vector(axes - 1 downto 0);
  signal positions : position_array_t(axes - 1 downto 0);

  signal started : std_ulogic := '0';
  signal last_guards : guard_array_t(axes - 1 downto 0);
  signal last_both_edges : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal last_line_ticks : ticks_t := (others => '0');
  signal last_tick, last_begin, line_known : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  pins : entity work.step_pins
    generic map (axes => axes)
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => request, response => open,
      software_stepping => '0', emergency_stop => emergency_stop, generated_step => generated_step,
      generated_direction => generated_direction, generator_idle => generator_idle, step => step,
      direction => direction, at_rest => open);

  remember : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    last_guards <= guards;
    last_both_edges <= both_edges;
    last_line_ticks <= line_ticks;
    last_tick <= tick;
    last_begin <= begin_line;
    if begin_line or reset then
      line_known <= begin_line and not reset;
    end if;
    if reset then
      last_tick <= '0';
      last_begin <= '0';
    end if;
  end process;

  -- What the axes rely on is proved of the step generator's core; its settings stay here.
  a_tick_waits_for_all_axes : assume always (tick -> (was_due and (and last_ready)));
  two_ticks_are_two_clocks_apart : assume always (not (tick and last_tick));
  a_line_is_known_before_its_tick : assume always (tick -> (line_known and not last_begin));
  no_line_begins_while_an_axis_waits : assume always (not (begin_line and was_due and not (and last_ready)));
  the_line_stays : assume always (started and not begin_line -> line_ticks = last_line_ticks);
  a_line_has_ticks : assume always (begin_line -> line_ticks /= 0);
  settings_stay : assume always (started -> (guards = last_guards and both_edges = last_both_edges));
  positions_are_set_at_rest : assume always ((or set_position) -> not tick);

  each_axis : for axis in 0 to axes - 1 generate
    -- In this form Yosys sees that it is the same in the axis.
    signal was_ready : std_ulogic := '1';
  begin
    remember_readiness : process
    begin
      wait until rising_edge(clk);
      was_ready <= ready(axis);
    end process;

    last_ready(axis) <= was_ready;

    a_line_has_no_more_steps : assume always
      (begin_line -> (steps(axis) <= line_ticks and first_errors(axis) < line_ticks));

    stepper : entity work.axis_stepper
      port map (
        clk => clk, reset => reset, guard => guards(axis), both_edges => both_edges(axis),
        begin_line => begin_line, steps => steps(axis), backward => backward(axis),
        first_error => first_errors(axis), line_ticks => line_ticks, ready => ready(axis),
        was_due => was_due, tick => tick, step => generated_step(axis),
        direction => generated_direction(axis), busy => open, working => open,
        position => positions(axis), set_position => set_position(axis),
        new_position => new_position, stalls => open);

    at_the_driver : entity work.pulse_monitor
      port map (
        clk => clk, reset => reset, guard => guards(axis), both_edges => both_edges(axis),
        step => step(axis), direction => direction(axis), position => positions(axis),
        set_position => set_position(axis), new_position => new_position, pulses => open,
        since_rise => open, since_fall => open, since_step => open, since_turn => open);

    a_driver_gets_the_generators_steps : assert always (step(axis) = generated_step(axis));
    a_driver_gets_the_generators_direction : assert always
      (direction(axis) = generated_direction(axis));
  end generate;

end architecture;
