-- SPDX-License-Identifier: Apache-2.0
-- Words of the uart's registers as its benches write and expect them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.serial_line_pkg.all;
use work.uart_registers_pkg.all;

package uart_bench_pkg is

  constant line_feed : byte_t := x"0A";
  constant carriage_return : byte_t := x"0D";

  -- A byte that waited.
  function data_word (byte : byte_t; after_a_gap : std_ulogic := '0') return word_t;
  function clear_word (overrun, framing_error, break_condition, noise : std_ulogic := '0') return word_t;
  -- No interrupt without an argument.
  function interrupts_word (received, space : natural := 0; line_end : std_ulogic := '0') return word_t;
  function line_ends_word (first, second : byte_t) return word_t;

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

end package body;
