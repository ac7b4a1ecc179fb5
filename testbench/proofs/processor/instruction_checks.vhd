-- SPDX-License-Identifier: Apache-2.0
-- One property for each instruction, named after it: whenever it retires or traps, it behaves as specified.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_names_pkg.all;
use work.processor_pkg.all;
use work.retired_instruction_pkg.all;
use work.short_instructions_pkg.all;

entity instruction_checks is
  port (
    clk : in std_ulogic;
    observed : in retired_instruction_t
  );
end entity;

architecture proof of instruction_checks is

  signal is_event, is_outside, is_long, is_checked : std_ulogic;
  signal outside : unsigned(31 downto 0);
  -- Of its 32-bit expansion; the same for a 32-bit instruction only; of a compressed one.
  signal name, long_name : name_t;
  signal short_name : short_name_t;
  -- It behaves as one of this name.
  signal right : boolean;

  default clock is rising_edge(clk);

begin

  is_event <= observed.completed or observed.exception;
  is_long <= and observed.instruction(1 downto 0);
  is_outside <= '1' when observed.address(31 downto 16) /= x"8000" or
                         (is_long = '1' and observed.address(15 downto 0) = x"fffe") else '0';
  -- The first half word outside the memory.
  outside <= x"80010000" when observed.address(31 downto 16) = x"8000" else observed.address;
  is_checked <= is_event and not is_outside;
  name <= name_of(observed.word);
  long_name <= name when is_checked and is_long else no_instruction;
  short_name <= short_name_of(observed.instruction(15 downto 0)) when is_checked and not is_long else
                no_short_instruction;
  right <= is_right(name, observed);

  fetch_outside_memory_traps : assert always
    ((is_event and is_outside) ->
     (is_quiet(observed) and traps(observed, cause_instruction_access, std_ulogic_vector(outside))));
  illegal_instruction_traps : assert always
    ((is_checked = '1' and name = no_instruction) -> right);
  illegal_compressed_instruction_traps : assert always
    ((is_checked = '1' and is_long = '0' and short_name = no_short_instruction) ->
     (name = no_instruction and right));

  does_lui : assert always (long_name = rv_lui -> right);
  does_auipc : assert always (long_name = rv_auipc -> right);
  does_jal : assert always (long_name = rv_jal -> right);
  does_jalr : assert always (long_name = rv_jalr -> right);
  does_beq : assert always (long_name = rv_beq -> right);
  does_bne : assert always (long_name = rv_bne -> right);
  does_blt : assert always (long_name = rv_blt -> right);
  does_bge : assert always (long_name = rv_bge -> right);
  does_bltu : assert always (long_name = rv_bltu -> right);
  does_bgeu : assert always (long_name = rv_bgeu -> right);
  does_lb : assert always (long_name = rv_lb -> right);
  does_lh : assert always (long_name = rv_lh -> right);
  does_lw : assert always (long_name = rv_lw -> right);
  does_lbu : assert always (long_name = rv_lbu -> right);
  does_lhu : assert always (long_name = rv_lhu -> right);
  does_sb : assert always (long_name = rv_sb -> right);
  does_sh : assert always (long_name = rv_sh -> right);
  does_sw : assert always (long_name = rv_sw -> right);
  does_addi : assert always (long_name = rv_addi -> right);
  does_slti : assert always (long_name = rv_slti -> right);
  does_sltiu : assert always (long_name = rv_sltiu -> right);
  does_xori : assert always (long_name = rv_xori -> right);
  does_ori : assert always (long_name = rv_ori -> right);
  does_andi : assert always (long_name = rv_andi -> right);
  does_slli : assert always (long_name = rv_slli -> right);
  does_srli : assert always (long_name = rv_srli -> right);
  does_srai : assert always (long_name = rv_srai -> right);
  does_add : assert always (long_name = rv_add -> right);
  does_sub : assert always (long_name = rv_sub -> right);
  does_sll : assert always (long_name = rv_sll -> right);
  does_slt : assert always (long_name = rv_slt -> right);
  does_sltu : assert always (long_name = rv_sltu -> right);
  does_xor : assert always (long_name = rv_xor -> right);
  does_srl : assert always (long_name = rv_srl -> right);
  does_sra : assert always (long_name = rv_sra -> right);
  does_or : assert always (long_name = rv_or -> right);
  does_and : assert always (long_name = rv_and -> right);
  does_mul : assert always (long_name = rv_mul -> right);
  does_mulh : assert always (long_name = rv_mulh -> right);
  does_mulhsu : assert always (long_name = rv_mulhsu -> right);
  does_mulhu : assert always (long_name = rv_mulhu -> right);
  does_div : assert always (long_name = rv_div -> right);
  does_divu : assert always (long_name = rv_divu -> right);
  does_rem : assert always (long_name = rv_rem -> right);
  does_remu : assert always (long_name = rv_remu -> right);
  does_fence : assert always (long_name = rv_fence -> right);
  does_fence_i : assert always (long_name = rv_fence_i -> right);
  does_ecall : assert always (long_name = rv_ecall -> right);
  does_ebreak : assert always (long_name = rv_ebreak -> right);
  does_mret : assert always (long_name = rv_mret -> right);
  does_wfi : assert always (long_name = rv_wfi -> right);
  does_csrrw : assert always (long_name = rv_csrrw -> right);
  does_csrrs : assert always (long_name = rv_csrrs -> right);
  does_csrrc : assert always (long_name = rv_csrrc -> right);
  does_csrrwi : assert always (long_name = rv_csrrwi -> right);
  does_csrrsi : assert always (long_name = rv_csrrsi -> right);
  does_csrrci : assert always (long_name = rv_csrrci -> right);

  -- Compressed instructions behave as those to which they expand.
  does_c_addi4spn : assert always (short_name = c_addi4spn -> (name = rv_addi and right));
  does_c_lw : assert always (short_name = c_lw -> (name = rv_lw and right));
  does_c_sw : assert always (short_name = c_sw -> (name = rv_sw and right));
  does_c_nop : assert always (short_name = c_nop -> (name = rv_addi and right));
  does_c_addi : assert always (short_name = c_addi -> (name = rv_addi and right));
  does_c_jal : assert always (short_name = c_jal -> (name = rv_jal and right));
  does_c_li : assert always (short_name = c_li -> (name = rv_addi and right));
  does_c_addi16sp : assert always (short_name = c_addi16sp -> (name = rv_addi and right));
  does_c_lui : assert always (short_name = c_lui -> (name = rv_lui and right));
  does_c_srli : assert always (short_name = c_srli -> (name = rv_srli and right));
  does_c_srai : assert always (short_name = c_srai -> (name = rv_srai and right));
  does_c_andi : assert always (short_name = c_andi -> (name = rv_andi and right));
  does_c_sub : assert always (short_name = c_sub -> (name = rv_sub and right));
  does_c_xor : assert always (short_name = c_xor -> (name = rv_xor and right));
  does_c_or : assert always (short_name = c_or -> (name = rv_or and right));
  does_c_and : assert always (short_name = c_and -> (name = rv_and and right));
  does_c_j : assert always (short_name = c_j -> (name = rv_jal and right));
  does_c_beqz : assert always (short_name = c_beqz -> (name = rv_beq and right));
  does_c_bnez : assert always (short_name = c_bnez -> (name = rv_bne and right));
  does_c_slli : assert always (short_name = c_slli -> (name = rv_slli and right));
  does_c_lwsp : assert always (short_name = c_lwsp -> (name = rv_lw and right));
  does_c_jr : assert always (short_name = c_jr -> (name = rv_jalr and right));
  does_c_mv : assert always (short_name = c_mv -> (name = rv_add and right));
  does_c_ebreak : assert always (short_name = c_ebreak -> (name = rv_ebreak and right));
  does_c_jalr : assert always (short_name = c_jalr -> (name = rv_jalr and right));
  does_c_add : assert always (short_name = c_add -> (name = rv_add and right));
  does_c_swsp : assert always (short_name = c_swsp -> (name = rv_sw and right));

end architecture;
