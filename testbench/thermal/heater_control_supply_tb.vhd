-- SPDX-License-Identifier: Apache-2.0
-- The supply of all heaters: closed by its key where no cause lasts, opened by every cause; unasked heat;
-- slots; rest.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_supply_tb is
end entity;

architecture simulation of heater_control_supply_tb is

  constant clock_frequency_hz : positive := 4_000_000;
  constant charges : positive := 16;
  -- Times in ticks, and the clocks of a conversion with some to spare: short ones, for a short run.
  constant patience : positive := 6;
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
    variable edges_before : natural;

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

    procedure switch (key : natural) is
    begin
      switch_supply(clk, request, response, key);
    end procedure;

    -- Causes as in opener_bits.
    procedure expect_opened (causes : std_ulogic_vector(3 downto 0)) is
    begin
      clocks_pass(3);
      supply_is_open : assert supply = '0' report "the supply is closed" severity error;
      read(heater_control_supply_address);
      supply_says_why : assert word(opener_bits) = causes and word(heater_control_supply_closed_bit) = '0'
        report to_hstring(word) & " instead of " & to_string(causes) severity error;
      clocks_pass(2);
      supply_interrupts : assert interrupt = '1' report "no interrupt" severity error;
      write(heater_control_duty_address, 0);
      clear;
      clocks_pass(3 * tick_cycles);
      feed_it;
      clocks_pass(3);
      stays_open : assert supply = '0' report "closed by itself" severity error;
      switch(heater_control_supply_key_close);
      closes_again : assert supply = '1' report "does not close" severity error;
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
    write(heater_control_watchdog_address, patience);
    write(heater_control_slot_address, 1);
    write(heater_control_minimum_count_address, 1_000);
    write(heater_control_maximum_count_address, 9_000);
    write(heater_control_hot_count_address, 6_000);
    write(heater_control_settle_address, settling);
    write(heater_control_minimum_count_address, 1_000, 1);
    write(heater_control_maximum_count_address, 9_000, 1);
    write(heater_control_hot_count_address, 6_000, 1);
    write(heater_control_settle_address, settling, 1);
    feed_it;
    clocks_pass(conversion);
    clear;

    -- The supply: closed by its key, at duty 0, without a cause; opened by its key and by every cause.
    is_open_at_first : assert supply = '0' report "closed" severity error;
    clocks_pass(2 * tick_cycles);
    feed_it;
    clocks_pass(3);
    switch(heater_control_supply_key_close + 1);
    wants_its_key : assert supply = '0' report "closed" severity error;
    write(heater_control_duty_address, 1, 1);
    switch(heater_control_supply_key_close);
    wants_no_duty : assert supply = '0' report "closed" severity error;
    read(heater_control_supply_address);
    says_that_it_stays_open : assert unsigned(word) = 2 ** heater_control_supply_refused_bit
      report to_hstring(word) severity error;
    write(heater_control_duty_address, 0, 1);
    clear;
    switch(heater_control_supply_key_close);
    closes : assert supply = '1' report "open" severity error;
    read(heater_control_supply_address);
    says_that_it_is_closed : assert unsigned(word) = 2 ** heater_control_supply_closed_bit
      report to_hstring(word) severity error;
    switch(heater_control_supply_key_open);
    opens_when_asked : assert supply = '0' report "closed" severity error;
    clocks_pass(3);
    that_is_no_alarm : assert interrupt = '0' report "interrupt" severity error;
    switch(heater_control_supply_key_close);
    veto <= '1';
    clocks_pass(6);
    switch(heater_control_supply_key_close);
    a_cause_that_lasts_keeps_it_open : assert supply = '0' report "closed" severity error;
    veto <= '0';
    clocks_pass(3);
    expect_opened("1000");
    emergency_stop <= '1';
    clocks_pass(6);
    emergency_stop <= '0';
    clocks_pass(3);
    expect_opened("0100");
    clocks_pass((patience + 1) * tick_cycles);
    expect_opened("0010");
    present_count <= 999;
    clocks_pass(conversion);
    present_count <= 5_000;
    clocks_pass(conversion);
    expect_opened("0001");

    -- A transistor that conducts by itself: an eighth hotter with the gate long closed.
    for i in 1 to settling loop
      clocks_pass(2 * tick_cycles);
      feed_it;
    end loop;
    present_count <= 5_500;
    clocks_pass(2 * conversion);
    feed_it;
    present_count <= 4_813;
    clocks_pass(2 * conversion);
    feed_it;
    bears_a_little : assert supply = '1' report "open" severity error;
    present_count <= 4_812;
    clocks_pass(2 * conversion);
    expect_trip(heater_control_status_heats_unasked_trip_bit);
    present_count <= 5_000;
    expect_opened("0001");

    -- Half duty in slots of 100 clocks: an edge every slot.
    clocks_pass(2 * tick_cycles);
    write(heater_control_slot_address, 100);
    heat;
    write(heater_control_duty_address, 32_768);
    clocks_pass(400);
    edges_before := gate_0_edges;
    clocks_pass(4_000);
    keeps_levels_for_a_slot : assert abs (gate_0_edges - edges_before - 40) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;

    -- A slot of 0 clocks is one of 1: an edge every clock.
    write(heater_control_slot_address, 0);
    feed_it;
    clocks_pass(200);
    edges_before := gate_0_edges;
    clocks_pass(1_000);
    a_slot_of_0_is_a_clock : assert abs (gate_0_edges - edges_before - 1_000) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;
    write(heater_control_duty_address, 0);
    write(heater_control_slot_address, 100);
    clocks_pass(200);
    edges_before := clocks_at_rest;
    clocks_pass(2_000);
    rests_most_of_the_time : assert clocks_at_rest - edges_before > 1_500
      report to_string(clocks_at_rest - edges_before) & " clocks at rest" severity error;

    std.env.finish;
  end process;

end architecture;
