-- SPDX-License-Identifier: Apache-2.0
-- The captured position is that of the clock of the capture, and stays.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;

entity position_latch_tb is
end entity;

architecture simulation of position_latch_tb is

  signal clk : std_ulogic := '0';
  signal capture : std_ulogic := '0';
  signal position : position_t := (others => '0');
  signal captured_position : position_t;

begin

  clk <= not clk after 10 ns;

  latch : entity work.position_latch
    port map (
      clk => clk, capture => capture, position => position,
      captured_position => captured_position);

  -- A step back in every clock.
  move : process
  begin
    wait until rising_edge(clk);
    position <= position - 1;
  end process;

  test : process
  begin
    for i in 1 to 10 loop
      wait until rising_edge(clk);
    end loop;
    assert captured_position = 0 severity failure;
    capture <= '1';
    wait until rising_edge(clk);
    capture <= '0';
    for i in 1 to 10 loop
      wait until rising_edge(clk);
    end loop;
    assert captured_position = -10 report to_string(to_integer(captured_position)) severity failure;
    finish;
  end process;

end architecture;
