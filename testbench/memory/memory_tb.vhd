-- SPDX-License-Identifier: Apache-2.0
-- The memory keeps each byte that is written, on both sides of each border of its banks, shows it on both
-- ports, and rests where it is not enabled.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity memory_tb is
  generic (
    words : positive := 64;
    shows_clear : boolean := false
  );
end entity;

architecture tb of memory_tb is

  constant is_power_of_two : boolean := to_unsigned(words, 31) = (to_unsigned(words, 31) and
                                                                  (not to_unsigned(words, 31)) + 1);

  signal clk : std_ulogic := '0';
  signal instruction_request : instruction_request_t := instruction_request_idle;
  signal data_request : memory_request_t := memory_request_idle;
  signal instruction_data, data : std_ulogic_vector(31 downto 0);

begin

  clk <= not clk after 5 ns;

  uut : entity work.memory
    generic map (size_bytes => 4 * words, shows_clear => shows_clear)
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

    procedure load(word : natural) is
    begin
      data_request <= (
        enable => '1', write_bytes => "0000", address => to_unsigned(word, 30), data => (others => '1'));
      clock;
      data_request.enable <= '0';
      assert data = expected(word mod words) report "word " & integer'image(word) severity failure;
    end procedure;

    procedure fetch(upper, lower : natural) is
    begin
      instruction_request <= (
        enable => '1', upper_address => to_unsigned(upper, 30), lower_address => to_unsigned(lower, 30),
        upper_elsewhere => not bank_of(to_unsigned(upper, 30), 4 * words),
        lower_elsewhere => not bank_of(to_unsigned(lower, 30), 4 * words));
      clock;
      instruction_request.enable <= '0';
      instruction_request.upper_elsewhere <= (others => '0');
      instruction_request.lower_elsewhere <= (others => '0');
      assert instruction_data =
        expected(upper mod words)(31 downto 16) & expected(lower mod words)(15 downto 0)
        report integer'image(upper) & " and " & integer'image(lower) severity failure;
    end procedure;

    -- A word is requested at both ports while neither is enabled: they keep their output, nothing is written.
    procedure rest(word : natural) is
      variable shown, shown_instruction : std_ulogic_vector(31 downto 0);
    begin
      shown := data;
      shown_instruction := instruction_data;
      data_request <= (
        enable => '0', write_bytes => "1111", address => to_unsigned(word, 30), data => (others => '0'));
      instruction_request <= (
        enable => '0', upper_address => to_unsigned(word, 30), lower_address => to_unsigned(word, 30),
        upper_elsewhere | lower_elsewhere => (others => '0'));
      clock;
      assert data = shown and instruction_data = shown_instruction severity failure;
      load(word);
    end procedure;
  begin
    for word in 0 to words - 1 loop
      write(word, "1111", pattern(word));
    end loop;
    -- Every pattern of lanes.
    for word in words - 1 downto 0 loop
      write(word, std_ulogic_vector(to_unsigned(word mod 16, 4)), not pattern((word + 17) mod words));
    end loop;
    for word in 0 to words - 1 loop
      load(word);
      fetch(word, word);
      fetch(words - 1 - word, word);
    end loop;
    -- Half words of any two words, so from both sides of each border.
    for upper in 0 to words - 1 loop
      for lower in 0 to words - 1 loop
        fetch(upper, lower);
      end loop;
    end loop;
    -- What is shown stays, whichever bank is requested next.
    for word in 0 to words - 1 loop
      load(word);
      rest((word + words / 3) mod words);
    end loop;
    -- Addresses beyond a power of two mean the same words.
    if is_power_of_two then
      load(3 * words + 5);
      fetch(words + 6, words + 7);
    end if;
    std.env.finish;
  end process;

end architecture;
