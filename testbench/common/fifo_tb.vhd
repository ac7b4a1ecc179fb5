-- SPDX-License-Identifier: Apache-2.0
-- The FIFO keeps every word in order under random traffic, at every level from empty to full.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity fifo_tb is
end entity;

architecture simulation of fifo_tb is

  constant width : positive := 9;
  constant depth : positive := 8;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal write_enable : std_ulogic := '0';
  signal write_data : std_ulogic_vector(width - 1 downto 0) := (others => '0');
  signal full : std_ulogic;
  signal read_enable : std_ulogic := '0';
  signal read_data : std_ulogic_vector(width - 1 downto 0);
  signal read_valid : std_ulogic;
  signal level : natural range 0 to depth;

begin

  clk <= not clk after 5 ns;

  queue : entity work.fifo
    generic map (width => width, depth => depth)
    port map (
      clk => clk, reset => reset, write_enable => write_enable, write_data => write_data,
      full => full, read_enable => read_enable, read_data => read_data,
      read_valid => read_valid, level => level);

  check : process
    variable seed_1 : positive := 5;
    variable seed_2 : positive := 6;

    impure function chance (probability : real) return std_ulogic is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      if value < probability then
        return '1';
      end if;
      return '0';
    end function;

    -- Words are numbers that count up: what has been written and what has been read.
    variable written : natural := 0;
    variable taken : natural := 0;
    variable clocks_empty_handed : natural := 0;
    variable times_full : natural := 0;
    variable times_empty : natural := 0;
    variable write_probability : real;

    impure function word (number : natural) return std_ulogic_vector is
    begin
      return std_ulogic_vector(to_unsigned(number mod 2 ** width, width));
    end function;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until falling_edge(clk);
    for clock in 0 to 29_999 loop
      write_probability := 0.2 + 0.6 * real((clock / 1000) mod 2);
      write_enable <= chance(write_probability);
      write_data <= word(written);
      read_enable <= chance(1.0 - write_probability);
      wait until rising_edge(clk);
      if read_enable and read_valid then
        gives_words_in_order : assert read_data = word(taken)
          report "read " & to_hstring(read_data) & " as number " & to_string(taken) severity error;
        taken := taken + 1;
      end if;
      if write_enable and not full then
        written := written + 1;
      end if;
      wait until falling_edge(clk);
      knows_its_level : assert level = written - taken
        report "level " & to_string(level) severity error;
      is_full_at_its_depth : assert (full = '1') = (written - taken = depth)
        report "full is wrong" severity error;
      offers_only_what_it_has : assert read_valid = '0' or written /= taken
        report "offers a word while empty" severity error;
      if read_valid = '0' and written /= taken then
        clocks_empty_handed := clocks_empty_handed + 1;
      else
        clocks_empty_handed := 0;
      end if;
      offers_within_two_clocks : assert clocks_empty_handed <= 1
        report "holds a word back" severity error;
      if full then
        times_full := times_full + 1;
      elsif level = 0 then
        times_empty := times_empty + 1;
      end if;
    end loop;
    was_driven_to_both_ends : assert times_full > 1000 and times_empty > 1000
      report "the traffic tests too little" severity failure;
    reset <= '1';
    wait until rising_edge(clk);
    wait until falling_edge(clk);
    is_empty_after_reset : assert level = 0 and read_valid = '0'
      report "not empty after reset" severity error;
    std.env.finish;
  end process;

end architecture;
