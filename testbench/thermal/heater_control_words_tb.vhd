-- SPDX-License-Identifier: Apache-2.0
-- Every limit, status bit and trip of each channel leads to its own place, ticks are 1024 clocks, and a
-- second heater control, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_words_tb is
end entity;

architecture simulation of heater_control_words_tb is

  constant conversion : positive := 300;
  constant watchdog_ticks : positive := 5;
  constant sensor_ticks : positive := 2;

  type counts_t is array (0 to 1) of natural;

  signal clk : std_ulogic;
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal gates : std_ulogic_vector(1 downto 0);
  signal supply, interrupt, at_rest : std_ulogic;
  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal emergency_stop, veto : std_ulogic := '0';
  signal counts : counts_t := (5_000, 5_000);
  signal sensor_works, sensor_is_valid : std_ulogic_vector(0 to 1) := "11";

  signal clocks_left_out : natural;
  signal clocks_run, gate_0_closed_at : natural := 0;

begin

  twins : entity work.heater_control_twins
    port map (
      clk => clk, reset => reset, request => request, response => response, readings => readings,
      emergency_stop => emergency_stop, veto => veto, gates => gates, supply => supply,
      interrupt => interrupt, at_rest => at_rest, clocks_left_out => clocks_left_out);

  -- Channel 1 half a conversion after channel 0.
  convert : process
  begin
    for channel in 0 to 1 loop
      for i in 1 to conversion / 2 loop
        wait until rising_edge(clk);
      end loop;
      if sensor_works(channel) then
        readings(channel) <= (
          updated => '1', valid => sensor_is_valid(channel), count => to_unsigned(counts(channel), 32));
        wait until rising_edge(clk);
        readings(channel).updated <= '0';
      end if;
    end loop;
  end process;

  watch_gate : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    clocks_run <= clocks_run + 1;
    if before = '1' and gates(0) = '0' then
      gate_0_closed_at <= clocks_run;
    end if;
    before := gates(0);
  end process;

  test : process
    subtype address_t is unsigned(31 downto 0);
    type limits_t is array (0 to 3) of address_t;
    constant limits : limits_t := (
      heater_control_minimum_count_address, heater_control_maximum_count_address,
      heater_control_hot_count_address, heater_control_settle_address);
    -- Values of the first channel's; the second has one more.
    type values_t is array (0 to 3) of natural;
    constant values : values_t := (1_000, 9_000, 4_000, 200);
    -- All limits are locked, and the channel may heat.
    constant ready : natural := 2 ** heater_control_status_permitted_bit
      + 2 ** heater_control_status_minimum_locked_bit + 2 ** heater_control_status_maximum_locked_bit
      + 2 ** heater_control_status_hot_locked_bit + 2 ** heater_control_status_settle_locked_bit;
    constant gate_open : natural := 2 ** heater_control_status_gate_bit;
    variable word : word_t;
    variable closed_before : natural;

    procedure write(address : address_t; value : natural; channel : natural := 0) is
    begin
      bus_write(clk, request, response, address + 4 * channel, value);
    end procedure;

    procedure expect(address : address_t; value : word_t; channel : natural := 0) is
    begin
      bus_expect(clk, request, response, address + 4 * channel, value);
    end procedure;

    procedure expect(address : address_t; value : natural; channel : natural := 0) is
    begin
      expect(address, word_t(to_unsigned(value, 32)), channel);
    end procedure;

    procedure clocks(count : natural) is
    begin
      wait_clocks(clk, count);
    end procedure;

    procedure feed_it is
    begin
      feed_watchdog(clk, request, response);
    end procedure;

    procedure clear is
    begin
      clear_trips(clk, request, response);
    end procedure;

    procedure lock(limit : natural; channel : natural) is
    begin
      write(limits(limit), values(limit) + channel, channel);
    end procedure;

    procedure start_over is
    begin
      reset <= '1';
      clocks(3);
      reset <= '0';
      clocks(4);
      write(heater_control_watchdog_address, watchdog_ticks);
      write(heater_control_sensor_timeout_address, sensor_ticks);
      write(heater_control_slot_address, 100);
      clocks(conversion);
      feed_it;
      clocks(4);
    end procedure;

    -- Heats with one channel, and this cause closes its gate; the other one knows nothing of it.
    procedure heat(channel : natural) is
    begin
      clocks(2 * conversion);
      clear;
      feed_it;
      clocks(4);
      write(heater_control_duty_address, 65_535, channel);
      clocks(110);
      expect(heater_control_status_address, ready + gate_open, channel);
      assert gates(channel) = '1' and gates(1 - channel) = '0'
        report "gates " & to_string(gates) severity failure;
      expect(heater_control_status_address, ready, 1 - channel);
    end procedure;

    procedure expect_trip(bit_number : natural; channel : natural) is
    begin
      assert gates = "00" and interrupt = '1' severity failure;
      bus_read(clk, request, response, heater_control_status_address + 4 * channel, word);
      assert unsigned(word(trip_bits)) = 2 ** (bit_number - trip_bits'low)
        and word(heater_control_status_tripped_bit) = '1'
        report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity failure;
      bus_read(clk, request, response, heater_control_status_address + 4 * (1 - channel), word);
      assert unsigned(word(trip_bits)) = 0 and word(heater_control_status_tripped_bit) = '0'
        report "the other channel: " & to_hstring(word) severity failure;
      write(heater_control_duty_address, 0, channel);
    end procedure;
  begin
    -- A channel heats with all of its four limits, and with no three of them, whatever the other has.
    for channel in 0 to 1 loop
      for missing in 0 to 4 loop
        start_over;
        for limit in 0 to 3 loop
          lock(limit, 1 - channel);
          if limit /= missing then
            lock(limit, channel);
          end if;
        end loop;
        write(heater_control_duty_address, 65_535, channel);
        clocks(110);
        if missing < 4 then
          expect_trip(heater_control_status_limits_missing_trip_bit, channel);
        else
          assert gates = std_ulogic_vector(to_unsigned(channel + 1, 2)) severity failure;
        end if;
      end loop;
    end loop;
    expect(heater_control_minimum_count_address, 1_000);
    expect(heater_control_minimum_count_address, 1_001, 1);
    expect(heater_control_maximum_count_address, 9_000);
    expect(heater_control_maximum_count_address, 9_001, 1);
    expect(heater_control_hot_count_address, 4_000);
    expect(heater_control_hot_count_address, 4_001, 1);
    expect(heater_control_settle_address, 200);
    expect(heater_control_settle_address, 201, 1);
    expect(heater_control_watchdog_address, watchdog_ticks);
    expect(heater_control_sensor_timeout_address, sensor_ticks);
    -- A channel that is not there has no limits, and nothing to say.
    for channel in 2 to 3 loop
      expect(heater_control_minimum_count_address, x"FFFFFFFF", channel);
      expect(heater_control_maximum_count_address, 0, channel);
      expect(heater_control_hot_count_address, 0, channel);
      expect(heater_control_settle_address, 16#FFFFFF#, channel);
      expect(heater_control_status_address, 0, channel);
    end loop;

    for channel in 0 to 1 loop
      -- Each cause has its own bit, and is the one of the channel's own sensor.
      write(heater_control_duty_address, 0, 1 - channel);
      write(heater_control_duty_address, 0, channel);
      heat(channel);
      counts(channel) <= 999;
      clocks(conversion + 10);
      expect_trip(heater_control_status_too_hot_trip_bit, channel);
      counts(channel) <= 5_000;
      heat(channel);
      counts(channel) <= 9_002;
      clocks(conversion + 10);
      expect_trip(heater_control_status_too_cold_trip_bit, channel);
      counts(channel) <= 5_000;
      heat(channel);
      sensor_is_valid(channel) <= '0';
      clocks(conversion + 10);
      assert gates = "00" severity failure;
      feed_it;
      clocks(3 * tick_cycles);
      expect_trip(heater_control_status_sensor_invalid_trip_bit, channel);
      sensor_is_valid(channel) <= '1';
      heat(channel);
      sensor_works(channel) <= '0';
      clocks(3 * tick_cycles);
      expect_trip(heater_control_status_sensor_stale_trip_bit, channel);
      sensor_works(channel) <= '1';
      -- At rest only what is too hot.
      clocks(2 * conversion);
      clear;
      feed_it;
      counts(channel) <= 9_002;
      clocks(2 * conversion);
      assert interrupt = '0' report "trips at rest" severity failure;
      counts(channel) <= 999;
      clocks(2 * conversion);
      expect_trip(heater_control_status_too_hot_trip_bit, channel);
      counts(channel) <= 5_000;
      -- Its watchdog, and a tick of so many clocks: two gates are closed so many ticks apart.
      heat(channel);
      clocks(watchdog_ticks * tick_cycles);
      expect_trip(heater_control_status_watchdog_trip_bit, channel);
      if channel = 0 then
        closed_before := gate_0_closed_at;
        heat(0);
        clocks(watchdog_ticks * tick_cycles);
        expect_trip(heater_control_status_watchdog_trip_bit, 0);
        assert (gate_0_closed_at - closed_before) mod tick_cycles = 0 and gate_0_closed_at /= closed_before
          report to_string(gate_0_closed_at - closed_before) & " clocks between two ticks" severity failure;
      end if;
    end loop;

    -- A pin changes at rest.
    clear;
    feed_it;
    clocks(3);
    switch_supply(clk, request, response, heater_control_supply_key_close);
    wait until rising_edge(clk) and at_rest = '1';
    assert supply = '1' report "the supply is open" severity failure;
    -- A key that is none of the two does nothing.
    write(heater_control_supply_address, 0);
    switch_supply(clk, request, response, 16#FFFF#);
    wait until rising_edge(clk) and at_rest = '1';
    assert supply = '1' report "opened by a wrong key" severity failure;
    veto <= '1';
    clocks(8);
    assert supply = '0' and interrupt = '1' report "no veto at rest" severity failure;
    veto <= '0';
    clocks(8);
    switch_supply(clk, request, response, heater_control_supply_key_close);
    wait until rising_edge(clk) and at_rest = '1';
    assert supply = '1' and interrupt = '0' report "the supply is open" severity failure;
    emergency_stop <= '1';
    clocks(8);
    assert supply = '0' and interrupt = '1' report "no emergency stop at rest" severity failure;
    emergency_stop <= '0';
    for channel in 0 to 1 loop
      bus_read(clk, request, response, heater_control_status_address + 4 * channel, word);
      assert to_heater_control_status(word) = (
        tripped | emergency_stop_trip | minimum_locked | maximum_locked | hot_locked | settle_locked => '1',
        others => '0') report "status " & to_hstring(word) severity failure;
    end loop;
    assert clocks_left_out > 1_000 report to_string(clocks_left_out) & " clocks left out" severity failure;
    finish;
  end process;

end architecture;
