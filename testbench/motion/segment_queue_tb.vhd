-- SPDX-License-Identifier: Apache-2.0
-- Segments come out whole and in order, whatever the mixture of writing and taking.

library ieee;
use ieee.math_real.all;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_queue_tb is
end entity;

architecture simulation of segment_queue_tb is

  constant axes : positive := 2;
  constant depth : positive := 5;
  -- No multiple of the depth, so that a flush finds the queue within a round.
  constant segments : positive := 402;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal write : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  signal append : std_ulogic := '0';
  signal flush : std_ulogic := '0';
  signal level : natural range 0 to depth;
  signal max_level : natural range 0 to depth;
  signal full : std_ulogic;
  signal head_valid : std_ulogic;
  signal head : segment_t;
  signal head_steps : ticks_array_t(axes - 1 downto 0);
  signal take : std_ulogic := '0';
  signal may_take : boolean := false;
  signal taken : natural := 0;

  -- Word of a lane of the n-th segment, different everywhere; ticks and steps have 31 bits.
  function word(segment : natural; lane : lane_t) return std_ulogic_vector is
    constant half : std_ulogic_vector(15 downto 0) :=
      std_ulogic_vector(to_unsigned((segment * 7919 + lane * 40503) mod 2 ** 15, 16));
    constant both : std_ulogic_vector(31 downto 0) := half & half;
  begin
    return both;
  end function;

begin

  clk <= not clk after 10 ns;

  queue : entity work.segment_queue
    generic map (axes => axes, depth => depth)
    port map (
      clk => clk, bus_clk => clk, reset => reset, write => write, append => append, flush => flush,
      level => level, max_level => max_level, full => full, head_valid => head_valid,
      head => head, head_steps => head_steps, take => take);

  -- Takes and checks, now eagerly, now lazily.
  consume : process
    variable seed_1 : positive := 7;
    variable seed_2 : positive := 9;
    variable chance : real;
    variable clocks_since_take : natural := 100;
    variable last_level : natural := 0;
  begin
    wait until falling_edge(clk);
    take <= '0';
    clocks_since_take := clocks_since_take + 1;
    if head_valid = '1' and may_take then
      uniform(seed_1, seed_2, chance);
      if chance < 0.3 or (taken / 50) mod 2 = 0 then
        take <= '1';
        taken <= taken + 1;
        clocks_since_take := 0;
        assert head.backward = word(taken, flags_lane)(7 downto 0) severity failure;
        assert head.stop_on.mask = word(taken, flags_lane)(23 downto 16) severity failure;
        assert head.stop_on.on_change = word(taken, flags_lane)(10) severity failure;
        assert head.stop_on.on_release = word(taken, flags_lane)(11) severity failure;
        assert head.stop_on.brakes = word(taken, flags_lane)(12) severity failure;
        assert head.continues_line = word(taken, flags_lane)(8) severity failure;
        assert head.ends_motion = word(taken, flags_lane)(9) severity failure;
        assert head.waits_for_start = word(taken, flags_lane)(13) severity failure;
        assert head.ahead = x"0" & word(taken, flags_lane)(27 downto 24) severity failure;
        assert head.behind = x"0" & word(taken, flags_lane)(31 downto 28) severity failure;
        assert head.line_ticks = unsigned(word(taken, line_ticks_lane)) severity failure;
        assert head.ticks = unsigned(word(taken, ticks_lane)) severity failure;
        assert head.rate = unsigned(word(taken, rate_high_lane)) & unsigned(word(taken, rate_low_lane))
          severity failure;
        assert head.acceleration =
          signed(word(taken, acceleration_high_lane)) & signed(word(taken, acceleration_low_lane))
          severity failure;
        assert head.jerk = signed(word(taken, jerk_high_lane)) & signed(word(taken, jerk_low_lane))
          severity failure;
        for axis in 0 to axes - 1 loop
          assert head_steps(axis) = unsigned(word(taken, steps_lane + axis)) severity failure;
        end loop;
      end if;
    elsif clocks_since_take = 1 and last_level > 1 then
      assert false report "the next segment is not ready after a clock" severity failure;
    end if;
    last_level := level;
  end process;

  test : process
    procedure write_segment(number : natural) is
    begin
      for lane in 0 to steps_lane + axes - 1 loop
        write <= (valid => '1', lane => lane, data => word(number, lane));
        wait until rising_edge(clk);
      end loop;
      -- Nothing is written any more, whatever the other wires say.
      write <= (valid => '0', lane => ticks_lane, data => x"00000BAD");
      append <= '1';
      wait until rising_edge(clk);
      append <= '0';
      wait until rising_edge(clk);
    end procedure;
  begin
    wait until rising_edge(clk);
    reset <= '0';

    for number in 0 to depth - 1 loop
      assert level = number severity failure;
      write_segment(number);
    end loop;
    assert full = '1' and level = depth severity failure;
    -- Lost, without effect.
    write <= (valid => '1', lane => ticks_lane, data => x"DEADBEEF");
    wait until rising_edge(clk);
    write.valid <= '0';

    may_take <= true;
    for number in depth to segments - 1 loop
      if full = '1' then
        wait until rising_edge(clk) and full = '0';
      end if;
      write_segment(number);
    end loop;
    if taken < segments then
      wait until taken = segments for 10 us;
    end if;
    assert taken = segments report to_string(taken) & " taken" severity failure;
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    assert level = 0 and max_level = depth severity failure;

    may_take <= false;
    write_segment(0);
    write_segment(0);
    flush <= '1';
    wait until rising_edge(clk);
    flush <= '0';
    wait for 1 ns;
    assert level = 0 and head_valid = '0' severity failure;
    may_take <= true;
    write_segment(segments);
    wait until taken = segments + 1 for 1 us;
    assert taken = segments + 1 severity failure;

    -- A reset leaves nothing either, nor the highest level.
    may_take <= false;
    write_segment(0);
    write_segment(0);
    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    wait for 1 ns;
    assert level = 0 and max_level = 0 and head_valid = '0' and full = '0' severity failure;

    finish;
  end process;

end architecture;
