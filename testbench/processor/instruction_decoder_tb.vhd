-- SPDX-License-Identifier: Apache-2.0
-- Both decoders and the selector of registers get the instruction, and each the bits that it reads.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity instruction_decoder_tb is
end entity;

architecture tb of instruction_decoder_tb is

  signal instruction : word_t := (others => '0');
  signal decoded_of_compressed, decoded_of_word : decoded_t;
  signal first, second : register_choice_t;
  signal immediate_of_compressed, immediate_of_word : word_t;

begin

  uut : entity work.instruction_decoder
    port map (instruction => instruction,
              decoded_of_compressed => decoded_of_compressed,
              decoded_of_word => decoded_of_word,
              first => first, second => second,
              immediate_of_compressed => immediate_of_compressed,
              immediate_of_word => immediate_of_word);

  check : process
    procedure decode(word : word_t) is
    begin
      instruction <= word;
      wait for 1 ns;
    end procedure;
  begin
    decode(x"01f50513");  -- addi a0, a0, 31
    assert (or decoded_of_word.legal) = '1' and decoded_of_word.destination = 5d"10" and
      immediate_of_word = x"0000001f" and chosen(first) = 5d"10"
      severity failure;
    decode(x"00b60533");  -- add a0, a2, a1
    assert chosen(first) = 5d"12" and chosen(second) = 5d"11" severity failure;
    -- c.addi t6, -32 below anything.
    for upper in 0 to 15 loop
      decode(std_ulogic_vector(to_unsigned(upper * 16#1111#, 16)) & x"1f81");
      assert (or decoded_of_compressed.legal) = '1' and
        decoded_of_compressed.destination = 5d"31" and chosen(first) = 5d"31" and
        immediate_of_compressed = x"ffffffe0" severity failure;
    end loop;
    decode(x"ffffffff");
    assert (or decoded_of_word.legal) = '0' severity failure;
    decode(x"01f50000");
    assert (or decoded_of_compressed.legal) = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
