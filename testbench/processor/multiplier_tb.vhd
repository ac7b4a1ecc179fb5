-- SPDX-License-Identifier: Apache-2.0
-- Signed and unsigned products equal shift and add, one clock later.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity multiplier_tb is
end entity;

architecture tb of multiplier_tb is

  signal clk : std_ulogic := '0';
  signal enable : std_ulogic := '0';
  signal operation : std_ulogic_vector(1 downto 0) := "00";
  signal first, second, result : word_t := (others => '0');

  type words_t is array (natural range <>) of word_t;
  constant values : words_t := (
    x"00000000", x"00000001", x"ffffffff", x"80000000", x"7fffffff", x"12345678", x"0000ffff",
    x"ffff0000", x"deadbeef", x"00010000");

  -- Both extended to 64 bits, multiplied modulo 2 ** 64.
  function product(first, second : word_t; first_signed, second_signed : boolean) return unsigned is
    variable sum : unsigned(63 downto 0) := (others => '0');
    variable a, b : unsigned(63 downto 0);
  begin
    a := x"00000000" & unsigned(first);
    b := x"00000000" & unsigned(second);
    if first_signed and first(31) = '1' then
      a(63 downto 32) := (others => '1');
    end if;
    if second_signed and second(31) = '1' then
      b(63 downto 32) := (others => '1');
    end if;
    for index in 0 to 63 loop
      if b(index) then
        sum := sum + shift_left(a, index);
      end if;
    end loop;
    return sum;
  end function;

begin

  clk <= not clk after 5 ns;

  uut : entity work.multiplier
    port map (
      clk => clk,
      enable => enable,
      operation => operation,
      first => first,
      second => second,
      result => result);

  check : process
    variable wanted : unsigned(63 downto 0);
    variable kept : word_t;
  begin
    for code in 0 to 3 loop
      for a in values'range loop
        for b in values'range loop
          enable <= '1';
          operation <= std_ulogic_vector(to_unsigned(code, 2));
          first <= values(a);
          second <= values(b);
          wait until rising_edge(clk);
          enable <= '0';
          wait for 1 ns;
          wanted := product(values(a), values(b), code = 1 or code = 2, code = 1);
          kept := std_ulogic_vector(wanted(31 downto 0)) when code = 0 else
                  std_ulogic_vector(wanted(63 downto 32));
          assert result = kept report "operation " & integer'image(code) & " of " &
            to_hstring(values(a)) & " and " & to_hstring(values(b)) severity failure;
          -- The result is stable without `enable`.
          first <= not values(a);
          wait until rising_edge(clk);
          wait for 1 ns;
          assert result = kept severity failure;
        end loop;
      end loop;
    end loop;
    std.env.finish;
  end process;

end architecture;
