-- SPDX-License-Identifier: Apache-2.0
-- Size, speed and registers of the serial line in its benches, and what they check again and again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.serial_line_pkg.all;
use work.uart_registers_pkg.all;

package uart_harness_pkg is

  constant clock_period : time := 10 ns;
  constant clocks_per_bit : real := 4.0;
  constant bit_time : time := clock_period * clocks_per_bit;
  constant receive_depth : positive := 16;
  constant transmit_depth : positive := 8;

  constant baud_rate : unsigned(31 downto 0) := uart_baud_rate_address;
  constant status : unsigned(31 downto 0) := uart_status_address;
  constant clear : unsigned(31 downto 0) := uart_clear_address;
  constant data : unsigned(31 downto 0) := uart_data_address;
  constant interrupts : unsigned(31 downto 0) := uart_interrupts_address;
  constant overruns : unsigned(31 downto 0) := uart_overruns_address;
  constant framing_errors : unsigned(31 downto 0) := uart_framing_errors_address;
  constant breaks : unsigned(31 downto 0) := uart_breaks_address;
  constant noisy_bytes : unsigned(31 downto 0) := uart_noisy_bytes_address;
  constant line_ends : unsigned(31 downto 0) := uart_line_ends_address;

  constant line_feed : byte_t := x"0A";
  constant carriage_return : byte_t := x"0D";

  procedure check_status (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t;
    what : string; receive_level, transmit_space : natural;
    transmit_idle, overrun, framing_error, break_condition : std_ulogic);

  procedure check_count (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t;
    what : string; address : unsigned(31 downto 0); expected : natural);

  procedure check_data (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t; expected : byte_t;
    after_a_gap : std_ulogic := '0');

  procedure check_no_data (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t);

end package;

package body uart_harness_pkg is

  procedure check_status (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t;
    what : string; receive_level, transmit_space : natural;
    transmit_idle, overrun, framing_error, break_condition : std_ulogic) is
    variable word : word_t;
  begin
    bus_read(clk, request, response, status, word);
    status_is_as_expected : assert unsigned(word(11 downto 0)) = receive_level
      and unsigned(word(23 downto 12)) = transmit_space and word(24) = transmit_idle
      and word(25) = overrun and word(26) = framing_error and word(27) = break_condition
      and word(31 downto 30) = "00"
      report what & ": status " & to_hstring(word) severity error;
  end procedure;

  procedure check_count (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t;
    what : string; address : unsigned(31 downto 0); expected : natural) is
    variable word : word_t;
  begin
    bus_read(clk, request, response, address, word);
    count_is_as_expected : assert unsigned(word) = expected
      report what & ": " & to_hstring(word) severity error;
  end procedure;

  procedure check_data (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t; expected : byte_t;
    after_a_gap : std_ulogic := '0') is
    variable word : word_t;
  begin
    bus_read(clk, request, response, data, word);
    gives_the_oldest_byte : assert word = x"00000" & "00" & after_a_gap & '1' & expected
      report "data " & to_hstring(word) & ", expected " & to_hstring(expected) severity error;
  end procedure;

  procedure check_no_data (
    signal clk : in std_ulogic; signal request : inout bus_request_t;
    signal response : in bus_response_t) is
    variable word : word_t;
  begin
    bus_read(clk, request, response, data, word);
    says_that_there_is_no_byte : assert word(8) = '0' report "data " & to_hstring(word)
      severity error;
  end procedure;

end package body;
