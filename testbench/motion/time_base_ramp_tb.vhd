-- SPDX-License-Identifier: Apache-2.0
-- Ramps of every shape, with leaps, stalls and pauses: the model of the harness looks at each clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.time_base_harness_pkg.all;

entity time_base_ramp_tb is
end entity;

architecture simulation of time_base_ramp_tb is

  signal clk : std_ulogic;
  signal inputs : time_base_inputs_t := time_base_in_reset;
  signal outputs : time_base_outputs_t;
  signal counts : time_base_counts_t;

  -- The longest leap that is taken, where the base permits it.
  signal wanted_leap : natural range 0 to 2 := 0;
  signal disturbed : time_base_inputs_t := time_base_in_reset;
  signal leap : leap_t := (others => '0');
  signal advance, axes_ready : std_ulogic := '1';

begin

  base : entity work.time_base_harness
    port map (clk => clk, inputs => disturbed, outputs => outputs, counts => counts);

  give_disturbed_inputs : process (all)
  begin
    disturbed <= inputs;
    disturbed.leap <= leap;
    disturbed.advance <= advance;
    disturbed.axes_ready <= axes_ready;
  end process;

  disturb : process
    variable seed_1, seed_2 : positive := 11;
    variable chance : real;
  begin
    wait until rising_edge(clk);
    uniform(seed_1, seed_2, chance);
    advance <= '0' when chance < 0.15 else '1';
    uniform(seed_1, seed_2, chance);
    axes_ready <= '0' when chance < 0.25 else '1';
    leap <= outputs.longest_leap when outputs.longest_leap < wanted_leap else to_unsigned(wanted_leap, 2);
  end process;

  test : process
    variable seed_1, seed_2 : positive := 7;
    variable random_acceleration : signed(63 downto 0);
    variable ends : std_ulogic;

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
  begin
    wait_for_clocks(clk, 2);
    inputs.reset <= '0';
    inputs.run <= '1';
    wait_for_clocks(clk, 2);

    for i in 1 to 300 loop
      wanted_leap <= random(3);
      if random(4) = 0 then
        inputs.rate_floor <= shift_right(to_unsigned(random(2 ** 30), 30) & '1', random(24));
      else
        inputs.rate_floor <= to_unsigned(1 + random(2 ** 24), 31);
      end if;
      inputs.head.jerk <= random_change(random(64)) when random(3) /= 0 else (others => '0');
      random_acceleration := random_change(40 + random(24)) when random(5) /= 0 else (others => '0');
      ends := '0' when random(2) = 0 else '1';
      offer(clk, inputs, outputs, 1 + random(30),
        shift_right(to_unsigned(random(2 ** 24), 24) & (39 downto 0 => '1'), 1 + random(7)),
        ends, random_acceleration);
      wait_for_clocks(clk, random(30));
      -- To its end, or to the next segment; a slow one is stopped.
      for k in 1 to 150 loop
        exit when outputs.active = '0' or random(100) = 0;
        wait_for_clocks(clk, 1);
      end loop;
      if outputs.active = '1' and (inputs.rate_floor < 2 ** 24 or random(4) = 0) then
        inputs.stop <= '1';
        wait_for_clocks(clk, 1);
        inputs.stop <= '0';
      end if;
    end loop;
    wait until rising_edge(clk) and outputs.active = '0';

    finish;
  end process;

end architecture;
