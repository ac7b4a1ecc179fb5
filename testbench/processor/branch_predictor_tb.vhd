-- SPDX-License-Identifier: Apache-2.0
-- jal, and backward bne, bge, bgeu, are taken in decode, all other branches predicted not taken; the
-- alternate address and redirect condition for execute.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity branch_predictor_tb is
end entity;

architecture tb of branch_predictor_tb is

  signal valid, is_word, taken : std_ulogic := '1';
  signal instruction, immediate : word_t := (others => '0');
  signal address : unsigned(31 downto 0) := x"80001000";
  signal decoded : control_t;
  signal target, target_plus_2, next_address, alternate_address : unsigned(31 downto 0);
  signal condition : redirect_condition_t;

begin

  is_word <= and instruction(1 downto 0);

  instruction_decoder : entity work.instruction_decoder
    port map (instruction => instruction, is_word => is_word, decoded => decoded, immediate => immediate,
              first => open, second => open);

  uut : entity work.branch_predictor
    port map (
      valid => valid,
      address => address,
      instruction => instruction,
      is_word => is_word,
      decoded => decoded,
      taken => taken,
      target => target,
      target_plus_2 => target_plus_2,
      next_address => next_address,
      alternate_address => alternate_address,
      condition => condition);

  check : process
    type words_t is array (natural range <>) of word_t;
    -- addi, lui, sw, c.sw to sp, c.andi, c.addi to sp, csrrsi.
    constant not_jumps : words_t := (
      x"fff50513", x"ffdff037", x"fea52fa3", x"ffffdfee", x"ffff9b7d", x"ffff7101", x"30046573");

    procedure decode(word : word_t) is
    begin
      instruction <= word;
      wait for 1 ns;
    end procedure;

    impure function link return unsigned is
    begin
      if is_word then
        return address + 4;
      end if;
      return address + 2;
    end function;

    -- Taken to the target, or not taken with the target as the alternate address.
    procedure expect(word : word_t; distance : integer; is_taken : std_ulogic) is
      variable wanted : unsigned(31 downto 0);
    begin
      for place in 0 to 1 loop
        address <= x"80001000" when place = 0 else x"8000fffe";
        decode(word);
        wanted := address + unsigned(to_signed(distance, 32));
        assert (or decoded.legal) = '1' and taken = is_taken report to_hstring(word) severity failure;
        assert target = wanted and target_plus_2 = wanted + 2
          report to_hstring(word) & " goes to " & to_hstring(target) severity failure;
        assert next_address = wanted or is_taken = '0' severity failure;
        assert next_address = link or is_taken = '1' severity failure;
        assert alternate_address = link or is_taken = '0' severity failure;
        assert alternate_address = wanted or is_taken = '1' severity failure;
      end loop;
    end procedure;

    procedure expect_not_taken(word : word_t) is
    begin
      decode(word);
      assert taken = '0' and next_address = link report to_hstring(word) & " is taken" severity failure;
    end procedure;

    procedure expect_condition(word : word_t; wanted : std_ulogic_vector(2 downto 0)) is
    begin
      decode(word);
      assert condition.if_below & condition.if_above & condition.inverted = wanted
        report to_hstring(word) severity failure;
    end procedure;
  begin
    expect(x"ffdff06f", -4, '1');          -- j
    expect(x"0080006f", 8, '1');
    expect(x"800000ef", -1_048_576, '1');  -- jal
    expect(x"7ffff0ef", 1_048_574, '1');
    expect(x"fe001ee3", -4, '1');          -- bne
    expect(x"80001063", -4096, '1');
    expect(x"fe005ee3", -4, '1');          -- bge
    expect(x"fe007ee3", -4, '1');          -- bgeu
    expect(x"00007463", 8, '0');
    expect(x"fe000ee3", -4, '0');          -- beq
    expect(x"80000063", -4096, '0');
    expect(x"fe004ee3", -4, '0');          -- blt
    expect(x"fe006ee3", -4, '0');          -- bltu
    expect(x"00000463", 8, '0');
    expect(x"7e000fe3", 4094, '0');
    expect(x"ffffbffd", -2, '1');          -- c.j
    expect(x"0000a801", 16, '1');
    expect(x"ffff2401", 512, '1');         -- c.jal
    expect(x"0000a101", 1024, '1');
    expect(x"0000a081", 64, '1');
    expect(x"0000a041", 128, '1');
    expect(x"0000a201", 256, '1');
    expect(x"0000a005", 32, '1');
    expect(x"fffffc7d", -2, '1');          -- c.bnez
    expect(x"fffff081", -256, '1');
    expect(x"ffffd081", -256, '0');        -- c.beqz
    expect(x"0000cd7d", 254, '0');
    expect(x"ffffc2a1", 64, '0');
    expect(x"0000e385", 32, '0');
    expect(x"0000e401", 8, '0');

    -- auipc: its result is the alternate address.
    address <= x"80001002";
    decode(x"fffff517");
    assert alternate_address = x"80000002" and taken = '0' severity failure;
    decode(x"12345517");
    assert alternate_address = x"92346002" and taken = '0' severity failure;

    -- jalr: the alternate address is its link; fence.i: the next instruction.
    expect_not_taken(x"00850567");
    assert alternate_address = link severity failure;
    expect_not_taken(x"ffff9582");
    assert alternate_address = link severity failure;
    expect_not_taken(x"0000100f");
    assert alternate_address = link severity failure;
    -- Encodings that resemble jumps.
    for index in not_jumps'range loop
      expect_not_taken(not_jumps(index));
    end loop;

    -- Without a valid instruction the address does not advance.
    valid <= '0';
    decode(x"ffdff06f");
    assert taken = '0' and next_address = address severity failure;
    decode(x"ffffbffd");
    assert taken = '0' and next_address = address severity failure;
    valid <= '1';

    -- If below, if above, inverted: the branch's condition if predicted not taken, else the opposite.
    expect_condition(x"00850567", "001");  -- jalr
    expect_condition(x"ffff9582", "001");
    expect_condition(x"0000100f", "001");  -- fence.i
    expect_condition(x"ffdff06f", "000");  -- j
    expect_condition(x"00b50533", "000");  -- add
    expect_condition(x"00000463", "111");  -- beq
    expect_condition(x"00001463", "110");  -- bne
    expect_condition(x"00004463", "100");  -- blt
    expect_condition(x"00005463", "101");  -- bge
    expect_condition(x"00006463", "100");  -- bltu
    expect_condition(x"00007463", "101");  -- bgeu
    expect_condition(x"fe000ee3", "111");
    expect_condition(x"fe001ee3", "111");
    expect_condition(x"fe004ee3", "100");
    expect_condition(x"fe005ee3", "100");
    expect_condition(x"fe006ee3", "100");
    expect_condition(x"fe007ee3", "100");
    expect_condition(x"0000cd7d", "111");  -- c.beqz
    expect_condition(x"ffffd081", "111");
    expect_condition(x"0000e401", "110");  -- c.bnez
    expect_condition(x"fffffc7d", "111");
    std.env.finish;
  end process;

end architecture;
