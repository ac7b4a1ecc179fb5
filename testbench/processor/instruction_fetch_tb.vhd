-- SPDX-License-Identifier: Apache-2.0
-- Instructions of both lengths are fetched one after the other at any half word, from jumps at once,
-- from redirections a clock later.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch_tb is
end entity;

architecture tb of instruction_fetch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal redirect, jump, advance, valid, fault, leaves_memory : std_ulogic := '0';
  signal redirect_address, target, address : unsigned(31 downto 0) :=
    (others => '0');
  signal target_plus_2 : unsigned(31 downto 0);
  signal instruction_request : instruction_request_t;
  signal instruction_data : word_t := (others => '0');
  signal instruction : word_t;

  -- Every third half word would begin a short instruction; elsewhere three of five do.
  function begins_short(place : unsigned(31 downto 1)) return boolean is
    constant number : natural := to_integer(place(14 downto 1));
  begin
    if number / 64 mod 2 = 1 then
      return number mod 3 = 0;
    end if;
    return number mod 5 < 3;
  end function;

begin

  clk <= not clk after 5 ns;
  target_plus_2 <= target + 2;

  uut : entity work.instruction_fetch
    generic map (reset_address => x"80000000", memory_address_bits => 16)
    port map (
      clk => clk,
      reset => reset,
      redirect => redirect,
      redirect_address => redirect_address,
      redirect_address_plus_2 => redirect_address + 2,
      jump => jump,
      jump_address => target,
      jump_address_plus_2 => target_plus_2,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => valid,
      address => address,
      instruction => instruction,
      fault => fault,
      leaves_memory => leaves_memory);

  -- Each half word holds the number of its place; the lowest two bits tell the length.
  remember : process
    function half_word(place : unsigned(31 downto 1)) return std_ulogic_vector is
      variable half : std_ulogic_vector(15 downto 0);
    begin
      half := std_ulogic_vector(place(14 downto 1)) & "11";
      if begins_short(place) then
        half(1 downto 0) := "01";
      end if;
      return half;
    end function;
  begin
    wait until rising_edge(clk);
    if instruction_request.enable then
      instruction_data <= half_word(instruction_request.upper_address & '1') &
                          half_word(instruction_request.lower_address & '0');
    end if;
  end process;

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    impure function is_short return boolean is
    begin
      return instruction(1 downto 0) /= "11";
    end function;

    procedure expect(wanted : unsigned(31 downto 0)) is
    begin
      assert valid = '1' and address = wanted
        report "shows " & to_hstring(address) & " and not " & to_hstring(wanted) severity failure;
      assert unsigned(instruction(15 downto 2)) = wanted(14 downto 1)
        report "what lies there" severity failure;
      assert is_short = begins_short(wanted(31 downto 1)) severity failure;
      assert is_short or unsigned(instruction(31 downto 18)) = wanted(14 downto 1) + 1
        report "the second half" severity failure;
    end procedure;

    variable place : unsigned(31 downto 0);
  begin
    clock;
    reset <= '0';
    wait for 1 ns;
    assert valid = '0' severity failure;
    clock;
    expect(x"80000000");
    assert fault = '0' severity failure;
    assert instruction_request.enable = '0' report "nobody has taken it" severity failure;

    advance <= '1';
    place := x"80000000";
    for count in 1 to 100 loop
      place := place + 2 when is_short else place + 4;
      clock;
      expect(place);
    end loop;
    advance <= '0';
    clock;
    expect(place);

    -- From each place within a word on, with stops.
    for half_words in 0 to 5 loop
      place := x"80001000" + 2 * half_words;
      target <= place;
      jump <= '1';
      advance <= '1';
      clock;
      jump <= '0';
      for count in 1 to 300 loop
        expect(place);
        for stops in 1 to (count * count) mod 7 - 4 loop
          advance <= '0';
          clock;
          expect(place);
        end loop;
        advance <= '1';
        place := place + 2 when is_short else place + 4;
        clock;
      end loop;
    end loop;

    -- Jumps, of which bit 0 is ignored, behind what was not taken and what was.
    for half_words in 0 to 7 loop
      target <= x"80000101" + 2 * half_words;
      jump <= '1';
      advance <= '1';
      clock;
      jump <= '0';
      expect(x"80000100" + 2 * half_words);
      advance <= '0' when half_words mod 2 = 0 else '1';
      clock;
    end loop;

    -- Redirections, also while nothing is taken and in the clock of a jump.
    for half_words in 0 to 7 loop
      redirect <= '1';
      jump <= '0' when half_words mod 2 = 0 else '1';
      advance <= jump'driving_value;
      clock;
      redirect <= '0';
      jump <= '0';
      redirect_address <= x"80000302" + 2 * half_words;
      assert valid = '0' severity failure;
      clock;
      advance <= '0';
      redirect_address <= x"80000000";
      expect(x"80000302" + 2 * half_words);
    end loop;
    advance <= '1';

    -- The end of the memory: a short instruction fits, a long one does not.
    jump <= '1';
    target <= x"80010000";
    clock;
    assert fault = '1' and leaves_memory = '0' severity failure;
    target <= x"7ffffffe";
    clock;
    assert fault = '1' and leaves_memory = '0' severity failure;
    target <= x"8000fffc";
    clock;
    assert fault = '0' severity failure;
    target <= x"8000fffe";
    clock;
    assert is_short and fault = '0' and leaves_memory = '0' severity failure;
    instruction_data <= force x"00030000";
    wait for 1 ns;
    assert fault = '1' and leaves_memory = '1' severity failure;
    std.env.finish;
  end process;

end architecture;
