-- SPDX-License-Identifier: Apache-2.0
-- A serial line as a test bench drives it: frames with exact times, independent of any clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package serial_line_pkg is

  subtype byte_t is std_ulogic_vector(7 downto 0);

  -- The rate register's value: bits per clock in 2**-32.
  function increment_for (clocks_per_bit : real) return unsigned;

  -- One frame, start bit first; returns at the end of the stop bit.
  procedure send_byte (
    signal line_level : out std_ulogic;
    data : in byte_t;
    bit_time : in time;
    stop_level : in std_ulogic := '1');

  -- The byte number `index` of a sequence that mixes all values with the worst ones.
  function test_byte (index : natural) return byte_t;

end package;

package body serial_line_pkg is

  function increment_for (clocks_per_bit : real) return unsigned is
  begin
    return to_unsigned(integer(2.0 ** 32 / clocks_per_bit), 32);
  end function;

  procedure send_byte (
    signal line_level : out std_ulogic;
    data : in byte_t;
    bit_time : in time;
    stop_level : in std_ulogic := '1') is
  begin
    line_level <= '0';
    wait for bit_time;
    for i in 0 to 7 loop
      line_level <= data(i);
      wait for bit_time;
    end loop;
    line_level <= stop_level;
    wait for bit_time;
  end procedure;

  function test_byte (index : natural) return byte_t is
  begin
    case index mod 4 is
      when 0 => return byte_t(to_unsigned((index * 37) mod 256, 8));
      when 1 => return x"00";
      when 2 => return x"FF";
      when others => return byte_t(to_unsigned((index * 91 + 85) mod 256, 8));
    end case;
  end function;

end package body;
