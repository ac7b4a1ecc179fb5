-- SPDX-License-Identifier: Apache-2.0
-- Quotient times divisor plus remainder is the dividend, after 18 clocks, for any values.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;
use work.random_source_pkg.all;

entity divider_tb is
end entity;

architecture tb of divider_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request, done : std_ulogic := '0';
  signal operation : std_ulogic_vector(1 downto 0) := "00";
  signal first, second, result : word_t := (others => '0');

  type words_t is array (natural range <>) of word_t;
  constant values : words_t := (
    x"00000000", x"00000001", x"ffffffff", x"80000000", x"7fffffff", x"12345678", x"0000ffff",
    x"deadbeef", x"00000007", x"fffffff9");
  shared variable random : random_source_t;

begin

  clk <= not clk after 5 ns;

  uut : entity work.divider
    port map (
      clk => clk,
      reset => reset,
      request => request,
      operation => operation,
      first => first,
      second => second,
      done => done,
      result => result);

  check : process
    procedure divide(code : std_ulogic_vector(1 downto 0); a, b : word_t;
                     variable answer : out word_t) is
      variable clocks : natural := 1;
    begin
      request <= '1';
      operation <= code;
      first <= a;
      second <= b;
      wait for 1 ns;
      while done = '0' loop
        wait until rising_edge(clk);
        wait for 1 ns;
        clocks := clocks + 1;
      end loop;
      assert clocks = 18 report "took " & integer'image(clocks) & " clocks" severity failure;
      answer := result;
      wait until rising_edge(clk);
      request <= '0';
      wait for 1 ns;
      assert done = '0' severity failure;
    end procedure;
    procedure check_division(a, b : word_t) is
      variable quotient, remainder : word_t;
      variable product : unsigned(63 downto 0);
    begin
      divide("01", a, b, quotient);
      divide("11", a, b, remainder);
      if unsigned(b) = 0 then
        assert quotient = x"ffffffff" and remainder = a severity failure;
      else
        product := unsigned(quotient) * unsigned(b) + unsigned(remainder);
        assert product = unsigned(a) and unsigned(remainder) < unsigned(b)
          report "unsigned " & to_hstring(a) & " by " & to_hstring(b) severity failure;
      end if;

      divide("00", a, b, quotient);
      divide("10", a, b, remainder);
      if unsigned(b) = 0 then
        assert quotient = x"ffffffff" and remainder = a severity failure;
      else
        product := unsigned(quotient) * unsigned(b) + unsigned(remainder);
        assert product(31 downto 0) = unsigned(a) and
          (remainder = x"00000000" or remainder(31) = a(31)) and
          abs resize(signed(remainder), 33) < abs resize(signed(b), 33)
          report "signed " & to_hstring(a) & " by " & to_hstring(b) severity failure;
      end if;
    end procedure;
    -- Random lengths, for short and long quotients.
    impure function random_word return word_t is
      variable word : unsigned(31 downto 0);
    begin
      word := to_unsigned(random.between(0, 65535), 16) & to_unsigned(random.between(0, 65535), 16);
      word := shift_right(word, random.between(0, 31));
      if random.between(0, 1) = 1 then
        word := 0 - word;
      end if;
      return std_ulogic_vector(word);
    end function;
    variable quotient : word_t;
  begin
    wait until rising_edge(clk);
    reset <= '0';
    for a in values'range loop
      for b in values'range loop
        check_division(values(a), values(b));
      end loop;
    end loop;
    for count in 1 to 1000 loop
      check_division(random_word, random_word);
    end loop;

    -- An aborted division leaves no state behind.
    request <= '1';
    first <= x"ffffffff";
    second <= x"00000001";
    wait for 100 ns;
    request <= '0';
    wait until rising_edge(clk);
    wait for 1 ns;
    divide("01", x"00000064", x"00000007", quotient);
    assert quotient = x"0000000e" severity failure;
    std.env.finish;
  end process;

end architecture;
