-- SPDX-License-Identifier: Apache-2.0
-- The heater control's registers as its benches use them: what takes a key, in one call.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
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

  -- Whole and in time.
  procedure feed_watchdog (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t);

  procedure clear_trips (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    channels : in std_ulogic_vector(3 downto 0) := "0011";
    key : in natural := heater_control_clear_key_clear_trips);

  procedure switch_supply (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    key : in natural);

  -- The channel has tripped by the cause of this bit: its gate is closed, the processor interrupted.
  procedure expect_trip (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    signal interrupt : in std_ulogic;
    bit_number, channel : in natural);

end package;

package body heater_control_bench_pkg is

  procedure feed_watchdog (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t) is
  begin
    bus_write(clk, request, response, heater_control_feed_address, heater_control_feed_key_first);
    bus_write(clk, request, response, heater_control_feed_address, heater_control_feed_key_second);
  end procedure;

  procedure clear_trips (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    channels : in std_ulogic_vector(3 downto 0) := "0011";
    key : in natural := heater_control_clear_key_clear_trips) is
  begin
    bus_write(clk, request, response, heater_control_clear_address,
      to_word(heater_control_clear_t'(channels => channels, key => to_unsigned(key, 16))));
    wait_clocks(clk, 3);
  end procedure;

  procedure switch_supply (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    key : in natural) is
  begin
    bus_write(clk, request, response, heater_control_supply_address,
      to_word(heater_control_supply_t'(key => to_unsigned(key, 16), others => '0')));
    wait_clocks(clk, 3);
  end procedure;

  procedure expect_trip (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    signal interrupt : in std_ulogic;
    bit_number, channel : in natural) is
    variable word : word_t;
    variable status : heater_control_status_t;
  begin
    bus_read(clk, request, response, heater_control_status_address + 4 * channel, word);
    status := to_heater_control_status(word);
    trips : assert word(bit_number) = '1' and status.tripped = '1' and status.gate = '0'
      report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity error;
    wait_clocks(clk, 2);
    interrupts_the_processor : assert interrupt = '1' report "no interrupt" severity error;
  end procedure;

end package body;
