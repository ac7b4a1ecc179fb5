-- SPDX-License-Identifier: Apache-2.0
-- Every limit, status bit and trip of each channel leads to its own place, ticks are 1024 clocks,
-- and a second heater control with gated clocks does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
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

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : heater_inputs_t := (others => '0');
  signal outputs : heater_outputs_t;
  signal at_rest : std_ulogic;
  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal counts : counts_t := (5_000, 5_000);
  signal sensor_works, sensor_is_valid : std_ulogic_vector(0 to 1) := "11";

  signal clocks_left_out : natural;
  signal clocks_run, gate_0_closed_at : natural := 0;

  alias clk is master.clk;

begin

  twins : entity work.heater_control_twins
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, readings => readings, inputs => inputs,
      outputs => outputs, at_rest => at_rest, clocks_left_out => clocks_left_out);

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
    if before = '1' and outputs.gates(0) = '0' then
      gate_0_closed_at <= clocks_run;
    end if;
    before := outputs.gates(0);
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

    procedure lock(limit : natural; channel : natural) is
    begin
      write(master, limits(limit), values(limit) + channel, channel);
    end procedure;

    procedure start_over is
    begin
      reset <= '1';
      wait_clocks(clk, 3);
      reset <= '0';
      wait_clocks(clk, 4);
      write(master, heater_control_watchdog_address, watchdog_ticks);
      write(master, heater_control_sensor_timeout_address, sensor_ticks);
      write(master, heater_control_slot_address, 100);
      wait_clocks(clk, conversion);
      feed_watchdog(master);
      wait_clocks(clk, 4);
    end procedure;

    -- Heats with one channel, and this cause closes its gate; the other one knows nothing of it.
    procedure heat(channel : natural) is
    begin
      wait_clocks(clk, 2 * conversion);
      clear_trips(master);
      feed_watchdog(master);
      wait_clocks(clk, 4);
      write(master, heater_control_duty_address, 65_535, channel);
      wait_clocks(clk, 110);
      expect(master, heater_control_status_address, ready + gate_open, channel);
      assert outputs.gates(channel) = '1' and outputs.gates(1 - channel) = '0'
        report "gates " & to_string(outputs.gates) severity failure;
      expect(master, heater_control_status_address, ready, 1 - channel);
    end procedure;

    procedure expect_trip(bit_number : natural; channel : natural) is
    begin
      assert outputs.gates = "00" and outputs.interrupt = '1' severity failure;
      read(master, heater_control_status_address + 4 * channel, word);
      assert unsigned(word(trip_bits)) = 2 ** (bit_number - trip_bits'low)
        and word(heater_control_status_tripped_bit) = '1'
        report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity failure;
      read(master, heater_control_status_address + 4 * (1 - channel), word);
      assert unsigned(word(trip_bits)) = 0 and word(heater_control_status_tripped_bit) = '0'
        report "the other channel: " & to_hstring(word) severity failure;
      write(master, heater_control_duty_address, 0, channel);
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
        write(master, heater_control_duty_address, 65_535, channel);
        wait_clocks(clk, 110);
        if missing < 4 then
          expect_trip(heater_control_status_limits_missing_trip_bit, channel);
        else
          assert outputs.gates = std_ulogic_vector(to_unsigned(channel + 1, 2)) severity failure;
        end if;
      end loop;
    end loop;
    expect(master, heater_control_minimum_count_address, 1_000);
    expect(master, heater_control_minimum_count_address, 1_001, 1);
    expect(master, heater_control_maximum_count_address, 9_000);
    expect(master, heater_control_maximum_count_address, 9_001, 1);
    expect(master, heater_control_hot_count_address, 4_000);
    expect(master, heater_control_hot_count_address, 4_001, 1);
    expect(master, heater_control_settle_address, 200);
    expect(master, heater_control_settle_address, 201, 1);
    expect(master, heater_control_watchdog_address, watchdog_ticks);
    expect(master, heater_control_sensor_timeout_address, sensor_ticks);
    -- A channel that is not there has no limits, and nothing to say.
    for channel in 2 to 3 loop
      expect(master, heater_control_minimum_count_address + 4 * channel, x"FFFFFFFF");
      expect(master, heater_control_maximum_count_address, 0, channel);
      expect(master, heater_control_hot_count_address, 0, channel);
      expect(master, heater_control_settle_address, 16#FFFFFF#, channel);
      expect(master, heater_control_status_address, 0, channel);
    end loop;

    for channel in 0 to 1 loop
      -- Each cause has its own bit, and is the one of the channel's own sensor.
      write(master, heater_control_duty_address, 0, 1 - channel);
      write(master, heater_control_duty_address, 0, channel);
      heat(channel);
      counts(channel) <= 999;
      wait_clocks(clk, conversion + 10);
      expect_trip(heater_control_status_too_hot_trip_bit, channel);
      counts(channel) <= 5_000;
      heat(channel);
      counts(channel) <= 9_002;
      wait_clocks(clk, conversion + 10);
      expect_trip(heater_control_status_too_cold_trip_bit, channel);
      counts(channel) <= 5_000;
      heat(channel);
      sensor_is_valid(channel) <= '0';
      wait_clocks(clk, conversion + 10);
      assert outputs.gates = "00" severity failure;
      feed_watchdog(master);
      wait_clocks(clk, 3 * tick_cycles);
      expect_trip(heater_control_status_sensor_invalid_trip_bit, channel);
      sensor_is_valid(channel) <= '1';
      heat(channel);
      sensor_works(channel) <= '0';
      wait_clocks(clk, 3 * tick_cycles);
      expect_trip(heater_control_status_sensor_stale_trip_bit, channel);
      sensor_works(channel) <= '1';
      -- At rest only what is too hot.
      wait_clocks(clk, 2 * conversion);
      clear_trips(master);
      feed_watchdog(master);
      counts(channel) <= 9_002;
      wait_clocks(clk, 2 * conversion);
      assert outputs.interrupt = '0' report "trips at rest" severity failure;
      counts(channel) <= 999;
      wait_clocks(clk, 2 * conversion);
      expect_trip(heater_control_status_too_hot_trip_bit, channel);
      counts(channel) <= 5_000;
      -- Its watchdog, and a tick of so many clocks: two gates are closed so many ticks apart.
      heat(channel);
      wait_clocks(clk, watchdog_ticks * tick_cycles);
      expect_trip(heater_control_status_watchdog_trip_bit, channel);
      if channel = 0 then
        closed_before := gate_0_closed_at;
        heat(0);
        wait_clocks(clk, watchdog_ticks * tick_cycles);
        expect_trip(heater_control_status_watchdog_trip_bit, 0);
        assert (gate_0_closed_at - closed_before) mod tick_cycles = 0 and gate_0_closed_at /= closed_before
          report to_string(gate_0_closed_at - closed_before) & " clocks between two ticks" severity failure;
      end if;
    end loop;

    -- A pin changes at rest.
    clear_trips(master);
    feed_watchdog(master);
    wait_clocks(clk, 3);
    switch_supply(master, heater_control_supply_key_close);
    wait until rising_edge(clk) and at_rest = '1';
    assert outputs.supply = '1' report "the supply is open" severity failure;
    -- A key that is none of the two does nothing.
    write(master, heater_control_supply_address, 0);
    switch_supply(master, 16#FFFF#);
    wait until rising_edge(clk) and at_rest = '1';
    assert outputs.supply = '1' report "opened by a wrong key" severity failure;
    inputs.veto <= '1';
    wait_clocks(clk, 8);
    assert outputs.supply = '0' and outputs.interrupt = '1' report "no veto at rest" severity failure;
    inputs.veto <= '0';
    wait_clocks(clk, 8);
    switch_supply(master, heater_control_supply_key_close);
    wait until rising_edge(clk) and at_rest = '1';
    assert outputs.supply = '1' and outputs.interrupt = '0' report "the supply is open" severity failure;
    inputs.emergency_stop <= '1';
    wait_clocks(clk, 8);
    assert outputs.supply = '0' and outputs.interrupt = '1' report "no emergency stop at rest"
      severity failure;
    inputs.emergency_stop <= '0';
    for channel in 0 to 1 loop
      read(master, heater_control_status_address + 4 * channel, word);
      assert to_heater_control_status(word) = (
        tripped | emergency_stop_trip | minimum_locked | maximum_locked | hot_locked | settle_locked => '1',
        others => '0') report "status " & to_hstring(word) severity failure;
    end loop;
    assert clocks_left_out > 1_000 report to_string(clocks_left_out) & " clocks left out" severity failure;
    std.env.finish;
  end process;

end architecture;
