-- SPDX-License-Identifier: Apache-2.0
-- Mispredicted branches, jalr and fence.i redirect in their own clock; traps, returns and resets in the
-- next one.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity branch_resolution_tb is
end entity;

architecture tb of branch_resolution_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal condition : redirect_condition_t := redirect_never;
  signal comparison : comparison_t := (others => '0');
  signal jump_register, flush, to_handler, to_return, redirect, flushed : std_ulogic := '0';
  signal base, offset, alternate_address, target : unsigned(31 downto 0) := (others => '0');
  signal target_plus_2 : unsigned(31 downto 2);

begin

  clk <= not clk after 5 ns;

  uut : entity work.branch_resolution
    port map (
      clk => clk,
      reset => reset,
      condition => condition,
      comparison => comparison,
      alternate_address => alternate_address,
      jump_register => jump_register,
      base => base,
      offset => offset,
      sum => base + offset,
      flush => flush,
      to_handler => to_handler,
      to_return => to_return,
      handler_address => x"80000200",
      return_address => x"80000302",
      redirect => redirect,
      target => target,
      target_plus_2 => target_plus_2,
      flushed => flushed);

  check : process
    type outcomes_t is array (0 to 4) of comparison_t;
    constant outcomes : outcomes_t := (
      (others => '0'), (below => '1', others => '0'), (above => '1', others => '0'),
      (below => '1', above => '0', signs_differ => '1'), (below => '0', above => '1', signs_differ => '1'));

    variable condition_met : std_ulogic;

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
    alternate_address <= x"80000000";
    flush <= '1';
    clock;
    assert flushed = '1' severity failure;
    expect(x"80000000", x"80000002");
    reset <= '0';
    flush <= '0';
    clock;
    assert flushed = '0' severity failure;

    -- Each of the conditions, with each outcome.
    for outcome in outcomes'range loop
      comparison <= outcomes(outcome);
      for conditions in 0 to 6 loop
        next when conditions = 3;
        condition.if_below <= '1' when conditions mod 4 /= 0 else '0';
        condition.if_above <= '1' when conditions mod 4 = 2 else '0';
        condition.inverted <= '1' when conditions / 4 = 1 else '0';
        wait for 1 ns;
        -- Never, if less, if unequal; inverted: always, if not less, if equal. The first operand is less in
        -- outcomes 1 (unsigned or equal signs) and 4 (different signs).
        case conditions mod 4 is
          when 0 => condition_met := '0';
          when 1 => condition_met := '1' when outcome = 1 or outcome = 4 else '0';
          when others => condition_met := '1' when outcome /= 0 else '0';
        end case;
        assert redirect = (condition_met xor condition.inverted) severity failure;
      end loop;
    end loop;

    alternate_address <= x"80000406";
    expect(x"80000406", x"80000408");
    jump_register <= '1';
    base <= x"80000503";
    offset <= x"ffffffff";
    expect(x"80000502", x"80000504");
    offset <= x"00000007";
    expect(x"8000050a", x"8000050c");
    -- Bit 0 of an odd sum is ignored.
    offset <= x"00000000";
    expect(x"80000503", x"80000505");

    -- A flush takes priority.
    flush <= '1';
    clock;
    flush <= '0';
    alternate_address <= (others => '0');
    jump_register <= '0';
    assert flushed = '1' severity failure;
    to_handler <= '1';
    expect(x"80000200", x"80000200");
    to_handler <= '0';
    to_return <= '1';
    expect(x"80000302", x"80000304");
    clock;
    assert flushed = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
