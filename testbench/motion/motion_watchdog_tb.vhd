-- SPDX-License-Identifier: Apache-2.0
-- The watchdog expires a limit after the last sign of life, only in motion and only with a limit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

entity motion_watchdog_tb is
end entity;

architecture simulation of motion_watchdog_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal limit : unsigned(31 downto 0) := to_unsigned(10, 32);
  signal moving : std_ulogic := '0';
  signal feed : std_ulogic := '0';
  signal expired : std_ulogic;

begin

  clk <= not clk after 10 ns;

  watchdog : entity work.motion_watchdog
    port map (
      clk => clk, reset => reset, limit => limit, moving => moving, feed => feed, expired => expired);

  test : process
    procedure clocks(number : natural) is
    begin
      for i in 1 to number loop
        wait until rising_edge(clk);
        wait for 1 ns;
        assert expired = '0' report "expired too early" severity failure;
      end loop;
    end procedure;

    procedure expect_expiry is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
      assert expired = '1' report "did not expire" severity failure;
      moving <= '0';
      clocks(20);
    end procedure;
  begin
    clocks(2);
    reset <= '0';
    clocks(100);

    moving <= '1';
    clocks(9);
    expect_expiry;

    -- Feeding restarts the time.
    moving <= '1';
    for i in 1 to 5 loop
      clocks(8);
      feed <= '1';
      clocks(1);
      feed <= '0';
    end loop;
    clocks(9);
    expect_expiry;

    -- So does rest.
    moving <= '1';
    clocks(7);
    moving <= '0';
    clocks(1);
    moving <= '1';
    clocks(9);
    expect_expiry;

    -- A shorter limit holds from now on, not from the next feeding on.
    limit <= to_unsigned(1000, 32);
    clocks(1);
    moving <= '1';
    clocks(50);
    limit <= to_unsigned(10, 32);
    clocks(10);
    expect_expiry;

    -- One after none too, though nothing has been counted.
    limit <= to_unsigned(0, 32);
    clocks(1);
    moving <= '1';
    clocks(50);
    limit <= to_unsigned(10, 32);
    clocks(10);
    expect_expiry;

    -- A limit of one clock, and none.
    limit <= to_unsigned(1, 32);
    clocks(1);
    moving <= '1';
    expect_expiry;
    moving <= '1';
    wait until rising_edge(clk);
    wait for 1 ns;
    assert expired = '1' report "did not expire" severity failure;
    -- From the first clock of a reset on it has not.
    reset <= '1';
    clocks(3);
    reset <= '0';
    moving <= '0';
    limit <= to_unsigned(0, 32);
    clocks(1);
    moving <= '1';
    clocks(1000);

    finish;
  end process;

end architecture;
