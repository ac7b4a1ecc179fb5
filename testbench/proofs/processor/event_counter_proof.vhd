-- SPDX-License-Identifier: Apache-2.0
-- A 64-bit counter counts every event exactly once, also while its other half is written.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

entity event_counter_proof is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    increment : in std_ulogic;
    write_low : in std_ulogic;
    write_high : in std_ulogic;
    write_data : in value_t
  );
end entity;

architecture proof of event_counter_proof is

  signal count, next_count, expected, now_expected, next_expected : unsigned(63 downto 0);
  signal started : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  event_counter : entity work.event_counter
    port map (
      clk => clk,
      reset => reset,
      increment => increment,
      write_low => write_low,
      write_high => write_high,
      write_data => write_data,
      count => count,
      next_count => next_count);

  now_expected <= expected + 1 when increment else expected;
  next_expected(31 downto 0) <= unsigned(write_data) when write_low else now_expected(31 downto 0);
  next_expected(63 downto 32) <= unsigned(write_data) when write_high else now_expected(63 downto 32);

  follow : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    if reset then
      expected <= (others => '0');
    else
      expected <= next_expected;
    end if;
  end process;

  it_starts_with_reset : assume always (not started -> reset);

  every_event_is_counted_once : assert always (started -> count = now_expected);
  next_count_is_right : assert always (started -> next_count = next_expected);

end architecture;
