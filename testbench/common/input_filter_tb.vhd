-- SPDX-License-Identifier: Apache-2.0
-- The input filter takes over a level exactly when it was stable long enough, and no shorter pulse.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity input_filter_tb is
end entity;

architecture simulation of input_filter_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal stable_cycles : unsigned(7 downto 0) := (others => '0');
  signal level : std_ulogic := '0';
  signal filtered : std_ulogic;

begin

  clk <= not clk after 5 ns;

  filter : entity work.input_filter
    generic map (width => 8)
    port map (
      clk => clk, reset => reset, stable_cycles => stable_cycles, level => level,
      filtered => filtered);

  check : process
    variable seed_1 : positive := 3;
    variable seed_2 : positive := 4;
    variable value : real;
    variable expected : std_ulogic;

    procedure hold (new_level : std_ulogic; clocks : natural) is
    begin
      if clocks = 0 then
        return;
      end if;
      level <= new_level;
      for i in 1 to clocks loop
        wait until rising_edge(clk);
      end loop;
      wait until falling_edge(clk);
    end procedure;

    -- Clocks that a new level must last.
    impure function needed return positive is
    begin
      return maximum(1, to_integer(stable_cycles));
    end function;
  begin
    hold('0', 2);
    reset <= '0';
    for cycles in 0 to 20 loop
      stable_cycles <= to_unsigned(cycles, 8);
      hold('0', 30);
      hold('1', needed - 1);
      ignores_what_is_one_clock_too_short : assert filtered = '0'
        report "high too early with " & to_string(cycles) severity error;
      hold('0', 1);
      hold('1', needed);
      takes_over_what_lasts : assert filtered = '1'
        report "not high with " & to_string(cycles) severity error;
      hold('0', needed - 1);
      ignores_a_short_low : assert filtered = '1'
        report "low too early with " & to_string(cycles) severity error;
      hold('1', 1);
      hold('0', needed);
      takes_over_a_low : assert filtered = '0'
        report "not low with " & to_string(cycles) severity error;
    end loop;

    stable_cycles <= to_unsigned(255, 8);
    hold('1', 254);
    counts_to_its_longest_time : assert filtered = '0' report "high too early" severity error;
    hold('1', 1);
    reaches_its_longest_time : assert filtered = '1' report "never high" severity error;

    -- A bouncing contact: random pulses below the limit, for a long time.
    stable_cycles <= to_unsigned(10, 8);
    hold('1', 20);
    for bounce in 1 to 500 loop
      uniform(seed_1, seed_2, value);
      hold('0', 1 + integer(floor(value * 9.0)));
      hold('1', 1);
      ignores_bouncing : assert filtered = '1' report "bounced" severity error;
    end loop;
    reset <= '1';
    hold('1', 1);
    goes_idle_at_reset : assert filtered = '0' report "not idle" severity error;
    std.env.finish;
  end process;

end architecture;
