-- SPDX-License-Identifier: Apache-2.0
-- The pins of a time_base as two records, and what its benches do with them again and again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

package time_base_harness_pkg is

  constant half : unsigned(63 downto 0) := x"8000000000000000";
  constant quarter : unsigned(63 downto 0) := x"4000000000000000";

  type time_base_inputs_t is record
    reset : std_ulogic;
    advance : std_ulogic;
    leap : leap_t;
    run : std_ulogic;
    start : std_ulogic;
    stop : std_ulogic;
    rate_floor : unsigned(30 downto 0);
    head_valid : std_ulogic;
    head : segment_t;
    axes_ready : std_ulogic;
  end record;

  constant time_base_in_reset : time_base_inputs_t := (
    reset => '1', advance => '1', leap => (others => '0'), rate_floor => to_unsigned(1, 31),
    axes_ready => '1',
    head => (
      backward => x"00", ahead => x"00", behind => x"00", continues_line => '0',
      ends_motion => '0', waits_for_start => '0', stop_on => stop_condition_none,
      line_ticks => (others => '0'), ticks => (others => '0'),
      rate => (others => '0'), acceleration => (others => '0'), jerk => (others => '0')),
    others => '0');

  type time_base_outputs_t is record
    longest_leap : leap_t;
    take : std_ulogic;
    due : std_ulogic;
    tick : std_ulogic;
    stalled : std_ulogic;
    active : std_ulogic;
    stop_on : stop_condition_t;
    waiting : std_ulogic;
    segments : count_t;
    underruns : count_t;
    stalls : count_t;
    accelerating : std_ulogic;
    decelerating : std_ulogic;
  end record;

  -- What the harness counts.
  type time_base_counts_t is record
    clocks : natural;
    ticks : natural;
    clocks_between_ticks : natural;
    clocks_since_tick : natural;
  end record;

  procedure wait_for_clocks (signal clk : in std_ulogic; number : in natural);

  -- Until the segment is taken.
  procedure offer (
    signal clk : in std_ulogic; signal inputs : inout time_base_inputs_t;
    signal outputs : in time_base_outputs_t; number : in positive; rate : in unsigned;
    ends_motion : in std_ulogic := '1'; acceleration : in signed(63 downto 0) := (others => '0'));

  procedure wait_for_rest (signal clk : in std_ulogic; signal outputs : in time_base_outputs_t);

end package;

package body time_base_harness_pkg is

  procedure wait_for_clocks (signal clk : in std_ulogic; number : in natural) is
  begin
    for i in 1 to number loop
      wait until rising_edge(clk);
    end loop;
  end procedure;

  procedure offer (
    signal clk : in std_ulogic; signal inputs : inout time_base_inputs_t;
    signal outputs : in time_base_outputs_t; number : in positive; rate : in unsigned;
    ends_motion : in std_ulogic := '1'; acceleration : in signed(63 downto 0) := (others => '0')) is
  begin
    inputs.head.ticks <= to_unsigned(number, 31);
    inputs.head.rate <= rate;
    inputs.head.acceleration <= acceleration;
    inputs.head.ends_motion <= ends_motion;
    inputs.head_valid <= '1';
    wait until rising_edge(clk) and outputs.take = '1';
    inputs.head_valid <= '0';
  end procedure;

  procedure wait_for_rest (signal clk : in std_ulogic; signal outputs : in time_base_outputs_t) is
  begin
    wait until rising_edge(clk) and outputs.active = '0';
    wait_for_clocks(clk, 2);
  end procedure;

end package body;
