-- SPDX-License-Identifier: Apache-2.0
-- Each compressed instruction decodes as the 32-bit one to which it expands, and no other is legal.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity compressed_decoder_tb is
end entity;

architecture tb of compressed_decoder_tb is

  type pair_t is record
    compressed : std_ulogic_vector(15 downto 0);
    word : word_t;
  end record;
  type pairs_t is array (natural range <>) of pair_t;
  -- Both from an assembler.
  constant pairs : pairs_t := (
    (x"0048", x"00410513"),  -- addi a0, sp, 4
    (x"1fe0", x"3fc10413"),  -- addi s0, sp, 1020
    (x"003c", x"00810793"),  -- addi a5, sp, 8
    (x"0810", x"01010613"),  -- addi a2, sp, 16
    (x"0094", x"04010693"),  -- addi a3, sp, 64
    (x"0414", x"20010693"),  -- addi a3, sp, 512
    (x"41c8", x"0045a503"),  -- lw a0, 4(a1)
    (x"5fe4", x"07c7a483"),  -- lw s1, 124(a5)
    (x"4030", x"04042603"),  -- lw a2, 64(s0)
    (x"c588", x"00a5a423"),  -- sw a0, 8(a1)
    (x"dc7c", x"06f42e23"),  -- sw a5, 124(s0)
    (x"c2a4", x"0496a023"),  -- sw s1, 64(a3)
    (x"0001", x"00000013"),  -- nop
    (x"057d", x"01f50513"),  -- addi a0, a0, 31
    (x"1f81", x"fe0f8f93"),  -- addi t6, t6, -32
    (x"0a05", x"001a0a13"),  -- addi s4, s4, 1
    (x"a005", x"0200006f"),  -- j .+32
    (x"2005", x"020000ef"),  -- jal ra, .+32
    (x"a081", x"0400006f"),  -- j .+64
    (x"2081", x"040000ef"),  -- jal ra, .+64
    (x"a041", x"0800006f"),  -- j .+128
    (x"2041", x"080000ef"),  -- jal ra, .+128
    (x"a201", x"1000006f"),  -- j .+256
    (x"2201", x"100000ef"),  -- jal ra, .+256
    (x"a401", x"2000006f"),  -- j .+512
    (x"2401", x"200000ef"),  -- jal ra, .+512
    (x"a101", x"4000006f"),  -- j .+1024
    (x"2101", x"400000ef"),  -- jal ra, .+1024
    (x"bffd", x"fffff06f"),  -- j .-2
    (x"3ffd", x"fffff0ef"),  -- jal ra, .-2
    (x"a801", x"0100006f"),  -- j .+16
    (x"2801", x"010000ef"),  -- jal ra, .+16
    (x"5281", x"fe000293"),  -- li t0, -32
    (x"4dfd", x"01f00d93"),  -- li s11, 31
    (x"4501", x"00000513"),  -- li a0, 0
    (x"0141", x"01010113"),  -- addi sp, sp, 16
    (x"7101", x"e0010113"),  -- addi sp, sp, -512
    (x"6105", x"02010113"),  -- addi sp, sp, 32
    (x"6121", x"04010113"),  -- addi sp, sp, 64
    (x"6109", x"08010113"),  -- addi sp, sp, 128
    (x"6111", x"10010113"),  -- addi sp, sp, 256
    (x"6505", x"00001537"),  -- lui a0, 1
    (x"6afd", x"0001fab7"),  -- lui s5, 31
    (x"7f81", x"fffe0fb7"),  -- lui t6, 0xfffe0
    (x"8105", x"00155513"),  -- srli a0, a0, 1
    (x"80fd", x"01f4d493"),  -- srli s1, s1, 31
    (x"87c1", x"4107d793"),  -- srai a5, a5, 16
    (x"9b7d", x"fff77713"),  -- andi a4, a4, -1
    (x"887d", x"01f47413"),  -- andi s0, s0, 31
    (x"8d0d", x"40b50533"),  -- sub a0, a0, a1
    (x"8cbd", x"00f4c4b3"),  -- xor s1, s1, a5
    (x"8e55", x"00d66633"),  -- or a2, a2, a3
    (x"8f61", x"00877733"),  -- and a4, a4, s0
    (x"cd7d", x"0e050f63"),  -- beqz a0, .+254
    (x"d081", x"f00480e3"),  -- beqz s1, .-256
    (x"c2a1", x"04068063"),  -- beqz a3, .+64
    (x"e385", x"02079063"),  -- bnez a5, .+32
    (x"e401", x"00041463"),  -- bnez s0, .+8
    (x"fc7d", x"fe041fe3"),  -- bnez s0, .-2
    (x"0e7e", x"01fe1e13"),  -- slli t3, t3, 31
    (x"0906", x"00191913"),  -- slli s2, s2, 1
    (x"4082", x"00012083"),  -- lw ra, 0(sp)
    (x"5ffe", x"0fc12f83"),  -- lw t6, 252(sp)
    (x"5502", x"02012503"),  -- lw a0, 32(sp)
    (x"4506", x"04012503"),  -- lw a0, 64(sp)
    (x"8082", x"00008067"),  -- jr ra
    (x"8302", x"00030067"),  -- jr t1
    (x"852e", x"00b00533"),  -- add a0, zero, a1
    (x"8d7e", x"01f00d33"),  -- add s10, zero, t6
    (x"9002", x"00100073"),  -- ebreak
    (x"9082", x"000080e7"),  -- jalr ra
    (x"9982", x"000980e7"),  -- jalr s3
    (x"92fe", x"01f282b3"),  -- add t0, t0, t6
    (x"9526", x"00950533"),  -- add a0, a0, s1
    (x"dfee", x"0fb12e23"),  -- sw s11, 252(sp)
    (x"c006", x"00112023"),  -- sw ra, 0(sp)
    (x"d032", x"02c12023"),  -- sw a2, 32(sp)
    (x"c0b2", x"04c12023"));  -- sw a2, 64(sp)

  signal compressed : std_ulogic_vector(15 downto 0) := x"0001";
  signal word : word_t := x"00000013";
  signal decoded, reference : control_t;
  signal first, second, reference_first, reference_second : register_index_t;
  signal immediate, reference_immediate : word_t;

begin

  uut : entity work.compressed_decoder
    port map (instruction => compressed, decoded => decoded, immediate => immediate);

  -- The reference, which has its own bench.
  word_decoder : entity work.word_decoder
    port map (instruction => word, decoded => reference, immediate => reference_immediate);

  -- The source registers, too.
  selector : entity work.register_selector
    port map (instruction => x"ffff" & compressed, is_word => '0', first => first, second => second);
  word_selector : entity work.register_selector
    port map (instruction => word, is_word => '1', first => reference_first, second => reference_second);

  check : process
    variable legal : natural;
    variable is_second_operand : boolean;
    variable destination : register_index_t;

    procedure compare(condition : boolean; what : string) is
    begin
      assert condition report what & " of " & to_hstring(compressed) severity failure;
    end procedure;

    -- Number of legal instructions in this quadrant with this funct3.
    procedure expect_legal(quadrant, funct3 : natural; wanted : natural) is
    begin
      legal := 0;
      for code in 0 to 2047 loop
        compressed <= std_ulogic_vector(to_unsigned(funct3, 3)) &
                      std_ulogic_vector(to_unsigned(code, 11)) &
                      std_ulogic_vector(to_unsigned(quadrant, 2));
        wait for 1 ns;
        if (or decoded.legal) = '1' then
          legal := legal + 1;
        end if;
      end loop;
      assert legal = wanted report integer'image(legal) & " legal in quadrant " &
        integer'image(quadrant) & ", funct3 " & integer'image(funct3) severity failure;
    end procedure;
  begin
    for index in pairs'range loop
      compressed <= pairs(index).compressed;
      word <= pairs(index).word;
      wait for 1 ns;
      compare((or decoded.legal) = '1' and (or reference.legal) = '1', "legality");
      destination := "00001" when decoded.writes_link = '1' else decoded.destination;
      compare(decoded.writes = (reference.writes and (or reference.destination)) or
              (destination = "00000" and reference.destination = "00000"), "result");
      compare(decoded.late = reference.late, "late");
      compare(decoded.writes = '0' or destination = reference.destination, "destination");
      compare(decoded.load = reference.load and decoded.store = reference.store and
              decoded.branch = reference.branch and decoded.jump = reference.jump and
              decoded.jump_register = reference.jump_register and
              decoded.breakpoint = reference.breakpoint, "kind");
      compare((decoded.address_result or decoded.multiply or decoded.divide or decoded.csr or
               decoded.environment_call or decoded.trap_return or
               decoded.wait_for_interrupt) = '0', "no such kind");
      if not decoded.breakpoint then
        -- The expansion adds to x0; the decoder passes the second operand.
        is_second_operand := decoded.operation = "101" and decoded.shift = '0';
        if is_second_operand then
          compare(decoded.reads_first = '0' and decoded.second_is_immediate = reference.second_is_immediate
                  and (reference.operation = "101" or
                       (reference.operation = "000" and reference_first = "00000")), "constant");
        end if;
        compare(decoded.jump = '1' or is_second_operand or first = reference_first, "rs1");
        if decoded.second_is_immediate = '0' and not (decoded.jump or decoded.jump_register or
                                                     decoded.load) = '1' then
          compare(decoded.reads_second = '1' and
                  second = reference_second, "rs2");
        end if;
        -- branch_predictor generates those of jumps and branches.
        if (decoded.load or decoded.store or decoded.jump_register or
            (decoded.second_is_immediate and not decoded.jump and not decoded.branch)) = '1' then
          -- A shift uses only the lowest five bits.
          compare(immediate = reference_immediate or
                  (decoded.shift = '1' and
                   immediate(4 downto 0) = reference_immediate(4 downto 0)), "constant");
        end if;
        if (decoded.load or decoded.store or decoded.branch) = '1' then
          compare(decoded.funct3 = reference.funct3, "funct3");
        elsif not is_second_operand and (decoded.jump or decoded.jump_register) = '0' then
          compare(decoded.operation = reference.operation and decoded.shift = reference.shift and
                  decoded.subtract = reference.subtract and
                  (decoded.operation /= "101" or
                   decoded.arithmetic_shift = reference.arithmetic_shift) and
                  decoded.second_is_immediate = reference.second_is_immediate, "operation");
        end if;
        -- Source registers can cause a hazard; x0 never does.
        compare(decoded.reads_first = reference.reads_first or is_second_operand or
                decoded.jump = '1', "wait");
      end if;
    end loop;

    expect_legal(0, 0, 2048 - 8);  -- addi to sp, but of 0
    expect_legal(0, 2, 2048);
    expect_legal(0, 6, 2048);
    expect_legal(1, 0, 2048);
    expect_legal(1, 1, 2048);
    expect_legal(1, 2, 2048);
    expect_legal(1, 3, 2048 - 32);  -- lui and addi to sp, but of 0
    expect_legal(1, 4, 256 + 256 + 512 + 256);  -- srli, srai, andi, four operations
    expect_legal(1, 5, 2048);
    expect_legal(1, 6, 2048);
    expect_legal(1, 7, 2048);
    expect_legal(2, 0, 1024);
    expect_legal(2, 2, 2048 - 64);  -- lw from sp, but to x0
    expect_legal(2, 4, 2048 - 1);  -- but jr x0
    expect_legal(2, 6, 2048);
    for funct3 in 0 to 7 loop
      case funct3 is
        when 1 | 3 | 4 | 5 | 7 => expect_legal(0, funct3, 0);
        when others => null;
      end case;
      case funct3 is
        when 1 | 3 | 5 | 7 => expect_legal(2, funct3, 0);
        when others => null;
      end case;
    end loop;
    std.env.finish;
  end process;

end architecture;
