-- SPDX-License-Identifier: Apache-2.0
-- A reset reaches every clock with its next edge, and each clock is at rest exactly while nothing wakes it.

library ieee;
use ieee.std_logic_1164.all;

use work.clocked_bench_pkg.all;
use work.clocks_pkg.all;

entity clock_gating_tb is
end entity;

architecture bench of clock_gating_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal chip_reset, processor_rests, timer_alarm, bus_strobe : std_ulogic := '0';
  signal axes_rest, peripherals_rest : std_ulogic := '0';
  signal resets, debug_resets : resets_t;
  signal at_rest, debug_at_rest : clocks_at_rest_t;

begin

  clk <= not clk after 10 ns;

  gating : entity work.clock_gating
    port map (
      clocks => (others => clk), reset => reset, chip_reset => chip_reset,
      processor_rests => processor_rests, timer_alarm => timer_alarm, bus_strobe => bus_strobe,
      axes_rest => axes_rest, peripherals_rest => peripherals_rest, resets => resets,
      at_rest => at_rest);

  with_debug : entity work.clock_gating
    generic map (has_debug => true)
    port map (
      clocks => (others => clk), reset => reset, chip_reset => chip_reset,
      processor_rests => processor_rests, timer_alarm => timer_alarm, bus_strobe => bus_strobe,
      axes_rest => axes_rest, peripherals_rest => peripherals_rest, resets => debug_resets,
      at_rest => debug_at_rest);

  test : process

    constant none : resets_t := (others => '0');
    constant all_of_them : resets_t := (others => '1');

    procedure expect(processor, registers, axes, peripherals : std_ulogic; what : string) is
    begin
      wait for 1 ns;
      is_at_rest : assert at_rest = (processor, registers, axes, peripherals) report what severity failure;
      with_a_debugger_the_processor_never_rests : assert
        debug_at_rest = ('0', registers, axes, peripherals) report what severity failure;
    end procedure;

  begin
    processor_rests <= '1';
    axes_rest <= '1';
    peripherals_rest <= '1';
    wait_clocks(clk, 1);
    the_pin_resets_all : assert resets = all_of_them severity failure;
    expect('0', '0', '1', '1', "reset");
    reset <= '0';
    wait_clocks(clk, 1);
    ends_for_all : assert resets = none severity failure;
    wait_clocks(clk, 10);
    expect('1', '1', '1', '1', "nothing to do");

    timer_alarm <= '1';
    expect('0', '1', '1', '1', "the timer's deadline");
    timer_alarm <= '0';
    processor_rests <= '0';
    expect('0', '1', '1', '1', "the processor works");
    processor_rests <= '1';
    axes_rest <= '0';
    expect('1', '1', '0', '1', "something moves");
    axes_rest <= '1';
    peripherals_rest <= '0';
    expect('1', '1', '1', '0', "a peripheral works");
    peripherals_rest <= '1';
    bus_strobe <= '1';
    expect('1', '0', '1', '1', "an access");
    wait_clocks(clk, 1);
    bus_strobe <= '0';
    for i in 1 to 6 loop
      expect('1', '0', '1', '1', "what an access sets off");
      wait_clocks(clk, 1);
    end loop;
    wait_clocks(clk, 3);
    expect('1', '1', '1', '1', "the access is over");

    chip_reset <= '1';
    expect('1', '1', '0', '0', "the debugger resets");
    wait_clocks(clk, 1);
    the_debugger_resets_all : assert resets = all_of_them and debug_resets = all_of_them severity failure;
    expect('0', '0', '0', '0', "in reset");
    chip_reset <= '0';
    wait_clocks(clk, 10);
    expect('1', '1', '1', '1', "at rest again");
    std.env.finish;
  end process;

end architecture;
