-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `uart`. Generated from rtl/serial/uart.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package uart_registers_pkg is

  constant uart_address : unsigned(31 downto 0) := x"F0001000";

  -- Bytes that the FIFO of received ones holds.
  constant uart_receive_depth : natural := 2048;

  -- Bytes that the FIFO of those to be sent holds.
  constant uart_transmit_depth : natural := 512;

  -- Speed of the line. A write restarts both directions; the FIFOs keep their contents.
  constant uart_baud_rate_address : unsigned(31 downto 0) := x"F0001000";
  subtype uart_baud_rate_increment_bits is natural range 31 downto 0;
  type uart_baud_rate_t is record
    increment : unsigned(31 downto 0);
  end record;
  constant uart_baud_rate_after_reset : uart_baud_rate_t := (increment => 32x"0");
  function to_word(value : uart_baud_rate_t) return std_ulogic_vector;
  function to_uart_baud_rate(word : std_ulogic_vector(31 downto 0)) return uart_baud_rate_t;

  -- What the line is doing. The four flags stay until they are cleared.
  constant uart_status_address : unsigned(31 downto 0) := x"F0001004";
  subtype uart_status_receive_level_bits is natural range 11 downto 0;
  subtype uart_status_transmit_space_bits is natural range 23 downto 12;
  constant uart_status_transmit_idle_bit : natural := 24;
  constant uart_status_overrun_bit : natural := 25;
  constant uart_status_framing_error_bit : natural := 26;
  constant uart_status_break_condition_bit : natural := 27;
  constant uart_status_noise_bit : natural := 28;
  constant uart_status_line_waits_bit : natural := 29;
  type uart_status_t is record
    receive_level : unsigned(11 downto 0);
    transmit_space : unsigned(11 downto 0);
    transmit_idle : std_ulogic;
    overrun : std_ulogic;
    framing_error : std_ulogic;
    break_condition : std_ulogic;
    noise : std_ulogic;
    line_waits : std_ulogic;
  end record;
  function to_word(value : uart_status_t) return std_ulogic_vector;
  function to_uart_status(word : std_ulogic_vector(31 downto 0)) return uart_status_t;

  -- Clears those flags of `status` whose bit is written as 1.
  constant uart_clear_address : unsigned(31 downto 0) := x"F0001008";
  constant uart_clear_overrun_bit : natural := 0;
  constant uart_clear_framing_error_bit : natural := 1;
  constant uart_clear_break_condition_bit : natural := 2;
  constant uart_clear_noise_bit : natural := 3;
  type uart_clear_t is record
    overrun : std_ulogic;
    framing_error : std_ulogic;
    break_condition : std_ulogic;
    noise : std_ulogic;
  end record;
  function to_word(value : uart_clear_t) return std_ulogic_vector;
  function to_uart_clear(word : std_ulogic_vector(31 downto 0)) return uart_clear_t;

  -- Read: takes the oldest received byte. Write: sends a byte; without space it is dropped.
  constant uart_data_address : unsigned(31 downto 0) := x"F000100C";
  subtype uart_data_byte_bits is natural range 7 downto 0;
  constant uart_data_valid_bit : natural := 8;
  constant uart_data_gap_bit : natural := 9;
  type uart_data_t is record
    byte : unsigned(7 downto 0);
    valid : std_ulogic;
    gap : std_ulogic;
  end record;
  function to_word(value : uart_data_t) return std_ulogic_vector;
  function to_uart_data(word : std_ulogic_vector(31 downto 0)) return uart_data_t;

  -- When to interrupt. All are levels: they end when the FIFO has been served.
  constant uart_interrupts_address : unsigned(31 downto 0) := x"F0001010";
  subtype uart_interrupts_receive_threshold_bits is natural range 11 downto 0;
  constant uart_interrupts_on_line_end_bit : natural := 12;
  subtype uart_interrupts_transmit_threshold_bits is natural range 27 downto 16;
  type uart_interrupts_t is record
    receive_threshold : unsigned(11 downto 0);
    on_line_end : std_ulogic;
    transmit_threshold : unsigned(11 downto 0);
  end record;
  constant uart_interrupts_after_reset : uart_interrupts_t := (receive_threshold => 12x"0", on_line_end => '0', transmit_threshold => 12x"0");
  function to_word(value : uart_interrupts_t) return std_ulogic_vector;
  function to_uart_interrupts(word : std_ulogic_vector(31 downto 0)) return uart_interrupts_t;

  -- How often bytes were lost.
  constant uart_overruns_address : unsigned(31 downto 0) := x"F0001014";
  subtype uart_overruns_count_bits is natural range 15 downto 0;
  type uart_overruns_t is record
    count : unsigned(15 downto 0);
  end record;
  function to_word(value : uart_overruns_t) return std_ulogic_vector;
  function to_uart_overruns(word : std_ulogic_vector(31 downto 0)) return uart_overruns_t;

  -- How often a stop bit was missing.
  constant uart_framing_errors_address : unsigned(31 downto 0) := x"F0001018";
  subtype uart_framing_errors_count_bits is natural range 15 downto 0;
  type uart_framing_errors_t is record
    count : unsigned(15 downto 0);
  end record;
  function to_word(value : uart_framing_errors_t) return std_ulogic_vector;
  function to_uart_framing_errors(word : std_ulogic_vector(31 downto 0)) return uart_framing_errors_t;

  -- How often the line was low for a whole frame.
  constant uart_breaks_address : unsigned(31 downto 0) := x"F000101C";
  subtype uart_breaks_count_bits is natural range 15 downto 0;
  type uart_breaks_t is record
    count : unsigned(15 downto 0);
  end record;
  function to_word(value : uart_breaks_t) return std_ulogic_vector;
  function to_uart_breaks(word : std_ulogic_vector(31 downto 0)) return uart_breaks_t;

  -- How many bytes were received although looks at their bits differed.
  constant uart_noisy_bytes_address : unsigned(31 downto 0) := x"F0001020";
  subtype uart_noisy_bytes_count_bits is natural range 15 downto 0;
  type uart_noisy_bytes_t is record
    count : unsigned(15 downto 0);
  end record;
  function to_word(value : uart_noisy_bytes_t) return std_ulogic_vector;
  function to_uart_noisy_bytes(word : std_ulogic_vector(31 downto 0)) return uart_noisy_bytes_t;

  -- The bytes that end a line, for `status.line_waits`. A write counts for bytes that come after it.
  constant uart_line_ends_address : unsigned(31 downto 0) := x"F0001024";
  subtype uart_line_ends_first_bits is natural range 7 downto 0;
  subtype uart_line_ends_second_bits is natural range 15 downto 8;
  type uart_line_ends_t is record
    first : unsigned(7 downto 0);
    second : unsigned(7 downto 0);
  end record;
  constant uart_line_ends_after_reset : uart_line_ends_t := (first => 8x"A", second => 8x"D");
  function to_word(value : uart_line_ends_t) return std_ulogic_vector;
  function to_uart_line_ends(word : std_ulogic_vector(31 downto 0)) return uart_line_ends_t;

  type uart_from_software_t is record
    baud_rate : uart_baud_rate_t;
    baud_rate_written : std_ulogic;
    clear : uart_clear_t;
    clear_written : std_ulogic;
    data : uart_data_t;
    data_written : std_ulogic;
    data_read : std_ulogic;
    interrupts : uart_interrupts_t;
    line_ends : uart_line_ends_t;
  end record;

  type uart_to_software_t is record
    status : uart_status_t;
    data : uart_data_t;
    overruns : uart_overruns_t;
    framing_errors : uart_framing_errors_t;
    breaks : uart_breaks_t;
    noisy_bytes : uart_noisy_bytes_t;
  end record;

end package;

package body uart_registers_pkg is

  function to_word(value : uart_baud_rate_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.increment);
  end function;

  function to_uart_baud_rate(word : std_ulogic_vector(31 downto 0)) return uart_baud_rate_t is
  begin
    return (
      increment => unsigned(word(uart_baud_rate_increment_bits)));
  end function;

  function to_word(value : uart_status_t) return std_ulogic_vector is
  begin
    return "00" & value.line_waits & value.noise & value.break_condition & value.framing_error & value.overrun & value.transmit_idle & std_ulogic_vector(value.transmit_space) & std_ulogic_vector(value.receive_level);
  end function;

  function to_uart_status(word : std_ulogic_vector(31 downto 0)) return uart_status_t is
  begin
    return (
      receive_level => unsigned(word(uart_status_receive_level_bits)),
  transmit_space => unsigned(word(uart_status_transmit_space_bits)),
  transmit_idle => word(uart_status_transmit_idle_bit),
  overrun => word(uart_status_overrun_bit),
  framing_error => word(uart_status_framing_error_bit),
  break_condition => word(uart_status_break_condition_bit),
  noise => word(uart_status_noise_bit),
  line_waits => word(uart_status_line_waits_bit));
  end function;

  function to_word(value : uart_clear_t) return std_ulogic_vector is
  begin
    return "0000000000000000000000000000" & value.noise & value.break_condition & value.framing_error & value.overrun;
  end function;

  function to_uart_clear(word : std_ulogic_vector(31 downto 0)) return uart_clear_t is
  begin
    return (
      overrun => word(uart_clear_overrun_bit),
  framing_error => word(uart_clear_framing_error_bit),
  break_condition => word(uart_clear_break_condition_bit),
  noise => word(uart_clear_noise_bit));
  end function;

  function to_word(value : uart_data_t) return std_ulogic_vector is
  begin
    return "0000000000000000000000" & value.gap & value.valid & std_ulogic_vector(value.byte);
  end function;

  function to_uart_data(word : std_ulogic_vector(31 downto 0)) return uart_data_t is
  begin
    return (
      byte => unsigned(word(uart_data_byte_bits)),
  valid => word(uart_data_valid_bit),
  gap => word(uart_data_gap_bit));
  end function;

  function to_word(value : uart_interrupts_t) return std_ulogic_vector is
  begin
    return "0000" & std_ulogic_vector(value.transmit_threshold) & "000" & value.on_line_end & std_ulogic_vector(value.receive_threshold);
  end function;

  function to_uart_interrupts(word : std_ulogic_vector(31 downto 0)) return uart_interrupts_t is
  begin
    return (
      receive_threshold => unsigned(word(uart_interrupts_receive_threshold_bits)),
  on_line_end => word(uart_interrupts_on_line_end_bit),
  transmit_threshold => unsigned(word(uart_interrupts_transmit_threshold_bits)));
  end function;

  function to_word(value : uart_overruns_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.count);
  end function;

  function to_uart_overruns(word : std_ulogic_vector(31 downto 0)) return uart_overruns_t is
  begin
    return (
      count => unsigned(word(uart_overruns_count_bits)));
  end function;

  function to_word(value : uart_framing_errors_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.count);
  end function;

  function to_uart_framing_errors(word : std_ulogic_vector(31 downto 0)) return uart_framing_errors_t is
  begin
    return (
      count => unsigned(word(uart_framing_errors_count_bits)));
  end function;

  function to_word(value : uart_breaks_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.count);
  end function;

  function to_uart_breaks(word : std_ulogic_vector(31 downto 0)) return uart_breaks_t is
  begin
    return (
      count => unsigned(word(uart_breaks_count_bits)));
  end function;

  function to_word(value : uart_noisy_bytes_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.count);
  end function;

  function to_uart_noisy_bytes(word : std_ulogic_vector(31 downto 0)) return uart_noisy_bytes_t is
  begin
    return (
      count => unsigned(word(uart_noisy_bytes_count_bits)));
  end function;

  function to_word(value : uart_line_ends_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.second) & std_ulogic_vector(value.first);
  end function;

  function to_uart_line_ends(word : std_ulogic_vector(31 downto 0)) return uart_line_ends_t is
  begin
    return (
      first => unsigned(word(uart_line_ends_first_bits)),
  second => unsigned(word(uart_line_ends_second_bits)));
  end function;

end package body;
