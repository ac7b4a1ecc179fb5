-- SPDX-License-Identifier: Apache-2.0
-- Specification of extension C for the proofs: the 32-bit expansion of a compressed instruction.

library ieee;
use ieee.std_logic_1164.all;

package short_instructions_pkg is

  -- Zero, which is illegal, if the half word is no instruction.
  function expanded(half : std_ulogic_vector(15 downto 0)) return std_ulogic_vector;

end package;

package body short_instructions_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);
  subtype index_t is std_ulogic_vector(4 downto 0);

  constant zero : index_t := "00000";
  constant link : index_t := "00001";
  constant stack : index_t := "00010";

  function format_i(opcode : std_ulogic_vector(6 downto 0); funct3 : std_ulogic_vector(2 downto 0);
                    rd, rs1 : index_t; value : std_ulogic_vector(11 downto 0)) return word_t is
  begin
    return value & rs1 & funct3 & rd & opcode;
  end function;

  function format_r(funct7 : std_ulogic_vector(6 downto 0); funct3 : std_ulogic_vector(2 downto 0);
                    rd, rs1, rs2 : index_t) return word_t is
  begin
    return funct7 & rs2 & rs1 & funct3 & rd & "0110011";
  end function;

  function format_s(rs1, rs2 : index_t; value : std_ulogic_vector(11 downto 0)) return word_t is
  begin
    return value(11 downto 5) & rs2 & rs1 & "010" & value(4 downto 0) & "0100011";
  end function;

  function jump(rd : index_t; value : std_ulogic_vector(11 downto 1)) return word_t is
  begin
    return value(11) & value(10 downto 1) & value(11) & (7 downto 0 => value(11)) & rd & "1101111";
  end function;

  -- c.beqz, c.bnez: offset[8|4:3|7:6|2:1|5].
  function branch(funct3 : std_ulogic_vector(2 downto 0); rs1 : index_t;
                  value : std_ulogic_vector(8 downto 1)) return word_t is
  begin
    return (3 downto 0 => value(8)) & value(7 downto 5) & zero & rs1 & funct3 & value(4 downto 1) &
           value(8) & "1100011";
  end function;

  function expanded(half : std_ulogic_vector(15 downto 0)) return std_ulogic_vector is
    variable selector : std_ulogic_vector(4 downto 0);
    variable upper, lower, upper_short, lower_short : index_t;
    variable small : std_ulogic_vector(11 downto 0);
    variable result : word_t;
  begin
    upper := half(11 downto 7);
    lower := half(6 downto 2);
    upper_short := "01" & half(9 downto 7);
    lower_short := "01" & half(4 downto 2);
    small := (11 downto 5 => half(12)) & half(6 downto 2);
    result := x"00000000";
    selector := half(1 downto 0) & half(15 downto 13);
    case selector is
      when "00000" =>  -- c.addi4spn: nzuimm[5:4|9:6|2|3]
        if half(12 downto 5) /= "00000000" then
          result := format_i("0010011", "000", lower_short, stack,
                             "00" & half(10 downto 7) & half(12 downto 11) & half(5) & half(6) & "00");
        end if;
      when "00010" =>  -- c.lw: uimm[5:3], uimm[2|6]
        result := format_i("0000011", "010", lower_short, upper_short,
                           "00000" & half(5) & half(12 downto 10) & half(6) & "00");
      when "00110" =>  -- c.sw
        result := format_s(upper_short, lower_short,
                           "00000" & half(5) & half(12 downto 10) & half(6) & "00");
      when "01000" =>  -- c.addi, c.nop
        result := format_i("0010011", "000", upper, upper, small);
      when "01001" | "01101" =>  -- c.jal, c.j: offset[11|4|9:8|10|6|7|3:1|5]
        result := jump((link and (4 downto 0 => not half(15))),
                       half(12) & half(8) & half(10 downto 9) & half(6) & half(7) & half(2) & half(11) &
                       half(5 downto 3));
      when "01010" =>  -- c.li
        result := format_i("0010011", "000", upper, zero, small);
      when "01011" =>
        if half(12) = '1' or half(6 downto 2) /= "00000" then
          if upper = stack then  -- c.addi16sp: nzimm[9], nzimm[4|6|8:7|5]
            result := format_i("0010011", "000", stack, stack,
                               (11 downto 9 => half(12)) & half(4 downto 3) & half(5) & half(2) & half(6) &
                               "0000");
          else  -- c.lui
            result := (31 downto 17 => half(12)) & half(6 downto 2) & upper & "0110111";
          end if;
        end if;
      when "01100" =>
        case half(11 downto 10) is
          when "00" | "01" =>  -- c.srli, c.srai
            if half(12) = '0' then
              result := format_i("0010011", "101", upper_short, upper_short,
                                 '0' & half(10) & "00000" & lower);
            end if;
          when "10" =>  -- c.andi
            result := format_i("0010011", "111", upper_short, upper_short, small);
          when others =>
            if half(12) = '0' then
              case half(6 downto 5) is
                when "00" => result := format_r("0100000", "000", upper_short, upper_short, lower_short);
                when "01" => result := format_r("0000000", "100", upper_short, upper_short, lower_short);
                when "10" => result := format_r("0000000", "110", upper_short, upper_short, lower_short);
                when others => result := format_r("0000000", "111", upper_short, upper_short, lower_short);
              end case;
            end if;
        end case;
      when "01110" =>
        result := branch("000", upper_short, half(12) & half(6 downto 5) & half(2) & half(11 downto 10) &
                         half(4 downto 3));
      when "01111" =>
        result := branch("001", upper_short, half(12) & half(6 downto 5) & half(2) & half(11 downto 10) &
                         half(4 downto 3));
      when "10000" =>  -- c.slli
        if half(12) = '0' then
          result := format_i("0010011", "001", upper, upper, "0000000" & lower);
        end if;
      when "10010" =>  -- c.lwsp: uimm[5], uimm[4:2|7:6]
        if upper /= zero then
          result := format_i("0000011", "010", upper, stack,
                             "0000" & half(3 downto 2) & half(12) & half(6 downto 4) & "00");
        end if;
      when "10100" =>
        if lower /= zero then  -- c.mv, c.add
          result := format_r("0000000", "000", upper, upper and (4 downto 0 => half(12)), lower);
        elsif upper /= zero then  -- c.jr, c.jalr
          result := format_i("1100111", "000", link and (4 downto 0 => half(12)), upper, x"000");
        elsif half(12) = '1' then
          result := x"00100073";
        end if;
      when "10110" =>  -- c.swsp: uimm[5:2|7:6]
        result := format_s(stack, lower, "0000" & half(8 downto 7) & half(12 downto 9) & "00");
      when others => null;
    end case;
    return result;
  end function;

end package body;
