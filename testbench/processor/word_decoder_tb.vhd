-- SPDX-License-Identifier: Apache-2.0
-- Immediates of each format, control signals, and that exactly the words of RV32IM are legal.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity word_decoder_tb is
end entity;

architecture tb of word_decoder_tb is

  signal instruction : word_t := (others => '0');
  signal decoded : control_t;
  signal immediate : word_t;

begin

  uut : entity work.word_decoder
    port map (instruction => instruction, decoded => decoded, immediate => immediate);

  check : process
    type addresses_t is array (natural range <>) of std_ulogic_vector(11 downto 0);
    -- Trap, counter, trigger, shadow and identity CSRs; and the 87 counters and events that are zero.
    constant csrs : addresses_t := (
      x"300", x"301", x"304", x"305", x"310", x"340", x"341", x"342", x"343", x"344", x"320", x"7a0",
      x"7a1", x"7a2", x"7a3", x"b00", x"b02", x"b80", x"b82", x"c00", x"c02", x"c80", x"c82", x"f11",
      x"f12", x"f13", x"f14", x"f15");
    variable legal_words, existing : natural;

    procedure decode(word : word_t) is
    begin
      instruction <= word;
      wait for 1 ns;
    end procedure;

    procedure expect_offset(word, offset : word_t) is
    begin
      decode(word);
      assert (or decoded.legal) = '1' and immediate = offset
        report to_hstring(word) & " has offset " & to_hstring(immediate) severity failure;
    end procedure;

    procedure expect_constant(word, operand : word_t) is
    begin
      decode(word);
      assert (or decoded.legal) = '1' and decoded.second_is_immediate = '1' and
        immediate = operand report to_hstring(word) severity failure;
    end procedure;

    -- Number of legal funct7 and funct3 with this opcode.
    procedure expect_legal(opcode : std_ulogic_vector(6 downto 0); wanted : natural) is
      variable word : word_t;
    begin
      legal_words := 0;
      for code in 0 to 1023 loop
        word := (others => '0');
        word(6 downto 0) := opcode;
        word(14 downto 12) := std_ulogic_vector(to_unsigned(code mod 8, 3));
        word(31 downto 25) := std_ulogic_vector(to_unsigned(code / 8, 7));
        -- Register fields that are zero in all privileged instructions.
        word(11 downto 7) := "00001";
        decode(word);
        if (or decoded.legal) = '1' then
          legal_words := legal_words + 1;
        end if;
      end loop;
      assert legal_words = wanted report "opcode " & to_string(opcode) & " has " &
        integer'image(legal_words) & " legal words" severity failure;
    end procedure;
  begin
    expect_offset(x"fff52503", x"ffffffff");  -- lw a0, -1(a0)
    expect_offset(x"7ff52503", x"000007ff");
    expect_offset(x"fea52fa3", x"ffffffff");  -- sw a0, -1(a0)
    expect_offset(x"00a525a3", x"0000000b");  -- sw a0, 11(a0)
    expect_constant(x"80050513", x"fffff800");  -- addi a0, a0, -2048
    expect_constant(x"12345537", x"12345000");  -- lui
    assert decoded.operation = "101" and decoded.shift = '0' and decoded.reads_first = '0'
      report "lui has its constant as the result" severity failure;
    decode(x"fffff517");  -- auipc
    assert decoded.address_result = '1' severity failure;
    expect_offset(x"00850567", x"00000008");  -- jalr a0, 8(a0)
    assert decoded.jump_register = '1' and decoded.jump = '0' and decoded.writes_link = '0'
      severity failure;

    -- Writes (also x0 here), late results, reads.
    decode(x"00b50033");
    assert decoded.writes = '1' and decoded.destination = "00000" and decoded.reads_first = '1' and
      decoded.reads_second = '1' and decoded.late = '0' severity failure;
    decode(x"00052583");
    assert decoded.writes = '1' and decoded.load = '1' and decoded.late = '1' and
      decoded.reads_first = '1' and decoded.reads_second = '0' severity failure;
    decode(x"02b54533");
    assert decoded.divide = '1' and decoded.multiply = '0' severity failure;
    decode(x"02b50533");
    assert decoded.divide = '0' and decoded.multiply = '1' severity failure;
    decode(x"40b50533");
    assert decoded.subtract = '1' and decoded.operation = "000" severity failure;
    assert decoded.shift = '0' severity failure;
    decode(x"00151513");
    assert decoded.operation = "001" and decoded.shift = '1' severity failure;
    decode(x"c0050513");
    assert decoded.subtract = '0' report "addi of a negative constant does not subtract"
      severity failure;
    decode(x"30046573");
    assert decoded.csr = '1' and decoded.reads_first = '0' severity failure;
    decode(x"30051573");
    assert decoded.csr = '1' and decoded.reads_first = '1' severity failure;
    decode(x"00000073");
    assert decoded.environment_call = '1' and (or decoded.legal) = '1' severity failure;
    decode(x"00100073");
    assert decoded.breakpoint = '1' and (or decoded.legal) = '1' severity failure;
    decode(x"30200073");
    assert decoded.trap_return = '1' and (or decoded.legal) = '1' severity failure;
    decode(x"10500073");
    assert decoded.wait_for_interrupt = '1' and (or decoded.legal) = '1' severity failure;
    decode(x"30200173");
    assert decoded.trap_return = '0' and (or decoded.legal) = '0' severity failure;

    existing := 0;
    for address in 0 to 4095 loop
      decode(std_ulogic_vector(to_unsigned(address, 12)) & x"02573");
      if decoded.csr_exists then
        existing := existing + 1;
      end if;
      assert decoded.csr = '1' severity failure;
    end loop;
    assert existing = csrs'length + 87 report integer'image(existing) & " CSRs" severity failure;
    for index in csrs'range loop
      decode(csrs(index) & x"02573");
      assert decoded.csr_exists = '1' report to_hstring(csrs(index)) severity failure;
    end loop;
    for number in 3 to 31 loop
      decode((x"b00" or std_ulogic_vector(to_unsigned(number, 12))) & x"02573");
      assert decoded.csr_exists = '1' severity failure;
      decode((x"b80" or std_ulogic_vector(to_unsigned(number, 12))) & x"02573");
      assert decoded.csr_exists = '1' severity failure;
      decode((x"320" or std_ulogic_vector(to_unsigned(number, 12))) & x"02573");
      assert decoded.csr_exists = '1' severity failure;
    end loop;

    expect_legal("0110111", 1024);
    expect_legal("0010111", 1024);
    expect_legal("1101111", 1024);
    expect_legal("1100111", 128);
    expect_legal("1100011", 6 * 128);
    expect_legal("0000011", 5 * 128);
    expect_legal("0100011", 3 * 128);
    expect_legal("0010011", 6 * 128 + 3);
    expect_legal("0110011", 8 + 2 + 8);
    expect_legal("0001111", 2 * 128);
    expect_legal("1110011", 6 * 128);
    -- All other opcodes of 32 bits.
    for code in 0 to 31 loop
      case std_ulogic_vector(to_unsigned(code, 5)) is
        when "01101" | "00101" | "11011" | "11001" | "11000" | "00000" | "01000" | "00100" |
             "01100" | "00011" | "11100" => null;
        when others => expect_legal(std_ulogic_vector(to_unsigned(code, 5)) & "11", 0);
      end case;
    end loop;
    std.env.finish;
  end process;

end architecture;
