-- SPDX-License-Identifier: Apache-2.0
-- A port that is closed gives one break after its last byte; a host without DTR, or that reopens
-- the port, is heard.

library ieee;
use ieee.std_logic_1164.all;

entity port_watch_tb is
end entity;

architecture simulation of port_watch_tb is

  constant period : time := 20 ns;
  constant quiet_clocks : positive := 50;
  constant break_clocks : positive := 1000;
  -- At least, of the bytes here.
  constant stop_bit_clocks : positive := 16;
  -- Two flip-flops and the state.
  constant latency_clocks : positive := 4;

  signal clk : std_ulogic := '0';
  signal line, closed : std_ulogic := '1';
  signal receive : std_ulogic;
  signal break_allowed : boolean := false;
  signal breaks : natural := 0;

begin

  clk <= not clk after period / 2;

  watch : entity work.port_watch
    generic map (quiet_clocks => quiet_clocks, break_clocks => break_clocks)
    port map (clk => clk, line => line, closed => closed, receive => receive);

  -- At the end of each instant.
  compare : process
  begin
    wait until falling_edge(clk);
    is_heard : assert break_allowed or receive = line report "the host is not heard" severity error;
  end process;

  count_breaks : process
  begin
    wait until falling_edge(receive) and line = '1';
    breaks <= breaks + 1;
  end process;

  check : process

    -- A start bit, bits and the stop bit, at times that are no clock's.
    procedure send_byte is
      constant bits : std_ulogic_vector(0 to 9) := "0110010101";
    begin
      for i in bits'range loop
        line <= bits(i);
        wait for 15 * period + 3 ns;
      end loop;
    end procedure;

    procedure expect_one_break is
      variable began : time;
      variable before : natural;
    begin
      before := breaks;
      break_allowed <= true;
      wait until receive = '0' for (quiet_clocks + latency_clocks) * period;
      comes : assert receive = '0' report "no break" severity error;
      began := now;
      wait until receive = '1' for (break_clocks + latency_clocks) * period;
      lasts : assert now - began = break_clocks * period
        report "lasts " & to_string(now - began) severity error;
      break_allowed <= false;
      wait for 3 * break_clocks * period;
      once : assert breaks = before + 1 report to_string(breaks - before) & " breaks" severity error;
    end procedure;

  begin
    -- A host that does not raise DTR.
    for i in 1 to 20 loop
      send_byte;
    end loop;
    wait for 3 * break_clocks * period;
    -- One that does, also before its first byte.
    closed <= '0';
    wait for 100 * period;
    for i in 1 to 20 loop
      send_byte;
    end loop;
    wait for 3 * break_clocks * period;
    closed <= '1';
    expect_one_break;

    -- The bridge still sends when the port is closed, with pauses that are too short.
    closed <= '0';
    wait for 100 * period;
    send_byte;
    closed <= '1';
    for i in 1 to 5 loop
      send_byte;
      wait for (quiet_clocks - stop_bit_clocks - latency_clocks) * period;
    end loop;
    send_byte;
    expect_one_break;

    -- Without DTR again, after a break.
    send_byte;
    wait for 3 * break_clocks * period;

    -- Closed and opened again before the break: none.
    closed <= '0';
    wait for 100 * period;
    closed <= '1';
    wait for (quiet_clocks - latency_clocks) * period;
    closed <= '0';
    wait for 3 * break_clocks * period;
    none_was_made : assert breaks = 2 report to_string(breaks) & " breaks" severity error;

    -- Opened in the middle of the break: it ends at once.
    closed <= '1';
    break_allowed <= true;
    wait for break_clocks / 2 * period;
    breaks_off_begun : assert receive = '0' report "no break" severity error;
    closed <= '0';
    wait for latency_clocks * period;
    break_allowed <= false;
    wait for 1 ns;
    send_byte;
    wait for 3 * break_clocks * period;
    std.env.finish;
  end process;

end architecture;
