-- SPDX-License-Identifier: Apache-2.0
-- The receiver gets every byte of a sender 3 % too fast or slow, from 4 clocks per bit on; noise,
-- missing stop bits and breaks are distinguished from bytes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.serial_line_pkg.all;

entity uart_receiver_tb is
end entity;

architecture simulation of uart_receiver_tb is

  constant clock_period : time := 10 ns;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal increment : unsigned(31 downto 0) := increment_for(4.0);
  signal receive : std_ulogic := '1';
  signal valid : std_ulogic;
  signal noisy : std_ulogic;
  signal framing_error : std_ulogic;
  signal break_condition : std_ulogic;
  signal data : byte_t;

  -- What has been received since reset.
  signal bytes : natural := 0;
  signal framing_errors : natural := 0;
  signal breaks : natural := 0;
  signal noisy_bytes : natural := 0;
  signal last_byte : byte_t := x"00";
  -- Bytes of the test sequence are checked where they arrive.
  signal expect_sequence : boolean := false;

begin

  clk <= not clk after clock_period / 2;

  receiver : entity work.uart_receiver
    port map (
      clk => clk, reset => reset, increment => increment, receive => receive, valid => valid,
      noisy => noisy, framing_error => framing_error, break_condition => break_condition, data => data);

  watch : process
  begin
    wait until rising_edge(clk);
    if reset then
      bytes <= 0;
      framing_errors <= 0;
      breaks <= 0;
      noisy_bytes <= 0;
    else
      if valid and noisy then
        noisy_bytes <= noisy_bytes + 1;
      end if;
      if valid then
        bytes <= bytes + 1;
        last_byte <= data;
        gets_the_byte_that_was_sent : assert not expect_sequence or data = test_byte(bytes)
          report "byte " & to_string(bytes) & " is " & to_hstring(data) & ", not "
            & to_hstring(test_byte(bytes)) & ", with increment " & to_hstring(increment)
          severity error;
      end if;
      if framing_error then
        framing_errors <= framing_errors + 1;
      end if;
      if break_condition then
        breaks <= breaks + 1;
      end if;
    end if;
  end process;

  check : process
    variable bit_time : time;

    procedure start (clocks_per_bit : real) is
    begin
      bit_time := clock_period * clocks_per_bit;
      receive <= '1';
      reset <= '1';
      increment <= increment_for(clocks_per_bit);
      expect_sequence <= false;
      wait for 6 * clock_period;
      reset <= '0';
      wait for 2 * clock_period;
    end procedure;

    procedure check_counts (what : string; expected_bytes, expected_framing_errors,
      expected_breaks : natural) is
    begin
      counts_are_as_expected : assert bytes = expected_bytes
        and framing_errors = expected_framing_errors and breaks = expected_breaks
        report what & " at increment " & to_hstring(increment) & ": " & to_string(bytes)
          & " bytes, " & to_string(framing_errors) & " framing errors, " & to_string(breaks)
          & " breaks" severity error;
    end procedure;

    -- Bytes without a gap from a sender whose bits are `deviation` longer, at several phases to clk.
    procedure receives_a_stream (clocks_per_bit, deviation : real) is
      -- Where bits are long, a part of a clock and what adds up over frames are of little matter.
      constant count : positive := 6 + integer(100.0 / clocks_per_bit);
      constant phases : positive := 2 + integer(100.0 / clocks_per_bit);
      variable sent_bit_time : time;
    begin
      for phase in 0 to phases - 1 loop
        start(clocks_per_bit);
        expect_sequence <= true;
        sent_bit_time := bit_time * (1.0 + deviation);
        wait until rising_edge(clk);
        wait for clock_period * (real(phase) / real(phases) + 0.013);
        for i in 0 to count - 1 loop
          send_byte(receive, test_byte(i), sent_bit_time);
        end loop;
        wait for 2 * bit_time + 5 * clock_period;
        check_counts("stream of deviation " & to_string(deviation, 3), count, 0, 0);
        a_difference_of_clocks_is_no_noise : assert noisy_bytes = 0 or clocks_per_bit < 16.0
          report "noise at " & to_string(clocks_per_bit, 2) & " clocks per bit" severity error;
      end loop;
    end procedure;

    procedure ignores_noise_on_an_idle_line (clocks_per_bit : real) is
      variable longest : positive;
      variable clocks : positive := 1;
    begin
      start(clocks_per_bit);
      -- Up to nearly half a bit, at most what leaves the middle of the start bit high.
      longest := maximum(1, integer(clocks_per_bit * 0.4) - 1);
      while clocks <= longest loop
        receive <= '0';
        wait for clocks * clock_period;
        receive <= '1';
        wait for 12 * bit_time;
        clocks := clocks + 1 + clocks / 4;
      end loop;
      check_counts("noise", 0, 0, 0);
      -- A byte right after noise.
      receive <= '0';
      wait for clock_period;
      receive <= '1';
      wait for maximum(bit_time / 12, clock_period);
      send_byte(receive, x"A5", bit_time);
      wait for 2 * bit_time + 5 * clock_period;
      check_counts("byte after noise", 1, 0, 0);
      noise_does_not_change_the_byte : assert last_byte = x"A5"
        report "received " & to_hstring(last_byte) severity error;
    end procedure;

    -- Every bit of the frame is wrong for `noise` somewhere near its middle.
    procedure outvotes_noise_within_bits (clocks_per_bit : real; noise : time) is
      constant frame : std_ulogic_vector(0 to 9) := "0011010011";
    begin
      start(clocks_per_bit);
      for position in 0 to 8 loop
        for i in frame'range loop
          receive <= frame(i);
          wait for bit_time * (0.4 + 0.02 * real(position));
          receive <= not frame(i);
          wait for noise;
          receive <= frame(i);
          wait for bit_time * (0.6 - 0.02 * real(position)) - noise;
        end loop;
        wait for bit_time;
        check_counts("noise in a byte", position + 1, 0, 0);
        noise_is_outvoted : assert last_byte = x"96"
          report "received " & to_hstring(last_byte) severity error;
      end loop;
      noise_is_reported : assert noisy_bytes /= 0 severity error;
    end procedure;

    procedure distinguishes_errors_from_bytes (clocks_per_bit : real) is
    begin
      start(clocks_per_bit);
      send_byte(receive, x"41", bit_time, stop_level => '0');
      receive <= '1';
      wait for 2 * bit_time;
      check_counts("missing stop bit", 0, 1, 0);
      send_byte(receive, x"42", bit_time);
      wait for 2 * bit_time;
      check_counts("byte after a missing stop bit", 1, 1, 0);
      receive <= '0';
      wait for 35 * bit_time;
      check_counts("long break", 1, 1, 1);
      receive <= '1';
      wait for 2 * bit_time;
      send_byte(receive, x"00", bit_time);
      send_byte(receive, x"FF", bit_time);
      wait for 2 * bit_time;
      check_counts("bytes after a break", 3, 1, 1);
    end procedure;

    type rates_t is array (natural range <>) of real;
    constant rates : rates_t := (
      4.0, 4.5, 5.0, 6.0, 7.4, 8.68, 15.9, 16.0, 16.1, 17.36, 43.4, 434.03);
  begin
    for rate in rates'range loop
      receives_a_stream(rates(rate), 0.0);
      receives_a_stream(rates(rate), 0.03);
      receives_a_stream(rates(rate), -0.03);
      ignores_noise_on_an_idle_line(rates(rate));
      distinguishes_errors_from_bytes(rates(rate));
    end loop;
    -- Between 4 and 4.4 clocks per bit, where samples cannot be placed well, a little less is left.
    for tenths in 41 to 44 loop
      receives_a_stream(real(tenths) / 10.0, 0.025);
      receives_a_stream(real(tenths) / 10.0, -0.025);
    end loop;
    outvotes_noise_within_bits(10.0, clock_period);
    outvotes_noise_within_bits(64.0, clock_period);
    outvotes_noise_within_bits(434.0, 20 * clock_period);
    std.env.finish;
  end process;

end architecture;
