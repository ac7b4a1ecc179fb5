-- SPDX-License-Identifier: Apache-2.0
-- Both decoders and the register selector get the instruction, and its length selects between them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity instruction_decoder_tb is
end entity;

architecture tb of instruction_decoder_tb is

  signal instruction : word_t := (others => '0');
  signal is_word : std_ulogic;
  signal decoded : control_t;
  signal first, second : register_index_t;
  signal immediate : word_t;

begin

  uut : entity work.instruction_decoder
    port map (instruction => instruction, is_word => is_word, decoded => decoded, first => first,
              second => second, immediate => immediate);

  is_word <= and instruction(1 downto 0);

  check : process
    procedure decode(word : word_t) is
    begin
      instruction <= word;
      wait for 1 ns;
    end procedure;
  begin
    decode(x"01f50513");  -- addi a0, a0, 31
    assert (or decoded.legal) = '1' and decoded.destination = 5d"10" and
      immediate = x"0000001f" and first = 5d"10"
      severity failure;
    decode(x"00b60533");  -- add a0, a2, a1
    assert first = 5d"12" and second = 5d"11" severity failure;
    -- c.addi t6, -32 in the lower half.
    for upper in 0 to 15 loop
      decode(std_ulogic_vector(to_unsigned(upper * 16#1111#, 16)) & x"1f81");
      assert (or decoded.legal) = '1' and
        decoded.destination = 5d"31" and first = 5d"31" and
        immediate = x"ffffffe0" severity failure;
    end loop;
    -- c.jalr a1 links to x1; x0 is not written.
    decode(x"ffff9582");
    assert decoded.writes = '1' and decoded.destination = 5d"1" and first = 5d"11" severity failure;
    decode(x"00b60033");
    assert decoded.writes = '0' and (or decoded.legal) = '1' severity failure;
    decode(x"ffffffff");
    assert (or decoded.legal) = '0' severity failure;
    decode(x"01f50000");
    assert (or decoded.legal) = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
