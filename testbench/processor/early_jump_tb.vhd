-- SPDX-License-Identifier: Apache-2.0
-- jal, and bne, bge, bgeu backwards, go to their target while they are decoded, all others on; what execute
-- is told then.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity early_jump_tb is
end entity;

architecture tb of early_jump_tb is

  signal valid, is_word, jump : std_ulogic := '1';
  signal instruction, immediate : word_t := (others => '0');
  signal address : unsigned(31 downto 0) := x"80001000";
  signal decoded : decoded_t;
  signal target, target_plus_2, following, other : unsigned(31 downto 0);
  signal turn : late_turn_t;

begin

  is_word <= and instruction(1 downto 0);

  instruction_decoder : entity work.instruction_decoder
    port map (instruction => instruction, is_word => is_word, decoded => decoded, immediate => immediate,
              first => open, second => open);

  uut : entity work.early_jump
    port map (
      valid => valid,
      address => address,
      instruction => instruction,
      is_word => is_word,
      decoded => decoded,
      jump => jump,
      target => target,
      target_plus_2 => target_plus_2,
      following => following,
      other => other,
      turn => turn);

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

    -- It jumps, or goes on and may go there later.
    procedure expect(word : word_t; distance : integer; jumps : std_ulogic) is
      variable wanted : unsigned(31 downto 0);
    begin
      for place in 0 to 1 loop
        address <= x"80001000" when place = 0 else x"8000fffe";
        decode(word);
        wanted := address + unsigned(to_signed(distance, 32));
        assert (or decoded.legal) = '1' and jump = jumps report to_hstring(word) severity failure;
        assert target = wanted and target_plus_2 = wanted + 2
          report to_hstring(word) & " goes to " & to_hstring(target) severity failure;
        assert following = wanted or jumps = '0' severity failure;
        assert following = link or jumps = '1' severity failure;
        assert other = link or jumps = '0' severity failure;
        assert other = wanted or jumps = '1' severity failure;
      end loop;
    end procedure;

    procedure expect_on(word : word_t) is
    begin
      decode(word);
      assert jump = '0' and following = link report to_hstring(word) & " jumps" severity failure;
    end procedure;

    procedure expect_turn(word : word_t; wanted : std_ulogic_vector(2 downto 0)) is
    begin
      decode(word);
      assert turn.if_below & turn.if_above & turn.inverted = wanted
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

    -- auipc, as a sum of addresses.
    address <= x"80001002";
    decode(x"fffff517");
    assert other = x"80000002" and jump = '0' severity failure;
    decode(x"12345517");
    assert other = x"92346002" and jump = '0' severity failure;

    -- jalr links; fence.i goes on anew.
    expect_on(x"00850567");
    assert other = link severity failure;
    expect_on(x"ffff9582");
    assert other = link severity failure;
    expect_on(x"0000100f");
    assert other = link severity failure;
    -- What resembles jumps.
    for index in not_jumps'range loop
      expect_on(not_jumps(index));
    end loop;

    -- Where there is none, it stays where it is.
    valid <= '0';
    decode(x"ffdff06f");
    assert jump = '0' and following = address severity failure;
    decode(x"ffffbffd");
    assert jump = '0' and following = address severity failure;
    valid <= '1';

    -- If below, if above, inverted: as it is named, or where it was taken the other way round.
    expect_turn(x"00850567", "001");  -- jalr
    expect_turn(x"ffff9582", "001");
    expect_turn(x"0000100f", "001");  -- fence.i
    expect_turn(x"ffdff06f", "000");  -- j
    expect_turn(x"00b50533", "000");  -- add
    expect_turn(x"00000463", "111");  -- beq
    expect_turn(x"00001463", "110");  -- bne
    expect_turn(x"00004463", "100");  -- blt
    expect_turn(x"00005463", "101");  -- bge
    expect_turn(x"00006463", "100");  -- bltu
    expect_turn(x"00007463", "101");  -- bgeu
    expect_turn(x"fe000ee3", "111");
    expect_turn(x"fe001ee3", "111");
    expect_turn(x"fe004ee3", "100");
    expect_turn(x"fe005ee3", "100");
    expect_turn(x"fe006ee3", "100");
    expect_turn(x"fe007ee3", "100");
    expect_turn(x"0000cd7d", "111");  -- c.beqz
    expect_turn(x"ffffd081", "111");
    expect_turn(x"0000e401", "110");  -- c.bnez
    expect_turn(x"fffffc7d", "111");
    std.env.finish;
  end process;

end architecture;
