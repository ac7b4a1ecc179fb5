-- SPDX-License-Identifier: Apache-2.0
-- Decodes an instruction of 16 or 32 bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity instruction_decoder is
  generic (
    has_zbb : boolean := false
  );
  port (
    -- The upper half of a compressed instruction is don't care.
    instruction : in word_t;
    -- 32 bits, not compressed.
    is_word : in std_ulogic;
    -- The destination of c.jal and c.jalr is x1; x0 is never written.
    decoded : out control_t;
    immediate : out word_t;
    -- Source registers.
    first : out register_index_t;
    second : out register_index_t
  );
end entity;

architecture rtl of instruction_decoder is

  signal of_word, of_compressed, chosen : control_t;
  signal immediate_of_word, immediate_of_compressed : word_t;

begin

  word_decoder : entity work.word_decoder
    generic map (has_zbb => has_zbb)
    port map (
      instruction => instruction,
      decoded => of_word,
      immediate => immediate_of_word);

  compressed_decoder : entity work.compressed_decoder
    port map (
      instruction => instruction(15 downto 0),
      decoded => of_compressed,
      immediate => immediate_of_compressed);

  register_selector : entity work.register_selector
    port map (
      instruction => instruction,
      is_word => is_word,
      first => first,
      second => second);

  chosen <= of_word when is_word else of_compressed;
  immediate <= immediate_of_word when is_word else immediate_of_compressed;

  link_and_x0 : process (all)
  begin
    decoded <= chosen;
    if chosen.writes_link then
      decoded.destination <= "00001";
    end if;
    decoded.writes <= chosen.writes and (chosen.writes_link or (or chosen.destination));
  end process;

end architecture;
