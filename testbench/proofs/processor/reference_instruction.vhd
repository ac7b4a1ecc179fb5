-- SPDX-License-Identifier: Apache-2.0
-- Decodes and predicts the instruction of the execute stage once more.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;
use work.reference_instruction_pkg.all;

entity reference_instruction is
  generic (
    has_zbb : boolean
  );
  port (
    instruction : in word_t;
    address : in unsigned(31 downto 0);
    expected : out reference_instruction_t
  );
end entity;

architecture proof of reference_instruction is
begin

  expected.is_word <= and instruction(1 downto 0);

  decoder : entity work.instruction_decoder
    generic map (has_zbb => has_zbb)
    port map (
      instruction => instruction,
      is_word => expected.is_word,
      decoded => expected.control,
      immediate => expected.immediate,
      first => expected.first_index,
      second => expected.second_index);

  predictor : entity work.branch_predictor
    port map (
      valid => '1',
      address => address,
      instruction => instruction,
      is_word => expected.is_word,
      decoded => expected.control,
      taken => expected.taken,
      target => open,
      target_plus_2 => open,
      next_address => expected.next_address,
      alternate_address => expected.alternate_address,
      condition => expected.condition);

end architecture;
