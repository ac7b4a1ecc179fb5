-- SPDX-License-Identifier: Apache-2.0
-- Source registers of instructions from an assembler.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity register_selector_tb is
end entity;

architecture tb of register_selector_tb is

  signal instruction : word_t := (others => '0');
  signal first, second : register_index_t;
  signal is_word : std_ulogic;

begin

  uut : entity work.register_selector
    port map (instruction => instruction, is_word => is_word, first => first, second => second);

  is_word <= and instruction(1 downto 0);

  check : process
    constant none : natural := 99;

    procedure expect(word : word_t; first_wanted : natural; second_wanted : natural) is
    begin
      instruction <= word;
      wait for 1 ns;
      assert first_wanted = none or to_integer(unsigned(first)) = first_wanted
        report to_hstring(word) severity failure;
      assert second_wanted = none or to_integer(unsigned(second)) = second_wanted
        report to_hstring(word) severity failure;
    end procedure;
  begin
    expect(x"00b60533", 12, 11);    -- add a0, a2, a1
    expect(x"01ef8fb3", 31, 30);    -- add t6, t6, t5
    expect(x"fff52503", 10, none);  -- lw a0, -1(a0)
    expect(x"fea52fa3", 10, 10);    -- sw a0, -1(a0)
    expect(x"fe209ee3", 1, 2);      -- bne ra, sp, -4
    expect(x"30051573", 10, none);  -- csrrw a0, mstatus, a0
    expect(x"ffff0048", 2, none);   -- addi a0, sp, 4
    expect(x"ffff41c8", 11, none);  -- lw a0, 4(a1)
    expect(x"ffffc588", 11, 10);    -- sw a0, 8(a1)
    expect(x"ffff0a05", 20, none);  -- addi s4, s4, 1
    expect(x"ffff7101", 2, none);   -- addi sp, sp, -512
    expect(x"ffff8105", 10, none);  -- srli a0, a0, 1
    expect(x"ffff9b7d", 14, none);  -- andi a4, a4, -1
    expect(x"ffff8cbd", 9, 15);     -- xor s1, s1, a5
    expect(x"ffffcd7d", 10, 0);     -- beqz a0
    expect(x"ffffe401", 8, 0);      -- bnez s0
    expect(x"ffff0906", 18, none);  -- slli s2, s2, 1
    expect(x"ffff4082", 2, none);   -- lw ra, 0(sp)
    expect(x"ffffdfee", 2, 27);     -- sw s11, 252(sp)
    expect(x"ffff8082", 1, none);   -- jr ra
    expect(x"ffff9982", 19, none);  -- jalr s3
    expect(x"ffff8d7e", none, 31);  -- mv s10, t6
    expect(x"ffff92fe", 5, 31);     -- add t0, t0, t6
    std.env.finish;
  end process;

end architecture;
