-- SPDX-License-Identifier: Apache-2.0
-- Registers of `uart`. Generated from rtl/serial/uart.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.uart_registers_pkg.all;

entity uart_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out uart_from_software_t;
    to_software : in uart_to_software_t
  );
end entity;

architecture rtl of uart_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(3 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal baud_rate_word : std_ulogic_vector(31 downto 0);
  signal baud_rate_stored : uart_baud_rate_t := uart_baud_rate_after_reset;
  signal status_word : std_ulogic_vector(31 downto 0);
  signal data_word : std_ulogic_vector(31 downto 0);
  signal interrupts_word : std_ulogic_vector(31 downto 0);
  signal interrupts_stored : uart_interrupts_t := uart_interrupts_after_reset;
  signal overruns_word : std_ulogic_vector(31 downto 0);
  signal framing_errors_word : std_ulogic_vector(31 downto 0);
  signal breaks_word : std_ulogic_vector(31 downto 0);
  signal noisy_bytes_word : std_ulogic_vector(31 downto 0);
  signal line_ends_word : std_ulogic_vector(31 downto 0);
  signal line_ends_stored : uart_line_ends_t := uart_line_ends_after_reset;
  signal clear_written : std_ulogic := '0';
  signal data_written : std_ulogic := '0';
  signal data_read : std_ulogic := '0';

begin

  access_begins <= request.strobe and not answered;

  -- Answers in the clock after the strobe; an error for everything that is not described.
  answer : process
  begin
    wait until rising_edge(clk);
    answered <= access_begins;
    writing <= access_begins and known and request.write;
    response.acknowledge <= access_begins and known;
    response.error <= access_begins and not known;
    response.data <= (others => '0');
    if access_begins then
      response.data <= read_word;
      written_data <= request.data;
      register_index <= request.address(5 downto 2);
    end if;
    if reset then
      answered <= '0';
      writing <= '0';
      response <= bus_response_idle;
    end if;
  end process;

  -- Whole words only.
  whole_write <= request.write and (and request.select_bytes);
  known <= writable and whole_write when request.write = '1' else readable;

  readable <= '1' when request.address(11 downto 2) <= 1
    or (request.address(11 downto 2) >= 3 and request.address(11 downto 2) <= 9) else '0';

  writable <= '1' when request.address(11 downto 2) = 0
    or (request.address(11 downto 2) >= 2 and request.address(11 downto 2) <= 4)
    or request.address(11 downto 2) = 9 else '0';

  baud_rate_word <= to_word(baud_rate_stored)
    when request.address(11 downto 2) = 0 else (others => '0');
  status_word <= to_word(to_software.status)
    when request.address(11 downto 2) = 1 else (others => '0');
  data_word <= to_word(to_software.data)
    when request.address(11 downto 2) = 3 else (others => '0');
  interrupts_word <= to_word(interrupts_stored)
    when request.address(11 downto 2) = 4 else (others => '0');
  overruns_word <= to_word(to_software.overruns)
    when request.address(11 downto 2) = 5 else (others => '0');
  framing_errors_word <= to_word(to_software.framing_errors)
    when request.address(11 downto 2) = 6 else (others => '0');
  breaks_word <= to_word(to_software.breaks)
    when request.address(11 downto 2) = 7 else (others => '0');
  noisy_bytes_word <= to_word(to_software.noisy_bytes)
    when request.address(11 downto 2) = 8 else (others => '0');
  line_ends_word <= to_word(line_ends_stored)
    when request.address(11 downto 2) = 9 else (others => '0');

  read_word <= baud_rate_word
    or status_word
    or data_word
    or interrupts_word
    or overruns_word
    or framing_errors_word
    or breaks_word
    or noisy_bytes_word
    or line_ends_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 0 then
      baud_rate_stored <= to_uart_baud_rate(written_data);
    end if;
    if writing = '1' and register_index = 4 then
      interrupts_stored <= to_uart_interrupts(written_data);
    end if;
    if writing = '1' and register_index = 9 then
      line_ends_stored <= to_uart_line_ends(written_data);
    end if;
    if reset then
      baud_rate_stored <= uart_baud_rate_after_reset;
      interrupts_stored <= uart_interrupts_after_reset;
      line_ends_stored <= uart_line_ends_after_reset;
    end if;
  end process;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    clear_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 2);
    data_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 3);
    data_read <= access_begins and not request.write and (request.address(11 downto 2) ?= 3);
    if reset then
      clear_written <= '0';
      data_written <= '0';
      data_read <= '0';
    end if;
  end process;

  -- One clock later than the write, together with the stored value.
  note_baud_rate : process
  begin
    wait until rising_edge(clk);
    from_software.baud_rate_written <= '1' when writing = '1' and register_index = 0 else '0';
  end process;

  from_software.baud_rate <= baud_rate_stored;
  from_software.clear_written <= clear_written;
  from_software.clear <= to_uart_clear(written_data);
  from_software.data_written <= data_written;
  from_software.data_read <= data_read;
  from_software.data <= to_uart_data(written_data);
  from_software.interrupts <= interrupts_stored;
  from_software.line_ends <= line_ends_stored;

end architecture;
