-- SPDX-License-Identifier: Apache-2.0
-- Watches a time_base: what the header of the entity says of a clock, in real numbers.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.time_base_harness_pkg.all;

entity time_base_model is
  port (
    clk : in std_ulogic;
    inputs : in time_base_inputs_t;
    outputs : in time_base_outputs_t
  );
end entity;

architecture simulation of time_base_model is
begin

  -- In ticks, ticks per clock, and so on.
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
      ((outputs.accelerating = '1') = was_positive and (outputs.decelerating = '1') = was_negative)
      report "accelerating " & to_string(outputs.accelerating) & " decelerating "
        & to_string(outputs.decelerating)
        & " at " & to_string(acceleration) & " after leaps of " & to_string(to_integer(inputs.leap))
        & " by " & to_string(jerk)
      severity failure;
    is_stalled_by_an_axis : assert inputs.stop = '1' or
      outputs.stalled = (outputs.due and not inputs.axes_ready) severity failure;
    ticks_when_due : assert outputs.tick = (outputs.due and inputs.axes_ready) severity failure;

    was_positive := acceleration > 0.0;
    was_negative := acceleration < 0.0;
    floor_rate := real(to_integer(inputs.rate_floor)) * 2.0 ** (-32);
    is_moving := outputs.active = '1';
    if outputs.active = '1' and inputs.advance = '1' and inputs.stop = '0' then
      factor := 2.0 ** to_integer(inputs.leap);
      sum := phase + factor * rate;
      is_due := outputs.due = '1';
      ticks_at_its_instant : assert (sum >= 1.0) = is_due or abs (sum - 1.0) < tolerance
        report "at " & to_string(sum) & " ticks due is " & to_string(outputs.due) severity failure;
      if not is_due or inputs.axes_ready = '1' then
        phase := sum - 1.0 when is_due else sum;
        rate := rate + factor * acceleration * unit;
        rate := realmax(realmin(rate, 0.5), floor_rate);
        change := jerk;
        for i in 1 to to_integer(inputs.leap) loop
          if change * 2.0 < 2.0 ** 63 and change * 2.0 >= -2.0 ** 63 then
            change := change * 2.0;
          end if;
        end loop;
        if acceleration + change < 2.0 ** 63 and acceleration + change >= -2.0 ** 63 then
          acceleration := acceleration + change;
        end if;
      end if;
    end if;
    if outputs.take = '1' then
      if outputs.active = '0' then
        phase := 0.0;
      end if;
      rate := realmax(to_real(inputs.head.rate), floor_rate);
      acceleration := to_real(inputs.head.acceleration);
      jerk := to_real(inputs.head.jerk);
    end if;
    keeps_the_rate_within_a_half : assert outputs.longest_leap = 0 or not (outputs.active = '1'
      or outputs.take = '1')
      or rate * 2.0 ** to_integer(outputs.longest_leap) <= 0.5
      report "leap of " & to_string(to_integer(outputs.longest_leap)) & " at " & to_string(rate)
        severity failure;
    takes_with_a_tick_or_from_rest : assert outputs.take = '0' or outputs.active = '0' or outputs.tick = '1'
      severity failure;
  end process;

end architecture;
