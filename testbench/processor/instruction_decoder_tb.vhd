-- SPDX-License-Identifier: Apache-2.0
-- The two lowest bits choose between the decoders of long and short instructions.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity instruction_decoder_tb is
end entity;

architecture tb of instruction_decoder_tb is

  signal instruction : word_t := (others => '0');
  signal decoded : decoded_t;
  signal immediate_of_compressed, immediate_of_word : word_t;

begin

  uut : entity work.instruction_decoder
    port map (instruction => instruction, decoded => decoded,
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
    assert (or decoded.legal) = '1' and decoded.destination = 5d"10" and
      immediate_of_word = x"0000001f"
      severity failure;
    -- c.addi t6, -32 below anything.
    for upper in 0 to 15 loop
      decode(std_ulogic_vector(to_unsigned(upper * 16#1111#, 16)) & x"1f81");
      assert (or decoded.legal) = '1' and decoded.destination = 5d"31" and
        immediate_of_compressed = x"ffffffe0" severity failure;
    end loop;
    decode(x"ffffffff");
    assert (or decoded.legal) = '0' severity failure;
    decode(x"01f50000");
    assert (or decoded.legal) = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
