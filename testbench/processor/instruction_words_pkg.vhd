-- SPDX-License-Identifier: Apache-2.0
-- Instructions as words, for the benches of the pipeline's stages.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

package instruction_words_pkg is

  constant nop : word_t := x"00000013";
  -- Into x3, of x1 and x2, unless the name says otherwise.
  constant add : word_t := x"002081b3";
  constant add_x2_x1_x1 : word_t := x"00108133";
  constant addi_x1_5 : word_t := x"00500093";
  constant mul : word_t := x"022081b3";
  constant divu : word_t := x"0220d1b3";
  constant jal_16 : word_t := x"010000ef";
  constant jal_x3_16 : word_t := x"010001ef";
  constant jalr_8 : word_t := x"008081e7";
  constant beq : word_t := x"00208463";
  constant lw_4 : word_t := x"0040a183";
  constant lw_x1 : word_t := x"00002083";
  constant sb_1 : word_t := x"002080a3";
  constant csrw_mtvec : word_t := x"30509073";
  constant csrw_mscratch : word_t := x"34009073";
  constant csrr_mscratch : word_t := x"340021f3";
  constant csrw_mie : word_t := x"30409073";
  constant csrwi_mstatus_8 : word_t := x"30045073";
  constant csrw_mhartid : word_t := x"f1409073";
  constant ecall : word_t := x"00000073";
  constant ebreak : word_t := x"00100073";
  constant mret : word_t := x"30200073";
  -- c.addi x8, 1, followed by half a word of something else.
  constant c_addi_x8 : word_t := x"ffff0405";
  constant illegal : word_t := x"00000000";

end package;
