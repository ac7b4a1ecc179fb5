-- SPDX-License-Identifier: Apache-2.0
-- Finds where jumps and branches go while they are decoded, and takes those that can be taken so early: jal,
-- and bne, bge and bgeu backwards, which are taken to be taken, as they end loops. beq, blt and bltu rarely
-- do.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity early_jump is
  port (
    -- Of the instruction decoded, if there is one; else where the next is.
    valid : in std_ulogic;
    address : in unsigned(31 downto 0);
    instruction : in word_t;
    is_word : in std_ulogic;
    decoded : in decoded_t;
    -- It jumps.
    jump : out std_ulogic;
    -- Where a jump goes, and this plus 2; where it goes on.
    target : out unsigned(31 downto 0);
    target_plus_2 : out unsigned(31 downto 0);
    following : out unsigned(31 downto 0);
    -- What execute needs of addresses: the result of jal, jalr and auipc, or where a branch or fence.i goes
    -- if it does not go on as it did here.
    other : out unsigned(31 downto 0);
    turn : out late_turn_t
  );
end entity;

architecture rtl of early_jump is

  signal sign, is_far, long_jumps, short_jumps, turns_if_not : std_ulogic;
  signal offset : unsigned(31 downto 0);
  signal low : std_ulogic_vector(11 downto 0);
  signal link : unsigned(31 downto 0);

begin

  -- The constants of jumps and auipc alone, told apart by few bits: those of all instructions come too late
  -- in the clock.
  sign <= instruction(31) when is_word else instruction(12);
  is_far <= is_word and instruction(2);
  low <= instruction(20) & instruction(30 downto 21) & '0' when is_word and instruction(3) else
         x"000" when is_word and instruction(2) else
         instruction(7) & instruction(30 downto 25) & instruction(11 downto 8) & '0' when is_word else
         (11 downto 8 => instruction(12)) & instruction(6 downto 5) & instruction(2) &
           instruction(11 downto 10) & instruction(4 downto 3) & '0' when instruction(14) else
         instruction(12) & instruction(8) & instruction(10 downto 9) & instruction(6) &
           instruction(7) & instruction(2) & instruction(11) & instruction(5 downto 3) & '0';
  offset(11 downto 0) <= unsigned(low);
  offset(19 downto 12) <= unsigned(instruction(19 downto 12)) when is_far else (19 downto 12 => sign);
  offset(31 downto 20) <= unsigned(instruction(31 downto 20)) when is_far and not instruction(3) else
                          (31 downto 20 => sign);

  target <= address + offset;
  -- Both are even: a carry into bit 1 adds 2.
  target_plus_2 <= ((address(31 downto 1) & '1') + (offset(31 downto 1) & '1')) and x"fffffffe";
  link <= (address(31 downto 1) + unsigned'((valid and is_word) & (valid and not is_word))) & '0';

  -- Told by few bits, too: what these take for a jump and is none is illegal.
  long_jumps <= instruction(6) and instruction(5) and
                (instruction(3) or
                 ((instruction(4) nor instruction(2)) and instruction(31) and instruction(12)));
  short_jumps <= not instruction(1) and instruction(0) and
                 instruction(13) and (not instruction(14) or (instruction(15) and instruction(12)));
  jump <= valid and ((is_word and long_jumps) or (not is_word and short_jumps));
  following <= target when jump else link;
  other <= link when jump or decoded.jump_register or decoded.refetch else target;

  -- A branch that was taken turns where its condition does not hold.
  turns_if_not <= jump xor decoded.funct3(0);
  turn <= (
    -- Less, or unequal.
    if_below => decoded.branch,
    if_above => decoded.branch and not decoded.funct3(2),
    inverted => decoded.jump_register or decoded.refetch or
                (decoded.branch and (turns_if_not xnor decoded.funct3(2))));

end architecture;
