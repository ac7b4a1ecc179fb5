-- SPDX-License-Identifier: Apache-2.0
-- Exactly the words of Zbb are legal, and are assigned to the ALU or to bit_manipulation.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity bit_manipulation_decoder_tb is
end entity;

architecture tb of bit_manipulation_decoder_tb is

  signal instruction : word_t := (others => '0');
  signal legal, manipulates : std_ulogic;

  type words_t is array (natural range <>) of word_t;
  -- Assembled with a0, a1, a2: clz, ctz, cpop, sext.b, sext.h, orc.b, rev8, zext.h, min,
  -- minu, max, maxu.
  constant manipulating : words_t := (
    x"60059513", x"60159513", x"60259513", x"60459513", x"60559513", x"2875d513", x"6985d513",
    x"0805c533", x"0ac5c533", x"0ac5d533", x"0ac5e533", x"0ac5f533");
  -- andn, orn, xnor, rol, ror, rori.
  constant arithmetic : words_t := (
    x"40c5f533", x"40c5e533", x"40c5c533", x"60c59533", x"60c5d533", x"61f5d513");

begin

  uut : entity work.bit_manipulation_decoder
    port map (instruction => instruction, legal => legal, manipulates => manipulates);

  check : process
    variable legal_words, manipulating_words : natural := 0;
  begin
    for index in manipulating'range loop
      instruction <= manipulating(index);
      wait for 1 ns;
      assert legal = '1' and manipulates = '1' report to_hstring(instruction) severity failure;
    end loop;
    for index in arithmetic'range loop
      instruction <= arithmetic(index);
      wait for 1 ns;
      assert legal = '1' and manipulates = '0' report to_hstring(instruction) severity failure;
    end loop;

    -- No others: all of funct7, rs2 and funct3 with the opcodes of Zbb, then with every opcode.
    for opcode in 0 to 31 loop
      for code in 0 to 32767 loop
        -- Other opcodes with only a few rs2.
        next when opcode /= 4 and opcode /= 12 and (code / 8) mod 32 > 1;
        instruction <= std_ulogic_vector(to_unsigned(code / 8, 12)) & "01011" &
                       std_ulogic_vector(to_unsigned(code mod 8, 3)) & "01010" &
                       std_ulogic_vector(to_unsigned(opcode, 5)) & "11";
        wait for 1 ns;
        if legal then
          legal_words := legal_words + 1;
        end if;
        if legal and manipulates then
          manipulating_words := manipulating_words + 1;
        end if;
      end loop;
    end loop;
    -- Ten with any rs2 or shift amount, of which four are minimum and maximum; eight with a fixed one.
    assert legal_words = 10 * 32 + 8 report integer'image(legal_words) & " words" severity failure;
    assert manipulating_words = 4 * 32 + 8 report integer'image(manipulating_words) & " words"
      severity failure;
    std.env.finish;
  end process;

end architecture;
