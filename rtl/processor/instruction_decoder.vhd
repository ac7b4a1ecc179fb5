-- SPDX-License-Identifier: Apache-2.0
-- Reads an instruction of 16 or 32 bits, as both; its length stands in its lowest two bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity instruction_decoder is
  port (
    -- The bits behind a shorter instruction are of no meaning.
    instruction : in word_t;
    -- What it is if it is short and if it is long: the choice is left to the next stage, which has the
    -- time for it.
    decoded_of_compressed : out decoded_t;
    decoded_of_word : out decoded_t;
    immediate_of_compressed : out word_t;
    immediate_of_word : out word_t;
    -- The registers that it reads.
    first : out register_choice_t;
    second : out register_choice_t
  );
end entity;

architecture rtl of instruction_decoder is

begin

  word_decoder : entity work.word_decoder
    port map (
      instruction => instruction,
      decoded => decoded_of_word,
      immediate => immediate_of_word);

  compressed_decoder : entity work.compressed_decoder
    port map (
      instruction => instruction(15 downto 0),
      decoded => decoded_of_compressed,
      immediate => immediate_of_compressed);

  register_selector : entity work.register_selector
    port map (
      instruction => instruction,
      first => first,
      second => second);

end architecture;
