-- SPDX-License-Identifier: Apache-2.0
-- Serial line to the host: registers, FIFOs, receiver and transmitter.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.uart_registers_pkg.all;

entity uart is
  generic (
    -- Bytes, a power of two, at most 2048.
    receive_depth : positive := uart_receive_depth;
    transmit_depth : positive := uart_transmit_depth
  );
  port (
    -- May be gated while `at_rest` is high, except for the edge after a change of `receive`.
    clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- The pins; `receive` is asynchronous.
    receive : in std_ulogic;
    transmit : out std_ulogic;
    -- Levels: as many bytes wait, or as much space is free, as software has requested, or a whole line waits.
    receive_interrupt : out std_ulogic;
    transmit_interrupt : out std_ulogic := '0';
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of uart is

  signal from_software : uart_from_software_t;
  signal to_software : uart_to_software_t;

  -- Both directions rest while the speed changes or is 0.
  signal restart : std_ulogic := '1';

  signal receiving, line_changes, sending, working : std_ulogic;

begin

  levels_fit_their_fields : assert receive_depth <= 2048 and transmit_depth <= 2048
    severity failure;

  registers : entity work.uart_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software
    );

  working <= receiving or sending;

  watch_rest : entity work.rest_watch
    generic map (settling_clocks => 6)
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset,
      strobe => request.strobe,
      working => working,
      alarm => line_changes,
      at_rest => at_rest
    );

  settle_speed : process
  begin
    wait until rising_edge(clk);
    restart <= '1' when from_software.baud_rate.increment = 0 else from_software.baud_rate_written;
    if reset then
      restart <= '1';
    end if;
  end process;

  receive_direction : block
    signal byte_received : std_ulogic;
    signal noisy : std_ulogic;
    signal framing_error : std_ulogic;
    signal break_condition : std_ulogic;
    signal overrun : std_ulogic;
    signal received_data : std_ulogic_vector(7 downto 0);
    signal full : std_ulogic;
    -- Something was lost since the last byte was written to the FIFO: the next one is marked.
    signal gap : std_ulogic := '0';
    signal oldest : std_ulogic_vector(8 downto 0);
    signal oldest_valid : std_ulogic;
    signal oldest_was_valid : std_ulogic := '0';
    signal take : std_ulogic;
    signal level : natural range 0 to receive_depth;
  begin

    receiver : entity work.uart_receiver
      port map (
        clk => clk,
        reset => restart,
        increment => from_software.baud_rate.increment,
        receive => receive,
        valid => byte_received,
        noisy => noisy,
        framing_error => framing_error,
        break_condition => break_condition,
        data => received_data,
        busy => receiving,
        settling => line_changes
      );

    received_bytes : entity work.receive_queue
      generic map (depth => receive_depth)
      port map (
        clk => clk,
        reset => reset,
        write_enable => byte_received,
        write_data => gap & received_data,
        full => full,
        read_enable => take,
        read_data => oldest,
        read_valid => oldest_valid,
        level => level,
        first_line_end => std_ulogic_vector(from_software.line_ends.first),
        second_line_end => std_ulogic_vector(from_software.line_ends.second),
        line_waits => to_software.status.line_waits,
        threshold => from_software.interrupts.receive_threshold,
        wake_on_line => from_software.interrupts.on_line_end,
        interrupt => receive_interrupt
      );

    overrun <= byte_received and full;
    -- The read event comes a clock after software has read the data: a byte that arrived in between
    -- was not read and stays.
    take <= from_software.data_read and oldest_was_valid;
    to_software.data <=
      (byte => unsigned(oldest(7 downto 0)), valid => oldest_valid, gap => oldest(8));
    to_software.status.receive_level <= to_unsigned(level, 12);

    keep_count : process
    begin
      wait until rising_edge(clk);
      oldest_was_valid <= oldest_valid;

      if overrun or framing_error or break_condition then
        gap <= '1';
      elsif byte_received then
        gap <= '0';
      end if;

      if from_software.clear_written then
        to_software.status.overrun <=
          to_software.status.overrun and not from_software.clear.overrun;
        to_software.status.framing_error <=
          to_software.status.framing_error and not from_software.clear.framing_error;
        to_software.status.break_condition <=
          to_software.status.break_condition and not from_software.clear.break_condition;
        to_software.status.noise <=
          to_software.status.noise and not from_software.clear.noise;
      end if;
      if overrun then
        to_software.status.overrun <= '1';
        to_software.overruns.count <= to_software.overruns.count + 1;
      end if;
      if framing_error then
        to_software.status.framing_error <= '1';
        to_software.framing_errors.count <= to_software.framing_errors.count + 1;
      end if;
      if break_condition then
        to_software.status.break_condition <= '1';
        to_software.breaks.count <= to_software.breaks.count + 1;
      end if;
      if byte_received and noisy then
        to_software.status.noise <= '1';
        to_software.noisy_bytes.count <= to_software.noisy_bytes.count + 1;
      end if;

      if reset then
        oldest_was_valid <= '0';
        gap <= '0';
        to_software.status.noise <= '0';
        to_software.status.overrun <= '0';
        to_software.status.framing_error <= '0';
        to_software.status.break_condition <= '0';
        to_software.overruns.count <= (others => '0');
        to_software.framing_errors.count <= (others => '0');
        to_software.breaks.count <= (others => '0');
        to_software.noisy_bytes.count <= (others => '0');
      end if;
    end process;

  end block;

  transmit_direction : block
    signal next_byte : std_ulogic_vector(7 downto 0);
    signal next_valid : std_ulogic;
    signal taken : std_ulogic;
    signal busy : std_ulogic;
    signal level : natural range 0 to transmit_depth;
    signal space : natural range 0 to transmit_depth;
  begin

    bytes_to_send : entity work.fifo
      generic map (width => 8, depth => transmit_depth)
      port map (
        clk => clk,
        reset => reset,
        write_enable => from_software.data_written,
        write_data => std_ulogic_vector(from_software.data.byte),
        full => open,
        read_enable => taken,
        read_data => next_byte,
        read_valid => next_valid,
        level => level
      );

    transmitter : entity work.uart_transmitter
      port map (
        clk => clk,
        reset => restart,
        increment => from_software.baud_rate.increment,
        data => next_byte,
        valid => next_valid,
        taken => taken,
        busy => busy,
        transmit => transmit
      );

    sending <= next_valid or taken or busy;
    space <= transmit_depth - level;
    to_software.status.transmit_space <= to_unsigned(space, 12);
    to_software.status.transmit_idle <= '1' when level = 0 and busy = '0' else '0';

    ask_for_more : process
    begin
      wait until rising_edge(clk);
      transmit_interrupt <= '1' when from_software.interrupts.transmit_threshold /= 0
        and space >= from_software.interrupts.transmit_threshold else '0';
      if reset then
        transmit_interrupt <= '0';
      end if;
    end process;

  end block;

end architecture;
