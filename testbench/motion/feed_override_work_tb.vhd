-- SPDX-License-Identifier: Apache-2.0
-- The scale asks for its clock as long as something is to be done, although nothing changes yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.clocked_bench_pkg.all;
use work.step_generator_pkg.all;

entity feed_override_work_tb is
end entity;

architecture simulation of feed_override_work_tb is

  -- In 2^-16.
  constant one : natural := 65536;
  constant at_once : slope_t := x"FFFFFFFF";

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal moving : std_ulogic := '0';
  signal target : unsigned(17 downto 0) := to_unsigned(one, 18);
  signal slope : slope_t := x"00001000";
  signal accelerating, decelerating : std_ulogic := '0';
  signal longest_leap : leap_t := to_unsigned(2, 2);
  signal advance : std_ulogic;
  signal leap : leap_t;
  signal scale : scale_t;
  signal working : std_ulogic;

begin

  clk <= not clk after 10 ns;

  pace : entity work.feed_override
    port map (
      clk => clk, reset => reset, moving => moving, target => target, slope => slope,
      accelerating => accelerating, decelerating => decelerating, braking => '0',
      brake_slope => at_once, stalled => '0', longest_leap => longest_leap,
      advance => advance, leap => leap, scale => scale, standing => open, working => working);

  test : process

    procedure move_at(value : natural) is
    begin
      moving <= '0';
      target <= to_unsigned(value, 18);
      wait_clocks(clk, 4);
      moving <= '1';
      wait_clocks(clk, 10);
      assert scale = (to_unsigned(value, 18) & x"0000") severity failure;
    end procedure;

    variable done : natural := 0;
    variable scale_before : scale_t;
  begin
    wait_clocks(clk, 2);
    reset <= '0';

    move_at(one);
    rests_at_one : assert working = '0' report "works at a scale of 1" severity failure;

    -- A change that waits for the end of the base's ramp: from 1, and to 1.
    for from in 1 to 2 loop
      move_at(from * one);
      accelerating <= '1';
      decelerating <= '1';
      target <= to_unsigned((3 - from) * one, 18);
      wait_clocks(clk, 20);
      scale_before := scale;
      for i in 1 to 100 loop
        wait_clocks(clk, 1);
        assert scale = scale_before severity failure;
        waits_at_work : assert working = '1' report "rests before its change" severity failure;
      end loop;
      accelerating <= '0';
      decelerating <= '0';
      wait_clocks(clk, 2);
      assert scale /= scale_before severity failure;
    end loop;

    -- Base clocks that wait for longer leaps: three are caught up as soon as there may be one.
    slope <= at_once;
    longest_leap <= to_unsigned(0, 2);
    move_at(3 * one);
    target <= to_unsigned(one, 18);
    wait_clocks(clk, 5);
    for i in 1 to 100 loop
      wait_clocks(clk, 1);
      assert scale = scale_of_one and advance = '1' and leap = 0 severity failure;
      owes : assert working = '1' report "rests while it owes" severity failure;
    end loop;
    longest_leap <= to_unsigned(2, 2);
    for i in 1 to 10 loop
      wait_clocks(clk, 1);
      done := done + 2 ** to_integer(leap) when advance = '1' else done;
    end loop;
    catches_up : assert done = 13 report to_string(done) & " base clocks" severity failure;
    std.env.finish;
  end process;

end architecture;
