-- SPDX-License-Identifier: Apache-2.0
-- The transmitter's every edge comes at its exact time, to less than one clock, also over many bytes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.serial_line_pkg.all;

entity uart_transmitter_tb is
end entity;

architecture simulation of uart_transmitter_tb is

  constant clock_period : time := 10 ns;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal increment : unsigned(31 downto 0) := increment_for(4.0);
  signal data : byte_t := x"00";
  signal valid : std_ulogic := '0';
  signal taken : std_ulogic;
  signal busy : std_ulogic;
  signal transmit : std_ulogic;

  signal bytes_taken : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  transmitter : entity work.uart_transmitter
    port map (
      clk => clk, reset => reset, increment => increment, data => data, valid => valid,
      taken => taken, busy => busy, transmit => transmit);

  -- The source: the test sequence, always the byte after those that were taken.
  supply : process
  begin
    wait until rising_edge(clk);
    if reset then
      bytes_taken <= 0;
    elsif taken then
      bytes_taken <= bytes_taken + 1;
    end if;
  end process;
  data <= test_byte(bytes_taken);

  check : process
    type rates_t is array (natural range <>) of real;
    constant rates : rates_t := (4.0, 4.34, 5.0, 16.67, 434.03);
    constant count : positive := 50;
    variable bit_time : time;
    variable begun : time;
    variable first_bit : natural;
    variable expected : std_ulogic;
    variable earlier : time;
  begin
    for rate in rates'range loop
      reset <= '1';
      valid <= '0';
      increment <= increment_for(rates(rate));
      -- Of the rounded increment.
      bit_time := clock_period * (2.0 ** 32 / real(to_integer(increment_for(rates(rate)))));
      wait for 5 * clock_period;
      reset <= '0';
      wait for 5 * clock_period;
      is_idle_high : assert transmit = '1' and busy = '0' report "not idle" severity error;

      valid <= '1';
      wait until falling_edge(transmit);
      begun := now;
      for index in 0 to count - 1 loop
        for position in 0 to 9 loop
          case position is
            when 0 => expected := '0';
            when 9 => expected := '1';
            when others => expected := test_byte(index)(position - 1);
          end case;
          -- From a clock after the bit's exact beginning to just before its exact end.
          first_bit := index * 10 + position;
          earlier := begun + bit_time * first_bit;
          wait for earlier + clock_period + 1 ps - now;
          has_the_level_from_its_time : assert transmit = expected and busy = '1'
            report "bit " & to_string(position) & " of byte " & to_string(index)
              & " late at " & to_string(rates(rate), 2) severity error;
          wait for bit_time - clock_period - 2 ps;
          keeps_the_level_to_its_time : assert transmit = expected and busy = '1'
            report "bit " & to_string(position) & " of byte " & to_string(index)
              & " ends early at " & to_string(rates(rate), 2) severity error;
        end loop;
        if index = count - 2 then
          -- The last byte has been on offer since this one began.
          valid <= '0' after bit_time;
        end if;
      end loop;
      wait for bit_time * 5.0;
      sends_what_was_taken : assert bytes_taken = count and busy = '0' and transmit = '1'
        report to_string(bytes_taken) & " bytes taken" severity error;
    end loop;

    -- A pause between bytes: the next one begins on time, whatever the phase was.
    for pause in 0 to 20 loop
      valid <= '1';
      wait until rising_edge(taken);
      valid <= '0';
      wait until busy = '0';
      wait for pause * clock_period;
      stays_idle : assert transmit = '1' report "not idle" severity error;
    end loop;

    valid <= '1';
    wait until falling_edge(transmit);
    reset <= '1';
    wait until rising_edge(clk);
    wait until falling_edge(clk);
    releases_the_line_at_reset : assert transmit = '1' and busy = '0'
      report "still sending" severity error;
    std.env.finish;
  end process;

end architecture;
