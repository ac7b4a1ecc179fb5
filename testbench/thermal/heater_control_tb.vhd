-- SPDX-License-Identifier: Apache-2.0
-- A hung processor, a second write to a limit, a wrong key: nothing that software does or omits heats.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_tb is
end entity;

architecture simulation of heater_control_tb is

  constant clock_frequency_hz : positive := 4_000_000;
  -- As the registers' description says.
  constant tick_cycles : positive := 1024;
  constant ticks_per_s : positive := clock_frequency_hz / tick_cycles;

  constant feed : unsigned(31 downto 0) := heater_control_feed_address;
  constant watchdog : unsigned(31 downto 0) := heater_control_watchdog_address;
  constant sensor_timeout : unsigned(31 downto 0) := heater_control_sensor_timeout_address;
  constant slot : unsigned(31 downto 0) := heater_control_slot_address;
  constant clear : unsigned(31 downto 0) := heater_control_clear_address;
  constant duty : unsigned(31 downto 0) := heater_control_duty_address;
  constant minimum_count : unsigned(31 downto 0) := heater_control_minimum_count_address;
  constant maximum_count : unsigned(31 downto 0) := heater_control_maximum_count_address;
  constant status : unsigned(31 downto 0) := heater_control_status_address;
  constant hot_count : unsigned(31 downto 0) := heater_control_hot_count_address;
  constant settle : unsigned(31 downto 0) := heater_control_settle_address;
  constant supply_register : unsigned(31 downto 0) := heater_control_supply_address;
  -- 4 * 2^-20 s at 4 MHz, and a sixteenth of a second.
  constant charges : positive := 16;
  constant floor : positive := 15 * charges;
  constant ceiling : positive := 250_000 * charges;
  -- Times in ticks, and the clocks of a conversion with some to spare: short ones, for a short run.
  constant patience : positive := 6;
  constant sensor_patience : positive := 9;
  constant settling : positive := 3;
  constant conversion : positive := 250;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal emergency_stop : std_ulogic := '0';
  signal veto : std_ulogic := '0';
  signal supply, limits_locked : std_ulogic;
  signal gates : std_ulogic_vector(1 downto 0);
  signal interrupt : std_ulogic;
  signal at_rest : std_ulogic;
  signal sensors_work : boolean := true;
  signal present_count : natural := 5_000;
  signal gate_0_edges : natural := 0;
  signal clocks_at_rest : natural := 0;

begin

  clk <= not clk after 125 ns;

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => response, readings => readings,
      more_charges => to_unsigned(charges - 1, 8), limits_locked => limits_locked,
      emergency_stop => emergency_stop, veto => veto, gates => gates, supply => supply,
      interrupt => interrupt, at_rest => at_rest);

  convert : process
  begin
    for i in 1 to conversion - 50 loop
      wait until rising_edge(clk);
    end loop;
    if sensors_work then
      for channel in readings'range loop
        readings(channel) <= (updated => '1', valid => '1', count => to_unsigned(present_count, 32));
      end loop;
    end if;
    wait until rising_edge(clk);
    for channel in readings'range loop
      readings(channel).updated <= '0';
    end loop;
  end process;

  -- An edge at rest changes nothing, and no reading comes at rest.
  watch_rest : process
    variable outputs, outputs_before : std_ulogic_vector(4 downto 0) := (others => '0');
    variable rested : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    outputs := gates & supply & interrupt & limits_locked;
    changes_nothing_at_rest : assert rested = '0' or outputs = outputs_before
      report "changes at rest" severity error;
    is_awake_for_a_reading : assert at_rest = '0' or (readings(0).updated = '0' and readings(1).updated = '0')
      report "rests while a reading comes" severity error;
    rested := at_rest and not emergency_stop;
    outputs_before := outputs;
    if at_rest then
      clocks_at_rest <= clocks_at_rest + 1;
    end if;
  end process;

  watch_gate : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    if gates(0) /= before then
      gate_0_edges <= gate_0_edges + 1;
    end if;
    before := gates(0);
  end process;

  check : process

    variable word : word_t;
    variable edges_before, clocks : natural;

    procedure write (address : unsigned(31 downto 0); value : natural; channel : natural := 0) is
    begin
      bus_write(clk, request, response, address + 4 * channel, value);
    end procedure;

    procedure read (address : unsigned(31 downto 0); channel : natural := 0) is
    begin
      bus_read(clk, request, response, address + 4 * channel, word);
    end procedure;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure feed_it is
    begin
      write(feed, heater_control_feed_key_first);
      write(feed, heater_control_feed_key_second);
    end procedure;

    procedure expect_trip (bit_number : natural; channel : natural := 0) is
    begin
      read(status, channel);
      trips : assert word(bit_number) = '1' and word(7) = '1' and word(0) = '0'
        report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity error;
      wait_clocks(2);
      interrupts_the_processor : assert interrupt = '1' report "no interrupt" severity error;
    end procedure;

    procedure clear_trips (
      key : natural := heater_control_clear_key_clear_trips; channels : natural := 3) is
    begin
      bus_write(clk, request, response, clear,
        word_t(shift_left(to_unsigned(key, 32), 16) or to_unsigned(channels, 32)));
      wait_clocks(3);
    end procedure;

    procedure switch_supply (key : natural) is
    begin
      bus_write(clk, request, response, supply_register, word_t(shift_left(to_unsigned(key, 32), 16)));
      wait_clocks(3);
    end procedure;

    -- Causes as bits 7 to 4 of the register: veto, emergency stop, watchdog, trip.
    procedure expect_opened (causes : std_ulogic_vector(3 downto 0)) is
    begin
      wait_clocks(3);
      supply_is_open : assert supply = '0' report "the supply is closed" severity error;
      read(supply_register);
      supply_says_why : assert word(7 downto 4) = causes and word(0) = '0'
        report to_hstring(word) & " instead of " & to_string(causes) severity error;
      wait_clocks(2);
      supply_interrupts : assert interrupt = '1' report "no interrupt" severity error;
      write(duty, 0);
      clear_trips;
      wait_clocks(3 * tick_cycles);
      feed_it;
      wait_clocks(3);
      stays_open : assert supply = '0' report "closed by itself" severity error;
      switch_supply(heater_control_supply_key_close);
      closes_again : assert supply = '1' report "does not close" severity error;
    end procedure;

    procedure heat is
    begin
      feed_it;
      wait_clocks(conversion);
      write(duty, 65_535);
      wait_clocks(220);
      heats : assert gates = "01" report "gates " & to_string(gates) & " after " & to_string(now)
        severity error;
    end procedure;
  begin
    wait_clocks(3);
    reset <= '0';
    wait_clocks(10);
    read(watchdog);
    watches_for_a_second_at_first : assert unsigned(word) = ticks_per_s
      report to_hstring(word) severity error;
    write(watchdog, 2 ** 20 - 1);
    read(watchdog);
    has_a_built_in_maximum : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(sensor_timeout, 2 ** 20 - 1);
    read(sensor_timeout);
    has_one_for_sensors_too : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(watchdog, patience);
    write(sensor_timeout, sensor_patience);
    write(slot, 1);

    -- No heat without limits.
    feed_it;
    wait_clocks(conversion);
    write(duty, 65_535);
    wait_clocks(20);
    heats_not_without_limits : assert gates = "00" report "heats" severity error;
    expect_trip(13);

    -- Out of its bounds nothing locks.
    nothing_is_locked : assert limits_locked = '0' report "locked" severity error;
    write(minimum_count, floor - 1);
    read(status);
    refuses_what_is_hotter_than_any_machine : assert word(6 downto 2) = "10000"
      report to_hstring(word) severity error;
    clear_trips;
    write(maximum_count, ceiling + 1);
    read(status);
    refuses_what_is_no_sensor : assert word(6 downto 2) = "10000" report to_hstring(word) severity error;
    clear_trips;
    write(hot_count, 8 * floor - 1);
    read(status);
    refuses_to_be_blind : assert word(6 downto 2) = "10000" report to_hstring(word) severity error;
    clear_trips;
    write(settle, 120 * ticks_per_s + 1);
    read(status);
    refuses_to_sleep : assert word(6 downto 2) = "10000" report to_hstring(word) severity error;
    clear_trips(channels => 2);
    read(status);
    forgets_only_what_is_named : assert word(6) = '1' report to_hstring(word) severity error;
    clear_trips(channels => 1);
    read(status);
    forgets_what_is_named : assert word(6) = '0' report to_hstring(word) severity error;
    write(minimum_count, floor, 1);
    write(maximum_count, ceiling, 1);
    write(hot_count, 8 * floor, 1);
    write(settle, 120 * ticks_per_s, 1);
    read(status, 1);
    takes_the_bounds_themselves : assert word(6 downto 2) = "01111" report to_hstring(word) severity error;
    locks_the_converter : assert limits_locked = '1' report "not locked" severity error;
    read(status);
    locks_each_channel_alone : assert word(6 downto 2) = "00000" report to_hstring(word) severity error;

    -- Limits lock with the first write, each for itself.
    write(minimum_count, 1_000);
    write(maximum_count, 9_000);
    write(hot_count, 6_000);
    write(settle, settling);
    write(minimum_count, 0);
    write(maximum_count, 2_000_000_000);
    read(minimum_count);
    minimum_is_locked : assert unsigned(word) = 1_000 report to_hstring(word) severity error;
    read(maximum_count);
    maximum_is_locked : assert unsigned(word) = 9_000 report to_hstring(word) severity error;
    read(status);
    says_that_it_refused : assert word(6) = '1' report to_hstring(word) severity error;

    -- Clearing takes the key and no duty.
    clear_trips;
    expect_trip(13);
    write(duty, 0);
    clear_trips(16#C1EB#);
    expect_trip(13);
    clear_trips;
    is_cleared : assert interrupt = '0' report "still tripped" severity error;

    -- The processor hangs: the gate closes after its patience, less the part of the first one.
    heat;
    feed_it;
    clocks := 0;
    while gates(0) loop
      wait_clocks(1);
      clocks := clocks + 1;
    end loop;
    closes_in_time : assert clocks > (patience - 1) * tick_cycles and clocks < patience * tick_cycles + 10
      report to_string(clocks) & " clocks" severity error;
    expect_trip(8);
    feed_it;
    wait_clocks(100);
    feeding_is_not_clearing : assert gates = "00" report "heats again" severity error;
    write(duty, 0);
    clear_trips;

    -- Whatever is not the key that is due, in its time, trips all channels, also those at rest.
    -- The window is a sixteenth of the patience.
    write(watchdog, 16);
    for mistake in 0 to 3 loop
      wait_clocks(2 * tick_cycles);
      heat;
      wait_clocks(tick_cycles);
      if mistake = 0 then
        write(feed, 16#FEEE#);
      elsif mistake = 1 then
        write(feed, heater_control_feed_key_second);
      else
        write(feed, heater_control_feed_key_first);
        read(status);
        one_key_is_no_mistake : assert word(7) = '0' report to_hstring(word) severity error;
        if mistake = 3 then
          write(feed, heater_control_feed_key_second);
        end if;
        write(feed, heater_control_feed_key_first);
      end if;
      expect_trip(8);
      expect_trip(8, 1);
      write(duty, 0);
      clear_trips(channels => 1);
      read(status);
      clears_the_channel_named : assert word(7) = '0' report to_hstring(word) severity error;
      expect_trip(8, 1);
      clear_trips;
    end loop;

    -- One key of the two is not enough.
    write(watchdog, patience);
    wait_clocks(2 * tick_cycles);
    heat;
    wait_clocks(2 * tick_cycles);
    write(feed, heater_control_feed_key_first);
    wait_clocks(patience * tick_cycles);
    expect_trip(8);
    write(duty, 0);
    clear_trips;
    write(feed, heater_control_feed_key_second);
    wait_clocks(2 * tick_cycles);

    -- The sensor falls silent while software is well.
    heat;
    sensors_work <= false;
    for i in 1 to sensor_patience / 2 + 1 loop
      wait_clocks(2 * tick_cycles);
      feed_it;
    end loop;
    expect_trip(10);
    sensors_work <= true;
    wait_clocks(conversion);
    write(duty, 0);
    clear_trips;

    -- Emergency stop reaches every channel, also those at rest.
    heat;
    emergency_stop <= '1';
    wait_clocks(5);
    stops : assert gates = "00" report "heats" severity error;
    emergency_stop <= '0';
    expect_trip(14);
    expect_trip(14, 1);
    write(duty, 0);
    clear_trips;

    -- The supply: closed by its key, at duty 0, without a cause; opened by its key and by every cause.
    is_open_at_first : assert supply = '0' report "closed" severity error;
    wait_clocks(2 * tick_cycles);
    feed_it;
    wait_clocks(3);
    switch_supply(16#C106#);
    wants_its_key : assert supply = '0' report "closed" severity error;
    write(duty, 1, 1);
    switch_supply(heater_control_supply_key_close);
    wants_no_duty : assert supply = '0' report "closed" severity error;
    read(supply_register);
    says_that_it_stays_open : assert unsigned(word) = 2 report to_hstring(word) severity error;
    write(duty, 0, 1);
    clear_trips;
    switch_supply(heater_control_supply_key_close);
    closes : assert supply = '1' report "open" severity error;
    read(supply_register);
    says_that_it_is_closed : assert unsigned(word) = 1 report to_hstring(word) severity error;
    switch_supply(heater_control_supply_key_open);
    opens_when_asked : assert supply = '0' report "closed" severity error;
    wait_clocks(3);
    that_is_no_alarm : assert interrupt = '0' report "interrupt" severity error;
    switch_supply(heater_control_supply_key_close);
    veto <= '1';
    wait_clocks(6);
    switch_supply(heater_control_supply_key_close);
    a_cause_that_lasts_keeps_it_open : assert supply = '0' report "closed" severity error;
    veto <= '0';
    wait_clocks(3);
    expect_opened("1000");
    emergency_stop <= '1';
    wait_clocks(6);
    emergency_stop <= '0';
    wait_clocks(3);
    expect_opened("0100");
    wait_clocks((patience + 1) * tick_cycles);
    expect_opened("0010");
    present_count <= 999;
    wait_clocks(conversion);
    present_count <= 5_000;
    wait_clocks(conversion);
    expect_opened("0001");

    -- A transistor that conducts by itself: an eighth hotter with the gate long closed.
    for i in 1 to settling loop
      wait_clocks(2 * tick_cycles);
      feed_it;
    end loop;
    present_count <= 5_500;
    wait_clocks(2 * conversion);
    feed_it;
    present_count <= 4_813;
    wait_clocks(2 * conversion);
    feed_it;
    bears_a_little : assert supply = '1' report "open" severity error;
    present_count <= 4_812;
    wait_clocks(2 * conversion);
    expect_trip(15);
    present_count <= 5_000;
    expect_opened("0001");

    -- Half duty in slots of 100 clocks: an edge every slot.
    wait_clocks(2 * tick_cycles);
    write(slot, 100);
    heat;
    write(duty, 32_768);
    wait_clocks(400);
    edges_before := gate_0_edges;
    wait_clocks(4_000);
    keeps_levels_for_a_slot : assert abs (gate_0_edges - edges_before - 40) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;

    -- A slot of 0 clocks is one of 1: an edge every clock.
    write(slot, 0);
    feed_it;
    wait_clocks(200);
    edges_before := gate_0_edges;
    wait_clocks(1_000);
    a_slot_of_0_is_a_clock : assert abs (gate_0_edges - edges_before - 1_000) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;
    write(duty, 0);
    write(slot, 100);
    wait_clocks(200);
    edges_before := clocks_at_rest;
    wait_clocks(2_000);
    rests_most_of_the_time : assert clocks_at_rest - edges_before > 1_500
      report to_string(clocks_at_rest - edges_before) & " clocks at rest" severity error;

    reset <= '1';
    wait_clocks(3);
    is_off_in_reset : assert gates = "00" report "heats" severity error;
    reset <= '0';
    wait_clocks(3);
    read(minimum_count);
    reset_unlocks : assert unsigned(word) = x"FFFF_FFFF" report to_hstring(word) severity error;
    std.env.finish;
  end process;

end architecture;
