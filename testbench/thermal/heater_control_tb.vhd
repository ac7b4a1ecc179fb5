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
  constant ticks_per_s : positive := clock_frequency_hz / tick_cycles;

  constant feed : unsigned(31 downto 0) := heater_control_address;
  constant watchdog : unsigned(31 downto 0) := heater_control_address + 4;
  constant sensor_timeout : unsigned(31 downto 0) := heater_control_address + 8;
  constant slot : unsigned(31 downto 0) := heater_control_address + 12;
  constant clear : unsigned(31 downto 0) := heater_control_address + 16;
  constant duty : unsigned(31 downto 0) := heater_control_address + 20;
  constant minimum_count : unsigned(31 downto 0) := heater_control_address + 36;
  constant maximum_count : unsigned(31 downto 0) := heater_control_address + 52;
  constant status : unsigned(31 downto 0) := heater_control_address + 68;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal emergency_stop : std_ulogic := '0';
  signal gates : std_ulogic_vector(1 downto 0);
  signal interrupt : std_ulogic;
  signal sensors_work : boolean := true;
  signal gate_0_edges : natural := 0;

begin

  clk <= not clk after 125 ns;

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => response, readings => readings,
      emergency_stop => emergency_stop, gates => gates, interrupt => interrupt);

  convert : process
  begin
    for i in 1 to 1_000 loop
      wait until rising_edge(clk);
    end loop;
    if sensors_work then
      for channel in readings'range loop
        readings(channel) <= (updated => '1', valid => '1', count => to_unsigned(5_000, 32));
      end loop;
    end if;
    wait until rising_edge(clk);
    for channel in readings'range loop
      readings(channel).updated <= '0';
    end loop;
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
      write(feed, heater_control_feed_key_alive);
    end procedure;

    procedure expect_trip (bit_number : natural; channel : natural := 0) is
    begin
      read(status, channel);
      trips : assert word(bit_number) = '1' and word(7) = '1' and word(0) = '0'
        report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity error;
      wait_clocks(2);
      tells_the_processor : assert interrupt = '1' report "no interrupt" severity error;
    end procedure;

    procedure clear_trips (key : natural := heater_control_clear_key_clear_trips) is
    begin
      bus_write(clk, request, response, clear,
        word_t(shift_left(to_unsigned(key, 32), 16) or to_unsigned(3, 32)));
      wait_clocks(3);
    end procedure;

    procedure heat is
    begin
      feed_it;
      wait_clocks(1_200);
      write(duty, 65_535);
      wait_clocks(220);
      heats : assert gates = "01" report "gates " & to_string(gates) severity error;
    end procedure;
  begin
    wait_clocks(3);
    reset <= '0';
    wait_clocks(10);
    read(watchdog);
    watches_for_a_second_at_first : assert abs (to_integer(unsigned(word)) - ticks_per_s) < 40
      report to_hstring(word) severity error;
    write(watchdog, 2 ** 20 - 1);
    read(watchdog);
    has_a_built_in_maximum : assert abs (to_integer(unsigned(word)) - 3 * ticks_per_s) < 120
      report to_hstring(word) severity error;
    write(sensor_timeout, 2 ** 20 - 1);
    read(sensor_timeout);
    has_one_for_sensors_too : assert abs (to_integer(unsigned(word)) - 3 * ticks_per_s) < 120
      report to_hstring(word) severity error;
    write(watchdog, 20);
    write(sensor_timeout, 30);
    write(slot, 1);

    -- No heat without limits.
    feed_it;
    wait_clocks(1_200);
    write(duty, 65_535);
    wait_clocks(20);
    heats_not_without_limits : assert gates = "00" report "heats" severity error;
    expect_trip(13);

    -- Limits lock with the first write, each for itself.
    write(minimum_count, 1_000);
    write(maximum_count, 9_000);
    write(minimum_count, 0);
    write(maximum_count, 2_000_000_000);
    read(minimum_count);
    minimum_is_locked : assert unsigned(word) = 1_000 report to_hstring(word) severity error;
    read(maximum_count);
    maximum_is_locked : assert unsigned(word) = 9_000 report to_hstring(word) severity error;
    read(status, 1);
    locks_each_channel_alone : assert word(3 downto 2) = "00" report to_hstring(word) severity error;

    -- Clearing takes the key and no duty.
    clear_trips;
    expect_trip(13);
    write(duty, 0);
    clear_trips(16#C1EB#);
    expect_trip(13);
    clear_trips;
    is_cleared : assert interrupt = '0' report "still tripped" severity error;

    -- The processor hangs: the gate closes after 20 ticks, less the part of the first one.
    heat;
    write(feed, 16#BEEF#);
    feed_it;
    clocks := 0;
    while gates(0) loop
      wait_clocks(1);
      clocks := clocks + 1;
    end loop;
    closes_in_time : assert clocks > 19 * tick_cycles and clocks < 20 * tick_cycles + 10
      report to_string(clocks) & " clocks" severity error;
    expect_trip(8);
    feed_it;
    wait_clocks(100);
    feeding_is_not_clearing : assert gates = "00" report "heats again" severity error;
    write(duty, 0);
    clear_trips;

    -- A wrong key does not feed.
    heat;
    for i in 1 to 30 loop
      wait_clocks(tick_cycles);
      write(feed, 16#FEEE#);
    end loop;
    expect_trip(8);
    write(duty, 0);
    clear_trips;

    -- The sensor falls silent while software is well.
    heat;
    sensors_work <= false;
    for i in 1 to 32 loop
      wait_clocks(tick_cycles);
      feed_it;
    end loop;
    expect_trip(10);
    sensors_work <= true;
    wait_clocks(1_200);
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

    -- Half duty in slots of 100 clocks: an edge every slot.
    write(slot, 100);
    heat;
    write(duty, 32_768);
    wait_clocks(400);
    edges_before := gate_0_edges;
    wait_clocks(10_000);
    keeps_levels_for_a_slot : assert abs (gate_0_edges - edges_before - 100) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;

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
