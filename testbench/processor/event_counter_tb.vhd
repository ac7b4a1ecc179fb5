-- SPDX-License-Identifier: Apache-2.0
-- Events carry from the lower into the upper half; a write replaces the count.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity event_counter_tb is
end entity;

architecture tb of event_counter_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal increment, write_low, write_high : std_ulogic := '0';
  signal write_data : word_t := (others => '0');
  signal count, next_count : unsigned(63 downto 0);

begin

  clk <= not clk after 5 ns;

  uut : entity work.event_counter
    port map (
      clk => clk,
      reset => reset,
      increment => increment,
      write_low => write_low,
      write_high => write_high,
      write_data => write_data,
      count => count,
      next_count => next_count);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;
  begin
    clock;
    reset <= '0';
    assert count = 0 severity failure;
    increment <= '1';
    for index in 1 to 5 loop
      wait for 1 ns;
      assert count = index and next_count = index report "with the event of this clock" severity failure;
      clock;
    end loop;
    increment <= '0';
    wait for 1 ns;
    assert count = 5 severity failure;
    increment <= '1';
    write_low <= '1';
    write_data <= x"fffffffe";
    wait for 1 ns;
    assert count = 6 and next_count = x"00000000fffffffe" severity failure;
    clock;
    write_low <= '0';
    clock;
    wait for 1 ns;
    assert count = x"0000000100000000" report "over the edge of the halves" severity failure;
    clock;
    write_high <= '1';
    write_data <= x"00000007";
    clock;
    write_high <= '0';
    increment <= '0';
    wait for 1 ns;
    assert count = x"0000000700000001" report "the half that is not written counts" severity failure;
    clock;
    assert count = x"0000000700000001" severity failure;
    reset <= '1';
    clock;
    assert count = 0 severity failure;
    std.env.finish;
  end process;

end architecture;
