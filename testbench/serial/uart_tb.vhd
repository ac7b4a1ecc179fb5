-- SPDX-License-Identifier: Apache-2.0
-- The serial line as software sees it: FIFOs, flags and counters, over the bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.serial_line_pkg.all;
use work.uart_harness_pkg.all;

entity uart_tb is
end entity;

architecture simulation of uart_tb is

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
    variable before : natural;

    procedure is_off_until_it_has_a_speed is
    begin
      check_status(clk, request, response, "after reset", 0, transmit_depth, '1', '0', '0', '0');
      send_byte(sent, x"55", bit_time);
      bus_write(clk, request, response, data, x"00000041");
      wait for 20 * bit_time;
      check_status(clk, request, response, "without a speed", 0, transmit_depth - 1, '0', '0', '0', '0');
      waits_with_sending : assert transmit = '1' report "sends without a speed" severity error;
      check_no_data(clk, request, response);
    end procedure;

    procedure sends_and_receives_through_the_fifos is
    begin
      looped_back <= true;
      bus_write(clk, request, response, baud_rate, word_t(increment_for(clocks_per_bit)));
      wait for 12 * bit_time;
      check_data(clk, request, response, x"41");
      check_no_data(clk, request, response);
      for i in 0 to 5 loop
        bus_write(clk, request, response, data, x"000000" & test_byte(i));
      end loop;
      wait for 70 * bit_time;
      check_status(clk, request, response, "after six bytes", 6, transmit_depth, '1', '0', '0', '0');
      for i in 0 to 5 loop
        check_data(clk, request, response, test_byte(i));
      end loop;
      check_no_data(clk, request, response);
    end procedure;

    procedure drops_what_has_no_space is
    begin
      -- One byte goes on the line at once, so one more than the depth fits.
      for i in 0 to transmit_depth + 3 loop
        bus_write(clk, request, response, data, x"000000" & test_byte(i));
      end loop;
      check_status(clk, request, response, "full", 0, 0, '0', '0', '0', '0');
      wait for (transmit_depth + 4) * 10 * bit_time;
      check_status(clk, request, response, "sent", transmit_depth + 1, transmit_depth, '1', '0', '0', '0');
      for i in 0 to transmit_depth loop
        check_data(clk, request, response, test_byte(i));
      end loop;
      check_no_data(clk, request, response);
    end procedure;

    procedure counts_and_flags_overruns is
    begin
      looped_back <= false;
      for i in 0 to receive_depth + 2 loop
        send_byte(sent, test_byte(i), bit_time);
      end loop;
      wait for 5 * clock_period;
      check_status(clk, request, response, "overrun", receive_depth, transmit_depth, '1', '1', '0', '0');
      check_count(clk, request, response, "overruns", overruns, 3);
      -- Clearing another flag leaves it.
      bus_write(clk, request, response, clear, x"00000006");
      check_status(clk, request, response, "not cleared", receive_depth, transmit_depth, '1', '1', '0', '0');
      bus_write(clk, request, response, clear, x"00000001");
      check_status(clk, request, response, "cleared", receive_depth, transmit_depth, '1', '0', '0', '0');
      check_count(clk, request, response, "overruns", overruns, 3);
      for i in 0 to receive_depth - 1 loop
        check_data(clk, request, response, test_byte(i));
      end loop;
      check_no_data(clk, request, response);
    end procedure;

    procedure counts_and_flags_line_errors is
    begin
      send_byte(sent, x"41", bit_time, stop_level => '0');
      sent <= '1';
      wait for 2 * bit_time;
      check_status(clk, request, response, "framing error", 0, transmit_depth, '1', '0', '1', '0');
      sent <= '0';
      wait for 30 * bit_time;
      sent <= '1';
      wait for 2 * bit_time;
      check_status(clk, request, response, "break", 0, transmit_depth, '1', '0', '1', '1');
      bus_write(clk, request, response, clear, x"00000002");
      check_status(clk, request, response, "one cleared", 0, transmit_depth, '1', '0', '0', '1');
      bus_write(clk, request, response, clear, x"00000004");
      check_status(clk, request, response, "both cleared", 0, transmit_depth, '1', '0', '0', '0');
      check_count(clk, request, response, "framing errors", framing_errors, 1);
      check_count(clk, request, response, "breaks", breaks, 1);
      -- What was lost is marked at the byte behind it, and only there.
      send_byte(sent, x"42", bit_time);
      send_byte(sent, x"43", bit_time);
      wait for 2 * bit_time;
      check_data(clk, request, response, x"42", after_a_gap => '1');
      check_data(clk, request, response, x"43");
    end procedure;

    procedure marks_the_byte_behind_an_overrun is
    begin
      for i in 0 to receive_depth + 2 loop
        send_byte(sent, test_byte(i), bit_time);
      end loop;
      wait for 5 * clock_period;
      check_data(clk, request, response, test_byte(0));
      send_byte(sent, x"44", bit_time);
      wait for 5 * clock_period;
      for i in 1 to receive_depth - 1 loop
        check_data(clk, request, response, test_byte(i));
      end loop;
      check_data(clk, request, response, x"44", after_a_gap => '1');
      check_no_data(clk, request, response);
      bus_write(clk, request, response, clear, x"00000001");
    end procedure;

    procedure flags_and_counts_noisy_bytes is
      constant long_bit_time : time := 16 * clock_period;
    begin
      bus_write(clk, request, response, clear, x"00000008");
      bus_write(clk, request, response, baud_rate, word_t(increment_for(16.0)));
      wait for 5 * clock_period;
      bus_read(clk, request, response, noisy_bytes, word);
      before := to_integer(unsigned(word));
      send_byte(sent, x"A5", long_bit_time);
      wait for long_bit_time;
      bus_read(clk, request, response, status, word);
      a_clean_byte_is_not_noisy : assert word(28) = '0' severity error;
      -- The line falls for a clock in the middle of the first bit.
      sent <= '0';
      wait for long_bit_time + long_bit_time / 2;
      sent <= '1';
      wait for clock_period;
      sent <= '0';
      wait for long_bit_time / 2 - clock_period;
      for i in 1 to 7 loop
        sent <= '1';
        wait for long_bit_time;
      end loop;
      sent <= '1';
      wait for 2 * long_bit_time;
      bus_read(clk, request, response, status, word);
      noise_is_flagged : assert word(28) = '1' severity error;
      check_count(clk, request, response, "noisy bytes", noisy_bytes, before + 1);
      check_data(clk, request, response, x"A5");
      check_data(clk, request, response, x"FE");
      bus_write(clk, request, response, clear, x"00000008");
      bus_read(clk, request, response, status, word);
      noise_is_cleared : assert word(28) = '0' severity error;
      bus_write(clk, request, response, baud_rate, word_t(increment_for(clocks_per_bit)));
    end procedure;

    -- Software polls in every phase to the arrival of bytes.
    procedure loses_no_byte_to_a_poll_at_the_wrong_time is
      variable received : natural;
    begin
      looped_back <= true;
      for delay in 0 to 11 loop
        for i in 0 to 3 loop
          bus_write(clk, request, response, data, x"000000" & test_byte(i));
        end loop;
        wait for delay * clock_period;
        received := 0;
        for poll in 1 to 200 loop
          bus_read(clk, request, response, data, word);
          if word(8) then
            gets_each_byte : assert word(7 downto 0) = test_byte(received)
              report "poll got " & to_hstring(word) severity error;
            received := received + 1;
          end if;
        end loop;
        gets_all_bytes : assert received = 4 report to_string(received) & " bytes" severity error;
      end loop;
    end procedure;
  begin
    wait for 5 * clock_period;
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    is_off_until_it_has_a_speed;
    sends_and_receives_through_the_fifos;
    drops_what_has_no_space;
    counts_and_flags_overruns;
    counts_and_flags_line_errors;
    marks_the_byte_behind_an_overrun;
    flags_and_counts_noisy_bytes;
    loses_no_byte_to_a_poll_at_the_wrong_time;
    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    check_status(clk, request, response, "after another reset", 0, transmit_depth, '1', '0', '0', '0');
    check_count(clk, request, response, "overruns", overruns, 0);
    check_count(clk, request, response, "framing errors", framing_errors, 0);
    check_count(clk, request, response, "breaks", breaks, 0);
    check_count(clk, request, response, "noisy bytes", noisy_bytes, 0);
    std.env.finish;
  end process;

end architecture;
