-- SPDX-License-Identifier: Apache-2.0
-- Reads an instruction word: what it is, the registers it reads, its constants, whether it is
-- legal.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity instruction_decoder is
  port (
    instruction : in word_t;
    decoded : out decoded_t
  );
end entity;

architecture rtl of instruction_decoder is

  -- Written as equations and not as one large case: each is a few gates and a few instructions of a
  -- simulation, which evaluates them in every clock.
  alias opcode : std_ulogic_vector(6 downto 0) is instruction(6 downto 0);
  alias funct3 : std_ulogic_vector(2 downto 0) is instruction(14 downto 12);
  alias funct7 : std_ulogic_vector(6 downto 0) is instruction(31 downto 25);

  signal is_load, is_fence, is_immediate_operation, is_upper_to_pc, is_store : std_ulogic;
  signal is_operation, is_upper, is_branch, is_jump_register, is_jump, is_system : std_ulogic;
  signal is_fence_i, is_shift, is_multiply_or_divide, is_csr, is_privileged : std_ulogic;
  signal is_ecall, is_ebreak, is_mret, is_wfi : std_ulogic;
  signal funct7_zero, funct7_alternate : std_ulogic;
  signal has_destination, legal : std_ulogic;

  signal immediate, store_offset, branch_offset, jump_offset, upper_immediate : word_t;

begin

  is_load <= opcode ?= "0000011";
  is_fence <= opcode ?= "0001111";
  is_immediate_operation <= opcode ?= "0010011";
  is_upper_to_pc <= opcode ?= "0010111";
  is_store <= opcode ?= "0100011";
  is_operation <= opcode ?= "0110011";
  is_upper <= opcode ?= "0110111";
  is_branch <= opcode ?= "1100011";
  is_jump_register <= opcode ?= "1100111";
  is_jump <= opcode ?= "1101111";
  is_system <= opcode ?= "1110011";

  funct7_zero <= funct7 ?= "0000000";
  funct7_alternate <= funct7 ?= "0100000";
  is_fence_i <= is_fence and (funct3 ?= "001");
  is_shift <= funct3(0) and not funct3(1);
  is_multiply_or_divide <= is_operation and (funct7 ?= "0000001");
  is_csr <= is_system and (funct3(0) or funct3(1));
  is_privileged <= is_system and (funct3 ?= "000") and (instruction(19 downto 15) ?= "00000") and
                   (instruction(11 downto 7) ?= "00000");
  is_ecall <= is_privileged and (instruction(31 downto 20) ?= x"000");
  is_ebreak <= is_privileged and (instruction(31 downto 20) ?= x"001");
  is_mret <= is_privileged and (instruction(31 downto 20) ?= x"302");
  is_wfi <= is_privileged and (instruction(31 downto 20) ?= x"105");

  legal <= is_upper or is_upper_to_pc or is_jump or
           (is_jump_register and (funct3 ?= "000")) or
           (is_branch and (funct3(2) or not funct3(1))) or
           (is_load and not (funct3(1) and (funct3(0) or funct3(2)))) or
           (is_store and not funct3(2) and (funct3(1) nand funct3(0))) or
           (is_immediate_operation and
            (not is_shift or funct7_zero or (funct7_alternate and funct3(2)))) or
           (is_operation and
            (funct7_zero or (funct7_alternate and (funct3 ?= "000" or funct3 ?= "101")))) or
           is_multiply_or_divide or
           (is_fence and not funct3(2) and not funct3(1)) or
           is_csr or is_ecall or is_ebreak or is_mret or is_wfi;
  decoded.illegal <= not legal;

  immediate <= (31 downto 12 => instruction(31)) & instruction(31 downto 20);
  store_offset <= (31 downto 12 => instruction(31)) & instruction(31 downto 25) &
                  instruction(11 downto 7);
  branch_offset <= (31 downto 12 => instruction(31)) & instruction(7) & instruction(30 downto 25) &
                   instruction(11 downto 8) & '0';
  jump_offset <= (31 downto 20 => instruction(31)) & instruction(19 downto 12) & instruction(20) &
                 instruction(30 downto 21) & '0';
  upper_immediate <= instruction(31 downto 12) & x"000";

  -- From few bits, since the fetch of the next instruction waits for them: all but lui, auipc, jal,
  -- fence and CSR instructions with a constant; then branch, store and operation. Of no meaning
  -- where
  -- the instruction is illegal.
  decoded.reads_first <= not (opcode(2) and (opcode(3) or opcode(4))) and
                         not (opcode(6) and opcode(4) and funct3(2));
  decoded.reads_second <= opcode(5) and not opcode(2) and not (opcode(6) and opcode(4));
  has_destination <= is_load or is_immediate_operation or is_upper_to_pc or is_operation or
                     is_upper or is_jump_register or is_jump or is_csr;
  decoded.writes <= has_destination and (instruction(11 downto 7) ?/= "00000");
  decoded.late <= is_load or is_multiply_or_divide or is_csr;

  -- Jumps leave the arithmetic unit to the return address.
  decoded.first_is_address <= is_upper_to_pc or is_jump or is_jump_register;
  decoded.first_is_zero <= is_upper;
  decoded.second_is_constant <= is_immediate_operation or is_upper_to_pc or is_upper or is_jump or
                                is_jump_register;
  decoded.constant_operand <= x"00000004" when is_jump or is_jump_register else
                              upper_immediate when is_upper or is_upper_to_pc else
                              immediate;

  -- fence.i jumps to the next instruction and so has it fetched again.
  decoded.relative <= is_branch or is_jump or is_fence_i;
  decoded.offset <= store_offset when is_store else
                    branch_offset when is_branch else
                    jump_offset when is_jump else
                    x"00000004" when is_fence_i else
                    immediate;

  decoded.operation <= funct3 when is_immediate_operation or is_operation else "000";
  decoded.alternate <= instruction(30) and (is_operation or (is_immediate_operation and is_shift));
  decoded.compare_unsigned <= funct3(1) when is_branch else funct3(0);

  decoded.load <= is_load;
  decoded.store <= is_store;
  decoded.branch <= is_branch;
  decoded.jump <= is_jump or is_jump_register or is_fence_i;
  decoded.multiply <= is_multiply_or_divide and not funct3(2);
  decoded.divide <= is_multiply_or_divide and funct3(2);
  decoded.csr <= is_csr;
  decoded.environment_call <= is_ecall;
  decoded.breakpoint <= is_ebreak;
  decoded.trap_return <= is_mret;
  decoded.wait_for_interrupt <= is_wfi;

end architecture;
