-- SPDX-License-Identifier: Apache-2.0
-- Specification of loads and stores of bytes, half words and words for the proofs.
-- Independent of `data_access`.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

package data_width_pkg is

  function is_misaligned(word : value_t; address : unsigned(31 downto 0)) return boolean;
  function loaded(word, memory : value_t; address : unsigned(31 downto 0)) return value_t;
  function stored(word, memory, data : value_t; address : unsigned(31 downto 0)) return value_t;
  function lanes(word : value_t; address : unsigned(31 downto 0)) return std_ulogic_vector;

end package;

package body data_width_pkg is

  function is_misaligned(word : value_t; address : unsigned(31 downto 0)) return boolean is
  begin
    case word(13 downto 12) is
      when "00" => return false;
      when "01" => return address(0) = '1';
      when others => return address(1 downto 0) /= "00";
    end case;
  end function;

  function loaded(word, memory : value_t; address : unsigned(31 downto 0)) return value_t is
    variable half : std_ulogic_vector(15 downto 0);
    variable byte : std_ulogic_vector(7 downto 0);
    variable result : value_t;
  begin
    half := memory(31 downto 16) when address(1) = '1' else memory(15 downto 0);
    byte := half(15 downto 8) when address(0) = '1' else half(7 downto 0);
    case word(14 downto 12) is
      when "000" => result := std_ulogic_vector(resize(signed(byte), 32));
      when "001" => result := std_ulogic_vector(resize(signed(half), 32));
      when "100" => result := x"000000" & byte;
      when "101" => result := x"0000" & half;
      when others => result := memory;
    end case;
    return result;
  end function;

  function lanes(word : value_t; address : unsigned(31 downto 0)) return std_ulogic_vector is
    variable result : std_ulogic_vector(3 downto 0);
  begin
    case word(13 downto 12) is
      when "00" =>
        case address(1 downto 0) is
          when "00" => result := "0001";
          when "01" => result := "0010";
          when "10" => result := "0100";
          when others => result := "1000";
        end case;
      when "01" =>
        result := "1100" when address(1) = '1' else "0011";
      when others =>
        result := "1111";
    end case;
    return result;
  end function;

  function stored(word, memory, data : value_t; address : unsigned(31 downto 0)) return value_t is
    variable result : value_t;
  begin
    result := memory;
    case word(13 downto 12) is
      when "00" =>
        case address(1 downto 0) is
          when "00" => result(7 downto 0) := data(7 downto 0);
          when "01" => result(15 downto 8) := data(7 downto 0);
          when "10" => result(23 downto 16) := data(7 downto 0);
          when others => result(31 downto 24) := data(7 downto 0);
        end case;
      when "01" =>
        if address(1) = '1' then
          result(31 downto 16) := data(15 downto 0);
        else
          result(15 downto 0) := data(15 downto 0);
        end if;
      when others =>
        result := data;
    end case;
    return result;
  end function;

end package body;
