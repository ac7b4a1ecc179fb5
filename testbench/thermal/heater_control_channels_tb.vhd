-- SPDX-License-Identifier: Apache-2.0
-- Four heaters: each has its own sensor, duty, limits and trips, and each of them opens the common supply.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_channels_tb is
end entity;

architecture simulation of heater_control_channels_tb is

  constant channels : positive := 4;
  -- In ticks.
  constant sensor_patience : positive := 2;

  -- Of each channel its own: the cut-off, and a count that is good for this channel and no other.
  type counts_t is array (0 to channels - 1) of positive;
  constant cut_offs : counts_t := (1_000, 2_000, 3_000, 4_000);
  constant good : counts_t := (1_500, 2_500, 3_500, 4_500);

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal emergency_stop : std_ulogic := '0';
  signal converts : std_ulogic_vector(channels - 1 downto 0) := (others => '1');
  signal is_valid : std_ulogic_vector(channels - 1 downto 0) := (others => '1');
  signal is_hot : std_ulogic_vector(channels - 1 downto 0) := (others => '0');
  signal readings : sensor_reading_array_t(0 to channels - 1) := (others => sensor_reading_none);
  signal gates : std_ulogic_vector(channels - 1 downto 0);
  signal supply, interrupt : std_ulogic;

  alias clk is master.clk;

begin

  make_clock(master.clk, 250 ns);

  control : entity work.heater_control
    generic map (channels => channels)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => to_request(master.request), to_wires(response) => master.response,
      readings => readings, more_charges => x"0f", limits_locked => open,
      emergency_stop => emergency_stop, veto => '0', gates => gates, supply => supply,
      interrupt => interrupt, at_rest => open);

  convert : process
  begin
    wait_clocks(clk, conversion - 50);
    for channel in readings'range loop
      if converts(channel) then
        readings(channel) <= (
          updated => '1', valid => is_valid(channel), count => to_unsigned(good(channel), 32));
        if is_hot(channel) then
          readings(channel).count <= to_unsigned(cut_offs(channel) - 1, 32);
        end if;
      end if;
    end loop;
    wait_clocks(clk, 1);
    for channel in readings'range loop
      readings(channel).updated <= '0';
    end loop;
  end process;

  check : process

    -- Of these ticks none is without a feed.
    procedure pass (ticks : positive) is
    begin
      for i in 1 to ticks loop
        wait_clocks(clk, tick_cycles);
        feed_watchdog(master);
      end loop;
    end procedure;

    -- Of this channel alone, which opens the supply; then everything is as before.
    procedure expect_trip_of (channel, cause : natural; what : string) is
      variable word : word_t;
    begin
      for other in 0 to channels - 1 loop
        read(master, heater_control_status_address + 4 * other, word);
        trips_alone : assert (word(cause) = '1') = (other = channel)
          and (word(heater_control_status_tripped_bit) = '1') = (other = channel)
          report what & " of channel " & to_string(channel) & ": channel " & to_string(other) & " has "
            & to_hstring(word) severity error;
        closes_its_gate : assert (gates(other) = '0') = (other = channel)
          report what & ": gates " & to_string(gates) severity error;
      end loop;
      opens_the_supply : assert supply = '0' and interrupt = '1'
        report what & " of channel " & to_string(channel) severity error;
      converts <= (others => '1');
      is_valid <= (others => '1');
      is_hot <= (others => '0');
      for other in 0 to channels - 1 loop
        write(master, heater_control_duty_address, 0, other);
      end loop;
      feed_watchdog(master);
      wait_clocks(clk, conversion);
      clear_trips(master, not std_ulogic_vector(shift_left(to_unsigned(1, 4), channel)));
      read(master, heater_control_status_address + 4 * channel, word);
      stays_without_its_own_bit : assert word(heater_control_status_tripped_bit) = '1'
        report what & " of channel " & to_string(channel) severity error;
      clear_trips(master, "1111");
      switch_supply(master, heater_control_supply_key_close);
      closes_again : assert supply = '1' report what & " of channel " & to_string(channel) severity error;
    end procedure;

    procedure heat_all is
    begin
      feed_watchdog(master);
      for channel in 0 to channels - 1 loop
        write(master, heater_control_duty_address, 65_535, channel);
      end loop;
      wait_clocks(clk, 20);
      heats : assert gates = "1111" and supply = '1' report "gates " & to_string(gates) severity error;
    end procedure;

    variable word : word_t;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 10);
    -- So short that the window of the first key is always open.
    write(master, heater_control_watchdog_address, 15);
    write(master, heater_control_sensor_timeout_address, sensor_patience);
    write(master, heater_control_slot_address, 1);
    for channel in 0 to channels - 1 loop
      write(master, heater_control_minimum_count_address, cut_offs(channel), channel);
      write(master, heater_control_maximum_count_address, cut_offs(channel) + 999, channel);
      write(master, heater_control_hot_count_address, 6_000, channel);
      -- Longer than this bench.
      write(master, heater_control_settle_address, 10_000, channel);
    end loop;
    feed_watchdog(master);
    wait_clocks(clk, conversion);
    clear_trips(master, "1111");
    switch_supply(master, heater_control_supply_key_close);
    closes : assert supply = '1' report "does not close" severity error;

    for channel in 0 to channels - 1 loop
      -- Its duty opens its gate and no other, and while it is asked for the supply is not closed.
      feed_watchdog(master);
      write(master, heater_control_duty_address, 65_535, channel);
      wait_clocks(clk, 20);
      heats_alone : assert unsigned(gates) = 2 ** channel report to_string(gates) severity error;
      switch_supply(master, heater_control_supply_key_open);
      switch_supply(master, heater_control_supply_key_close);
      is_no_rest : assert supply = '0' report "channel " & to_string(channel) severity error;
      write(master, heater_control_duty_address, 0, channel);
      switch_supply(master, heater_control_supply_key_close);

      heat_all;
      is_hot(channel) <= '1';
      wait_clocks(clk, conversion);
      expect_trip_of(channel, heater_control_status_too_hot_trip_bit, "heat");

      heat_all;
      converts(channel) <= '0';
      pass(sensor_patience + 1);
      expect_trip_of(channel, heater_control_status_sensor_stale_trip_bit, "silence");

      -- One fault closes the gate. What lasts trips, also where no conversion comes any more.
      heat_all;
      is_valid(channel) <= '0';
      wait_clocks(clk, conversion);
      closes_at_once : assert gates(channel) = '0' report to_string(gates) severity error;
      converts(channel) <= '0';
      pass(sensor_patience + 1);
      expect_trip_of(channel, heater_control_status_sensor_invalid_trip_bit, "a fault, then silence");
    end loop;

    -- The emergency stop and the watchdog are of all.
    heat_all;
    emergency_stop <= '1';
    wait_clocks(clk, 5);
    emergency_stop <= '0';
    wait_clocks(clk, 5);
    stops_all : assert gates = "0000" and supply = '0' report to_string(gates) severity error;
    for channel in 0 to channels - 1 loop
      read(master, heater_control_status_address + 4 * channel, word);
      trips_all : assert word(heater_control_status_emergency_stop_trip_bit) = '1'
        report "channel " & to_string(channel) severity error;
      write(master, heater_control_duty_address, 0, channel);
    end loop;
    clear_trips(master, "1111");
    switch_supply(master, heater_control_supply_key_close);
    heat_all;
    write(master, heater_control_feed_address, 0);
    wait_clocks(clk, 5);
    closes_all : assert gates = "0000" and supply = '0' report to_string(gates) severity error;
    for channel in 0 to channels - 1 loop
      read(master, heater_control_status_address + 4 * channel, word);
      trips_all_by_a_wrong_feed : assert word(heater_control_status_watchdog_trip_bit) = '1'
        report "channel " & to_string(channel) severity error;
    end loop;
    std.env.finish;
  end process;

end architecture;
