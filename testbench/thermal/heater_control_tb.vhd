-- SPDX-License-Identifier: Apache-2.0
-- A hung processor, a second write to a limit, a wrong key: nothing that software does or omits heats.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_tb is
end entity;

architecture simulation of heater_control_tb is

  constant clock_frequency_hz : positive := 4_000_000;
  constant ticks_per_s : positive := clock_frequency_hz / tick_cycles;
  constant charges : positive := 16;
  -- 4 * 2^-20 s at 4 MHz, and a sixteenth of a second.
  constant floor : positive := 15 * charges;
  constant ceiling : positive := 250_000 * charges;
  -- Times in ticks, and the clocks of a conversion with some to spare: short ones, for a short run.
  constant patience : positive := 6;
  constant sensor_patience : positive := 9;
  constant settling : positive := 3;
  constant conversion : positive := 250;

  signal clk : std_ulogic;
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal emergency_stop : std_ulogic := '0';
  signal veto : std_ulogic := '0';
  signal supply, interrupt, limits_locked : std_ulogic;
  signal gates : std_ulogic_vector(1 downto 0);
  signal sensors_work : boolean := true;
  signal present_count : natural := 5_000;
  signal gate_0_edges, clocks_at_rest : natural;

begin

  rig : entity work.heater_control_rig
    generic map (
      clock_frequency_hz => clock_frequency_hz, charges => charges, conversion => conversion - 49)
    port map (
      clk => clk, reset => reset, request => request, response => response,
      sensors_work => sensors_work, present_count => present_count,
      emergency_stop => emergency_stop, veto => veto, gates => gates, supply => supply,
      interrupt => interrupt, limits_locked => limits_locked, gate_0_edges => gate_0_edges,
      clocks_at_rest => clocks_at_rest);

  check : process

    variable word : word_t;
    variable clocks : natural;

    procedure write (address : unsigned(31 downto 0); value : natural; channel : natural := 0) is
    begin
      bus_write(clk, request, response, address + 4 * channel, value);
    end procedure;

    procedure read (address : unsigned(31 downto 0); channel : natural := 0) is
    begin
      bus_read(clk, request, response, address + 4 * channel, word);
    end procedure;

    procedure clocks_pass (count : natural) is
    begin
      wait_clocks(clk, count);
    end procedure;

    procedure feed_it is
    begin
      feed_watchdog(clk, request, response);
    end procedure;

    procedure clear (
      channels : std_ulogic_vector(3 downto 0) := "0011";
      key : natural := heater_control_clear_key_clear_trips) is
    begin
      clear_trips(clk, request, response, channels, key);
    end procedure;

    procedure expect_trip (bit_number : natural; channel : natural := 0) is
    begin
      expect_trip(clk, request, response, interrupt, bit_number, channel);
    end procedure;

    procedure heat is
    begin
      feed_it;
      clocks_pass(conversion);
      write(heater_control_duty_address, 65_535);
      clocks_pass(220);
      heats : assert gates = "01" report "gates " & to_string(gates) & " after " & to_string(now)
        severity error;
    end procedure;
  begin
    clocks_pass(3);
    reset <= '0';
    clocks_pass(10);
    read(heater_control_watchdog_address);
    watches_for_a_second_at_first : assert unsigned(word) = ticks_per_s
      report to_hstring(word) severity error;
    write(heater_control_watchdog_address, 2 ** 20 - 1);
    read(heater_control_watchdog_address);
    has_a_built_in_maximum : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(heater_control_sensor_timeout_address, 2 ** 20 - 1);
    read(heater_control_sensor_timeout_address);
    has_one_for_sensors_too : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(heater_control_watchdog_address, patience);
    write(heater_control_sensor_timeout_address, sensor_patience);
    write(heater_control_slot_address, 1);

    -- No heat without limits.
    feed_it;
    clocks_pass(conversion);
    write(heater_control_duty_address, 65_535);
    clocks_pass(20);
    heats_not_without_limits : assert gates = "00" report "heats" severity error;
    expect_trip(heater_control_status_limits_missing_trip_bit);

    -- Out of its bounds nothing locks.
    nothing_is_locked : assert limits_locked = '0' report "locked" severity error;
    write(heater_control_minimum_count_address, floor - 1);
    read(heater_control_status_address);
    refuses_what_is_hotter_than_any_machine : assert word(lock_bits) = "10000"
      report to_hstring(word) severity error;
    clear;
    write(heater_control_maximum_count_address, ceiling + 1);
    read(heater_control_status_address);
    refuses_what_is_no_sensor : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear;
    write(heater_control_hot_count_address, 8 * floor - 1);
    read(heater_control_status_address);
    refuses_to_be_blind : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear;
    write(heater_control_settle_address, 120 * ticks_per_s + 1);
    read(heater_control_status_address);
    refuses_to_sleep : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear("0010");
    read(heater_control_status_address);
    forgets_only_what_is_named : assert word(heater_control_status_refused_bit) = '1'
      report to_hstring(word) severity error;
    clear("0001");
    read(heater_control_status_address);
    forgets_what_is_named : assert word(heater_control_status_refused_bit) = '0'
      report to_hstring(word) severity error;
    write(heater_control_minimum_count_address, floor, 1);
    write(heater_control_maximum_count_address, ceiling, 1);
    write(heater_control_hot_count_address, 8 * floor, 1);
    write(heater_control_settle_address, 120 * ticks_per_s, 1);
    read(heater_control_status_address, 1);
    takes_the_bounds_themselves : assert word(lock_bits) = "01111" report to_hstring(word) severity error;
    locks_the_converter : assert limits_locked = '1' report "not locked" severity error;
    read(heater_control_status_address);
    locks_each_channel_alone : assert word(lock_bits) = "00000" report to_hstring(word) severity error;

    -- Limits lock with the first write, each for itself.
    write(heater_control_minimum_count_address, 1_000);
    write(heater_control_maximum_count_address, 9_000);
    write(heater_control_hot_count_address, 6_000);
    write(heater_control_settle_address, settling);
    write(heater_control_minimum_count_address, 0);
    write(heater_control_maximum_count_address, 2_000_000_000);
    read(heater_control_minimum_count_address);
    minimum_is_locked : assert unsigned(word) = 1_000 report to_hstring(word) severity error;
    read(heater_control_maximum_count_address);
    maximum_is_locked : assert unsigned(word) = 9_000 report to_hstring(word) severity error;
    read(heater_control_status_address);
    says_that_it_refused : assert word(heater_control_status_refused_bit) = '1'
      report to_hstring(word) severity error;

    -- Clearing takes the key and no duty.
    clear;
    expect_trip(heater_control_status_limits_missing_trip_bit);
    write(heater_control_duty_address, 0);
    clear("0011", heater_control_clear_key_clear_trips + 1);
    expect_trip(heater_control_status_limits_missing_trip_bit);
    clear;
    is_cleared : assert interrupt = '0' report "still tripped" severity error;

    -- The processor hangs: the gate closes after its patience, less the part of the first one.
    heat;
    feed_it;
    clocks := 0;
    while gates(0) loop
      clocks_pass(1);
      clocks := clocks + 1;
    end loop;
    closes_in_time : assert clocks > (patience - 1) * tick_cycles and clocks < patience * tick_cycles + 10
      report to_string(clocks) & " clocks" severity error;
    expect_trip(heater_control_status_watchdog_trip_bit);
    feed_it;
    clocks_pass(100);
    feeding_is_not_clearing : assert gates = "00" report "heats again" severity error;
    write(heater_control_duty_address, 0);
    clear;

    -- Whatever is not the key that is due, in its time, trips all channels, also those at rest.
    -- The window is a sixteenth of the patience.
    write(heater_control_watchdog_address, 16);
    for mistake in 0 to 3 loop
      clocks_pass(2 * tick_cycles);
      heat;
      clocks_pass(tick_cycles);
      if mistake = 0 then
        write(heater_control_feed_address, heater_control_feed_key_first + 1);
      elsif mistake = 1 then
        write(heater_control_feed_address, heater_control_feed_key_second);
      else
        write(heater_control_feed_address, heater_control_feed_key_first);
        read(heater_control_status_address);
        one_key_is_no_mistake : assert word(heater_control_status_tripped_bit) = '0'
          report to_hstring(word) severity error;
        if mistake = 3 then
          write(heater_control_feed_address, heater_control_feed_key_second);
        end if;
        write(heater_control_feed_address, heater_control_feed_key_first);
      end if;
      expect_trip(heater_control_status_watchdog_trip_bit);
      expect_trip(heater_control_status_watchdog_trip_bit, 1);
      write(heater_control_duty_address, 0);
      clear("0001");
      read(heater_control_status_address);
      clears_the_channel_named : assert word(heater_control_status_tripped_bit) = '0'
        report to_hstring(word) severity error;
      expect_trip(heater_control_status_watchdog_trip_bit, 1);
      clear;
    end loop;

    -- One key of the two is not enough.
    write(heater_control_watchdog_address, patience);
    clocks_pass(2 * tick_cycles);
    heat;
    clocks_pass(2 * tick_cycles);
    write(heater_control_feed_address, heater_control_feed_key_first);
    clocks_pass(patience * tick_cycles);
    expect_trip(heater_control_status_watchdog_trip_bit);
    write(heater_control_duty_address, 0);
    clear;
    write(heater_control_feed_address, heater_control_feed_key_second);
    clocks_pass(2 * tick_cycles);

    -- The sensor falls silent while software is well.
    heat;
    sensors_work <= false;
    for i in 1 to sensor_patience / 2 + 1 loop
      clocks_pass(2 * tick_cycles);
      feed_it;
    end loop;
    expect_trip(heater_control_status_sensor_stale_trip_bit);
    sensors_work <= true;
    clocks_pass(conversion);
    write(heater_control_duty_address, 0);
    clear;

    -- Emergency stop reaches every channel, also those at rest.
    heat;
    emergency_stop <= '1';
    clocks_pass(5);
    stops : assert gates = "00" report "heats" severity error;
    emergency_stop <= '0';
    expect_trip(heater_control_status_emergency_stop_trip_bit);
    expect_trip(heater_control_status_emergency_stop_trip_bit, 1);
    write(heater_control_duty_address, 0);
    clear;

    reset <= '1';
    clocks_pass(3);
    is_off_in_reset : assert gates = "00" report "heats" severity error;
    reset <= '0';
    clocks_pass(3);
    read(heater_control_minimum_count_address);
    reset_unlocks : assert unsigned(word) = x"FFFF_FFFF" report to_hstring(word) severity error;
    std.env.finish;
  end process;

end architecture;
