-- SPDX-License-Identifier: Apache-2.0
-- The memory keeps each byte that is written, shows it on both ports, and rests where it is not
-- enabled.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity memory_tb is
end entity;

architecture tb of memory_tb is

  constant words : positive := 64;

  signal clk : std_ulogic := '0';
  signal instruction_request : instruction_request_t := instruction_request_idle;
  signal data_request : memory_request_t := memory_request_idle;
  signal instruction_data, data : std_ulogic_vector(31 downto 0);

begin

  clk <= not clk after 5 ns;

  uut : entity work.memory
    generic map (size_bytes => 4 * words)
    port map (
      clk => clk,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      data_request => data_request,
      data => data);

  check : process
    type words_t is array (0 to words - 1) of std_ulogic_vector(31 downto 0);
    variable expected : words_t;

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    function pattern(word : natural) return std_ulogic_vector is
    begin
      return std_ulogic_vector(to_unsigned(word * 16#2040811#, 32));
    end function;

    procedure write(word : natural; lanes : std_ulogic_vector(3 downto 0);
                    value : std_ulogic_vector(31 downto 0)) is
    begin
      data_request <= (
        enable => '1', write_bytes => lanes, address => to_unsigned(word, 30), data => value);
      clock;
      data_request.enable <= '0';
      for lane in 0 to 3 loop
        if lanes(lane) then
          expected(word)(8 * lane + 7 downto 8 * lane) := value(8 * lane + 7 downto 8 * lane);
        end if;
      end loop;
    end procedure;
  begin
    for word in 0 to words - 1 loop
      write(word, "1111", pattern(word));
    end loop;
    -- Every pattern of lanes.
    for word in 0 to words - 1 loop
      write(word, std_ulogic_vector(to_unsigned(word mod 16, 4)),
            not pattern((word + 17) mod words));
    end loop;
    for word in 0 to words - 1 loop
      data_request <= (
        enable => '1', write_bytes => "0000", address => to_unsigned(word, 30),
        data => (others => '1'));
      instruction_request <= (
        enable => '1', upper_address => to_unsigned(words - 1 - word, 30),
        lower_address => to_unsigned(words - 1 - word, 30));
      clock;
      assert data = expected(word) report "word " & integer'image(word) severity failure;
      assert instruction_data = expected(words - 1 - word) severity failure;
    end loop;
    -- Not enabled: both ports keep what they show, nothing is written.
    data_request <= (
      enable => '0', write_bytes => "1111", address => to_unsigned(5, 30), data => (others => '0'));
    instruction_request <= (
      enable => '0', upper_address => to_unsigned(5, 30), lower_address => to_unsigned(5, 30));
    clock;
    assert data = expected(words - 1) and instruction_data = expected(0) severity failure;
    -- Addresses beyond the size mean the same words.
    data_request <= (
      enable => '1', write_bytes => "0000", address => to_unsigned(3 * words + 5, 30),
      data => (others => '0'));
    instruction_request <= (
      enable => '1', upper_address => to_unsigned(words + 6, 30),
      lower_address => to_unsigned(words + 7, 30));
    clock;
    assert data = expected(5) and
      instruction_data = expected(6)(31 downto 16) & expected(7)(15 downto 0)
      report "the half words may come from two words" severity failure;
    std.env.finish;
  end process;

end architecture;
