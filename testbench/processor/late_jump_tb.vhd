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
  signal comparison : comparison_t := (others => '0');
  signal jump_register, redirect, to_handler, to_return, jump, redirecting : std_ulogic := '0';
  signal base, offset, other, target : unsigned(31 downto 0) := (others => '0');
  signal target_plus_2 : unsigned(31 downto 2);

begin

  clk <= not clk after 5 ns;

  uut : entity work.late_jump
    port map (
      clk => clk,
      reset => reset,
      turn => turn,
      comparison => comparison,
      other => other,
      jump_register => jump_register,
      base => base,
      offset => offset,
      sum => base + offset,
      redirect => redirect,
      to_handler => to_handler,
      to_return => to_return,
      handler_address => x"80000200",
      return_address => x"80000302",
      jump => jump,
      target => target,
      target_plus_2 => target_plus_2,
      redirecting => redirecting);

  check : process
    type outcomes_t is array (0 to 4) of comparison_t;
    constant outcomes : outcomes_t := (
      (others => '0'), (below => '1', others => '0'), (above => '1', others => '0'),
      (below => '1', above => '0', signs_differ => '1'), (below => '0', above => '1', signs_differ => '1'));

    variable is_so : std_ulogic;

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure expect(wanted, plus_2 : unsigned(31 downto 0)) is
    begin
      wait for 1 ns;
      assert target = wanted and target_plus_2 = plus_2(31 downto 2)
        report to_hstring(target) & ", " & to_hstring(target_plus_2 & "00") severity failure;
    end procedure;
  begin
    other <= x"80000000";
    redirect <= '1';
    clock;
    assert redirecting = '1' severity failure;
    expect(x"80000000", x"80000002");
    reset <= '0';
    redirect <= '0';
    clock;
    assert redirecting = '0' severity failure;

    -- Each of the conditions, with each outcome.
    for outcome in outcomes'range loop
      comparison <= outcomes(outcome);
      for conditions in 0 to 6 loop
        next when conditions = 3;
        turn.if_below <= '1' when conditions mod 4 /= 0 else '0';
        turn.if_above <= '1' when conditions mod 4 = 2 else '0';
        turn.inverted <= '1' when conditions / 4 = 1 else '0';
        wait for 1 ns;
        -- In no case, if less, if unequal; in any, if not less, if equal. The first is less in the outcomes
        -- 1 and 4: without regard to signs, and with signs that differ.
        case conditions mod 4 is
          when 0 => is_so := '0';
          when 1 => is_so := '1' when outcome = 1 or outcome = 4 else '0';
          when others => is_so := '1' when outcome /= 0 else '0';
        end case;
        assert jump = (is_so xor turn.inverted) severity failure;
      end loop;
    end loop;

    other <= x"80000406";
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
    other <= (others => '0');
    jump_register <= '0';
    assert redirecting = '1' severity failure;
    to_handler <= '1';
    expect(x"80000200", x"80000200");
    to_handler <= '0';
    to_return <= '1';
    expect(x"80000302", x"80000304");
    clock;
    assert redirecting = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
