-- SPDX-License-Identifier: Apache-2.0
-- The highest-priority enabled request is selected, one clock later.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity interrupt_control_tb is
end entity;

architecture tb of interrupt_control_tb is

  signal clk : std_ulogic := '0';
  signal requested, enabled : word_t := (others => '0');
  signal pending : std_ulogic;
  signal cause : std_ulogic_vector(4 downto 0);

  type order_t is array (natural range <>) of natural;
  constant order : order_t := (
    11, 7, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31);

begin

  clk <= not clk after 5 ns;

  uut : entity work.interrupt_control
    port map (
      clk => clk, requested => requested, enabled => enabled, pending => pending, cause => cause);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;
  begin
    requested <= (others => '1');
    enabled <= (others => '0');
    clock;
    assert pending = '0' severity failure;
    for first in order'range loop
      for other in first to order'high loop
        enabled <= (others => '0');
        enabled(order(first)) <= '1';
        enabled(order(other)) <= '1';
        clock;
        assert pending = '1' and to_integer(unsigned(cause)) = order(first)
          report integer'image(order(first)) & " goes before " & integer'image(order(other))
          severity failure;
      end loop;
    end loop;
    requested <= (others => '0');
    clock;
    assert pending = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
