-- SPDX-License-Identifier: Apache-2.0
-- Software alone closes the supply, and only at rest and without danger;
-- every danger opens it and is remembered.

library ieee;
use ieee.std_logic_1164.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;

entity heater_supply_tb is
end entity;

architecture simulation of heater_supply_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal close, open_again : std_ulogic := '0';
  signal all_at_rest : std_ulogic := '1';
  -- Veto, emergency stop, watchdog, trip: the order of the register.
  signal causes : std_ulogic_vector(3 downto 0) := "0000";
  signal opened : std_ulogic_vector(3 downto 0);
  signal watchdog_alive, closed, refused : std_ulogic;

begin

  clk <= not clk after 10 ns;

  watchdog_alive <= not causes(1);

  supply : entity work.heater_supply
    port map (
      clk => clk, reset => reset, close => close, open_again => open_again,
      all_at_rest => all_at_rest, tripped => causes(0), watchdog_alive => watchdog_alive,
      emergency_stop => causes(2), veto => causes(3), closed => closed, trip_opened => opened(0),
      watchdog_opened => opened(1), emergency_stop_opened => opened(2), veto_opened => opened(3),
      refused => refused);

  test : process

    procedure expect (
      what : string; expected_closed : std_ulogic; expected_opened : std_ulogic_vector(3 downto 0);
      expected_refused : std_ulogic := '0') is
    begin
      is_closed_or_open : assert closed = expected_closed
        report what & ": closed is " & to_string(closed) severity error;
      says_what_opened_it : assert opened = expected_opened
        report what & ": opened by " & to_string(opened) severity error;
      says_what_it_refused : assert refused = expected_refused
        report what & ": refused is " & to_string(refused) severity error;
    end procedure;

    procedure wish_closed is
    begin
      close <= '1';
      wait_for_clock(clk);
      close <= '0';
    end procedure;

    procedure wish_open is
    begin
      open_again <= '1';
      wait_for_clock(clk);
      open_again <= '0';
    end procedure;

    procedure restart is
    begin
      reset <= '1';
      wait_for_clock(clk);
      reset <= '0';
      expect("reset", '0', "0000");
    end procedure;

    variable cause : std_ulogic_vector(3 downto 0);

  begin
    wait_for_clock(clk);
    restart;
    wait_for_clock(clk);
    expect("not asked for", '0', "0000");
    wish_closed;
    expect("closed", '1', "0000");
    wait_for_clock(clk);
    expect("stays closed", '1', "0000");
    all_at_rest <= '0';
    wait_for_clock(clk);
    expect("heating is no danger", '1', "0000");
    wish_closed;
    expect("closed while it heats: refused, but stays closed", '1', "0000", '1');
    wish_open;
    expect("opened", '0', "0000", '1');
    wish_closed;
    expect("not at rest", '0', "0000", '1');
    all_at_rest <= '1';
    wait_for_clock(clk);
    expect("not closed afterwards", '0', "0000", '1');
    wish_closed;
    expect("the last wish was granted", '1', "0000");
    wish_open;
    expect("software opens it: no cause", '0', "0000");

    -- Each set of causes: opens at once, is remembered when it has gone,
    -- keeps the supply open while it lasts.
    for bits in 1 to 15 loop
      for i in cause'range loop
        cause(i) := '1' when bits / 2 ** i mod 2 = 1 else '0';
      end loop;
      wish_closed;
      expect("closed", '1', "0000");
      causes <= cause;
      wait_for_clock(clk);
      expect("opened by " & to_string(cause), '0', cause);
      causes <= not cause;
      wait_for_clock(clk);
      expect("what comes later has not opened it", '0', cause);
      causes <= cause;
      wish_closed;
      expect("the cause lasts", '0', cause, '1');
      causes <= "0000";
      wait_for_clock(clk);
      expect("remembered", '0', cause, '1');
      all_at_rest <= '0';
      wish_closed;
      expect("not at rest after a cause", '0', cause, '1');
      all_at_rest <= '1';
      wish_open;
      expect("open anyway", '0', cause, '1');
      wish_closed;
      expect("closed again", '1', "0000");
      -- A cause in the clock of the request.
      causes <= cause;
      wish_closed;
      expect("danger comes with the wish", '0', cause, '1');
      causes <= "0000";
      restart;
      wish_closed;
      causes <= cause;
      restart;
      causes <= "0000";
    end loop;

    -- Opening wins over closing, reset over both.
    open_again <= '1';
    wish_closed;
    open_again <= '0';
    expect("both wishes", '0', "0000");
    wish_closed;
    open_again <= '1';
    wish_closed;
    open_again <= '0';
    expect("both wishes, closed before", '0', "0000");
    wish_closed;
    restart;
    close <= '1';
    restart;
    all_at_rest <= '0';
    restart;
    close <= '0';
    finish;
  end process;

end architecture;
