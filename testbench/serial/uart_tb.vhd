-- SPDX-License-Identifier: Apache-2.0
-- The serial line as software sees it: FIFOs, flags and counters, over the bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.serial_line_pkg.all;
use work.uart_bench_pkg.all;
use work.uart_registers_pkg.all;

entity uart_tb is
end entity;

architecture simulation of uart_tb is

  constant overruns : unsigned(31 downto 0) := uart_overruns_address;
  constant framing_errors : unsigned(31 downto 0) := uart_framing_errors_address;
  constant breaks : unsigned(31 downto 0) := uart_breaks_address;
  constant noisy_bytes : unsigned(31 downto 0) := uart_noisy_bytes_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal transmit : std_ulogic;

  -- The line comes from the bench or, looped back, from the transmitter.
  signal looped_back : boolean := false;
  signal sent : std_ulogic := '1';
  signal receive : std_ulogic;

  alias clk is master.clk;

begin

  make_clock(master.clk, clock_period);
  receive <= transmit when looped_back else sent;

  uart : entity work.uart
    generic map (receive_depth => receive_depth, transmit_depth => transmit_depth)
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, receive => receive, transmit => transmit,
      receive_interrupt => open, transmit_interrupt => open);

  check : process
    variable word : word_t;
    variable seen : uart_status_t;
    variable before : natural;

    procedure check_status (
      what : string; receive_level, transmit_space : natural;
      transmit_idle, overrun, framing_error, break_condition : std_ulogic) is
    begin
      read(master, status, word);
      seen := to_uart_status(word);
      status_is_as_expected : assert seen.receive_level = receive_level
        and seen.transmit_space = transmit_space and seen.transmit_idle = transmit_idle
        and seen.overrun = overrun and seen.framing_error = framing_error
        and seen.break_condition = break_condition and to_word(seen) = word
        report what & ": status " & to_hstring(word) severity error;
    end procedure;

    procedure check_count (what : string; address : unsigned(31 downto 0); expected : natural) is
    begin
      read(master, address, word);
      count_is_as_expected : assert unsigned(word) = expected
        report what & ": " & to_hstring(word) severity error;
    end procedure;

    procedure is_off_until_it_has_a_speed is
    begin
      check_status("after reset", 0, transmit_depth, '1', '0', '0', '0');
      send_byte(sent, x"55", bit_time);
      write(master, data, x"00000041");
      wait for 20 * bit_time;
      check_status("without a speed", 0, transmit_depth - 1, '0', '0', '0', '0');
      waits_with_sending : assert transmit = '1' report "sends without a speed" severity error;
      expect_no_byte(master);
    end procedure;

    procedure sends_and_receives_through_the_fifos is
    begin
      looped_back <= true;
      write(master, baud_rate, word_t(increment_for(clocks_per_bit)));
      wait for 12 * bit_time;
      expect_byte(master, x"41");
      expect_no_byte(master);
      for i in 0 to 5 loop
        write(master, data, x"000000" & test_byte(i));
      end loop;
      wait for 70 * bit_time;
      check_status("after six bytes", 6, transmit_depth, '1', '0', '0', '0');
      for i in 0 to 5 loop
        expect_byte(master, test_byte(i));
      end loop;
      expect_no_byte(master);
    end procedure;

    procedure drops_what_has_no_space is
    begin
      -- One byte goes on the line at once, so one more than the depth fits.
      for i in 0 to transmit_depth + 3 loop
        write(master, data, x"000000" & test_byte(i));
      end loop;
      check_status("full", 0, 0, '0', '0', '0', '0');
      wait for (transmit_depth + 4) * 10 * bit_time;
      check_status("sent", transmit_depth + 1, transmit_depth, '1', '0', '0', '0');
      for i in 0 to transmit_depth loop
        expect_byte(master, test_byte(i));
      end loop;
      expect_no_byte(master);
    end procedure;

    procedure counts_and_flags_overruns is
    begin
      looped_back <= false;
      for i in 0 to receive_depth + 2 loop
        send_byte(sent, test_byte(i), bit_time);
      end loop;
      wait for 5 * clock_period;
      check_status("overrun", receive_depth, transmit_depth, '1', '1', '0', '0');
      check_count("overruns", overruns, 3);
      -- Clearing another flag leaves it.
      write(master, clear, clear_word(framing_error => '1', break_condition => '1'));
      check_status("not cleared", receive_depth, transmit_depth, '1', '1', '0', '0');
      write(master, clear, clear_word(overrun => '1'));
      check_status("cleared", receive_depth, transmit_depth, '1', '0', '0', '0');
      check_count("overruns", overruns, 3);
      for i in 0 to receive_depth - 1 loop
        expect_byte(master, test_byte(i));
      end loop;
      expect_no_byte(master);
    end procedure;

    procedure counts_and_flags_line_errors is
    begin
      send_byte(sent, x"41", bit_time, stop_level => '0');
      sent <= '1';
      wait for 2 * bit_time;
      check_status("framing error", 0, transmit_depth, '1', '0', '1', '0');
      sent <= '0';
      wait for 30 * bit_time;
      sent <= '1';
      wait for 2 * bit_time;
      check_status("break", 0, transmit_depth, '1', '0', '1', '1');
      write(master, clear, clear_word(framing_error => '1'));
      check_status("one cleared", 0, transmit_depth, '1', '0', '0', '1');
      write(master, clear, clear_word(break_condition => '1'));
      check_status("both cleared", 0, transmit_depth, '1', '0', '0', '0');
      check_count("framing errors", framing_errors, 1);
      check_count("breaks", breaks, 1);
      -- A loss is marked at the byte after it, and only there.
      send_byte(sent, x"42", bit_time);
      send_byte(sent, x"43", bit_time);
      wait for 2 * bit_time;
      expect_byte(master, x"42", after_a_gap => '1');
      expect_byte(master, x"43");
    end procedure;

    procedure marks_the_byte_behind_an_overrun is
    begin
      for i in 0 to receive_depth + 2 loop
        send_byte(sent, test_byte(i), bit_time);
      end loop;
      wait for 5 * clock_period;
      expect_byte(master, test_byte(0));
      send_byte(sent, x"44", bit_time);
      wait for 5 * clock_period;
      for i in 1 to receive_depth - 1 loop
        expect_byte(master, test_byte(i));
      end loop;
      expect_byte(master, x"44", after_a_gap => '1');
      expect_no_byte(master);
      write(master, clear, clear_word(overrun => '1'));
    end procedure;

    procedure flags_and_counts_noisy_bytes is
      constant long_bit_time : time := 16 * clock_period;
    begin
      write(master, clear, clear_word(noise => '1'));
      write(master, baud_rate, word_t(increment_for(16.0)));
      wait for 5 * clock_period;
      read(master, noisy_bytes, word);
      before := to_integer(unsigned(word));
      send_byte(sent, x"A5", long_bit_time);
      wait for long_bit_time;
      read(master, status, word);
      a_clean_byte_is_not_noisy : assert word(uart_status_noise_bit) = '0' severity error;
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
      read(master, status, word);
      noise_is_flagged : assert word(uart_status_noise_bit) = '1' severity error;
      check_count("noisy bytes", noisy_bytes, before + 1);
      expect_byte(master, x"A5");
      expect_byte(master, x"FE");
      write(master, clear, clear_word(noise => '1'));
      read(master, status, word);
      noise_is_cleared : assert word(uart_status_noise_bit) = '0' severity error;
      write(master, baud_rate, word_t(increment_for(clocks_per_bit)));
    end procedure;

    -- Software polls in every phase to the arrival of bytes.
    procedure loses_no_byte_to_a_poll_at_the_wrong_time is
      variable received : natural;
    begin
      looped_back <= true;
      for delay in 0 to 11 loop
        for i in 0 to 3 loop
          write(master, data, x"000000" & test_byte(i));
        end loop;
        wait for delay * clock_period;
        received := 0;
        for poll in 1 to 200 loop
          read(master, data, word);
          if word(uart_data_valid_bit) then
            gets_each_byte : assert word(uart_data_byte_bits) = test_byte(received)
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
    looped_back <= false;
    send_byte(sent, line_feed, bit_time);
    wait for 6 * clock_period;
    check_status("before the reset", 1, transmit_depth, '1', '0', '0', '0');
    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    check_status("after reset", 0, transmit_depth, '1', '0', '0', '0');
    check_count("overruns", overruns, 0);
    check_count("framing errors", framing_errors, 0);
    check_count("breaks", breaks, 0);
    check_count("noisy bytes", noisy_bytes, 0);
    std.env.finish;
  end process;

end architecture;
