-- SPDX-License-Identifier: Apache-2.0
-- Each operation of the ALU equals integer arithmetic.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity alu_tb is
end entity;

architecture tb of alu_tb is

  signal first, second, result : word_t := (others => '0');
  signal operation : std_ulogic_vector(2 downto 0) := "000";
  signal shift, subtract, arithmetic_shift, rotate, compare_unsigned, less : std_ulogic := '0';
  signal comparison : comparison_t;

  type words_t is array (natural range <>) of word_t;
  constant values : words_t := (
    x"00000000", x"00000001", x"ffffffff", x"80000000", x"7fffffff", x"12345678", x"0000001f",
    x"deadbeef", x"00000010");

begin

  uut : entity work.alu
    generic map (has_zbb => true)
    port map (
      first => first,
      second => second,
      operation => operation,
      shift => shift,
      subtract => subtract,
      arithmetic_shift => arithmetic_shift,
      rotate => rotate,
      compare_unsigned => compare_unsigned,
      result => result,
      less => less,
      comparison => comparison);

  check : process
    procedure expect(code : std_ulogic_vector(2 downto 0); other, unsigned_order : std_ulogic;
                     wanted : word_t; name : string) is
    begin
      operation <= code;
      shift <= (not code(1) and code(0)) when name /= "second" else '0';
      subtract <= other;
      arithmetic_shift <= other;
      compare_unsigned <= unsigned_order;
      wait for 1 ns;
      assert result = wanted
        report name & " of " & to_hstring(first) & " and " & to_hstring(second) &
          " gives " & to_hstring(result) severity failure;
    end procedure;
    function flag(condition : boolean) return word_t is
    begin
      if condition then
        return x"00000001";
      end if;
      return x"00000000";
    end function;
    variable distance : natural;
    variable shifted : word_t;
  begin
    for a in values'range loop
      for b in values'range loop
        first <= values(a);
        second <= values(b);
        wait for 1 ns;
        distance := to_integer(unsigned(second(4 downto 0)));
        expect("000", '0', '0', std_ulogic_vector(unsigned(first) + unsigned(second)), "sum");
        expect("000", '1', '0', std_ulogic_vector(unsigned(first) - unsigned(second)),
               "difference");
        expect("010", '1', '0', flag(signed(first) < signed(second)), "less");
        assert (less = '1') = (signed(first) < signed(second)) severity failure;
        assert (comparison.below = '1') = (unsigned(first) < unsigned(second)) severity failure;
        assert (comparison.above = '1') = (unsigned(first) > unsigned(second)) severity failure;
        assert comparison.signs_differ = (first(31) xor second(31)) severity failure;
        expect("011", '1', '1', flag(unsigned(first) < unsigned(second)), "less unsigned");
        assert (less = '1') = (unsigned(first) < unsigned(second)) severity failure;
        assert comparison.signs_differ = '0' severity failure;
        expect("100", '0', '0', first xor second, "xor");
        expect("110", '0', '0', first or second, "or");
        expect("111", '0', '0', first and second, "and");
        expect("101", '0', '0', second, "second");
        expect("100", '1', '0', first xnor second, "xnor");
        expect("110", '1', '0', first or not second, "or not");
        expect("111", '1', '0', first and not second, "and not");
        -- Shifts bit by bit.
        shifted := first;
        for count in 1 to distance loop
          shifted := shifted(30 downto 0) & '0';
        end loop;
        expect("001", '0', '0', shifted, "shift left");
        shifted := first;
        for count in 1 to distance loop
          shifted := '0' & shifted(31 downto 1);
        end loop;
        expect("101", '0', '0', shifted, "shift right");
        shifted := first;
        for count in 1 to distance loop
          shifted := first(31) & shifted(31 downto 1);
        end loop;
        expect("101", '1', '0', shifted, "arithmetic shift right");
        rotate <= '1';
        shifted := first;
        for count in 1 to distance loop
          shifted := shifted(30 downto 0) & shifted(31);
        end loop;
        expect("001", '1', '0', shifted, "rotation left");
        shifted := first;
        for count in 1 to distance loop
          shifted := shifted(0) & shifted(31 downto 1);
        end loop;
        expect("101", '1', '0', shifted, "rotation right");
        rotate <= '0';
      end loop;
    end loop;
    std.env.finish;
  end process;

end architecture;
