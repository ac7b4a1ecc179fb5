-- SPDX-License-Identifier: Apache-2.0
-- Leaps take a ramp through the same ticks, and no leap is longer than rate and jerk permit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.time_base_harness_pkg.all;

entity time_base_leap_tb is
end entity;

architecture simulation of time_base_leap_tb is

  signal clk : std_ulogic;
  signal inputs : time_base_inputs_t := time_base_in_reset;
  signal outputs : time_base_outputs_t;
  signal counts : time_base_counts_t;

begin

  base : entity work.time_base_harness
    port map (clk => clk, inputs => inputs, outputs => outputs, counts => counts);

  test : process
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

    type naturals_t is array (natural range <>) of natural;
    variable clocks_at_leap : naturals_t(0 to 2);
    variable ticks_before : natural;
    variable began : natural;
    variable acceleration : signed(63 downto 0);
  begin
    wait_for_clocks(clk, 2);
    inputs.reset <= '0';
    inputs.run <= '1';
    wait_for_clocks(clk, 2);

    -- Leaps of 4 take a ramp through the same ticks in a quarter of the clocks, and the base requests
    -- shorter ones where it nears the highest rate.
    inputs.rate_floor <= to_unsigned(1, 31);
    for leaps in 0 to 2 loop
      ticks_before := counts.ticks;
      inputs.leap <= to_unsigned(leaps, 2);
      offer(clk, inputs, outputs, 100, half / 64, '1', x"0400000000000000");
      began := counts.clocks;
      wait_for_clocks(clk, 2);
      assert outputs.longest_leap = 2 severity failure;
      wait_for_rest(clk, outputs);
      assert counts.ticks = ticks_before + 100 severity failure;
      -- Without acceleration it would be 12800 clocks.
      clocks_at_leap(leaps) := counts.clocks - began - 2;
    end loop;
    assert clocks_at_leap(0) < 12800 and abs (clocks_at_leap(1) * 2 - clocks_at_leap(0)) <= 4 and
      abs (clocks_at_leap(2) * 4 - clocks_at_leap(0)) <= 8
      report to_string(clocks_at_leap(0)) & " " & to_string(clocks_at_leap(1)) & " " &
        to_string(clocks_at_leap(2))
      severity failure;
    inputs.leap <= "00";
    for sixty_fourths in 1 to 32 loop
      offer(clk, inputs, outputs, 100, to_unsigned(sixty_fourths, 6) & (57 downto 0 => '0'));
      wait_for_clocks(clk, 2);
      assert outputs.longest_leap = leap_below(sixty_fourths) severity failure;
      wait_for_rest(clk, outputs);
    end loop;
    inputs.rate_floor <= (28 => '1', others => '0');
    wait for 1 ns;
    assert outputs.longest_leap = 0 report "the floor is at 1/4, the leap too long" severity failure;
    inputs.rate_floor <= to_unsigned(1, 31);

    -- In the clock of the take the head decides, whatever the rate was.
    for sixty_fourths in 1 to 32 loop
      offer(clk, inputs, outputs, 2, to_unsigned(33 - sixty_fourths, 6) & (57 downto 0 => '0'));
      wait_for_rest(clk, outputs);
      inputs.head.rate <= to_unsigned(sixty_fourths, 6) & (57 downto 0 => '0');
      inputs.head.ticks <= to_unsigned(2, 31);
      inputs.head_valid <= '1';
      wait until rising_edge(clk) and outputs.take = '1';
      assert outputs.longest_leap = leap_below(sixty_fourths) severity failure;
      inputs.head_valid <= '0';
      wait_for_rest(clk, outputs);
    end loop;
    -- And so does the floor, where it is higher.
    offer(clk, inputs, outputs, 1, half / 32);
    wait_for_rest(clk, outputs);
    for sixty_fourths in 0 to 31 loop
      inputs.rate_floor <= to_unsigned(sixty_fourths, 5) & (25 downto 0 => '1');
      wait for 1 ns;
      assert outputs.longest_leap = leap_below(sixty_fourths) severity failure;
    end loop;

    -- A faster head that waits counts for the last tick, not before it; what is no valid head never counts.
    inputs.rate_floor <= to_unsigned(1, 31);
    for valid in 0 to 1 loop
      ticks_before := counts.ticks;
      offer(clk, inputs, outputs, 3, half / 64);
      inputs.head.rate <= half;
      inputs.head.ticks <= to_unsigned(1, 31);
      inputs.head_valid <= '1' when valid = 1 else '0';
      for ticks in 1 to 3 loop
        wait_for_clocks(clk, 3);
        assert (outputs.longest_leap = 0) = (valid = 1 and ticks = 3) and
          (outputs.longest_leap = 2) = (valid = 0 or ticks < 3)
          report "a head at 1/2, before tick " & to_string(ticks) severity failure;
        wait until rising_edge(clk) and counts.ticks = ticks_before + ticks;
      end loop;
      inputs.head_valid <= '0';
      wait_for_rest(clk, outputs);
    end loop;

    -- A rate that would fall below 0 in one clock is held at the floor, too: the tick comes in time.
    inputs.rate_floor <= to_unsigned(6144, 31);
    inputs.leap <= "10";
    offer(clk, inputs, outputs, 1, shift_right(x"FE00000000000000", 10), '1', x"8000000000000000");
    wait until rising_edge(clk) and outputs.active = '0' for 1 ms;
    assert outputs.active = '0' report "stands still at the floor" severity failure;
    inputs.rate_floor <= to_unsigned(1, 31);

    -- A jerk so large that a leap of it does not fit is taken with a shorter one.
    for size in 1 to 9 loop
      for leaps in 0 to 2 loop
        for signs in 0 to 3 loop
          inputs.leap <= to_unsigned(leaps, 2);
          acceleration := shift_left(to_signed(size, 64), 59);
          inputs.head.jerk <= acceleration when signs mod 2 = 0 else -acceleration;
          acceleration := x"A000000000000000" when signs / 2 = 0 else x"5FFFFFFF00000000";
          offer(clk, inputs, outputs, 100, half / 8, '1', acceleration);
          wait_for_clocks(clk, 12);
          inputs.stop <= '1';
          wait_for_clocks(clk, 1);
          inputs.stop <= '0';
          wait_for_clocks(clk, 2);
        end loop;
      end loop;
    end loop;
    inputs.leap <= "00";
    inputs.head.jerk <= (others => '0');

    -- An acceleration near its bounds stays there, and does not change its sign.
    inputs.rate_floor <= to_unsigned(1000, 31);
    for sign in 0 to 1 loop
      inputs.head.jerk <= x"1100000000000000" when sign = 0 else x"EF00000000000000";
      acceleration := x"6000000000000000" when sign = 0 else x"A000000000000000";
      offer(clk, inputs, outputs, 200, quarter / 64, '1', acceleration);
      wait_for_clocks(clk, 1000);
      assert (outputs.accelerating = '1') = (sign = 0) and (outputs.decelerating = '1') = (sign = 1)
        severity failure;
      inputs.stop <= '1';
      wait_for_clocks(clk, 1);
      inputs.stop <= '0';
    end loop;
    inputs.head.jerk <= (others => '0');
    inputs.rate_floor <= to_unsigned(1, 31);

    finish;
  end process;

end architecture;
