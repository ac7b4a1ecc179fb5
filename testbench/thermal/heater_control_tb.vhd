-- SPDX-License-Identifier: Apache-2.0
-- A hung processor, a second write to a limit, a wrong key: nothing that software does or omits heats.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_tb is
end entity;

architecture simulation of heater_control_tb is

  constant ticks_per_s : positive := clock_frequency_hz / tick_cycles;
  -- 4 * 2^-20 s at 4 MHz, and a sixteenth of a second.
  constant floor : positive := 15 * charges;
  constant ceiling : positive := 250_000 * charges;
  -- In ticks.
  constant sensor_patience : positive := 9;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : heater_inputs_t := (others => '0');
  signal outputs : heater_outputs_t;
  signal sensors_work : boolean := true;
  signal present_count : natural := 5_000;
  signal gate_0_edges, clocks_at_rest : natural;

  alias clk is master.clk;

begin

  rig : entity work.heater_control_rig
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      sensors_work => sensors_work, present_count => present_count,
      gate_0_edges => gate_0_edges, clocks_at_rest => clocks_at_rest);

  check : process

    variable word : word_t;
    variable clocks : natural;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 10);
    read(master, heater_control_watchdog_address, word);
    watches_for_a_second_at_first : assert unsigned(word) = ticks_per_s
      report to_hstring(word) severity error;
    write(master, heater_control_watchdog_address, 2 ** 20 - 1);
    read(master, heater_control_watchdog_address, word);
    has_a_built_in_maximum : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(master, heater_control_sensor_timeout_address, 2 ** 20 - 1);
    read(master, heater_control_sensor_timeout_address, word);
    has_one_for_sensors_too : assert unsigned(word) = 3 * ticks_per_s
      report to_hstring(word) severity error;
    write(master, heater_control_watchdog_address, patience);
    write(master, heater_control_sensor_timeout_address, sensor_patience);
    write(master, heater_control_slot_address, 1);

    -- No heat without limits.
    feed_watchdog(master);
    wait_clocks(clk, conversion);
    write(master, heater_control_duty_address, 65_535);
    wait_clocks(clk, 20);
    heats_not_without_limits : assert outputs.gates = "00" report "heats" severity error;
    expect_trip(master, outputs.interrupt, heater_control_status_limits_missing_trip_bit);

    -- Out of its bounds nothing locks.
    nothing_is_locked : assert outputs.limits_locked = '0' report "locked" severity error;
    write(master, heater_control_minimum_count_address, floor - 1);
    read(master, heater_control_status_address, word);
    refuses_what_is_hotter_than_any_machine : assert word(lock_bits) = "10000"
      report to_hstring(word) severity error;
    clear_trips(master);
    write(master, heater_control_maximum_count_address, ceiling + 1);
    read(master, heater_control_status_address, word);
    refuses_what_is_no_sensor : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear_trips(master);
    write(master, heater_control_hot_count_address, 8 * floor - 1);
    read(master, heater_control_status_address, word);
    refuses_to_be_blind : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear_trips(master);
    write(master, heater_control_settle_address, 120 * ticks_per_s + 1);
    read(master, heater_control_status_address, word);
    refuses_to_sleep : assert word(lock_bits) = "10000" report to_hstring(word) severity error;
    clear_trips(master, "0010");
    read(master, heater_control_status_address, word);
    forgets_only_what_is_named : assert word(heater_control_status_refused_bit) = '1'
      report to_hstring(word) severity error;
    clear_trips(master, "0001");
    read(master, heater_control_status_address, word);
    forgets_what_is_named : assert word(heater_control_status_refused_bit) = '0'
      report to_hstring(word) severity error;
    write(master, heater_control_minimum_count_address, floor, 1);
    write(master, heater_control_maximum_count_address, ceiling, 1);
    write(master, heater_control_hot_count_address, 8 * floor, 1);
    write(master, heater_control_settle_address, 120 * ticks_per_s, 1);
    read(master, heater_control_status_address + 4 * 1, word);
    takes_the_bounds_themselves : assert word(lock_bits) = "01111" report to_hstring(word) severity error;
    locks_the_converter : assert outputs.limits_locked = '1' report "not locked" severity error;
    read(master, heater_control_status_address, word);
    locks_each_channel_alone : assert word(lock_bits) = "00000" report to_hstring(word) severity error;

    -- Limits lock with the first write, each for itself.
    write(master, heater_control_minimum_count_address, 1_000);
    write(master, heater_control_maximum_count_address, 9_000);
    write(master, heater_control_hot_count_address, 6_000);
    write(master, heater_control_settle_address, settling);
    write(master, heater_control_minimum_count_address, 0);
    write(master, heater_control_maximum_count_address, 2_000_000_000);
    read(master, heater_control_minimum_count_address, word);
    minimum_is_locked : assert unsigned(word) = 1_000 report to_hstring(word) severity error;
    read(master, heater_control_maximum_count_address, word);
    maximum_is_locked : assert unsigned(word) = 9_000 report to_hstring(word) severity error;
    read(master, heater_control_status_address, word);
    says_that_it_refused : assert word(heater_control_status_refused_bit) = '1'
      report to_hstring(word) severity error;

    -- Clearing takes the key and no duty.
    clear_trips(master);
    expect_trip(master, outputs.interrupt, heater_control_status_limits_missing_trip_bit);
    write(master, heater_control_duty_address, 0);
    clear_trips(master, "0011", heater_control_clear_key_clear_trips + 1);
    expect_trip(master, outputs.interrupt, heater_control_status_limits_missing_trip_bit);
    clear_trips(master, "0011", heater_control_clear_key_clear_trips - 1);
    expect_trip(master, outputs.interrupt, heater_control_status_limits_missing_trip_bit);
    clear_trips(master);
    is_cleared : assert outputs.interrupt = '0' report "still tripped" severity error;

    -- The processor hangs: the gate closes after the time-out, less the part of the first tick.
    heat(master, outputs.gates);
    feed_watchdog(master);
    clocks := 0;
    while outputs.gates(0) loop
      wait_clocks(clk, 1);
      clocks := clocks + 1;
    end loop;
    closes_in_time : assert clocks > (patience - 1) * tick_cycles and clocks < patience * tick_cycles + 10
      report to_string(clocks) & " clocks" severity error;
    expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit);
    feed_watchdog(master);
    wait_clocks(clk, 100);
    feeding_is_not_clearing : assert outputs.gates = "00" report "heats again" severity error;
    write(master, heater_control_duty_address, 0);
    clear_trips(master);

    -- Whatever is not the key that is due, in its time, trips all channels, also those at rest.
    -- The window is a sixteenth of the time-out.
    write(master, heater_control_watchdog_address, 16);
    for mistake in 0 to 5 loop
      wait_clocks(clk, 2 * tick_cycles);
      heat(master, outputs.gates);
      wait_clocks(clk, tick_cycles);
      if mistake = 0 then
        write(master, heater_control_feed_address, heater_control_feed_key_first + 1);
      elsif mistake = 1 then
        write(master, heater_control_feed_address, heater_control_feed_key_second);
      else
        write(master, heater_control_feed_address, heater_control_feed_key_first);
        read(master, heater_control_status_address, word);
        one_key_is_no_mistake : assert word(heater_control_status_tripped_bit) = '0'
          report to_hstring(word) severity error;
        case mistake is
          when 2 => write(master, heater_control_feed_address, heater_control_feed_key_first);
          when 3 =>
            write(master, heater_control_feed_address, heater_control_feed_key_second);
            write(master, heater_control_feed_address, heater_control_feed_key_first);
          when 4 => write(master, heater_control_feed_address, heater_control_feed_key_second - 1);
          when others => write(master, heater_control_feed_address, heater_control_feed_key_second + 1);
        end case;
      end if;
      expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit);
      expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit, 1);
      write(master, heater_control_duty_address, 0);
      clear_trips(master, "0001");
      read(master, heater_control_status_address, word);
      clears_the_channel_named : assert word(heater_control_status_tripped_bit) = '0'
        report to_hstring(word) severity error;
      expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit, 1);
      clear_trips(master);
    end loop;

    -- One key of the two is not enough.
    write(master, heater_control_watchdog_address, patience);
    wait_clocks(clk, 2 * tick_cycles);
    heat(master, outputs.gates);
    wait_clocks(clk, 2 * tick_cycles);
    write(master, heater_control_feed_address, heater_control_feed_key_first);
    wait_clocks(clk, patience * tick_cycles);
    expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit);
    write(master, heater_control_duty_address, 0);
    clear_trips(master);
    write(master, heater_control_feed_address, heater_control_feed_key_second);
    wait_clocks(clk, 2 * tick_cycles);

    -- The sensor falls silent while software is well.
    heat(master, outputs.gates);
    sensors_work <= false;
    for i in 1 to sensor_patience / 2 + 1 loop
      wait_clocks(clk, 2 * tick_cycles);
      feed_watchdog(master);
    end loop;
    expect_trip(master, outputs.interrupt, heater_control_status_sensor_stale_trip_bit);
    sensors_work <= true;
    wait_clocks(clk, conversion);
    write(master, heater_control_duty_address, 0);
    clear_trips(master);

    -- Emergency stop reaches every channel, also those at rest.
    heat(master, outputs.gates);
    inputs.emergency_stop <= '1';
    wait_clocks(clk, 5);
    stops : assert outputs.gates = "00" report "heats" severity error;
    inputs.emergency_stop <= '0';
    expect_trip(master, outputs.interrupt, heater_control_status_emergency_stop_trip_bit);
    expect_trip(master, outputs.interrupt, heater_control_status_emergency_stop_trip_bit, 1);

    -- Reset withdraws the interrupt of a trip with its first clock.
    reset <= '1';
    wait_clocks(clk, 1);
    reset_ends_the_interrupt : assert outputs.interrupt = '0' report "interrupts" severity error;
    wait_clocks(clk, 2);
    is_off_in_reset : assert outputs.gates = "00" report "heats" severity error;
    no_interrupt_in_reset : assert outputs.interrupt = '0' report "interrupts" severity error;
    reset <= '0';
    wait_clocks(clk, 3);
    read(master, heater_control_minimum_count_address, word);
    reset_unlocks : assert unsigned(word) = x"FFFF_FFFF" report to_hstring(word) severity error;
    std.env.finish;
  end process;

end architecture;
