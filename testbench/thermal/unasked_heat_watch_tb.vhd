-- SPDX-License-Identifier: Apache-2.0
-- A count an eighth below the reference shows heat that was not requested; nothing else does.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.thermal_pkg.all;

entity unasked_heat_watch_tb is
end entity;

architecture simulation of unasked_heat_watch_tb is

  constant settle : positive := 5;
  constant hot : positive := 60_000;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal tick, gate : std_ulogic := '0';
  signal limits_set : std_ulogic := '1';
  signal reading : sensor_reading_t := sensor_reading_none;
  signal settle_ticks : settle_t := to_unsigned(settle, settle_t'length);
  signal found : std_ulogic;

begin

  clk <= not clk after 10 ns;

  watch : entity work.unasked_heat_watch
    port map (
      clk => clk, reset => reset, tick => tick, gate => gate, reading => reading,
      limits_set => limits_set, settle_ticks => settle_ticks, hot_count => to_unsigned(hot, 32),
      found => found);

  test : process

    procedure ticks (count : natural) is
    begin
      for i in 1 to count loop
        give_ticks(clk, tick, 1);
        finds_nothing_without_a_conversion : assert found = '0' report "found" severity error;
      end loop;
    end procedure;

    procedure convert (
      count : natural; is_heat : boolean := false; valid : std_ulogic := '1';
      updated : std_ulogic := '1') is
    begin
      reading <= (updated => updated, valid => valid, count => to_unsigned(count, 32));
      wait_for_clock(clk);
      reading.updated <= '0';
      finds_heat_alone : assert (found = '1') = is_heat
        report "count " & to_string(count) & ": found is " & to_string(found) severity error;
      wait_for_clock(clk);
      finds_it_for_one_clock : assert found = '0' report "found for two clocks" severity error;
    end procedure;

    -- The gate opens and closes, and the settling time begins.
    procedure heat is
    begin
      gate <= '1';
      wait_for_clock(clk);
      wait_for_clock(clk);
      gate <= '0';
    end procedure;

    procedure begin_with (count : natural) is
    begin
      heat;
      ticks(settle);
      convert(count);
    end procedure;

  begin
    wait_for_clock(clk);
    reset <= '0';

    -- Within the settling time nothing is a reference, and nothing is found.
    heat;
    convert(50_000);
    ticks(settle - 1);
    convert(50_000);
    convert(10);
    ticks(1);
    convert(40_000);
    -- 40 000 less an eighth is 35 000.
    convert(35_000);
    convert(34_999, is_heat => true);
    convert(34_999, is_heat => true);
    convert(35_000);
    convert(39_999);
    convert(0, is_heat => true);
    -- An invalid conversion says nothing, nor does a count that no conversion made.
    convert(100, valid => '0');
    convert(100, updated => '0');
    convert(100, valid => '0', updated => '0');
    convert(60_000, valid => '0');
    convert(60_000, updated => '0');
    convert(35_000);
    -- An eighth is rounded down: 40 007 less 5 000 is 35 007.
    convert(40_007);
    convert(35_007);
    convert(35_006, is_heat => true);

    -- While the part cools the reference follows; it does not sink again.
    convert(48_000);
    convert(42_000);
    convert(47_999);
    convert(42_000);
    convert(41_999, is_heat => true);
    convert(80_000);
    convert(70_000);
    -- Below an eighth less, but not hot.
    convert(60_001);
    convert(60_000);
    convert(59_999, is_heat => true);

    -- The gate opens: all starts over, with a new reference.
    begin_with(20_000);
    convert(17_500);
    convert(17_499, is_heat => true);
    heat;
    convert(10_000);
    ticks(settle);
    convert(10_000);
    convert(8_750);
    convert(8_749, is_heat => true);
    -- Also where the gate is open in the clock of the conversion.
    gate <= '1';
    convert(5_000);
    gate <= '0';
    ticks(settle);
    convert(5_000);
    convert(4_999);
    convert(6_000);

    -- And where a limit is missing.
    begin_with(20_000);
    limits_set <= '0';
    convert(10);
    limits_set <= '1';
    ticks(settle - 1);
    convert(10);
    convert(1);
    ticks(1);
    convert(20_000);
    convert(17_500);
    convert(17_499, is_heat => true);
    limits_set <= '0';
    convert(10);
    limits_set <= '1';

    -- And with a reset, whatever comes in its clock.
    begin_with(20_000);
    reset <= '1';
    convert(10);
    reset <= '0';
    ticks(settle - 1);
    convert(10);
    convert(1);
    ticks(1);
    -- What it knew is forgotten, too.
    convert(10_000);
    convert(8_750);
    convert(8_749, is_heat => true);

    -- Another settling time; one of 0 begins at once.
    settle_ticks <= to_unsigned(300, settle_t'length);
    heat;
    ticks(299);
    convert(100);
    ticks(1);
    convert(20_000);
    convert(100, is_heat => true);
    settle_ticks <= to_unsigned(0, settle_t'length);
    heat;
    convert(20_000);
    convert(17_499, is_heat => true);

    -- After the longest time that it can count, which no bench waits for, the part is still settled.
    settle_ticks <= to_unsigned(settle, settle_t'length);
    << signal watch.closed_ticks : settle_t >> <=
      force to_unsigned(2 ** settle_t'length - 2, settle_t'length);
    ticks(1);
    << signal watch.closed_ticks : settle_t >> <= release;
    convert(17_499, is_heat => true);
    ticks(2);
    convert(17_499, is_heat => true);
    finish;
  end process;

end architecture;
