-- SPDX-License-Identifier: Apache-2.0
-- A stop begins in the clock of its cause, remembers it, and ends only when acknowledged.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;

entity stop_latch_tb is
end entity;

architecture simulation of stop_latch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal active : std_ulogic := '0';
  signal stop_mask : std_ulogic_vector(7 downto 0) := x"00";
  signal end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop : std_ulogic := '0';
  signal software_stop : std_ulogic := '0';
  signal acknowledge : std_ulogic := '0';
  signal stop : std_ulogic;
  signal stop_begins : std_ulogic;
  signal stopped : std_ulogic;
  signal cause : stop_cause_t;

begin

  clk <= not clk after 10 ns;

  latch : entity work.stop_latch
    port map (
      clk => clk, reset => reset, active => active, stop_mask => stop_mask,
      end_stops => end_stops, emergency_stop => emergency_stop, software_stop => software_stop,
      acknowledge => acknowledge, stop => stop, stop_begins => stop_begins, stopped => stopped,
      cause => cause);

  test : process
    procedure settle is
    begin
      wait for 1 ns;
    end procedure;

    procedure clock is
    begin
      wait until rising_edge(clk);
      settle;
    end procedure;

    procedure acknowledge_it is
    begin
      acknowledge <= '1';
      clock;
      acknowledge <= '0';
    end procedure;
  begin
    clock;
    reset <= '0';
    clock;
    assert stop = '0' severity failure;

    -- Only end stops that are asked for, and only during a segment.
    stop_mask <= x"0C";
    end_stops <= x"FF";
    settle;
    assert stop = '0' report "stopped while at rest" severity failure;
    active <= '1';
    end_stops <= x"F3";
    settle;
    assert stop = '0' report "stopped by an end stop that is not asked for" severity failure;
    end_stops <= x"0B";
    settle;
    assert stop = '1' and stop_begins = '1' severity failure;
    clock;
    active <= '0';
    end_stops <= x"00";
    settle;
    assert stop = '1' and stop_begins = '0' and stopped = '1' severity failure;
    assert cause = (end_stops => x"08", emergency_input => '0', software => '0') severity failure;

    -- What comes later changes neither cause nor moment.
    software_stop <= '1';
    settle;
    assert stop_begins = '0' severity failure;
    clock;
    software_stop <= '0';
    assert cause.software = '0' severity failure;
    acknowledge_it;
    settle;
    assert stop = '0' and stopped = '0' severity failure;

    software_stop <= '1';
    settle;
    assert stop = '1' severity failure;
    clock;
    software_stop <= '0';
    assert stopped = '1' and cause = (end_stops => x"00", emergency_input => '0', software => '1')
      severity failure;
    acknowledge_it;

    -- The emergency stop holds as long as it is active, and then until acknowledged.
    emergency_stop <= '1';
    clock;
    assert cause.emergency_input = '1' severity failure;
    acknowledge_it;
    assert stopped = '1' report "acknowledged under an active emergency stop" severity failure;
    emergency_stop <= '0';
    clock;
    assert stop = '1' severity failure;
    acknowledge_it;
    settle;
    assert stop = '0' severity failure;

    finish;
  end process;

end architecture;
