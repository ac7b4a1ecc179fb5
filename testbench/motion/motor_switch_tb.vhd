-- SPDX-License-Identifier: Apache-2.0
-- Motors stay on in motion, go off at once in an emergency, and come back only when software says so.

library ieee;
use ieee.std_logic_1164.all;

library std;
use std.env.finish;

entity motor_switch_tb is
end entity;

architecture simulation of motor_switch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal written, positions_known, moving, emergency_stop, stopped : std_ulogic := '0';
  signal wanted : std_ulogic_vector(1 downto 0) := "00";
  signal enabled, pins : std_ulogic_vector(1 downto 0);
  signal positions_lost, refused, alarm : std_ulogic;

begin

  clk <= not clk after 10 ns;

  switch : entity work.motor_switch
    generic map (axes => 2)
    port map (
      clk => clk, reset => reset, written => written, wanted => wanted,
      positions_known => positions_known, moving => moving, emergency_stop => emergency_stop,
      stopped => stopped, enabled => enabled, pins => pins, positions_lost => positions_lost,
      refused => refused, alarm => alarm);

  test : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure want(motors : std_ulogic_vector(1 downto 0); refusal : std_ulogic) is
    begin
      wanted <= motors;
      written <= '1';
      wait for 1 ns;
      assert refused = refusal report "motors " & to_string(motors) severity failure;
      clock;
      written <= '0';
      wait for 1 ns;
      assert refused = '0' severity failure;
      assert refusal = '1' or pins = motors severity failure;
    end procedure;
  begin
    clock;
    reset <= '0';
    clock;
    assert pins = "00" severity failure;
    want("10", '0');
    want("11", '0');
    moving <= '1';
    want("01", '1');
    want("11", '0');
    assert pins = "11" severity failure;
    moving <= '0';
    want("01", '0');
    moving <= '1';
    -- What is off may stay off.
    want("01", '0');
    want("11", '0');
    assert alarm = '0' and positions_lost = '0' severity failure;

    -- In the clock of the emergency, and until software has acknowledged and written.
    emergency_stop <= '1';
    wait for 1 ns;
    assert pins = "00" and alarm = '1' severity failure;
    written <= '1';
    wait for 1 ns;
    assert refused = '1' report "taken in the clock of the emergency" severity failure;
    clock;
    written <= '0';
    stopped <= '1';
    moving <= '0';
    wait for 1 ns;
    assert pins = "00" and alarm = '0' and positions_lost = '1' severity failure;
    want("01", '1');
    emergency_stop <= '0';
    clock;
    want("01", '1');
    want("00", '0');
    stopped <= '0';
    clock;
    clock;
    assert pins = "00" and positions_lost = '1' severity failure;
    want("11", '0');
    assert positions_lost = '1' severity failure;
    positions_known <= '1';
    clock;
    positions_known <= '0';
    assert positions_lost = '0' and pins = "11" severity failure;

    -- A reset switches all off, and knows of no emergency.
    reset <= '1';
    clock;
    reset <= '0';
    wait for 1 ns;
    assert enabled = "00" and pins = "00" and positions_lost = '0' severity failure;
    want("11", '0');
    emergency_stop <= '1';
    clock;
    assert positions_lost = '1' severity failure;
    emergency_stop <= '0';
    stopped <= '1';
    reset <= '1';
    clock;
    reset <= '0';
    wait for 1 ns;
    assert enabled = "00" and positions_lost = '0' and alarm = '0' severity failure;
    want("01", '0');
    finish;
  end process;

end architecture;
