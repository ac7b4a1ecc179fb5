-- SPDX-License-Identifier: Apache-2.0
-- The synchroniser delays every bit by its stages and begins at its idle level.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity synchronizer_tb is
end entity;

architecture simulation of synchronizer_tb is

  constant width : positive := 3;

  signal clk : std_ulogic := '0';
  signal pins : std_ulogic_vector(width - 1 downto 0) := "010";
  signal after_two : std_ulogic_vector(width - 1 downto 0);
  signal after_three : std_ulogic_vector(width - 1 downto 0);
  signal settling : std_ulogic;

begin

  clk <= not clk after 5 ns;

  two_stages : entity work.synchronizer
    generic map (width => width)
    port map (
      clk => clk, asynchronous => pins, synchronous => after_two, settling => settling);

  three_stages : entity work.synchronizer
    generic map (width => width, stages => 3, idle_level => '1')
    port map (clk => clk, asynchronous => pins, synchronous => after_three);

  check : process
    type samples_t is array (1 to 3) of std_ulogic_vector(width - 1 downto 0);
    variable samples : samples_t;
    variable seed_1 : positive := 1;
    variable seed_2 : positive := 2;
    variable value : real;
  begin
    wait for 1 ns;
    begins_at_its_idle_level : assert after_two = "000" and after_three = "111"
      report "wrong level before the first clock" severity error;
    for clock in 1 to 1000 loop
      uniform(seed_1, seed_2, value);
      pins <= std_ulogic_vector(to_unsigned(integer(floor(value * 2.0 ** width)), width));
      wait until rising_edge(clk);
      samples := pins & samples(1 to 2);
      wait until falling_edge(clk);
      delays_by_two : assert clock < 2 or after_two = samples(2)
        report "two stages: " & to_string(after_two) severity error;
      reports_a_new_level : assert clock < 2 or (settling = '1') = (samples(1) /= samples(2))
        report "settling: " & to_string(settling) severity error;
      delays_by_three : assert clock < 3 or after_three = samples(3)
        report "three stages: " & to_string(after_three) severity error;
    end loop;
    std.env.finish;
  end process;

end architecture;
