-- SPDX-License-Identifier: Apache-2.0
-- Decodes an instruction of 32 bits: control signals, immediate, legality.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity word_decoder is
  generic (
    -- The instructions of Zbb are legal.
    has_zbb : boolean := false
  );
  port (
    instruction : in word_t;
    decoded : out control_t;
    -- Don't care for jal, branches, auipc and instructions without an immediate.
    immediate : out word_t
  );
end entity;

architecture rtl of word_decoder is

  alias csr_address : std_ulogic_vector(11 downto 0) is instruction(31 downto 20);
  signal csr_exists, is_hardware_performance : std_ulogic;

  -- Equations instead of one large case statement: few gates, and fast in simulation. The lowest two bits
  -- are always "11".
  alias opcode : std_ulogic_vector(4 downto 0) is instruction(6 downto 2);
  alias funct3 : std_ulogic_vector(2 downto 0) is instruction(14 downto 12);
  alias funct7 : std_ulogic_vector(6 downto 0) is instruction(31 downto 25);

  signal is_load, is_fence, is_immediate_operation, is_upper_to_pc, is_store : std_ulogic;
  signal is_operation, is_upper, is_branch, is_jump_register, is_jump, is_system : std_ulogic;
  signal is_shift, is_multiply_or_divide, is_csr, is_privileged : std_ulogic;
  signal is_ecall, is_ebreak, is_mret, is_wfi : std_ulogic;
  signal funct7_zero, funct7_alternate : std_ulogic;
  signal is_zbb, manipulates : std_ulogic := '0';

begin

  with_zbb : if has_zbb generate
    bit_manipulation_decoder : entity work.bit_manipulation_decoder
      port map (
        instruction => instruction,
        legal => is_zbb,
        manipulates => manipulates);
  end generate;

  is_load <= opcode ?= "00000";
  is_fence <= opcode ?= "00011";
  is_immediate_operation <= opcode ?= "00100";
  is_upper_to_pc <= opcode ?= "00101";
  is_store <= opcode ?= "01000";
  is_operation <= opcode ?= "01100";
  is_upper <= opcode ?= "01101";
  is_branch <= opcode ?= "11000";
  is_jump_register <= opcode ?= "11001";
  is_jump <= opcode ?= "11011";
  is_system <= opcode ?= "11100";

  funct7_zero <= funct7 ?= "0000000";
  funct7_alternate <= funct7 ?= "0100000";
  is_shift <= funct3(0) and not funct3(1);
  is_multiply_or_divide <= is_operation and (funct7 ?= "0000001");
  is_csr <= is_system and (funct3(0) or funct3(1));
  is_privileged <= is_system and (funct3 ?= "000") and (instruction(19 downto 15) ?= "00000") and
                   (instruction(11 downto 7) ?= "00000");
  is_ecall <= is_privileged and (instruction(31 downto 20) ?= x"000");
  is_ebreak <= is_privileged and (instruction(31 downto 20) ?= x"001");
  is_mret <= is_privileged and (instruction(31 downto 20) ?= x"302");
  is_wfi <= is_privileged and (instruction(31 downto 20) ?= x"105");

  decoded.legal(0) <= is_upper or is_upper_to_pc or is_jump or
                      (is_jump_register and (funct3 ?= "000")) or
                      (is_branch and (funct3(2) or not funct3(1)));
  decoded.legal(1) <= (is_load and not (funct3(1) and (funct3(0) or funct3(2)))) or
                      (is_store and not funct3(2) and (funct3(1) nand funct3(0))) or
                      (is_fence and not funct3(2) and not funct3(1)) or is_csr;
  decoded.legal(2) <= (is_immediate_operation and
                       (not is_shift or funct7_zero or (funct7_alternate and funct3(2)))) or
                      (is_operation and
                       (funct7_zero or
                        (funct7_alternate and (funct3 ?= "000" or funct3 ?= "101")))) or
                      is_multiply_or_divide;
  decoded.legal(3) <= is_ecall or is_ebreak or is_mret or is_wfi or is_zbb;

  -- mhpmcounter3..31, mhpmcounter3h..31h and mhpmevent3..31 are read-only zero.
  is_hardware_performance <= (or csr_address(4 downto 2)) or (and csr_address(1 downto 0));
  find_csr : process (all)
  begin
    csr_exists <= '0';
    case csr_address(11 downto 5) is
      when "0011000" =>  -- mstatus, misa, mie, mtvec; mstatush.
        csr_exists <= not (csr_address(4) or csr_address(3) or csr_address(1)) or
                      (csr_address(4 downto 0) ?= "10000");
      when "0011001" =>  -- mcountinhibit, mhpmevent.
        csr_exists <= (csr_address(4 downto 0) ?= "00000") or is_hardware_performance;
      when "0011010" =>  -- mscratch, mepc, mcause, mtval, mip.
        csr_exists <= not csr_address(4) and not csr_address(3) and
                      (not csr_address(2) or not (or csr_address(1 downto 0)));
      when "0111101" =>  -- tselect, tdata1..3: zero, no trigger.
        csr_exists <= nor csr_address(4 downto 2);
      when "1011000" | "1011100" =>  -- mcycle, minstret, mhpmcounter.
        csr_exists <= not csr_address(0) or is_hardware_performance;
      when "1100000" | "1100100" =>  -- cycle, instret.
        csr_exists <= not (or csr_address(4 downto 2)) and not csr_address(0);
      when "1111000" =>  -- mvendorid, marchid, mimpid, mhartid, mconfigptr: zero.
        csr_exists <= csr_address(4) and not csr_address(3) and
                      ((not csr_address(2) and (or csr_address(1 downto 0))) or
                       (csr_address(2) and not csr_address(1)));
      when others => null;
    end case;
  end process;

  -- Without those of branches, jal and auipc, which branch_predictor generates. On the critical path, so
  -- selected by few bits: U format, then S format.
  immediate(31 downto 12) <= instruction(31 downto 12) when opcode(2) and opcode(0) else
                             (31 downto 12 => instruction(31));
  immediate(11 downto 5) <= instruction(31 downto 25) and (11 downto 5 => opcode(2) nand opcode(0));
  immediate(4 downto 0) <= "00000" when opcode(2) and opcode(0) else
                           instruction(11 downto 7) when opcode(3) and not opcode(0) else
                           instruction(24 downto 20);

  decoded.destination <= instruction(11 downto 7);
  -- All but lui, auipc, jal, fence and CSR instructions with an immediate; then branch, store and
  -- register-register operations. Don't care for illegal instructions.
  decoded.reads_first <= not (opcode(0) and (opcode(1) or opcode(2))) and
                         not (opcode(4) and opcode(2) and funct3(2));
  decoded.reads_second <= opcode(3) and not opcode(0) and not (opcode(4) and opcode(2));
  decoded.writes <= is_load or is_immediate_operation or is_upper_to_pc or is_operation or
                    is_upper or is_jump_register or is_jump or is_csr;
  decoded.writes_link <= '0';
  decoded.late <= is_load or (is_multiply_or_divide and not funct3(2)) or is_csr or manipulates;

  -- Low for register-register operations, branches and stores; don't care for CSR instructions.
  decoded.second_is_immediate <= not opcode(3) or opcode(0);
  -- lui passes its immediate.
  decoded.operation <= "101" when is_upper else
                       funct3 when is_immediate_operation or is_operation else
                       "000";
  decoded.shift <= is_shift and (is_immediate_operation or is_operation);
  decoded.subtract <= is_operation and instruction(30);
  decoded.arithmetic_shift <= instruction(30);
  -- Of shifts only those of Zbb have this bit.
  decoded.rotate <= instruction(29) and is_zbb;
  decoded.compare_unsigned <= funct3(1) when is_branch else funct3(0);

  decoded.funct3 <= funct3;
  decoded.load <= is_load;
  decoded.store <= is_store;
  decoded.branch <= is_branch;
  decoded.jump <= is_jump;
  decoded.refetch <= is_fence and funct3(0);
  decoded.jump_register <= is_jump_register;
  decoded.address_result <= is_upper_to_pc;
  decoded.multiply <= is_multiply_or_divide and not funct3(2);
  decoded.divide <= is_multiply_or_divide and funct3(2);
  decoded.manipulate <= manipulates;
  decoded.csr <= is_csr;
  decoded.csr_exists <= csr_exists;
  decoded.csr_written <= not funct3(1) or (or instruction(19 downto 15));
  decoded.environment_call <= is_ecall;
  decoded.breakpoint <= is_ebreak;
  decoded.trap_return <= is_mret;
  decoded.wait_for_interrupt <= is_wfi;

end architecture;
