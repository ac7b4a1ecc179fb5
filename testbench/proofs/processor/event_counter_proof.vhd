-- SPDX-License-Identifier: Apache-2.0
-- A counter of 64 bits has counted every event, none twice, with the last one taken back where asked.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

entity event_counter_proof is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    happens : in std_ulogic;
    take_back : in std_ulogic;
    write_low : in std_ulogic;
    write_high : in std_ulogic;
    write_data : in value_t
  );
end entity;

architecture proof of event_counter_proof is

  signal count, next_count, expected, next_expected : unsigned(63 downto 0);
  signal started : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  event_counter : entity work.event_counter
    port map (
      clk => clk,
      reset => reset,
      happens => happens,
      take_back => take_back,
      write_low => write_low,
      write_high => write_high,
      write_data => write_data,
      count => count,
      next_count => next_count);

  next_expected <= expected - 1 when take_back else expected + 1 when happens else expected;

  follow : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    if reset then
      expected <= (others => '0');
    elsif write_low then
      expected(31 downto 0) <= unsigned(write_data);
    elsif write_high then
      expected(63 downto 32) <= unsigned(write_data);
    else
      expected <= next_expected;
    end if;
  end process;

  it_starts_with_reset : assume always (not started -> reset);
  one_thing_at_a_time : assume always
    (not (take_back and (happens or write_low or write_high)) and not (write_low and write_high));

  every_event_is_counted_once : assert always (started -> count = expected);
  the_next_count_is_told : assert always
    ((started = '1' and reset = '0' and write_low = '0' and write_high = '0') ->
     next_count = next_expected);

end architecture;
