-- SPDX-License-Identifier: Apache-2.0
-- Quotient times divisor plus remainder is the dividend, after 34 clocks, whatever the values.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

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
      assert clocks = 34 report "took " & integer'image(clocks) & " clocks" severity failure;
      answer := result;
      wait until rising_edge(clk);
      request <= '0';
      wait for 1 ns;
      assert done = '0' severity failure;
    end procedure;
    variable quotient, remainder : word_t;
    variable product : unsigned(63 downto 0);
  begin
    wait until rising_edge(clk);
    reset <= '0';
    for a in values'range loop
      for b in values'range loop
        divide("01", values(a), values(b), quotient);
        divide("11", values(a), values(b), remainder);
        if unsigned(values(b)) = 0 then
          assert quotient = x"ffffffff" and remainder = values(a) severity failure;
        else
          product := unsigned(quotient) * unsigned(values(b)) + unsigned(remainder);
          assert product = unsigned(values(a)) and unsigned(remainder) < unsigned(values(b))
            report "unsigned " & to_hstring(values(a)) & " by " & to_hstring(values(b))
            severity failure;
        end if;

        divide("00", values(a), values(b), quotient);
        divide("10", values(a), values(b), remainder);
        if unsigned(values(b)) = 0 then
          assert quotient = x"ffffffff" and remainder = values(a) severity failure;
        else
          product := unsigned(quotient) * unsigned(values(b)) + unsigned(remainder);
          assert product(31 downto 0) = unsigned(values(a)) and
            (remainder = x"00000000" or remainder(31) = values(a)(31)) and
            abs resize(signed(remainder), 33) < abs resize(signed(values(b)), 33)
            report "signed " & to_hstring(values(a)) & " by " & to_hstring(values(b))
            severity failure;
        end if;
      end loop;
    end loop;

    -- A division given up leaves nothing behind.
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
