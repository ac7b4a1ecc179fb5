-- SPDX-License-Identifier: Apache-2.0
-- Registers of `uart`. Generated from rtl/serial/uart.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package uart_registers_pkg is

  constant uart_address : unsigned(31 downto 0) := x"F0001000";

  -- Speed of the line. A write restarts both directions; the FIFOs keep their contents.
  type uart_baud_rate_t is record
    increment : unsigned(31 downto 0);
  end record;

  -- What the line is doing. The three flags stay until they are cleared.
  type uart_status_t is record
    receive_level : unsigned(11 downto 0);
    transmit_space : unsigned(11 downto 0);
    transmit_idle : std_ulogic;
    overrun : std_ulogic;
    framing_error : std_ulogic;
    break_condition : std_ulogic;
  end record;

  -- Clears those flags of `status` whose bit is written as 1.
  type uart_clear_t is record
    overrun : std_ulogic;
    framing_error : std_ulogic;
    break_condition : std_ulogic;
  end record;

  -- Read: takes the oldest received byte. Write: sends a byte; without space it is dropped.
  type uart_data_t is record
    byte : unsigned(7 downto 0);
    valid : std_ulogic;
  end record;

  -- When to interrupt. Both are levels: they end when the FIFO has been served.
  type uart_interrupts_t is record
    receive_threshold : unsigned(11 downto 0);
    transmit_threshold : unsigned(11 downto 0);
  end record;

  -- How often bytes were lost.
  type uart_overruns_t is record
    count : unsigned(15 downto 0);
  end record;

  -- How often a stop bit was missing.
  type uart_framing_errors_t is record
    count : unsigned(15 downto 0);
  end record;

  -- How often the line was low for a whole frame.
  type uart_breaks_t is record
    count : unsigned(15 downto 0);
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
  end record;

  type uart_to_software_t is record
    status : uart_status_t;
    data : uart_data_t;
    overruns : uart_overruns_t;
    framing_errors : uart_framing_errors_t;
    breaks : uart_breaks_t;
  end record;

end package;

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

  signal answered : std_ulogic := '0';
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal baud_rate_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal interrupts_stored : std_ulogic_vector(31 downto 0) := x"00000000";

begin

  -- Answers in the clock after the strobe: whole words only, errors for everything not described.
  answer : process
    variable word : std_ulogic_vector(31 downto 0);
    variable known : boolean;
  begin
    wait until rising_edge(clk);
    if answered then
      response <= bus_response_idle;
      answered <= '0';
      from_software.baud_rate_written <= '0';
      from_software.clear_written <= '0';
      from_software.data_written <= '0';
      from_software.data_read <= '0';
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      written_data <= request.data;
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if not request.write then
            known := true;
            word(31 downto 0) := baud_rate_stored(31 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            baud_rate_stored(31 downto 0) <= request.data(31 downto 0);
            from_software.baud_rate_written <= '1';
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(11 downto 0) := std_ulogic_vector(to_software.status.receive_level);
            word(23 downto 12) := std_ulogic_vector(to_software.status.transmit_space);
            word(24) := to_software.status.transmit_idle;
            word(25) := to_software.status.overrun;
            word(26) := to_software.status.framing_error;
            word(27) := to_software.status.break_condition;
          end if;
        when 2 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.clear_written <= '1';
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(7 downto 0) := std_ulogic_vector(to_software.data.byte);
            word(8) := to_software.data.valid;
            from_software.data_read <= '1';
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.data_written <= '1';
          end if;
        when 4 =>
          if not request.write then
            known := true;
            word(11 downto 0) := interrupts_stored(11 downto 0);
            word(27 downto 16) := interrupts_stored(27 downto 16);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            interrupts_stored(11 downto 0) <= request.data(11 downto 0);
            interrupts_stored(27 downto 16) <= request.data(27 downto 16);
          end if;
        when 5 =>
          if not request.write then
            known := true;
            word(15 downto 0) := std_ulogic_vector(to_software.overruns.count);
          end if;
        when 6 =>
          if not request.write then
            known := true;
            word(15 downto 0) := std_ulogic_vector(to_software.framing_errors.count);
          end if;
        when 7 =>
          if not request.write then
            known := true;
            word(15 downto 0) := std_ulogic_vector(to_software.breaks.count);
          end if;
        when others =>
          null;
      end case;
      if known then
        response.acknowledge <= '1';
        response.data <= word;
      else
        response.error <= '1';
      end if;
    end if;
    if reset then
      response <= bus_response_idle;
      answered <= '0';
      from_software.baud_rate_written <= '0';
      from_software.clear_written <= '0';
      from_software.data_written <= '0';
      from_software.data_read <= '0';
      baud_rate_stored <= x"00000000";
      interrupts_stored <= x"00000000";
    end if;
  end process;

  from_software.baud_rate.increment <= unsigned(baud_rate_stored(31 downto 0));

  from_software.clear.overrun <= written_data(0);
  from_software.clear.framing_error <= written_data(1);
  from_software.clear.break_condition <= written_data(2);

  from_software.data.byte <= unsigned(written_data(7 downto 0));
  from_software.data.valid <= written_data(8);

  from_software.interrupts.receive_threshold <= unsigned(interrupts_stored(11 downto 0));
  from_software.interrupts.transmit_threshold <= unsigned(interrupts_stored(27 downto 16));

end architecture;
