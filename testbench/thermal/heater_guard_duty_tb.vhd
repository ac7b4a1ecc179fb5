-- SPDX-License-Identifier: Apache-2.0
-- Heat is requested by any duty, also in the slots in which the gate is closed: at the least duty in all but
-- one of 65535. What fails then is latched as at full duty.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.clocked_bench_pkg.all;
use work.thermal_pkg.all;

entity heater_guard_duty_tb is
end entity;

architecture simulation of heater_guard_duty_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal tick : std_ulogic := '0';
  signal duty : unsigned(15 downto 0) := (others => '0');
  signal watchdog_alive : std_ulogic := '1';
  signal reading : sensor_reading_t := sensor_reading_none;
  constant sensor_timeout_ticks : tick_count_t := to_unsigned(20, tick_count_bits);
  constant minimum_count : unsigned(31 downto 0) := to_unsigned(1_000, 32);
  constant maximum_count : unsigned(31 downto 0) := to_unsigned(50_000, 32);
  signal limits_set : std_ulogic := '1';
  signal clear : std_ulogic := '0';
  signal gate, permitted : std_ulogic;
  signal trips : heater_trips_t;

begin

  clk <= not clk after 5 ns;

  guard : entity work.heater_guard
    port map (
      clk => clk, reset => reset, tick => tick, slot_start => '1', duty => duty,
      watchdog_alive => watchdog_alive, watchdog_violated => '0', heats_unasked => '0',
      reading => reading, sensor_timeout_ticks => sensor_timeout_ticks, minimum_count => minimum_count,
      maximum_count => maximum_count, limits_set => limits_set, emergency_stop => '0',
      clear => clear, gate => gate, permitted => permitted, trips => trips);

  check : process

    variable expected : heater_trips_t;

    procedure convert (count : natural; valid : std_ulogic := '1') is
    begin
      reading <= (updated => '1', valid => valid, count => to_unsigned(count, 32));
      wait_clocks(clk, 1);
      reading.updated <= '0';
    end procedure;

    procedure pass_ticks (count : natural) is
    begin
      for i in 1 to count loop
        tick <= '1';
        wait_clocks(clk, 1);
        tick <= '0';
        wait_clocks(clk, 1);
      end loop;
    end procedure;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    for cause in 0 to 5 loop
      convert(10_000);
      duty <= to_unsigned(1, 16);
      wait_clocks(clk, 4);
      is_closed_for_now : assert gate = '0' and permitted = '1' and trips = heater_trips_none
        report "no slot without heat" severity error;
      expected := heater_trips_none;
      case cause is
        when 0 =>
          expected.watchdog := '1';
          watchdog_alive <= '0';
        when 1 =>
          expected.limits_missing := '1';
          limits_set <= '0';
        when 2 =>
          expected.too_hot := '1';
          convert(999);
        when 3 =>
          expected.too_cold := '1';
          convert(50_001);
        when 4 =>
          expected.sensor_stale := '1';
          pass_ticks(20);
        when others =>
          expected.sensor_invalid := '1';
          convert(10_000, valid => '0');
          pass_ticks(20);
      end case;
      wait_clocks(clk, 3);
      watchdog_alive <= '1';
      limits_set <= '1';
      convert(10_000);
      wait_clocks(clk, 3);
      is_latched : assert gate = '0' and permitted = '0' and trips = expected
        report "cause " & to_string(cause) severity error;
      duty <= (others => '0');
      clear <= '1';
      wait_clocks(clk, 1);
      clear <= '0';
      wait_clocks(clk, 2);
    end loop;
    std.env.finish;
  end process;

end architecture;
