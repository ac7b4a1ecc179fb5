-- SPDX-License-Identifier: Apache-2.0
-- The timer counts every clock, is read without tearing, and interrupts exactly from its deadline on.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.timer_registers_pkg.all;

entity timer_tb is
end entity;

architecture simulation of timer_tb is

  constant time_low : unsigned(31 downto 0) := timer_time_low_address;
  constant time_high : unsigned(31 downto 0) := timer_time_high_address;
  constant compare_low : unsigned(31 downto 0) := timer_compare_low_address;
  constant compare_high : unsigned(31 downto 0) := timer_compare_high_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal timer_interrupt, alarm : std_ulogic;

  -- Clocks since reset, counted by the bench.
  signal clocks : natural := 0;
  signal clocks_at_interrupt : natural := 0;

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  timer : entity work.timer
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response,
      timer_interrupt => timer_interrupt, alarm => alarm);

  count : process
  begin
    wait until rising_edge(clk);
    clocks <= 0 when reset else clocks + 1;
  end process;

  catch_interrupt : process
  begin
    wait until rising_edge(timer_interrupt);
    clocks_at_interrupt <= clocks;
  end process;

  -- Clock gating relies on it.
  watch_alarm : process
    variable interrupt_before, alarm_before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    no_interrupt_begins_without_alarm : assert
      timer_interrupt = '0' or interrupt_before = '1' or alarm_before = '1'
      report "the clock before was taken for one that changes nothing" severity error;
    interrupt_before := timer_interrupt;
    alarm_before := alarm;
  end process;

  check : process
    variable word : word_t;
    variable now_cycles : unsigned(63 downto 0);
    variable strobe_clocks : natural;

    procedure read_time is
    begin
      strobe_clocks := clocks;
      read(master, time_low, word);
      now_cycles(31 downto 0) := unsigned(word);
      read(master, time_high, word);
      now_cycles(63 downto 32) := unsigned(word);
    end procedure;

    procedure set_deadline (cycles : unsigned(63 downto 0)) is
    begin
      write(master, compare_low, word_t(cycles(31 downto 0)));
      write(master, compare_high, word_t(cycles(63 downto 32)));
    end procedure;
    procedure set_deadline (cycles : natural) is
    begin
      set_deadline(to_unsigned(cycles, 64));
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);

    for i in 1 to 20 loop
      read_time;
      -- The value is sampled in the clock after the one in which the strobe is set.
      counts_every_clock : assert now_cycles = strobe_clocks + 1
        report "time " & to_hstring(now_cycles) & " in clock " & to_string(strobe_clocks)
        severity error;
    end loop;

    no_interrupt_before_a_deadline_is_set : assert timer_interrupt = '0' report "interrupt"
      severity error;
    set_deadline(500);
    wait until clocks = 600;
    interrupts_one_clock_after_the_deadline : assert clocks_at_interrupt = 501
      report "interrupt in clock " & to_string(clocks_at_interrupt) severity error;
    stays_until_a_later_deadline : assert timer_interrupt = '1' report "went away" severity error;

    -- Half a write changes nothing; a whole one ends the interrupt at once.
    write(master, compare_low, x"FFFF_FFFF");
    half_a_deadline_has_no_effect : assert timer_interrupt = '1' report "went away" severity error;
    master.request <= (strobe => '1', write => '1', address => compare_high, select_bytes => "1111",
      data => x"0000_0000");
    wait until rising_edge(clk);
    wait until falling_edge(clk);
    ends_with_the_acknowledge : assert master.response.acknowledge = '1' and timer_interrupt = '0'
      report "still interrupts while acknowledged" severity error;
    wait until rising_edge(clk);
    master.request <= request_wires_idle;
    for i in 1 to 20 loop
      wait until rising_edge(clk);
      is_not_spurious : assert timer_interrupt = '0' report "spurious interrupt" severity error;
    end loop;

    -- From a deadline beyond 2**32 to a near one and back: no value in between may interrupt.
    set_deadline(x"0000_0002_0000_0000");
    set_deadline(x"0000_0001_0000_0000");
    wait for 100 ns;
    an_old_half_does_not_mix_in : assert timer_interrupt = '0' report "spurious interrupt"
      severity error;

    set_deadline(0);
    wait for 100 ns;
    a_passed_deadline_interrupts_at_once : assert timer_interrupt = '1' report "no interrupt"
      severity error;

    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    wait for 100 ns;
    forgets_its_deadline_at_reset : assert timer_interrupt = '0' report "interrupt" severity error;
    read_time;
    starts_over : assert now_cycles = strobe_clocks + 1 report to_hstring(now_cycles)
      severity error;

    -- Tearing: the low half overflows around the two reads, at every distance.
    for distance in 0 to 12 loop
      << signal timer.now_cycles : unsigned(63 downto 0) >> <= force x"0000_0007_FFFF_FFF8";
      wait until rising_edge(clk);
      << signal timer.now_cycles : unsigned(63 downto 0) >> <= release;
      for i in 1 to distance loop
        wait until rising_edge(clk);
      end loop;
      read_time;
      both_halves_are_of_one_instant : assert now_cycles >= x"0000_0007_FFFF_FFF8"
        and now_cycles < x"0000_0008_0000_0010"
        report "torn: " & to_hstring(now_cycles) severity error;
    end loop;
    std.env.finish;
  end process;

end architecture;
