-- SPDX-License-Identifier: Apache-2.0
-- Registers hold what is written to them, and x0 is zero.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity register_file_tb is
end entity;

architecture tb of register_file_tb is

  signal clk : std_ulogic := '0';
  signal first_index, second_index, write_index : register_index_t := "00000";
  signal first, second, write_data : word_t := (others => '0');
  signal write : std_ulogic := '0';

begin

  clk <= not clk after 5 ns;

  uut : entity work.register_file
    port map (
      clk => clk,
      first_index => first_index,
      first => first,
      second_index => second_index,
      second => second,
      write => write,
      write_index => write_index,
      write_data => write_data);

  check : process
    function pattern(index : natural) return word_t is
    begin
      return std_ulogic_vector(to_unsigned(index * 16#1234567#, 32));
    end function;
  begin
    for index in 1 to 31 loop
      write <= '1';
      write_index <= std_ulogic_vector(to_unsigned(index, 5));
      write_data <= pattern(index);
      first_index <= std_ulogic_vector(to_unsigned(index, 5));
      wait for 1 ns;
      assert first = x"00000000" report "who reads in the clock of a write gets the old value"
        severity failure;
      wait until rising_edge(clk);
      wait for 1 ns;
      assert first = pattern(index) severity failure;
    end loop;
    write <= '0';
    write_data <= x"ffffffff";
    wait until rising_edge(clk);
    for index in 0 to 31 loop
      first_index <= std_ulogic_vector(to_unsigned(index, 5));
      second_index <= std_ulogic_vector(to_unsigned(31 - index, 5));
      wait for 1 ns;
      assert first = pattern(index) and second = pattern(31 - index) severity failure;
    end loop;
    std.env.finish;
  end process;

end architecture;
