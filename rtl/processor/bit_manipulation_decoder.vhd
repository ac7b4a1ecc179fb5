-- SPDX-License-Identifier: Apache-2.0
-- Decodes Zbb: whether a word is one of its instructions,
-- and whether bit_manipulation or the ALU executes it.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity bit_manipulation_decoder is
  port (
    -- The lowest two bits are always "11".
    instruction : in word_t;
    -- An instruction of RV32 Zbb.
    legal : out std_ulogic;
    -- If it is legal: executed by bit_manipulation, not by the ALU.
    manipulates : out std_ulogic
  );
end entity;

architecture rtl of bit_manipulation_decoder is

  alias funct7 : std_ulogic_vector(6 downto 0) is instruction(31 downto 25);
  alias second : std_ulogic_vector(4 downto 0) is instruction(24 downto 20);
  alias funct3 : std_ulogic_vector(2 downto 0) is instruction(14 downto 12);

  signal is_operation, is_immediate_operation, is_left, is_right : std_ulogic;
  signal is_inverted_logic, is_rotation, is_comparison, is_zero_extension : std_ulogic;
  signal is_count_or_extension, is_of_bytes : std_ulogic;

begin

  is_operation <= instruction(6 downto 2) ?= "01100";
  is_immediate_operation <= instruction(6 downto 2) ?= "00100";
  is_left <= funct3 ?= "001";
  is_right <= funct3 ?= "101";

  -- andn, orn, xnor; rol, ror, rori.
  is_inverted_logic <= is_operation and (funct7 ?= "0100000") and funct3(2) and not is_right;
  is_rotation <= (funct7 ?= "0110000") and
                 ((is_operation and is_left) or ((is_operation or is_immediate_operation) and is_right));
  -- min, minu, max, maxu; zext.h.
  is_comparison <= is_operation and (funct7 ?= "0000101") and funct3(2);
  is_zero_extension <= is_operation and (funct7 ?= "0000100") and (funct3 ?= "100") and
                       (second ?= "00000");
  -- clz, ctz, cpop; sext.b, sext.h.
  is_count_or_extension <= is_immediate_operation and (funct7 ?= "0110000") and is_left and
                           (second(4) nor second(3)) and
                           (second(1) nand (second(2) or second(0)));
  -- orc.b, rev8.
  is_of_bytes <= is_immediate_operation and is_right and
                 (((funct7 ?= "0010100") and (second ?= "00111")) or
                  ((funct7 ?= "0110100") and (second ?= "11000")));

  manipulates <= is_comparison or is_zero_extension or is_count_or_extension or is_of_bytes;
  legal <= is_inverted_logic or is_rotation or is_comparison or is_zero_extension or
           is_count_or_extension or is_of_bytes;

end architecture;
