-- SPDX-License-Identifier: Apache-2.0
-- All positions and the time are those of the clock of the capture.

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
  signal positions : position_array_t(1 downto 0) := (others => (others => '0'));
  signal now_clock : time_t := (others => '0');
  signal captured_positions : position_array_t(1 downto 0);
  signal captured_time : time_t;

begin

  clk <= not clk after 10 ns;

  latch : entity work.position_latch
    generic map (axes => 2)
    port map (
      clk => clk, capture => capture, positions => positions, now => now_clock,
      captured_positions => captured_positions, captured_time => captured_time);

  -- Both axes move in every clock.
  move : process
  begin
    wait until rising_edge(clk);
    now_clock <= now_clock + 1;
    positions(0) <= positions(0) + 1;
    positions(1) <= positions(1) - 1;
  end process;

  test : process
  begin
    for i in 1 to 10 loop
      wait until rising_edge(clk);
    end loop;
    assert captured_time = 0 severity failure;
    capture <= '1';
    wait until rising_edge(clk);
    capture <= '0';
    for i in 1 to 10 loop
      wait until rising_edge(clk);
    end loop;
    assert captured_time = 10 report to_string(to_integer(captured_time)) severity failure;
    assert captured_positions(0) = 10 and captured_positions(1) = -10 severity failure;
    finish;
  end process;

end architecture;
