-- SPDX-License-Identifier: Apache-2.0
-- Instructions of both lengths are shown one after the other, from any half word on, a clock after what the
-- memory brings; jumps of the instruction shown and of the one before go where they should.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch_tb is
end entity;

architecture tb of instruction_fetch_tb is

  signal clk : std_ulogic := '0';
  signal cancel, late_jump, early_jump, advance, valid, is_word, fault, leaves_memory : std_ulogic := '0';
  -- Of 96 KiB.
  signal smaller_faults, smaller_is_left : std_ulogic;
  signal target, target_plus_2, following_address, address : unsigned(31 downto 0) := (others => '0');
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

  following_address <= target when early_jump else
                       address when not valid else
                       address + 4 when is_word else
                       address + 2;

  uut : entity work.instruction_fetch
    generic map (memory_address => x"80000000", memory_address_bits => 16)
    port map (
      clk => clk,
      cancel => cancel,
      late_jump => late_jump,
      late_address => target,
      late_address_plus_2 => target_plus_2(31 downto 2),
      early_jump => early_jump,
      early_address => target,
      early_address_plus_2 => target_plus_2,
      following_address => following_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => valid,
      instruction => instruction,
      is_word => is_word,
      address => address,
      fault => fault,
      leaves_memory => leaves_memory);

  of_three_quarters : entity work.instruction_fetch
    generic map (memory_address => x"80000000", memory_address_bits => 17, memory_lacks_quarter => true)
    port map (
      clk => clk,
      cancel => cancel,
      late_jump => late_jump,
      late_address => target,
      late_address_plus_2 => target_plus_2(31 downto 2),
      early_jump => early_jump,
      early_address => target,
      early_address_plus_2 => target_plus_2,
      following_address => following_address,
      advance => advance,
      instruction_request => open,
      instruction_data => instruction_data,
      valid => open,
      instruction => open,
      is_word => open,
      address => open,
      fault => smaller_faults,
      leaves_memory => smaller_is_left);

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

    procedure expect(wanted : unsigned(31 downto 0)) is
    begin
      assert valid = '1' and address = wanted
        report "shows " & to_hstring(address) & " and not " & to_hstring(wanted) severity failure;
      assert unsigned(instruction(15 downto 2)) = wanted(14 downto 1)
        report "what lies there" severity failure;
      assert (is_word = '0') = begins_short(wanted(31 downto 1)) and
        is_word = (and instruction(1 downto 0))
        report "the length at " & to_hstring(wanted) & " " & to_hstring(instruction) severity failure;
      assert is_word = '0' or unsigned(instruction(31 downto 18)) = wanted(14 downto 1) + 1
        report "the second half" severity failure;
    end procedure;

    -- To a place, with whatever is shown going on; it is shown in the clock after the next.
    procedure jump_to(wanted : unsigned(31 downto 0); late : boolean) is
    begin
      target <= wanted;
      late_jump <= '1' when late else '0';
      early_jump <= '0' when late else '1';
      advance <= '1';
      clock;
      late_jump <= '0';
      early_jump <= '0';
      -- What comes then is no instruction, but its address is told already.
      target <= x"80000abc";
      wait for 1 ns;
      assert valid = '0' and address = wanted(31 downto 1) & '0' severity failure;
      clock;
    end procedure;

    variable place : unsigned(31 downto 0);
  begin
    -- A reset is a late jump that cancels what was.
    cancel <= '1';
    target <= x"80000000";
    late_jump <= '1';
    advance <= '1';
    clock;
    cancel <= '0';
    clock;
    late_jump <= '0';
    wait for 1 ns;
    assert valid = '0' severity failure;
    clock;
    expect(x"80000000");
    assert fault = '0' severity failure;
    advance <= '0';
    wait for 1 ns;
    assert instruction_request.enable = '0' report "nobody has taken it" severity failure;

    -- From each place within a word on, with stops.
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

    -- Jumps soon after another, behind 0 to 3 instructions; of the address of a late one bit 0 is
    -- ignored.
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

    -- Nothing is shown once it is cancelled, whether it was taken or not.
    for taken in 0 to 1 loop
      jump_to(x"80000300", true);
      expect(x"80000300");
      cancel <= '1';
      advance <= '1' when taken = 1 else '0';
      clock;
      cancel <= '0';
      assert valid = '0' severity failure;
      jump_to(x"80000402", true);
      expect(x"80000402");
    end loop;

    -- The end of the memory: a short instruction fits, a long one does not.
    jump_to(x"80010000", false);
    assert fault = '1' and leaves_memory = '0' severity failure;
    jump_to(x"7ffffffe", true);
    assert fault = '1' and leaves_memory = '0' severity failure;
    jump_to(x"8000fffc", true);
    assert fault = '0' severity failure;
    assert begins_short(31x"40007ffe") = false and begins_short(31x"40007fff") = true severity failure;
    jump_to(x"8000fffe", false);
    assert is_word = '0' and fault = '0' and leaves_memory = '0' severity failure;
    target <= x"8000fffe";
    late_jump <= '1';
    clock;
    late_jump <= '0';
    instruction_data <= force x"00030000";
    clock;
    assert fault = '1' and leaves_memory = '1' severity failure;
    assert smaller_faults = '0' and smaller_is_left = '0' severity failure;

    -- The same of a memory that ends three quarters of the way.
    jump_to(x"80017ffc", true);
    assert smaller_faults = '0' severity failure;
    target <= x"80017ffe";
    late_jump <= '1';
    clock;
    late_jump <= '0';
    instruction_data <= force x"00030000";
    clock;
    assert smaller_faults = '1' and smaller_is_left = '1' severity failure;
    for place in 0 to 2 loop
      target <= x"80018000" when place = 0 else x"8001fffe" when place = 1 else x"80020000";
      late_jump <= '1';
      clock;
      late_jump <= '0';
      clock;
      assert smaller_faults = '1' and smaller_is_left = '0' severity failure;
    end loop;
    std.env.finish;
  end process;

end architecture;
