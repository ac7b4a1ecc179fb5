-- SPDX-License-Identifier: Apache-2.0
-- Instructions of both lengths are aligned from any half-word address on, a clock after the memory's data;
-- jumps predicted in decode and redirects by execute fetch from their targets.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch_tb is
end entity;

architecture tb of instruction_fetch_tb is

  signal clk : std_ulogic := '0';
  signal flush, redirect, predicted_taken, advance : std_ulogic := '0';
  signal valid, is_word, fault, crosses_memory_end : std_ulogic := '0';
  -- Of 104 KiB.
  signal larger_faults, larger_crosses : std_ulogic;
  signal target, target_plus_2, predicted_next_address, address : unsigned(31 downto 0) := (others => '0');
  signal instruction_request : instruction_request_t;
  signal instruction_data : word_t := (others => '0');
  signal instruction : word_t;

  -- Half words that look compressed: in odd blocks of 64 one of three, elsewhere three of five.
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

  predicted_next_address <= target when predicted_taken else
                       address when not valid else
                       address + 4 when is_word else
                       address + 2;

  uut : entity work.instruction_fetch
    generic map (memory_address => x"80000000", memory_size_bytes => 65536)
    port map (
      clk => clk,
      flush => flush,
      redirect => redirect,
      redirect_target => target,
      redirect_target_plus_2 => target_plus_2(31 downto 2),
      predicted_taken => predicted_taken,
      predicted_target => target,
      predicted_target_plus_2 => target_plus_2,
      predicted_next_address => predicted_next_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => valid,
      instruction => instruction,
      is_word => is_word,
      address => address,
      fault => fault,
      crosses_memory_end => crosses_memory_end);

  of_104_kib : entity work.instruction_fetch
    generic map (memory_address => x"80000000", memory_size_bytes => 106496)
    port map (
      clk => clk,
      flush => flush,
      redirect => redirect,
      redirect_target => target,
      redirect_target_plus_2 => target_plus_2(31 downto 2),
      predicted_taken => predicted_taken,
      predicted_target => target,
      predicted_target_plus_2 => target_plus_2,
      predicted_next_address => predicted_next_address,
      advance => advance,
      instruction_request => open,
      instruction_data => instruction_data,
      valid => open,
      instruction => open,
      is_word => open,
      address => open,
      fault => larger_faults,
      crosses_memory_end => larger_crosses);

  -- Each half word holds its index; the lowest two bits are the instruction length.
  drive_memory : process
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

    procedure expect(wanted : unsigned(31 downto 0)) is
    begin
      assert valid = '1' and address = wanted
        report "address " & to_hstring(address) & " and not " & to_hstring(wanted) severity failure;
      assert unsigned(instruction(15 downto 2)) = wanted(14 downto 1)
        report "the instruction" severity failure;
      assert (is_word = '0') = begins_short(wanted(31 downto 1)) and
        is_word = (and instruction(1 downto 0))
        report "the length at " & to_hstring(wanted) & " " & to_hstring(instruction) severity failure;
      assert is_word = '0' or unsigned(instruction(31 downto 18)) = wanted(14 downto 1) + 1
        report "the second half" severity failure;
    end procedure;

    -- Jumps, with the current instruction issued; the target is valid in the clock after the next.
    procedure jump_to(wanted : unsigned(31 downto 0); late : boolean) is
    begin
      target <= wanted;
      redirect <= '1' when late else '0';
      predicted_taken <= '0' when late else '1';
      advance <= '1';
      clock;
      redirect <= '0';
      predicted_taken <= '0';
      -- A bubble, with the address of the next instruction.
      target <= x"80000abc";
      wait for 1 ns;
      assert valid = '0' and address = wanted(31 downto 1) & '0' severity failure;
      clock;
    end procedure;

    variable place : unsigned(31 downto 0);
  begin
    -- A reset is a redirect after a flush.
    flush <= '1';
    target <= x"80000000";
    redirect <= '1';
    advance <= '1';
    clock;
    flush <= '0';
    clock;
    redirect <= '0';
    wait for 1 ns;
    assert valid = '0' severity failure;
    clock;
    expect(x"80000000");
    assert fault = '0' severity failure;
    advance <= '0';
    wait for 1 ns;
    assert instruction_request.enable = '0' report "requests while stalled" severity failure;

    -- From each offset within a word on, with stalls.
    for half_words in 0 to 11 loop
      place := x"80001000" + 2 * (half_words / 2);
      jump_to(place, half_words mod 2 = 0);
      for count in 1 to 300 loop
        expect(place);
        for stops in 1 to (count * count) mod 7 - 4 loop
          advance <= '0';
          clock;
          expect(place);
        end loop;
        advance <= '1';
        place := place + 2 when is_word = '0' else place + 4;
        clock;
      end loop;
    end loop;

    -- Jumps in quick succession, after 0 to 3 instructions; bit 0 of a redirect target is ignored.
    for half_words in 0 to 15 loop
      place := x"80000101" + 2 * half_words when half_words mod 3 /= 0 else x"80000100" + 2 * half_words;
      jump_to(place, half_words mod 3 /= 0);
      place(0) := '0';
      for count in 1 to half_words mod 4 loop
        expect(place);
        place := place + 2 when is_word = '0' else place + 4;
        clock;
      end loop;
      expect(place);
    end loop;

    -- A flush invalidates the output, whether issued or not.
    for taken in 0 to 1 loop
      jump_to(x"80000300", true);
      expect(x"80000300");
      flush <= '1';
      advance <= '1' when taken = 1 else '0';
      clock;
      flush <= '0';
      assert valid = '0' severity failure;
      jump_to(x"80000402", true);
      expect(x"80000402");
    end loop;

    -- The end of the memory: a compressed instruction fits, a 32-bit one crosses it.
    jump_to(x"80010000", false);
    assert fault = '1' and crosses_memory_end = '0' severity failure;
    jump_to(x"7ffffffe", true);
    assert fault = '1' and crosses_memory_end = '0' severity failure;
    jump_to(x"8000fffc", true);
    assert fault = '0' severity failure;
    assert begins_short(31x"40007ffe") = false and begins_short(31x"40007fff") = true severity failure;
    jump_to(x"8000fffe", false);
    assert is_word = '0' and fault = '0' and crosses_memory_end = '0' severity failure;
    target <= x"8000fffe";
    redirect <= '1';
    clock;
    redirect <= '0';
    instruction_data <= force x"00030000";
    clock;
    assert fault = '1' and crosses_memory_end = '1' severity failure;
    assert larger_faults = '0' and larger_crosses = '0' severity failure;

    -- The same for a memory whose size is no power of two.
    jump_to(x"80019ffc", true);
    assert larger_faults = '0' severity failure;
    target <= x"80019ffe";
    redirect <= '1';
    clock;
    redirect <= '0';
    instruction_data <= force x"00030000";
    clock;
    assert larger_faults = '1' and larger_crosses = '1' severity failure;
    for place in 0 to 2 loop
      target <= x"8001a000" when place = 0 else x"8001fffe" when place = 1 else x"80020000";
      redirect <= '1';
      clock;
      redirect <= '0';
      clock;
      assert larger_faults = '1' and larger_crosses = '0' severity failure;
    end loop;
    std.env.finish;
  end process;

end architecture;
