-- SPDX-License-Identifier: Apache-2.0
-- What execute decides goes to its address at once; traps, returns and resets a clock later to theirs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity late_jump_tb is
end entity;

architecture tb of late_jump_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal turn : late_turn_t := no_turn;
  signal equal, less, jump_register, redirect, to_handler, jump, redirecting : std_ulogic := '0';
  signal base, offset, target, target_plus_2 : unsigned(31 downto 0) := (others => '0');

begin

  clk <= not clk after 5 ns;

  uut : entity work.late_jump
    generic map (reset_address => x"80000000")
    port map (
      clk => clk,
      reset => reset,
      turn => turn,
      equal => equal,
      less => less,
      other => x"80000406",
      jump_register => jump_register,
      base => base,
      offset => offset,
      sum => base + offset,
      redirect => redirect,
      to_handler => to_handler,
      handler_address => x"80000200",
      return_address => x"80000302",
      jump => jump,
      target => target,
      target_plus_2 => target_plus_2,
      redirecting => redirecting);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure expect(wanted, plus_2 : unsigned(31 downto 0)) is
    begin
      wait for 1 ns;
      assert target = wanted and target_plus_2 = plus_2
        report to_hstring(target) & ", " & to_hstring(target_plus_2) severity failure;
    end procedure;
  begin
    clock;
    assert redirecting = '1' severity failure;
    expect(x"80000000", x"80000000");
    reset <= '0';
    clock;
    clock;
    assert redirecting = '0' severity failure;

    -- Each of the conditions, with each outcome.
    for outcome in 0 to 3 loop
      equal <= '1' when outcome mod 2 = 1 else '0';
      less <= '1' when outcome / 2 = 1 else '0';
      turn <= no_turn;
      wait for 1 ns;
      assert jump = '0' severity failure;
      turn.always <= '1';
      wait for 1 ns;
      assert jump = '1' severity failure;
      turn <= (if_equal => '1', others => '0');
      wait for 1 ns;
      assert jump = equal severity failure;
      turn <= (if_not_equal => '1', others => '0');
      wait for 1 ns;
      assert jump = not equal severity failure;
      turn <= (if_less => '1', others => '0');
      wait for 1 ns;
      assert jump = less severity failure;
      turn <= (if_not_less => '1', others => '0');
      wait for 1 ns;
      assert jump = not less severity failure;
    end loop;

    expect(x"80000406", x"80000408");
    jump_register <= '1';
    base <= x"80000503";
    offset <= x"ffffffff";
    expect(x"80000502", x"80000504");
    offset <= x"00000007";
    expect(x"8000050a", x"8000050c");
    -- Of an odd sum bit 0 is of no meaning.
    offset <= x"00000000";
    expect(x"80000503", x"80000505");

    -- A redirection wins.
    redirect <= '1';
    clock;
    redirect <= '0';
    assert redirecting = '1' severity failure;
    to_handler <= '1';
    expect(x"80000200", x"80000200");
    to_handler <= '0';
    expect(x"80000302", x"80000304");
    clock;
    assert redirecting = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
