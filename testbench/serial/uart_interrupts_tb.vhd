-- SPDX-License-Identifier: Apache-2.0
-- The uart interrupts at its thresholds and at the end of a line: while there is a reason, and no longer.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.serial_line_pkg.all;
use work.uart_bench_pkg.all;
use work.uart_registers_pkg.all;

entity uart_interrupts_tb is
end entity;

architecture simulation of uart_interrupts_tb is

  constant interrupts : unsigned(31 downto 0) := uart_interrupts_address;
  constant line_ends : unsigned(31 downto 0) := uart_line_ends_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal receive_interrupt : std_ulogic;
  signal transmit_interrupt : std_ulogic;

  signal sent : std_ulogic := '1';

  alias clk is master.clk;

begin

  make_clock(master.clk, clock_period);

  uart : entity work.uart
    generic map (receive_depth => receive_depth, transmit_depth => transmit_depth)
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, receive => sent, transmit => open,
      receive_interrupt => receive_interrupt, transmit_interrupt => transmit_interrupt);

  check : process
    variable word : word_t;

    procedure check_interrupts (what : string; expected_receive, expected_transmit : std_ulogic) is
    begin
      wait for 6 * clock_period;
      interrupts_are_as_expected : assert receive_interrupt = expected_receive
        and transmit_interrupt = expected_transmit report what severity error;
    end procedure;

    procedure interrupts_at_its_thresholds is
    begin
      check_interrupts("both off", '0', '0');
      write(master, interrupts, interrupts_word(received => 3, space => 8));
      check_interrupts("transmit FIFO empty", '0', '1');
      send_byte(sent, x"01", bit_time);
      send_byte(sent, x"02", bit_time);
      check_interrupts("below the threshold", '0', '1');
      send_byte(sent, x"03", bit_time);
      check_interrupts("at the threshold", '1', '1');
      read(master, data, word);
      check_interrupts("served", '0', '1');
      read(master, data, word);
      read(master, data, word);
      write(master, data, x"00000055");
      write(master, data, x"00000055");
      check_interrupts("a byte waits", '0', '0');
      wait for 12 * bit_time;
      check_interrupts("the byte is on the line", '0', '1');
      write(master, interrupts, interrupts_word);
      check_interrupts("off again", '0', '0');
      wait for 12 * bit_time;
    end procedure;

    procedure check_line (what : string; expected_interrupt, expected_line : std_ulogic) is
    begin
      check_interrupts(what, expected_interrupt, '0');
      read(master, status, word);
      status_reports_whether_a_line_waits : assert word(uart_status_line_waits_bit) = expected_line
        report what severity error;
    end procedure;

    procedure interrupts_at_the_end_of_a_line is
    begin
      read(master, line_ends, word);
      line_feed_and_carriage_return_are_line_ends : assert word = line_ends_word(line_feed, carriage_return)
        severity error;
      write(master, interrupts, interrupts_word(line_end => '1'));
      send_byte(sent, x"4D", bit_time);
      send_byte(sent, x"35", bit_time);
      check_line("within a line", '0', '0');
      send_byte(sent, line_feed, bit_time);
      check_line("at its end", '1', '1');
      send_byte(sent, x"47", bit_time);
      send_byte(sent, carriage_return, bit_time);
      send_byte(sent, x"54", bit_time);
      expect_byte(master, x"4D");
      expect_byte(master, x"35");
      check_line("its end has not been read", '1', '1');
      expect_byte(master, line_feed);
      check_line("another line waits", '1', '1');
      expect_byte(master, x"47");
      expect_byte(master, carriage_return);
      check_line("the beginning of a line is left", '0', '0');
      expect_byte(master, x"54");
      expect_no_byte(master);
      check_line("all read", '0', '0');
      -- Either reason is enough.
      write(master, interrupts, interrupts_word(received => 2, line_end => '1'));
      send_byte(sent, line_feed, bit_time);
      check_line("a line of one byte", '1', '1');
      expect_byte(master, line_feed);
      send_byte(sent, x"01", bit_time);
      check_line("a byte", '0', '0');
      send_byte(sent, x"02", bit_time);
      check_line("as many bytes as asked for", '1', '0');
      expect_byte(master, x"01");
      expect_byte(master, x"02");
      -- Not requested, but to be seen.
      write(master, interrupts, interrupts_word);
      send_byte(sent, line_feed, bit_time);
      check_line("not asked for", '0', '1');
      write(master, interrupts, interrupts_word(line_end => '1'));
      check_line("asked for when it was there", '1', '1');
      expect_byte(master, line_feed);
    end procedure;

    procedure ends_lines_with_other_bytes is
    begin
      send_byte(sent, line_feed, bit_time);
      write(master, line_ends, line_ends_word(x"3B", x"3B"));
      check_line("a line end when it came", '1', '1');
      expect_byte(master, line_feed);
      send_byte(sent, line_feed, bit_time);
      send_byte(sent, carriage_return, bit_time);
      check_line("line ends no more", '0', '0');
      send_byte(sent, x"3B", bit_time);
      check_line("a line end now", '1', '1');
      expect_byte(master, line_feed);
      expect_byte(master, carriage_return);
      expect_byte(master, x"3B");
      check_line("all read", '0', '0');
      write(master, line_ends, line_ends_word(line_feed, carriage_return));
    end procedure;

    -- Nothing can be read of a line end that was lost, so it must not wake; the full queue itself may.
    procedure forgets_line_ends_that_are_lost is
    begin
      for i in 1 to receive_depth loop
        send_byte(sent, x"31", bit_time);
      end loop;
      send_byte(sent, line_feed, bit_time);
      check_line("the line end is lost", '0', '0');
      write(master, clear, clear_word(overrun => '1'));
      expect_byte(master, x"31");
      send_byte(sent, line_feed, bit_time);
      check_line("this one had room", '1', '1');
      for i in 2 to receive_depth loop
        expect_byte(master, x"31");
      end loop;
      check_line("only the line end is left", '1', '1');
      expect_byte(master, line_feed, after_a_gap => '1');
      check_line("all read", '0', '0');
      -- A break is no line end, nor is a byte without a stop bit.
      sent <= '0';
      wait for 30 * bit_time;
      sent <= '1';
      wait for 2 * bit_time;
      send_byte(sent, line_feed, bit_time, stop_level => '0');
      sent <= '1';
      wait for 2 * bit_time;
      check_line("nothing came", '0', '0');
      write(master, clear, clear_word(framing_error => '1', break_condition => '1'));
      send_byte(sent, x"32", bit_time);
      wait for 2 * bit_time;
      expect_byte(master, x"32", after_a_gap => '1');
      write(master, interrupts, interrupts_word);
    end procedure;

  begin
    wait for 5 * clock_period;
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    write(master, baud_rate, word_t(increment_for(clocks_per_bit)));
    interrupts_at_its_thresholds;
    interrupts_at_the_end_of_a_line;
    ends_lines_with_other_bytes;
    forgets_line_ends_that_are_lost;
    write(master, interrupts, interrupts_word(line_end => '1'));
    send_byte(sent, line_feed, bit_time);
    check_line("before the reset", '1', '1');
    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    check_line("after the reset", '0', '0');
    std.env.finish;
  end process;

end architecture;
