-- SPDX-License-Identifier: Apache-2.0
-- Registers keep what is written to them, and x0 is zero.

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
  signal read, write : std_ulogic := '0';

begin

  clk <= not clk after 5 ns;

  uut : entity work.register_file
    port map (
      clk => clk,
      read => read,
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
    read <= '1';
    for index in 1 to 31 loop
      write <= '1';
      write_index <= std_ulogic_vector(to_unsigned(index, 5));
      write_data <= pattern(index);
      first_index <= std_ulogic_vector(to_unsigned(index, 5));
      wait until rising_edge(clk);
      wait for 1 ns;
      assert first = x"00000000" report "who asks in the clock of a write gets the old value"
        severity failure;
    end loop;
    write <= '0';
    write_data <= x"ffffffff";
    wait until rising_edge(clk);
    for index in 0 to 31 loop
      first_index <= std_ulogic_vector(to_unsigned(index, 5));
      second_index <= std_ulogic_vector(to_unsigned(31 - index, 5));
      wait until rising_edge(clk);
      wait for 1 ns;
      assert first = pattern(index) and second = pattern(31 - index) severity failure;
    end loop;
    read <= '0';
    first_index <= 5d"3";
    second_index <= 5d"20";
    wait until rising_edge(clk);
    wait for 1 ns;
    assert first = pattern(31) and second = pattern(0) report "what was asked for stays"
      severity failure;
    std.env.finish;
  end process;

end architecture;
