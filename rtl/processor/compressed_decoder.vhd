-- SPDX-License-Identifier: Apache-2.0
-- Decodes a compressed instruction (extension C): control signals, immediate, legality.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity compressed_decoder is
  port (
    -- The lowest two bits are never "11".
    instruction : in std_ulogic_vector(15 downto 0);
    decoded : out control_t;
    -- Don't care for jumps, branches and instructions without an immediate.
    immediate : out word_t
  );
end entity;

architecture rtl of compressed_decoder is

  alias funct3 : std_ulogic_vector(2 downto 0) is instruction(15 downto 13);
  -- Five-bit register numbers, and three-bit ones for x8 to x15.
  alias upper_field : register_index_t is instruction(11 downto 7);
  alias lower_field : std_ulogic_vector(4 downto 0) is instruction(6 downto 2);
  signal upper_short, lower_short : register_index_t;

  signal quadrant_0, quadrant_1, quadrant_2 : std_ulogic;
  signal is_add_to_sp, is_load_word, is_store_word : std_ulogic;
  signal is_add_immediate, is_jump_and_link, is_load_immediate, is_upper_or_sp : std_ulogic;
  signal is_arithmetic, is_jump_only, is_branch : std_ulogic;
  signal is_shift_left, is_load_from_sp, is_store_to_sp, is_move_or_jump : std_ulogic;
  signal upper_is_sp, is_sp, is_short_shift, is_short_and, is_short_operation : std_ulogic;
  signal is_jump_register, is_move, is_add, is_breakpoint : std_ulogic;
  signal is_load, is_store, is_jump, is_second_operand : std_ulogic;
  signal upper_zero, lower_zero, immediate_zero : std_ulogic;
  signal sign, extension, without_link : std_ulogic;
  signal from_quadrant_0, from_quadrant_1, from_quadrant_2 : std_ulogic_vector(11 downto 0);
  signal sp_amount, small_immediate : std_ulogic_vector(11 downto 0);
  signal low : std_ulogic_vector(11 downto 0);

begin

  upper_short <= "01" & instruction(9 downto 7);
  lower_short <= "01" & instruction(4 downto 2);
  upper_zero <= nor upper_field;
  lower_zero <= nor lower_field;
  immediate_zero <= lower_zero and not instruction(12);
  sign <= instruction(12);

  quadrant_0 <= not instruction(1) and not instruction(0);
  quadrant_1 <= not instruction(1) and instruction(0);
  quadrant_2 <= instruction(1) and not instruction(0);

  is_add_to_sp <= quadrant_0 and (funct3 ?= "000");
  is_load_word <= quadrant_0 and (funct3 ?= "010");
  is_store_word <= quadrant_0 and (funct3 ?= "110");
  is_add_immediate <= quadrant_1 and (funct3 ?= "000");
  is_jump_and_link <= quadrant_1 and (funct3 ?= "001");
  is_load_immediate <= quadrant_1 and (funct3 ?= "010");
  is_upper_or_sp <= quadrant_1 and (funct3 ?= "011");
  is_arithmetic <= quadrant_1 and (funct3 ?= "100");
  is_jump_only <= quadrant_1 and (funct3 ?= "101");
  is_branch <= quadrant_1 and funct3(2) and funct3(1);
  is_shift_left <= quadrant_2 and (funct3 ?= "000");
  is_load_from_sp <= quadrant_2 and (funct3 ?= "010");
  is_move_or_jump <= quadrant_2 and (funct3 ?= "100");
  is_store_to_sp <= quadrant_2 and (funct3 ?= "110");

  upper_is_sp <= upper_field ?= "00010";
  is_sp <= is_upper_or_sp and upper_is_sp;
  is_short_shift <= is_arithmetic and not instruction(11);
  is_short_and <= is_arithmetic and instruction(11) and not instruction(10);
  is_short_operation <= is_arithmetic and instruction(11) and instruction(10);
  is_jump_register <= is_move_or_jump and lower_zero and not upper_zero;
  is_breakpoint <= is_move_or_jump and lower_zero and upper_zero and instruction(12);
  is_move <= is_move_or_jump and not lower_zero and not instruction(12);
  is_add <= is_move_or_jump and not lower_zero and instruction(12);
  is_load <= is_load_word or is_load_from_sp;
  is_store <= is_store_word or is_store_to_sp;
  is_jump <= is_jump_only or is_jump_and_link;
  -- li, lui and mv pass their second operand.
  is_second_operand <= is_load_immediate or (is_upper_or_sp and not upper_is_sp) or is_move;

  -- Reserved encodings (shift amounts above 31, zero immediates) are illegal.
  decoded.legal(0) <= (is_add_to_sp and (or instruction(12 downto 5))) or is_load_word or
                      is_store_word or is_add_immediate or is_jump or is_load_immediate;
  decoded.legal(1) <= (is_upper_or_sp and not immediate_zero) or
                      (is_short_shift and not instruction(12)) or is_short_and or
                      (is_short_operation and not instruction(12)) or is_branch;
  decoded.legal(2) <= (is_shift_left and not instruction(12)) or
                      (is_load_from_sp and not upper_zero) or is_store_to_sp;
  decoded.legal(3) <= is_jump_register or is_breakpoint or is_move or is_add;

  -- c.jr and c.j have no link, that of c.jal and c.jalr is x1.
  without_link <= is_jump_only or (is_move_or_jump and lower_zero and not instruction(12));
  decoded.destination <= lower_short when quadrant_0 else
                         upper_short when instruction(15) and quadrant_1 else
                         upper_field;
  decoded.writes <= not (is_store or is_branch or is_breakpoint or without_link);
  decoded.writes_link <= is_jump_and_link or (is_move_or_jump and lower_zero);
  decoded.late <= is_load;
  decoded.reads_first <= not (is_jump or is_second_operand);
  decoded.reads_second <= is_store or is_branch or is_short_operation or is_move_or_jump;

  -- Critical path: selected by as few bits as distinguish the formats, not by the decoded instruction.
  from_quadrant_0 <= "00000" & instruction(5) & instruction(12 downto 10) & instruction(6) & "00" when
                       instruction(14) else
                     "00" & instruction(10 downto 7) & instruction(12 downto 11) & instruction(5) &
                       instruction(6) & "00";
  sp_amount <= (11 downto 9 => sign) & instruction(4 downto 3) & instruction(5) & instruction(2) &
               instruction(6) & "0000";
  small_immediate <= (11 downto 5 => sign) & instruction(6 downto 2);
  -- funct3 0, 2, 4: 6-bit immediate; 3: c.addi16sp or c.lui.
  -- branch_predictor generates those of jumps and branches.
  from_quadrant_1 <= sp_amount when instruction(13) and upper_is_sp else
                     x"000" when instruction(13) else
                     small_immediate;
  from_quadrant_2 <= "0000" & instruction(8 downto 7) & instruction(12 downto 9) & "00" when
                       instruction(15) and instruction(14) else
                     "0000" & instruction(3 downto 2) & instruction(12) & instruction(6 downto 4) &
                       "00" when instruction(14) else
                     x"000" when instruction(15) else
                     small_immediate;
  low <= from_quadrant_2 when instruction(1) else
         from_quadrant_1 when instruction(0) else
         from_quadrant_0;
  extension <= sign and quadrant_1;
  immediate <= (31 downto 17 => sign) & instruction(6 downto 2) & low when
                 is_upper_or_sp and not is_sp else
               (31 downto 12 => extension) & low;

  -- Decoded from few bits: don't care for jumps.
  decoded.second_is_immediate <= not instruction(15) or
                                (quadrant_1 and not instruction(14) and
                                 (instruction(11) nand instruction(10)));
  decoded.operation <= (is_second_operand or (is_arithmetic and
                        (not is_short_operation or instruction(6) or instruction(5)))) &
                       (is_short_and or (is_short_operation and instruction(6))) &
                       (is_second_operand or is_shift_left or (is_arithmetic and
                        (not is_short_operation or (instruction(6) and instruction(5)))));
  decoded.shift <= is_shift_left or is_short_shift;
  decoded.subtract <= is_short_operation and not instruction(6) and not instruction(5);
  decoded.arithmetic_shift <= instruction(10);
  decoded.rotate <= '0';
  decoded.compare_unsigned <= '0';

  -- Loads and stores of words; beq or bne.
  decoded.funct3 <= "00" & instruction(13) when is_branch else "010";
  decoded.load <= is_load;
  decoded.store <= is_store;
  decoded.branch <= is_branch;
  decoded.jump <= is_jump;
  decoded.jump_register <= is_jump_register;
  decoded.refetch <= '0';
  decoded.address_result <= '0';
  decoded.multiply <= '0';
  decoded.divide <= '0';
  decoded.manipulate <= '0';
  decoded.csr <= '0';
  decoded.csr_exists <= '0';
  decoded.csr_written <= '0';
  decoded.environment_call <= '0';
  decoded.breakpoint <= is_breakpoint;
  decoded.trap_return <= '0';
  decoded.wait_for_interrupt <= '0';

end architecture;
