-- SPDX-License-Identifier: Apache-2.0
-- A block is at rest only after enough clocks without a reason to work, and an alarm ends that at once.

library ieee;
use ieee.std_logic_1164.all;

entity rest_watch_tb is
end entity;

architecture tb of rest_watch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal strobe, working, alarm : std_ulogic := '0';
  signal at_rest : std_ulogic;

begin

  clk <= not clk after 5 ns;

  watch : entity work.rest_watch
    generic map (settling_clocks => 3)
    port map (
      clk => clk, bus_clk => clk, reset => reset, strobe => strobe, working => working,
      alarm => alarm, at_rest => at_rest);

  check : process
    procedure clock (count : positive := 1) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
        wait for 1 ns;
      end loop;
    end procedure;

    procedure rests_after (clocks : positive; what : string) is
    begin
      for i in 1 to clocks loop
        assert not at_rest report "rests too early after " & what severity error;
        clock;
      end loop;
      assert at_rest report "does not rest after " & what severity error;
    end procedure;
  begin
    clock(5);
    assert not at_rest report "rests in reset" severity error;
    reset <= '0';
    wait for 1 ns;
    rests_after(3, "reset");
    clock(5);
    assert at_rest report "wakes without a reason" severity error;

    working <= '1';
    wait for 1 ns;
    assert at_rest report "looks at lasting work between edges" severity error;
    clock;
    assert not at_rest report "rests while there is work" severity error;
    clock(5);
    working <= '0';
    rests_after(3, "work");

    alarm <= '1';
    wait for 1 ns;
    assert not at_rest report "sleeps through an alarm" severity error;
    clock;
    alarm <= '0';
    rests_after(3, "an alarm");

    -- An alarm between two edges of which neither sees it.
    alarm <= '1';
    wait for 1 ns;
    alarm <= '0';
    wait for 1 ns;
    assert at_rest report "keeps what no edge has seen" severity error;

    strobe <= '1';
    clock;
    strobe <= '0';
    -- Two clocks for what the registers still pass on, and one in which the last of it is seen.
    rests_after(2 + 1 + 3, "an access");
    report "rest_watch_tb passed";
    std.env.finish;
  end process;

end architecture;
