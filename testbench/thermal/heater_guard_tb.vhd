-- SPDX-License-Identifier: Apache-2.0
-- The gate follows its duty while all is well, never opens otherwise, and every trip stays until cleared.

library ieee;
use ieee.math_real.all;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity heater_guard_tb is
end entity;

architecture simulation of heater_guard_tb is

  constant random_clocks : positive := 300_000;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal tick, slot_start : std_ulogic := '0';
  signal duty : unsigned(15 downto 0) := (others => '0');
  signal watchdog_alive : std_ulogic := '1';
  signal watchdog_violated, heats_unasked : std_ulogic := '0';
  signal reading : sensor_reading_t := sensor_reading_none;
  signal sensor_timeout_ticks : tick_count_t := to_unsigned(20, tick_count_bits);
  signal minimum_count : unsigned(31 downto 0) := to_unsigned(1_000, 32);
  signal maximum_count : unsigned(31 downto 0) := to_unsigned(50_000, 32);
  signal limits_set : std_ulogic := '1';
  signal emergency_stop, clear : std_ulogic := '0';
  signal gate, permitted : std_ulogic;
  signal trips : heater_trips_t;

  signal clocks_open : natural;

begin

  clk <= not clk after 5 ns;
  slot_start <= '1';

  guard : entity work.heater_guard
    port map (
      clk => clk, reset => reset, tick => tick, slot_start => slot_start, duty => duty,
      watchdog_alive => watchdog_alive, watchdog_violated => watchdog_violated,
      heats_unasked => heats_unasked, reading => reading,
      sensor_timeout_ticks => sensor_timeout_ticks, minimum_count => minimum_count,
      maximum_count => maximum_count, limits_set => limits_set, emergency_stop => emergency_stop,
      clear => clear, gate => gate, permitted => permitted, trips => trips);

  monitor : entity work.gate_monitor
    port map (
      clk => clk, reset => reset, tick => tick, duty => duty, watchdog_alive => watchdog_alive,
      watchdog_violated => watchdog_violated, heats_unasked => heats_unasked, reading => reading,
      sensor_timeout_ticks => sensor_timeout_ticks, minimum_count => minimum_count,
      maximum_count => maximum_count, limits_set => limits_set, emergency_stop => emergency_stop,
      gate => gate, trips => trips, clocks_open => clocks_open);

  check : process

    variable open_before : natural;
    variable seed_1, seed_2 : positive := 7;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure convert (count : natural; valid : std_ulogic := '1') is
    begin
      reading <= (updated => '1', valid => valid, count => to_unsigned(count, 32));
      wait_clocks(1);
      reading.updated <= '0';
    end procedure;

    procedure pass_ticks (count : natural) is
    begin
      for i in 1 to count loop
        tick <= '1';
        wait_clocks(1);
        tick <= '0';
        wait_clocks(1);
      end loop;
    end procedure;

    procedure clear_trips is
    begin
      duty <= (others => '0');
      clear <= '1';
      wait_clocks(1);
      clear <= '0';
      wait_clocks(2);
      is_cleared : assert trips = heater_trips_none report "still tripped" severity error;
    end procedure;

    procedure heat_fully is
    begin
      convert(10_000);
      duty <= (others => '1');
      wait_clocks(4);
      heats : assert gate = '1' and permitted = '1' report "does not heat" severity error;
    end procedure;

    -- Closed now, tripped as expected, still so when all is well again and clear comes at full duty.
    procedure expect_only (expected : heater_trips_t; why : string) is
    begin
      wait_clocks(2);
      is_closed : assert gate = '0' and permitted = '0' report why & ": open" severity error;
      has_its_name : assert trips = expected report why & ": other trips" severity error;
      watchdog_alive <= '1';
      limits_set <= '1';
      emergency_stop <= '0';
      duty <= (others => '1');
      convert(10_000);
      clear <= '1';
      wait_clocks(10);
      clear <= '0';
      stays : assert gate = '0' and trips = expected report why & ": forgotten" severity error;
      clear_trips;
      heat_fully;
    end procedure;

    impure function random return real is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      return value;
    end function;

    impure function random_bit (probability : real) return std_ulogic is
    begin
      if random < probability then
        return '1';
      end if;
      return '0';
    end function;

    variable expected : heater_trips_t;
  begin
    wait_clocks(3);
    reset <= '0';
    wait_clocks(3);
    needs_a_conversion : assert permitted = '0' report "permitted without a sensor" severity error;
    is_no_trip_while_nothing_heats : assert trips = heater_trips_none report "trips at rest" severity error;
    heat_fully;

    -- 16384 of 65535 slots, in two rounds.
    duty <= to_unsigned(16_384, 16);
    wait_clocks(4);
    open_before := clocks_open;
    wait_clocks(65_535);
    keeps_its_duty : assert abs (clocks_open - open_before - 16_384) <= 1
      report to_string(clocks_open - open_before) severity error;
    heat_fully;

    -- The limits themselves are within.
    convert(1_000);
    wait_clocks(3);
    heats_at_its_hottest : assert gate = '1' report "closed at a limit" severity error;
    convert(50_000);
    wait_clocks(3);
    heats_at_its_coldest : assert gate = '1' report "closed at a limit" severity error;

    expected := heater_trips_none;
    expected.watchdog := '1';
    watchdog_alive <= '0';
    expect_only(expected, "watchdog");

    expected := heater_trips_none;
    expected.too_hot := '1';
    convert(999);
    expect_only(expected, "too hot");

    expected := heater_trips_none;
    expected.too_cold := '1';
    convert(50_001);
    expect_only(expected, "too cold");

    expected := heater_trips_none;
    expected.limits_missing := '1';
    limits_set <= '0';
    expect_only(expected, "no limits");

    expected := heater_trips_none;
    expected.emergency_stop := '1';
    emergency_stop <= '1';
    expect_only(expected, "emergency stop");

    -- For one clock, and at duty 0 too.
    for at_rest in boolean loop
      expected := heater_trips_none;
      expected.watchdog := '1';
      if at_rest then
        duty <= (others => '0');
      end if;
      watchdog_violated <= '1';
      wait_clocks(1);
      watchdog_violated <= '0';
      expect_only(expected, "wrong feed");

      expected := heater_trips_none;
      expected.heats_unasked := '1';
      if at_rest then
        duty <= (others => '0');
      end if;
      heats_unasked <= '1';
      wait_clocks(1);
      heats_unasked <= '0';
      expect_only(expected, "heats unasked");
    end loop;

    expected := heater_trips_none;
    expected.sensor_stale := '1';
    pass_ticks(19);
    waits_for_the_sensor : assert gate = '1' report "closes early" severity error;
    pass_ticks(1);
    expect_only(expected, "silent sensor");

    -- One faulty conversion closes the gate for as long as it is the newest, and is no trip.
    for faulty in 0 to 2 loop
      -- Whatever it counted: within the limits, too hot, too cold.
      convert(10_000 - (faulty mod 2) * 9_999 + (faulty / 2) * 50_000, valid => '0');
      wait_clocks(2);
      closes_at_once : assert gate = '0' and trips = heater_trips_none
        report "a faulty conversion" severity error;
      convert(10_000);
      wait_clocks(2);
      goes_on : assert gate = '1' report "does not go on" severity error;
    end loop;
    expected := heater_trips_none;
    expected.sensor_invalid := '1';
    for i in 1 to 20 loop
      convert(10_000, valid => '0');
      pass_ticks(1);
    end loop;
    expect_only(expected, "faulty sensor");

    -- The emergency stop is remembered at duty 0 too, and lasts as long as the input.
    clear_trips;
    emergency_stop <= '1';
    wait_clocks(3);
    clear <= '1';
    wait_clocks(1);
    clear <= '0';
    wait_clocks(2);
    cannot_be_cleared_while_active : assert trips.emergency_stop = '1' report "cleared" severity error;
    emergency_stop <= '0';
    clear_trips;

    -- Too hot is remembered at duty 0 too: the part gets hot without being asked to.
    clear_trips;
    convert(999);
    wait_clocks(3);
    too_hot_at_rest : assert trips.too_hot = '1' report "forgets that it was too hot" severity error;
    convert(10_000);
    clear_trips;

    -- Without limits nothing is too hot.
    limits_set <= '0';
    convert(999);
    wait_clocks(3);
    knows_no_limit : assert trips = heater_trips_none report "tripped without limits" severity error;
    convert(10_000);
    limits_set <= '1';
    wait_clocks(1);

    -- Everything at once, at random: watch_gate and the properties of the guard judge.
    open_before := clocks_open;
    for i in 1 to random_clocks loop
      tick <= random_bit(0.2);
      watchdog_alive <= not random_bit(0.01);
      limits_set <= not random_bit(0.01);
      emergency_stop <= random_bit(0.003);
      watchdog_violated <= random_bit(0.003);
      heats_unasked <= random_bit(0.003);
      clear <= random_bit(0.3);
      if random < 0.1 then
        duty <= to_unsigned(integer(random * 65_535.0) * integer(random), 16);
      end if;
      reading.updated <= '0';
      if random < 0.05 then
        reading <= (updated => '1', valid => not random_bit(0.05),
          count => to_unsigned(integer(900.0 + random ** 3 * 50_000.0), 32));
      end if;
      reset <= random_bit(0.0005);
      wait_clocks(1);
    end loop;
    was_open_meanwhile : assert clocks_open - open_before > random_clocks / 50
      report to_string(clocks_open - open_before) & " clocks open" severity error;
    std.env.finish;
  end process;

end architecture;
