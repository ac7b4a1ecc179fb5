-- SPDX-License-Identifier: Apache-2.0
-- Static branch prediction in decode: jal is always taken; backward bne, bge and bgeu are predicted taken, as
-- they usually close loops; all other branches are predicted not taken.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity branch_predictor is
  port (
    -- The instruction in decode. Without a valid one, `address` is that of the next to be fetched.
    valid : in std_ulogic;
    address : in unsigned(31 downto 0);
    instruction : in word_t;
    is_word : in std_ulogic;
    decoded : in control_t;
    -- jal, or a branch predicted taken.
    taken : out std_ulogic;
    -- Target of a jump or branch, the same plus 2; predicted address of the next instruction.
    target : out unsigned(31 downto 0);
    target_plus_2 : out unsigned(31 downto 0);
    next_address : out unsigned(31 downto 0);
    -- For execute: the result of jal, jalr (the link) and auipc; the target of a redirect by a mispredicted
    -- branch or by fence.i.
    alternate_address : out unsigned(31 downto 0);
    -- When execute must redirect fetch.
    condition : out redirect_condition_t
  );
end entity;

architecture rtl of branch_predictor is

  signal sign, has_long_offset, word_taken, compressed_taken, redirects_if_false : std_ulogic;
  signal offset : unsigned(31 downto 0);
  signal low : std_ulogic_vector(11 downto 0);
  signal link : unsigned(31 downto 0);

begin

  -- Critical path: an immediate generator of its own for jumps, branches and auipc, selected by few bits.
  -- That of all instructions would be too late.
  sign <= instruction(31) when is_word else instruction(12);
  has_long_offset <= is_word and instruction(2);
  low <= instruction(20) & instruction(30 downto 21) & '0' when is_word and instruction(3) else
         x"000" when is_word and instruction(2) else
         instruction(7) & instruction(30 downto 25) & instruction(11 downto 8) & '0' when is_word else
         (11 downto 8 => instruction(12)) & instruction(6 downto 5) & instruction(2) &
           instruction(11 downto 10) & instruction(4 downto 3) & '0' when instruction(14) else
         instruction(12) & instruction(8) & instruction(10 downto 9) & instruction(6) &
           instruction(7) & instruction(2) & instruction(11) & instruction(5 downto 3) & '0';
  offset(11 downto 0) <= unsigned(low);
  offset(19 downto 12) <= unsigned(instruction(19 downto 12)) when has_long_offset else
                          (19 downto 12 => sign);
  offset(31 downto 20) <= unsigned(instruction(31 downto 20)) when has_long_offset and not instruction(3) else
                          (31 downto 20 => sign);

  target <= address + offset;
  -- Both addends are even: the carry into bit 1 adds 2.
  target_plus_2 <= ((address(31 downto 1) & '1') + (offset(31 downto 1) & '1')) and x"fffffffe";
  link <= (address(31 downto 1) + unsigned'((valid and is_word) & (valid and not is_word))) & '0';

  -- Decoded from few bits, too: any other instruction that matches is illegal.
  word_taken <= instruction(6) and instruction(5) and
                (instruction(3) or
                 ((instruction(4) nor instruction(2)) and instruction(31) and instruction(12)));
  compressed_taken <= not instruction(1) and instruction(0) and
                 instruction(13) and (not instruction(14) or (instruction(15) and instruction(12)));
  taken <= valid and ((is_word and word_taken) or (not is_word and compressed_taken));
  next_address <= target when taken else link;
  alternate_address <= link when taken or decoded.jump_register or decoded.refetch else target;

  -- A branch predicted taken redirects if its condition is false, any other if it is true.
  redirects_if_false <= taken xor decoded.funct3(0);
  condition <= (
    -- blt, bge: less; beq, bne: unequal.
    if_below => decoded.branch,
    if_above => decoded.branch and not decoded.funct3(2),
    inverted => decoded.jump_register or decoded.refetch or
                (decoded.branch and (redirects_if_false xnor decoded.funct3(2))));

end architecture;
