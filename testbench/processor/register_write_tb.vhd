-- SPDX-License-Identifier: Apache-2.0
-- What write-back writes comes to the register file a clock later, loads as the specification aligns them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;
use work.random_source_pkg.all;

entity register_write_tb is
end entity;

architecture tb of register_write_tb is

  signal clk : std_ulogic := '0';
  signal writing : writing_t := (
    destination => "00000", from_memory => lanes_of('0', "000", "00"),
    from_bus => lanes_of('0', "000", "00"), others => '0');
  signal memory_data, value_product, value_early : word_t := (others => '0');
  signal write : register_write_t;

begin

  clk <= not clk after 5 ns;

  uut : entity work.register_write
    port map (
      clk => clk,
      writing => writing,
      memory_data => memory_data,
      value_product => value_product,
      value_early => value_early,
      write => write);

  check : process
    variable random : random_source_t;

    impure function any_word return word_t is
    begin
      return std_ulogic_vector(to_unsigned(random.between(0, 65535), 16)) &
             std_ulogic_vector(to_unsigned(random.between(0, 65535), 16));
    end function;

    -- As the specification's lb, lh, lw, lbu and lhu.
    function loaded(word : word_t; funct3 : std_ulogic_vector(2 downto 0); byte : natural) return word_t is
      constant shifted : unsigned(31 downto 0) := shift_right(unsigned(word), 8 * byte);
    begin
      case funct3 is
        when "000" => return std_ulogic_vector(resize(signed(shifted(7 downto 0)), 32));
        when "001" => return std_ulogic_vector(resize(signed(shifted(15 downto 0)), 32));
        when "100" => return std_ulogic_vector(resize(shifted(7 downto 0), 32));
        when "101" => return std_ulogic_vector(resize(shifted(15 downto 0), 32));
        when others => return std_ulogic_vector(shifted);
      end case;
    end function;

    type functions_t is array (0 to 4) of std_ulogic_vector(2 downto 0);
    constant functions : functions_t := ("000", "001", "010", "100", "101");
    variable funct3 : std_ulogic_vector(2 downto 0);
    variable byte, size : natural;
    variable expected : word_t;
    variable expected_writes : std_ulogic;
    variable expected_destination : register_index_t;
  begin
    wait for 1 ns;
    assert write.enable = '0' report "a write before the first clock" severity failure;
    for count in 1 to 20_000 loop
      memory_data <= any_word;
      value_product <= (others => '0');
      value_early <= (others => '0');
      expected_writes := '1' when random.between(0, 2) /= 0 else '0';
      expected_destination := std_ulogic_vector(to_unsigned(random.between(0, 31), 5));
      writing.writes <= expected_writes;
      writing.destination <= expected_destination;
      writing.from_memory <= lanes_of('0', "000", "00");
      case random.between(0, 2) is
        when 0 => value_product <= any_word;
        when 1 => value_early <= any_word;
        when others =>
          funct3 := functions(random.between(0, 4));
          size := 2 ** to_integer(unsigned(funct3(1 downto 0)));
          byte := size * random.between(0, 4 / size - 1);
          writing.from_memory <= lanes_of('1', funct3, std_ulogic_vector(to_unsigned(byte, 2)));
      end case;
      wait for 1 ns;
      expected := value_product or value_early;
      if or writing.from_memory.low then
        expected := loaded(memory_data, funct3, byte);
      end if;

      wait until rising_edge(clk);
      -- The memory shows the next word, and write-back has the next instruction.
      memory_data <= any_word;
      value_early <= any_word;
      writing.writes <= not expected_writes;
      writing.destination <= not expected_destination;
      writing.from_memory <= lanes_of('1', "010", "00");
      wait for 1 ns;
      assert write.enable = expected_writes severity failure;
      assert expected_writes = '0' or (write.destination = expected_destination and write.data = expected)
        report to_hstring(write.data) & " is not " & to_hstring(expected) severity failure;
    end loop;
    std.env.finish;
  end process;

end architecture;
