-- SPDX-License-Identifier: Apache-2.0
-- What the uart's benches share: its speed and sizes, words of its registers, and bytes from its queue.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.serial_line_pkg.all;
use work.uart_registers_pkg.all;

package uart_bench_pkg is

  constant clock_period : time := 10 ns;
  constant clocks_per_bit : real := 4.0;
  constant bit_time : time := clock_period * clocks_per_bit;
  constant receive_depth : positive := 16;
  constant transmit_depth : positive := 8;

  constant baud_rate : unsigned(31 downto 0) := uart_baud_rate_address;
  constant status : unsigned(31 downto 0) := uart_status_address;
  constant clear : unsigned(31 downto 0) := uart_clear_address;
  constant data : unsigned(31 downto 0) := uart_data_address;

  constant line_feed : byte_t := x"0A";
  constant carriage_return : byte_t := x"0D";

  -- A byte that waited.
  function data_word (byte : byte_t; after_a_gap : std_ulogic := '0') return word_t;
  function clear_word (overrun, framing_error, break_condition, noise : std_ulogic := '0') return word_t;
  -- No interrupt without an argument.
  function interrupts_word (received, space : natural := 0; line_end : std_ulogic := '0') return word_t;
  function line_ends_word (first, second : byte_t) return word_t;

  -- Both read the data register once.
  procedure expect_byte (
    signal master : inout bus_master_t; byte : in byte_t; after_a_gap : in std_ulogic := '0');
  procedure expect_no_byte (signal master : inout bus_master_t);

end package;

package body uart_bench_pkg is

  function data_word (byte : byte_t; after_a_gap : std_ulogic := '0') return word_t is
  begin
    return to_word(uart_data_t'(byte => unsigned(byte), valid => '1', gap => after_a_gap));
  end function;

  function clear_word (overrun, framing_error, break_condition, noise : std_ulogic := '0') return word_t is
  begin
    return to_word(uart_clear_t'(overrun, framing_error, break_condition, noise));
  end function;

  function interrupts_word (received, space : natural := 0; line_end : std_ulogic := '0') return word_t is
  begin
    return to_word(uart_interrupts_t'(
      receive_threshold => to_unsigned(received, 12), on_line_end => line_end,
      transmit_threshold => to_unsigned(space, 12)));
  end function;

  function line_ends_word (first, second : byte_t) return word_t is
  begin
    return to_word(uart_line_ends_t'(first => unsigned(first), second => unsigned(second)));
  end function;

  procedure expect_byte (
    signal master : inout bus_master_t; byte : in byte_t; after_a_gap : in std_ulogic := '0') is
    variable word : word_t;
  begin
    read(master, data, word);
    gives_the_oldest_byte : assert word = data_word(byte, after_a_gap)
      report "data " & to_hstring(word) & ", expected " & to_hstring(byte) severity error;
  end procedure;

  procedure expect_no_byte (signal master : inout bus_master_t) is
    variable word : word_t;
  begin
    read(master, data, word);
    reports_that_there_is_no_byte : assert word(uart_data_valid_bit) = '0'
      report "data " & to_hstring(word) severity error;
  end procedure;

end package body;
