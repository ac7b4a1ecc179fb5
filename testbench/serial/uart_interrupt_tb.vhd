-- SPDX-License-Identifier: Apache-2.0
-- The serial line interrupts at its thresholds and at the ends of lines, and says which line end waits.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.serial_line_pkg.all;
use work.uart_harness_pkg.all;

entity uart_interrupt_tb is
end entity;

architecture simulation of uart_interrupt_tb is

  signal clk : std_ulogic;
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal sent : std_ulogic := '1';
  signal looped_back : boolean := false;
  signal transmit : std_ulogic;
  signal receive_interrupt : std_ulogic;
  signal transmit_interrupt : std_ulogic;

begin

  uart : entity work.uart_harness
    port map (
      clk => clk, reset => reset, request => request, response => response, sent => sent,
      looped_back => looped_back, transmit => transmit, receive_interrupt => receive_interrupt,
      transmit_interrupt => transmit_interrupt);

  check : process
    variable word : word_t;

    procedure check_interrupts (what : string; expected_receive, expected_transmit : std_ulogic) is
    begin
      wait for 6 * clock_period;
      interrupts_are_as_expected : assert receive_interrupt = expected_receive
        and transmit_interrupt = expected_transmit report what severity error;
    end procedure;

    procedure check_line (what : string; expected_interrupt, expected_line : std_ulogic) is
    begin
      check_interrupts(what, expected_interrupt, '0');
      bus_read(clk, request, response, status, word);
      status_reports_whether_a_line_waits : assert word(29) = expected_line report what severity error;
    end procedure;

    procedure interrupts_at_its_thresholds is
    begin
      check_interrupts("both off", '0', '0');
      bus_write(clk, request, response, interrupts, x"0008_0003");
      check_interrupts("transmit FIFO empty", '0', '1');
      send_byte(sent, x"01", bit_time);
      send_byte(sent, x"02", bit_time);
      check_interrupts("below the threshold", '0', '1');
      send_byte(sent, x"03", bit_time);
      check_interrupts("at the threshold", '1', '1');
      bus_read(clk, request, response, data, word);
      check_interrupts("served", '0', '1');
      bus_read(clk, request, response, data, word);
      bus_read(clk, request, response, data, word);
      bus_write(clk, request, response, data, x"00000055");
      bus_write(clk, request, response, data, x"00000055");
      check_interrupts("a byte waits", '0', '0');
      wait for 12 * bit_time;
      check_interrupts("the byte is on the line", '0', '1');
      bus_write(clk, request, response, interrupts, x"0000_0000");
      check_interrupts("off again", '0', '0');
      wait for 12 * bit_time;
    end procedure;

    procedure interrupts_at_the_end_of_a_line is
    begin
      bus_read(clk, request, response, line_ends, word);
      line_feed_and_carriage_return_are_line_ends : assert word = x"0000" & carriage_return & line_feed
        severity error;
      bus_write(clk, request, response, interrupts, x"0000_1000");
      send_byte(sent, x"4D", bit_time);
      send_byte(sent, x"35", bit_time);
      check_line("within a line", '0', '0');
      send_byte(sent, line_feed, bit_time);
      check_line("at its end", '1', '1');
      send_byte(sent, x"47", bit_time);
      send_byte(sent, carriage_return, bit_time);
      send_byte(sent, x"54", bit_time);
      check_data(clk, request, response, x"4D");
      check_data(clk, request, response, x"35");
      check_line("its end has not been read", '1', '1');
      check_data(clk, request, response, line_feed);
      check_line("another line waits", '1', '1');
      check_data(clk, request, response, x"47");
      check_data(clk, request, response, carriage_return);
      check_line("the beginning of a line is left", '0', '0');
      check_data(clk, request, response, x"54");
      check_no_data(clk, request, response);
      check_line("all read", '0', '0');
      -- Either reason is enough.
      bus_write(clk, request, response, interrupts, x"0000_1002");
      send_byte(sent, line_feed, bit_time);
      check_line("a line of one byte", '1', '1');
      check_data(clk, request, response, line_feed);
      send_byte(sent, x"01", bit_time);
      check_line("a byte", '0', '0');
      send_byte(sent, x"02", bit_time);
      check_line("as many bytes as asked for", '1', '0');
      check_data(clk, request, response, x"01");
      check_data(clk, request, response, x"02");
      -- Not asked for, but to be seen.
      bus_write(clk, request, response, interrupts, x"0000_0000");
      send_byte(sent, line_feed, bit_time);
      check_line("not asked for", '0', '1');
      bus_write(clk, request, response, interrupts, x"0000_1000");
      check_line("asked for when it was there", '1', '1');
      check_data(clk, request, response, line_feed);
    end procedure;

    procedure ends_lines_with_other_bytes is
    begin
      send_byte(sent, line_feed, bit_time);
      bus_write(clk, request, response, line_ends, x"0000_3B3B");
      check_line("a line end when it came", '1', '1');
      check_data(clk, request, response, line_feed);
      send_byte(sent, line_feed, bit_time);
      send_byte(sent, carriage_return, bit_time);
      check_line("line ends no more", '0', '0');
      send_byte(sent, x"3B", bit_time);
      check_line("a line end now", '1', '1');
      check_data(clk, request, response, line_feed);
      check_data(clk, request, response, carriage_return);
      check_data(clk, request, response, x"3B");
      check_line("all read", '0', '0');
      bus_write(clk, request, response, line_ends, x"0000" & carriage_return & line_feed);
    end procedure;

    -- Nothing can be read of a line end that was lost, so it must not wake; the full queue itself may.
    procedure forgets_line_ends_that_are_lost is
    begin
      for i in 1 to receive_depth loop
        send_byte(sent, x"31", bit_time);
      end loop;
      send_byte(sent, line_feed, bit_time);
      check_line("the line end is lost", '0', '0');
      bus_write(clk, request, response, clear, x"00000001");
      check_data(clk, request, response, x"31");
      send_byte(sent, line_feed, bit_time);
      check_line("this one had room", '1', '1');
      for i in 2 to receive_depth loop
        check_data(clk, request, response, x"31");
      end loop;
      check_line("only the line end is left", '1', '1');
      check_data(clk, request, response, line_feed, after_a_gap => '1');
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
      bus_write(clk, request, response, clear, x"00000006");
      send_byte(sent, x"32", bit_time);
      wait for 2 * bit_time;
      check_data(clk, request, response, x"32", after_a_gap => '1');
      bus_write(clk, request, response, interrupts, x"0000_0000");
    end procedure;
  begin
    wait for 5 * clock_period;
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    bus_write(clk, request, response, baud_rate, word_t(increment_for(clocks_per_bit)));
    wait for 12 * bit_time;
    interrupts_at_its_thresholds;
    interrupts_at_the_end_of_a_line;
    ends_lines_with_other_bytes;
    forgets_line_ends_that_are_lost;
    bus_write(clk, request, response, interrupts, x"0000_1000");
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
