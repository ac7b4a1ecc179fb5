-- SPDX-License-Identifier: Apache-2.0
-- The heater control's registers as its benches use them: what takes a key, in one call.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_registers_pkg.all;

package heater_control_bench_pkg is

  -- The trips of the register status, from watchdog_trip on.
  subtype trip_bits is natural range
    heater_control_status_heats_unasked_trip_bit downto heater_control_status_watchdog_trip_bit;
  -- Refused and locked limits of the register status.
  subtype lock_bits is natural range
    heater_control_status_refused_bit downto heater_control_status_minimum_locked_bit;
  -- What opened the supply, in the register supply: veto, emergency stop, watchdog, trip.
  subtype opener_bits is natural range
    heater_control_supply_veto_opened_bit downto heater_control_supply_trip_opened_bit;

  constant clock_frequency_hz : positive := 4_000_000;
  constant charges : positive := 16;
  -- Times in ticks, and the clocks of a conversion with some to spare: short ones, for a short run.
  constant patience : positive := 6;
  constant settling : positive := 3;
  constant conversion : positive := 250;

  type heater_inputs_t is record
    emergency_stop : std_ulogic;
    veto : std_ulogic;
  end record;

  type heater_outputs_t is record
    gates : std_ulogic_vector(1 downto 0);
    supply : std_ulogic;
    interrupt : std_ulogic;
    limits_locked : std_ulogic;
  end record;

  -- Of a channel's registers.
  procedure write (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    value, channel : in natural);
  procedure expect (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    value, channel : in natural);

  -- Whole and in time.
  procedure feed_watchdog (signal master : inout bus_master_t);

  procedure clear_trips (
    signal master : inout bus_master_t;
    channels : in std_ulogic_vector(3 downto 0) := "0011";
    key : in natural := heater_control_clear_key_clear_trips);

  procedure switch_supply (
    signal master : inout bus_master_t;
    key : in natural);

  -- The channel has tripped by the cause of this bit: its gate is closed, the processor interrupted.
  procedure expect_trip (
    signal master : inout bus_master_t;
    signal interrupt : in std_ulogic;
    bit_number : in natural;
    channel : in natural := 0);

  -- Fed, after a conversion, at full duty: the gate of channel 0 is open, the other closed.
  procedure heat (signal master : inout bus_master_t; signal gates : in std_ulogic_vector(1 downto 0));

end package;

package body heater_control_bench_pkg is

  procedure write (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    value, channel : in natural) is
  begin
    write(master, address + 4 * channel, value);
  end procedure;

  procedure expect (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    value, channel : in natural) is
  begin
    expect(master, address + 4 * channel, value);
  end procedure;

  procedure feed_watchdog (signal master : inout bus_master_t) is
  begin
    write(master, heater_control_feed_address, heater_control_feed_key_first);
    write(master, heater_control_feed_address, heater_control_feed_key_second);
  end procedure;

  procedure clear_trips (
    signal master : inout bus_master_t;
    channels : in std_ulogic_vector(3 downto 0) := "0011";
    key : in natural := heater_control_clear_key_clear_trips) is
  begin
    write(master, heater_control_clear_address,
      to_word(heater_control_clear_t'(channels => channels, key => to_unsigned(key, 16))));
    wait_clocks(master.clk, 3);
  end procedure;

  procedure switch_supply (
    signal master : inout bus_master_t;
    key : in natural) is
  begin
    write(master, heater_control_supply_address,
      to_word(heater_control_supply_t'(key => to_unsigned(key, 16), others => '0')));
    wait_clocks(master.clk, 3);
  end procedure;

  procedure expect_trip (
    signal master : inout bus_master_t;
    signal interrupt : in std_ulogic;
    bit_number : in natural;
    channel : in natural := 0) is
    variable word : word_t;
    variable status : heater_control_status_t;
  begin
    read(master, heater_control_status_address + 4 * channel, word);
    status := to_heater_control_status(word);
    trips : assert word(bit_number) = '1' and status.tripped = '1' and status.gate = '0'
      report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity error;
    wait_clocks(master.clk, 2);
    interrupts_the_processor : assert interrupt = '1' report "no interrupt" severity error;
  end procedure;

  procedure heat (signal master : inout bus_master_t; signal gates : in std_ulogic_vector(1 downto 0)) is
  begin
    feed_watchdog(master);
    wait_clocks(master.clk, conversion);
    write(master, heater_control_duty_address, 65_535);
    wait_clocks(master.clk, 220);
    heats : assert gates = "01" report "gates " & to_string(gates) & " after " & to_string(now)
      severity error;
  end procedure;

end package body;
