-- SPDX-License-Identifier: Apache-2.0
-- End stops of either polarity trigger after their filter time, bounce unseen, and only where enabled.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.end_stops_registers_pkg.all;

entity end_stops_tb is
end entity;

architecture simulation of end_stops_tb is

  constant status : unsigned(31 downto 0) := end_stops_status_address;
  constant filter : unsigned(31 downto 0) := end_stops_filter_address;
  constant polarity : unsigned(31 downto 0) := end_stops_polarity_address;
  constant enable : unsigned(31 downto 0) := end_stops_enable_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal switches : std_ulogic_vector(7 downto 0) := x"00";
  signal triggered : std_ulogic_vector(7 downto 0);

  -- A second one runs on gated clocks: at rest, and without an access.
  signal resting_clk, resting_bus_clk : std_ulogic;
  signal rested_response : bus_response_t;
  signal rested_triggered : std_ulogic_vector(7 downto 0);
  signal at_rest : std_ulogic;

  alias clk is master.clk;

begin

  clocks : entity work.resting_clocks
    generic map (period => 10 ns)
    port map (
      reset => reset, strobe => master.request.strobe, at_rest => at_rest, pins => switches, clk => clk,
      resting_clk => resting_clk, resting_bus_clk => resting_bus_clk, clocks_left_out => open);

  end_stops : entity work.end_stops
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, switches => switches, triggered => triggered);

  rested : entity work.end_stops
    port map (
      clk => resting_clk, bus_clk => resting_bus_clk, reset => reset,
      request => to_request(master.request), response => rested_response, switches => switches,
      triggered => rested_triggered, at_rest => at_rest);

  compare : process
  begin
    wait until falling_edge(clk);
    rest_changes_nothing : assert rested_triggered = triggered
      and rested_response = to_response(master.response)
      report "triggered " & to_hstring(rested_triggered) & " after a rest" severity error;
  end process;

  check : process
    -- Clocks from a pin to the output, besides the filter's: two to synchronise, one to judge.
    constant fixed_delay_clocks : positive := 3;
    variable word : word_t;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
      wait until falling_edge(clk);
    end procedure;

    procedure check_status (raw, filtered, expected_triggered : std_ulogic_vector(7 downto 0)) is
    begin
      wait until rising_edge(clk);
      read(master, status, word);
      status_reports_each_stage : assert word = to_word(end_stops_status_t'(
        raw => raw, filtered => filtered, triggered => expected_triggered))
        report "status " & to_hstring(word) severity error;
      output_is_what_the_status_reports : assert triggered = expected_triggered
        report "triggered " & to_hstring(triggered) severity error;
    end procedure;
  begin
    wait_clocks(2);
    reset <= '0';
    switches <= x"FF";
    wait_clocks(300);
    check_status(x"FF", x"FF", x"00");
    nothing_is_triggered_before_it_is_enabled : assert triggered = x"00"
      report to_hstring(triggered) severity error;
    switches <= x"00";
    wait_clocks(300);

    write(master, enable, 16#F7#);
    for cycles in 1 to 40 loop
      write(master, filter, cycles);
      wait_clocks(50);
      switches <= x"5A";
      wait_clocks(fixed_delay_clocks + cycles - 1);
      is_not_early : assert triggered = x"00" report "early with " & to_string(cycles)
        severity error;
      wait_clocks(1);
      is_exact : assert triggered = x"52" report "late with " & to_string(cycles) severity error;
      switches <= x"00";
      wait_clocks(fixed_delay_clocks + cycles - 1);
      does_not_release_early : assert triggered = x"52" report "early with " & to_string(cycles)
        severity error;
      wait_clocks(1);
      releases : assert triggered = x"00" report "late with " & to_string(cycles) severity error;
    end loop;

    -- A contact that bounces for a while is seen once, after it has come to rest.
    write(master, filter, 30);
    for bounce in 1 to 29 loop
      switches(0) <= '1';
      wait_clocks(bounce);
      switches(0) <= '0';
      wait_clocks(1);
      does_not_bounce : assert triggered = x"00" report "bounced" severity error;
    end loop;
    switches(0) <= '1';
    wait_clocks(30 + fixed_delay_clocks);
    comes_to_rest : assert triggered = x"01" report "not seen" severity error;
    switches(0) <= '0';
    switches(1) <= '1';
    wait_clocks(5);
    check_status(x"02", x"01", x"01");
    wait_clocks(40);
    check_status(x"02", x"02", x"02");

    -- Inverted inputs are triggered while low.
    write(master, polarity, 16#0C#);
    wait_clocks(2);
    check_status(x"02", x"02", x"06");
    switches <= x"0C";
    wait_clocks(50);
    check_status(x"0C", x"0C", x"00");
    wait_clocks(50);
    comes_to_rest_with_its_inputs : assert at_rest report "never at rest" severity error;

    -- Each input has a polarity of its own, and is enabled by itself.
    switches <= x"00";
    for input in 0 to 7 loop
      write(master, enable, 16#FF#);
      write(master, polarity, 2 ** input);
      wait_clocks(50);
      has_its_own_polarity : assert unsigned(triggered) = 2 ** input
        report "input " & to_string(input) & ": " & to_hstring(triggered) severity error;
      write(master, polarity, 16#FF#);
      write(master, enable, 2 ** input);
      wait_clocks(50);
      is_enabled_by_itself : assert unsigned(triggered) = 2 ** input
        report "input " & to_string(input) & ": " & to_hstring(triggered) severity error;
    end loop;
    write(master, polarity, 16#0C#);
    write(master, enable, 16#F7#);
    switches <= x"0C";
    wait_clocks(50);

    -- What comes from a pin is synchronized first.
    switches <= x"00";
    check_status(x"0C", x"0C", x"00");
    wait_clocks(50);
    check_status(x"00", x"00", x"04");
    reset <= '1';
    wait_clocks(1);
    reset <= '0';
    reset_takes_effect_at_once : assert triggered = x"00" report to_hstring(triggered)
      severity error;
    std.env.finish;
  end process;

end architecture;
