-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `uart`. Generated from rtl/serial/uart.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package uart_registers_pkg is

  constant uart_address : unsigned(31 downto 0) := x"F0001000";

  -- Speed of the line. A write restarts both directions; the FIFOs keep their contents.
  constant uart_baud_rate_address : unsigned(31 downto 0) := x"F0001000";
  type uart_baud_rate_t is record
    increment : unsigned(31 downto 0);
  end record;

  -- What the line is doing. The four flags stay until they are cleared.
  constant uart_status_address : unsigned(31 downto 0) := x"F0001004";
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

  -- Clears those flags of `status` whose bit is written as 1.
  constant uart_clear_address : unsigned(31 downto 0) := x"F0001008";
  type uart_clear_t is record
    overrun : std_ulogic;
    framing_error : std_ulogic;
    break_condition : std_ulogic;
    noise : std_ulogic;
  end record;

  -- Read: takes the oldest received byte. Write: sends a byte; without space it is dropped.
  constant uart_data_address : unsigned(31 downto 0) := x"F000100C";
  type uart_data_t is record
    byte : unsigned(7 downto 0);
    valid : std_ulogic;
    gap : std_ulogic;
  end record;

  -- When to interrupt. All are levels: they end when the FIFO has been served.
  constant uart_interrupts_address : unsigned(31 downto 0) := x"F0001010";
  type uart_interrupts_t is record
    receive_threshold : unsigned(11 downto 0);
    on_line_end : std_ulogic;
    transmit_threshold : unsigned(11 downto 0);
  end record;

  -- How often bytes were lost.
  constant uart_overruns_address : unsigned(31 downto 0) := x"F0001014";
  type uart_overruns_t is record
    count : unsigned(15 downto 0);
  end record;

  -- How often a stop bit was missing.
  constant uart_framing_errors_address : unsigned(31 downto 0) := x"F0001018";
  type uart_framing_errors_t is record
    count : unsigned(15 downto 0);
  end record;

  -- How often the line was low for a whole frame.
  constant uart_breaks_address : unsigned(31 downto 0) := x"F000101C";
  type uart_breaks_t is record
    count : unsigned(15 downto 0);
  end record;

  -- How many bytes were received although looks at their bits differed.
  constant uart_noisy_bytes_address : unsigned(31 downto 0) := x"F0001020";
  type uart_noisy_bytes_t is record
    count : unsigned(15 downto 0);
  end record;

  -- The bytes that end a line, for `status.line_waits`. A write counts for bytes that come after it.
  constant uart_line_ends_address : unsigned(31 downto 0) := x"F0001024";
  type uart_line_ends_t is record
    first : unsigned(7 downto 0);
    second : unsigned(7 downto 0);
  end record;

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
