-- SPDX-License-Identifier: Apache-2.0
-- Reads an instruction of 16 or 32 bits; its length stands in its lowest two bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity instruction_decoder is
  port (
    -- The bits behind a shorter instruction are of no meaning.
    instruction : in word_t;
    decoded : out decoded_t;
    -- The constant if it is short and if it is long: the choice is left to the next stage, which has
    -- the time for it.
    immediate_of_compressed : out word_t;
    immediate_of_word : out word_t
  );
end entity;

architecture rtl of instruction_decoder is

  signal from_word, from_compressed : decoded_t;
  signal is_word : std_ulogic;

begin

  word_decoder : entity work.word_decoder
    port map (
      instruction => instruction,
      decoded => from_word,
      immediate => immediate_of_word);

  compressed_decoder : entity work.compressed_decoder
    port map (
      instruction => instruction(15 downto 0),
      decoded => from_compressed,
      immediate => immediate_of_compressed);

  is_word <= instruction(1) and instruction(0);
  decoded <= from_word when is_word else from_compressed;

end architecture;
