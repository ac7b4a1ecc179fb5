-- SPDX-License-Identifier: Apache-2.0
-- The instructions of RV32IMC, Zicsr, Zifencei and machine mode by name, for the proofs, by the encoding
-- tables of the specification.

library ieee;
use ieee.std_logic_1164.all;

use work.instruction_set_pkg.all;

package instruction_names_pkg is

  type name_t is (
    no_instruction,
    rv_lui, rv_auipc, rv_jal, rv_jalr, rv_beq, rv_bne, rv_blt, rv_bge, rv_bltu, rv_bgeu,
    rv_lb, rv_lh, rv_lw, rv_lbu, rv_lhu, rv_sb, rv_sh, rv_sw,
    rv_addi, rv_slti, rv_sltiu, rv_xori, rv_ori, rv_andi, rv_slli, rv_srli, rv_srai,
    rv_add, rv_sub, rv_sll, rv_slt, rv_sltu, rv_xor, rv_srl, rv_sra, rv_or, rv_and,
    rv_mul, rv_mulh, rv_mulhsu, rv_mulhu, rv_div, rv_divu, rv_rem, rv_remu,
    rv_fence, rv_fence_i, rv_ecall, rv_ebreak, rv_mret, rv_wfi,
    rv_csrrw, rv_csrrs, rv_csrrc, rv_csrrwi, rv_csrrsi, rv_csrrci);

  type short_name_t is (
    no_short_instruction,
    c_addi4spn, c_lw, c_sw, c_nop, c_addi, c_jal, c_li, c_addi16sp, c_lui, c_srli, c_srai, c_andi, c_sub,
    c_xor, c_or, c_and, c_j, c_beqz, c_bnez, c_slli, c_lwsp, c_jr, c_mv, c_ebreak, c_jalr, c_add, c_swsp);

  function name_of(word : value_t) return name_t;
  function short_name_of(half : std_ulogic_vector(15 downto 0)) return short_name_t;

end package;

package body instruction_names_pkg is

  function name_of(word : value_t) return name_t is
    variable operation : std_ulogic_vector(9 downto 0);
    variable coding : std_ulogic_vector(16 downto 0);
  begin
    operation := word(14 downto 12) & word(6 downto 0);
    coding := word(31 downto 25) & operation;
    case word(6 downto 0) is
      when "0110111" => return rv_lui;
      when "0010111" => return rv_auipc;
      when "1101111" => return rv_jal;
      when others => null;
    end case;
    case operation is
      when "000" & "1100111" => return rv_jalr;
      when "000" & "1100011" => return rv_beq;
      when "001" & "1100011" => return rv_bne;
      when "100" & "1100011" => return rv_blt;
      when "101" & "1100011" => return rv_bge;
      when "110" & "1100011" => return rv_bltu;
      when "111" & "1100011" => return rv_bgeu;
      when "000" & "0000011" => return rv_lb;
      when "001" & "0000011" => return rv_lh;
      when "010" & "0000011" => return rv_lw;
      when "100" & "0000011" => return rv_lbu;
      when "101" & "0000011" => return rv_lhu;
      when "000" & "0100011" => return rv_sb;
      when "001" & "0100011" => return rv_sh;
      when "010" & "0100011" => return rv_sw;
      when "000" & "0010011" => return rv_addi;
      when "010" & "0010011" => return rv_slti;
      when "011" & "0010011" => return rv_sltiu;
      when "100" & "0010011" => return rv_xori;
      when "110" & "0010011" => return rv_ori;
      when "111" & "0010011" => return rv_andi;
      when "000" & "0001111" => return rv_fence;
      when "001" & "0001111" => return rv_fence_i;
      when "001" & "1110011" => return rv_csrrw;
      when "010" & "1110011" => return rv_csrrs;
      when "011" & "1110011" => return rv_csrrc;
      when "101" & "1110011" => return rv_csrrwi;
      when "110" & "1110011" => return rv_csrrsi;
      when "111" & "1110011" => return rv_csrrci;
      when others => null;
    end case;
    case coding is
      when "0000000" & "001" & "0010011" => return rv_slli;
      when "0000000" & "101" & "0010011" => return rv_srli;
      when "0100000" & "101" & "0010011" => return rv_srai;
      when "0000000" & "000" & "0110011" => return rv_add;
      when "0100000" & "000" & "0110011" => return rv_sub;
      when "0000000" & "001" & "0110011" => return rv_sll;
      when "0000000" & "010" & "0110011" => return rv_slt;
      when "0000000" & "011" & "0110011" => return rv_sltu;
      when "0000000" & "100" & "0110011" => return rv_xor;
      when "0000000" & "101" & "0110011" => return rv_srl;
      when "0100000" & "101" & "0110011" => return rv_sra;
      when "0000000" & "110" & "0110011" => return rv_or;
      when "0000000" & "111" & "0110011" => return rv_and;
      when "0000001" & "000" & "0110011" => return rv_mul;
      when "0000001" & "001" & "0110011" => return rv_mulh;
      when "0000001" & "010" & "0110011" => return rv_mulhsu;
      when "0000001" & "011" & "0110011" => return rv_mulhu;
      when "0000001" & "100" & "0110011" => return rv_div;
      when "0000001" & "101" & "0110011" => return rv_divu;
      when "0000001" & "110" & "0110011" => return rv_rem;
      when "0000001" & "111" & "0110011" => return rv_remu;
      when others => null;
    end case;
    case word is
      when x"00000073" => return rv_ecall;
      when x"00100073" => return rv_ebreak;
      when x"30200073" => return rv_mret;
      when x"10500073" => return rv_wfi;
      when others => return no_instruction;
    end case;
  end function;

  function short_name_of(half : std_ulogic_vector(15 downto 0)) return short_name_t is
    variable selector : std_ulogic_vector(4 downto 0);
    variable arithmetic : std_ulogic_vector(3 downto 0);
    variable has_upper, has_lower, has_immediate : boolean;
  begin
    selector := half(15 downto 13) & half(1 downto 0);
    has_upper := half(11 downto 7) /= "00000";
    has_lower := half(6 downto 2) /= "00000";
    has_immediate := half(12) = '1' or has_lower;
    case selector is
      when "000" & "00" =>
        if half(12 downto 5) /= "00000000" then
          return c_addi4spn;
        end if;
      when "010" & "00" => return c_lw;
      when "110" & "00" => return c_sw;
      when "000" & "01" =>
        if has_upper then
          return c_addi;
        end if;
        return c_nop;
      when "001" & "01" => return c_jal;
      when "010" & "01" => return c_li;
      when "011" & "01" =>
        if has_immediate and half(11 downto 7) = "00010" then
          return c_addi16sp;
        elsif has_immediate then
          return c_lui;
        end if;
      when "100" & "01" =>
        -- Shift amounts above 31 are reserved in RV32C.
        arithmetic := half(11 downto 10) & half(6 downto 5);
        if half(11 downto 10) = "10" then
          return c_andi;
        elsif half(12) = '0' then
          case arithmetic is
            when "0000" | "0001" | "0010" | "0011" => return c_srli;
            when "0100" | "0101" | "0110" | "0111" => return c_srai;
            when "1100" => return c_sub;
            when "1101" => return c_xor;
            when "1110" => return c_or;
            when "1111" => return c_and;
            when others => null;
          end case;
        end if;
      when "101" & "01" => return c_j;
      when "110" & "01" => return c_beqz;
      when "111" & "01" => return c_bnez;
      when "000" & "10" =>
        if half(12) = '0' then
          return c_slli;
        end if;
      when "010" & "10" =>
        if has_upper then
          return c_lwsp;
        end if;
      when "100" & "10" =>
        if has_lower then
          if half(12) = '1' then
            return c_add;
          end if;
          return c_mv;
        elsif has_upper then
          if half(12) = '1' then
            return c_jalr;
          end if;
          return c_jr;
        elsif half(12) = '1' then
          return c_ebreak;
        end if;
      when "110" & "10" => return c_swsp;
      when others => null;
    end case;
    return no_short_instruction;
  end function;

end package body;
