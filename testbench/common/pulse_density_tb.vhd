-- SPDX-License-Identifier: Apache-2.0
-- The pulse density modulator gives exactly its density, spread evenly, and honours its ends.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pulse_density_tb is
end entity;

architecture simulation of pulse_density_tb is

  constant width : positive := 5;
  constant full : positive := 2 ** width - 1;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal advance : std_ulogic := '0';
  signal density : unsigned(width - 1 downto 0) := (others => '0');
  signal level : std_ulogic;

begin

  clk <= not clk after 5 ns;

  modulator : entity work.pulse_density
    generic map (width => width)
    port map (clk => clk, reset => reset, advance => advance, density => density, level => level);

  check : process
    variable ones : natural;
    variable gap : natural;
    variable held : std_ulogic;

    -- One slot, which lasts three clocks.
    procedure next_slot is
    begin
      advance <= '1';
      wait until rising_edge(clk);
      advance <= '0';
      wait until falling_edge(clk);
      held := level;
      for i in 1 to 2 loop
        wait until rising_edge(clk);
        wait until falling_edge(clk);
        holds_within_a_slot : assert level = held report "changes within a slot" severity error;
      end loop;
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    is_off_after_reset : assert level = '0' report "on after reset" severity error;

    for value in 0 to full loop
      density <= to_unsigned(value, width);
      ones := 0;
      gap := 0;
      for slot in 1 to 4 * full loop
        next_slot;
        if level then
          ones := ones + 1;
          gap := 0;
        else
          gap := gap + 1;
          spreads_its_pulses : assert value = 0 or gap <= (full + value - 1) / value
            report "gap of " & to_string(gap) & " at density " & to_string(value) severity error;
        end if;
      end loop;
      gives_exactly_its_density : assert ones = 4 * value
        report to_string(ones) & " ones at density " & to_string(value) severity error;
    end loop;

    reset <= '1';
    wait until rising_edge(clk);
    wait until falling_edge(clk);
    goes_off_at_reset : assert level = '0' report "on in reset" severity error;
    std.env.finish;
  end process;

end architecture;
