-- SPDX-License-Identifier: Apache-2.0
-- Specification of extension Zbb for the proofs: its instructions and their results. Independent of decoder
-- and execution units.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

package bit_manipulation_pkg is

  type manipulation_t is (
    none, and_not, or_not, exclusive_nor, leading_zeros, trailing_zeros, population, maximum,
    maximum_unsigned, minimum, minimum_unsigned, extend_byte, extend_half, zero_extend_half,
    rotate_left, rotate_right, combine_bytes, reverse_bytes);

  function manipulation_of(word : value_t) return manipulation_t;
  function is_bit_manipulation(word : value_t) return boolean;
  -- `second` is the content of rs2; rori has its shift amount in the word.
  function manipulated(word, first, second : value_t) return value_t;

end package;

package body bit_manipulation_pkg is

  function manipulation_of(word : value_t) return manipulation_t is
    variable code : std_ulogic_vector(14 downto 0);
  begin
    -- Upper 12 bits and funct3.
    code := word(31 downto 20) & word(14 downto 12);
    if word(6 downto 0) = "0010011" then
      case code is
        when x"600" & "001" => return leading_zeros;
        when x"601" & "001" => return trailing_zeros;
        when x"602" & "001" => return population;
        when x"604" & "001" => return extend_byte;
        when x"605" & "001" => return extend_half;
        when x"287" & "101" => return combine_bytes;
        when x"698" & "101" => return reverse_bytes;
        when others => null;
      end case;
      if word(31 downto 25) = "0110000" and word(14 downto 12) = "101" then
        return rotate_right;
      end if;
    elsif word(6 downto 0) = "0110011" then
      case word(31 downto 25) & word(14 downto 12) is
        when "0100000" & "111" => return and_not;
        when "0100000" & "110" => return or_not;
        when "0100000" & "100" => return exclusive_nor;
        when "0000101" & "100" => return minimum;
        when "0000101" & "101" => return minimum_unsigned;
        when "0000101" & "110" => return maximum;
        when "0000101" & "111" => return maximum_unsigned;
        when "0110000" & "001" => return rotate_left;
        when "0110000" & "101" => return rotate_right;
        when others => null;
      end case;
      if code = x"080" & "100" then
        return zero_extend_half;
      end if;
    end if;
    return none;
  end function;

  function is_bit_manipulation(word : value_t) return boolean is
  begin
    return manipulation_of(word) /= none;
  end function;

  function count_from(value : value_t; above : boolean) return value_t is
    variable count : natural range 0 to 32;
    variable bit : std_ulogic;
    variable ended : boolean;
  begin
    count := 0;
    ended := false;
    for index in 0 to 31 loop
      bit := value(31 - index) when above else value(index);
      ended := ended or bit = '1';
      if not ended then
        count := index + 1;
      end if;
    end loop;
    return std_ulogic_vector(to_unsigned(count, 32));
  end function;

  function ones_in(value : value_t) return value_t is
    variable count : unsigned(5 downto 0);
  begin
    count := (others => '0');
    for index in value'range loop
      if value(index) = '1' then
        count := count + 1;
      end if;
    end loop;
    return 26x"0" & std_ulogic_vector(count);
  end function;

  function rotated_right(value : value_t; distance : std_ulogic_vector(4 downto 0)) return value_t is
    variable result : value_t;
  begin
    result := value;
    for step in 0 to 4 loop
      if distance(step) = '1' then
        result := result(2 ** step - 1 downto 0) & result(31 downto 2 ** step);
      end if;
    end loop;
    return result;
  end function;

  function manipulated(word, first, second : value_t) return value_t is
    variable result : value_t;
    variable distance : std_ulogic_vector(4 downto 0);
  begin
    result := first;
    case manipulation_of(word) is
      when and_not => result := first and not second;
      when or_not => result := first or not second;
      when exclusive_nor => result := not (first xor second);
      when leading_zeros => result := count_from(first, true);
      when trailing_zeros => result := count_from(first, false);
      when population => result := ones_in(first);
      when maximum =>
        if signed(first) < signed(second) then
          result := second;
        end if;
      when maximum_unsigned =>
        if unsigned(first) < unsigned(second) then
          result := second;
        end if;
      when minimum =>
        if signed(second) < signed(first) then
          result := second;
        end if;
      when minimum_unsigned =>
        if unsigned(second) < unsigned(first) then
          result := second;
        end if;
      when extend_byte => result := (31 downto 8 => first(7)) & first(7 downto 0);
      when extend_half => result := (31 downto 16 => first(15)) & first(15 downto 0);
      when zero_extend_half => result := x"0000" & first(15 downto 0);
      when rotate_left =>
        result := rotated_right(first, std_ulogic_vector(0 - unsigned(second(4 downto 0))));
      when rotate_right =>
        distance := second(4 downto 0) when word(5) = '1' else word(24 downto 20);
        result := rotated_right(first, distance);
      when combine_bytes =>
        for index in 0 to 3 loop
          if first(8 * index + 7 downto 8 * index) = x"00" then
            result(8 * index + 7 downto 8 * index) := x"00";
          else
            result(8 * index + 7 downto 8 * index) := x"ff";
          end if;
        end loop;
      when reverse_bytes =>
        result := first(7 downto 0) & first(15 downto 8) & first(23 downto 16) & first(31 downto 24);
      when none => null;
    end case;
    return result;
  end function;

end package body;
