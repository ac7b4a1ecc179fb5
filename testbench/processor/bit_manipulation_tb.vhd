-- SPDX-License-Identifier: Apache-2.0
-- Each instruction equals a bit-by-bit model, one clock later, and holds its result.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;
use work.random_source_pkg.all;

entity bit_manipulation_tb is
end entity;

architecture tb of bit_manipulation_tb is

  signal clk : std_ulogic := '0';
  signal enable, less : std_ulogic := '0';
  signal instruction, first, second, result : word_t := (others => '0');
  shared variable random : random_source_t;

  type words_t is array (natural range <>) of word_t;
  constant values : words_t := (
    x"00000000", x"00000001", x"ffffffff", x"80000000", x"7fffffff", x"12345678", x"0000ff00",
    x"deadbeef", x"00800080", x"00008000", x"01000000", x"00010203");

  -- The words without registers, from an assembler.
  constant clz : word_t := x"60059513";
  constant ctz : word_t := x"60159513";
  constant cpop : word_t := x"60259513";
  constant sext_b : word_t := x"60459513";
  constant sext_h : word_t := x"60559513";
  constant orc_b : word_t := x"2875d513";
  constant rev8 : word_t := x"6985d513";
  constant zext_h : word_t := x"0805c533";
  constant min : word_t := x"0ac5c533";
  constant minu : word_t := x"0ac5d533";
  constant max : word_t := x"0ac5e533";
  constant maxu : word_t := x"0ac5f533";

begin

  clk <= not clk after 5 ns;

  uut : entity work.bit_manipulation
    port map (
      clk => clk,
      enable => enable,
      instruction => instruction,
      first => first,
      second => second,
      less => less,
      result => result);

  check : process
    procedure expect(word, a, b, wanted : word_t; name : string) is
    begin
      instruction <= word;
      first <= a;
      second <= b;
      -- The ALU's comparison.
      less <= '1' when (word(12) = '1' and unsigned(a) < unsigned(b)) or
                       (word(12) = '0' and signed(a) < signed(b)) else '0';
      enable <= '1';
      wait until rising_edge(clk);
      enable <= '0';
      -- Inputs after the clock of `enable` are don't care.
      instruction <= not word;
      first <= not a;
      second <= a xor b;
      less <= not less;
      for clocks in 1 to 2 loop
        wait for 1 ns;
        assert result = wanted
          report name & " of " & to_hstring(a) & " and " & to_hstring(b) & " gives " &
            to_hstring(result) severity failure;
        wait until rising_edge(clk);
      end loop;
    end procedure;

    function as_word(value : natural) return word_t is
    begin
      return std_ulogic_vector(to_unsigned(value, 32));
    end function;

    procedure check_all(a, b : word_t) is
      variable leading, trailing, ones : natural := 0;
      variable bytes, backwards : word_t := (others => '0');
      variable smaller, smaller_unsigned, larger, larger_unsigned : word_t;
    begin
      for index in 31 downto 0 loop
        exit when a(index) = '1';
        leading := leading + 1;
      end loop;
      for index in 0 to 31 loop
        exit when a(index) = '1';
        trailing := trailing + 1;
      end loop;
      for index in 0 to 31 loop
        if a(index) = '1' then
          ones := ones + 1;
          bytes(8 * (index / 8) + 7 downto 8 * (index / 8)) := x"ff";
        end if;
        backwards(8 * (3 - index / 8) + index mod 8) := a(index);
      end loop;
      smaller := a;
      larger := b;
      if signed(a) > signed(b) then
        smaller := b;
        larger := a;
      end if;
      smaller_unsigned := a;
      larger_unsigned := b;
      if unsigned(a) > unsigned(b) then
        smaller_unsigned := b;
        larger_unsigned := a;
      end if;
      expect(clz, a, b, as_word(leading), "clz");
      expect(ctz, a, b, as_word(trailing), "ctz");
      expect(cpop, a, b, as_word(ones), "cpop");
      expect(orc_b, a, b, bytes, "orc.b");
      expect(rev8, a, b, backwards, "rev8");
      expect(sext_b, a, b, std_ulogic_vector(resize(signed(a(7 downto 0)), 32)), "sext.b");
      expect(sext_h, a, b, std_ulogic_vector(resize(signed(a(15 downto 0)), 32)), "sext.h");
      expect(zext_h, a, b, x"0000" & a(15 downto 0), "zext.h");
      expect(min, a, b, smaller, "min");
      expect(minu, a, b, smaller_unsigned, "minu");
      expect(max, a, b, larger, "max");
      expect(maxu, a, b, larger_unsigned, "maxu");
    end procedure;

    -- Random lengths, with leading or trailing ones or zeros.
    impure function random_word return word_t is
      variable word : unsigned(31 downto 0);
    begin
      word := to_unsigned(random.between(0, 65535), 16) & to_unsigned(random.between(0, 65535), 16);
      case random.between(0, 3) is
        when 0 => word := shift_right(word, random.between(0, 31));
        when 1 => word := shift_left(word, random.between(0, 31));
        when 2 => word := not shift_right(word, random.between(0, 31));
        when others => null;
      end case;
      return std_ulogic_vector(word);
    end function;
  begin
    for a in values'range loop
      for b in values'range loop
        check_all(values(a), values(b));
      end loop;
    end loop;
    for place in 0 to 31 loop
      check_all(std_ulogic_vector(shift_left(to_unsigned(1, 32), place)), x"00000000");
      check_all(not std_ulogic_vector(shift_left(to_unsigned(1, 32), place)), x"ffffffff");
    end loop;
    for count in 1 to 1000 loop
      check_all(random_word, random_word);
    end loop;
    std.env.finish;
  end process;

end architecture;
