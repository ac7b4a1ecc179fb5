-- SPDX-License-Identifier: Apache-2.0
-- Full rate on all five axes at once: a step every second clock, over segments of one tick that reverse, with
-- pulses and with both edges, at the shortest guard.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_core_bench_pkg.put;
use work.step_generator_pkg.all;

entity step_generator_rate_tb is
end entity;

architecture simulation of step_generator_rate_tb is

  constant axes : positive := 5;
  constant depth : positive := 32;
  constant shortest : guard_t := (others => to_unsigned(1, 12));

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal both_edges : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal run : std_ulogic := '0';
  signal write : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  signal commit : std_ulogic := '0';
  signal refused : refusal_t;
  signal level : natural range 0 to depth;
  signal moving : std_ulogic;
  signal idle : std_ulogic;
  signal segments : count_t;
  signal underruns : count_t;
  signal stalls : count_t;
  signal positions : position_array_t(axes - 1 downto 0);
  signal step : std_ulogic_vector(axes - 1 downto 0);
  signal direction : std_ulogic_vector(axes - 1 downto 0);
  type naturals_t is array (natural range <>) of natural;
  signal pulses : naturals_t(axes - 1 downto 0);

begin

  clk <= not clk after 10 ns;

  core : entity work.step_generator_core
    generic map (axes => axes, queue_depth => depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset,
      guards => (others => shortest),
      both_edges => both_edges, rate_floor => to_unsigned(1, 31), enabled => (others => '1'), run => run,
      start => '0',
      software_start => '0', waiting => open, override => to_unsigned(65536, 18),
      override_slope => (others => '0'), brake_slope => (others => '0'), scale => open, held => open,
      write => write, commit => commit, refused => refused, flush => '0', level => level,
      max_level => open, moving => moving, idle => idle, segments => segments,
      underruns => underruns, stalls => stalls, axis_stalls => open, end_stops => x"00",
      emergency_stop => '0', software_stop => '0', software_brake => '0', acknowledge_stop => '0',
      watchdog_limit => (others => '0'), feed_watchdog => '0', braking => open, stopped => open,
      stop_cause => open, stop_positions => open, stop_time => open, positions => positions,
      set_position => (others => '0'), new_position => (others => '0'), position_refused => open,
      snapshot => '0', snapshot_positions => open, snapshot_time => open, step => step,
      direction => direction);

  monitors : for axis in 0 to axes - 1 generate
    monitor : entity work.pulse_monitor
      port map (
        clk => clk, reset => reset, guard => shortest, both_edges => both_edges(axis),
        step => step(axis), direction => direction(axis), position => positions(axis),
        set_position => '0', new_position => (others => '0'), pulses => pulses(axis));
  end generate;

  test : process
    procedure append_tick(backward : std_ulogic_vector(7 downto 0)) is
    begin
      put(clk, write, flags_lane, x"000000" & backward);
      put(clk, write, line_ticks_lane, x"00000001");
      put(clk, write, ticks_lane, x"00000001");
      for axis in 0 to axes - 1 loop
        put(clk, write, steps_lane + axis, x"00000001");
      end loop;
      for lane in rate_low_lane to jerk_high_lane loop
        put(clk, write, lane, x"00000000");
      end loop;
      put(clk, write, rate_high_lane, x"80000000");
      wait until rising_edge(clk);
      commit <= '1';
      wait until rising_edge(clk);
      commit <= '0';
      assert refused = refusal_none severity failure;
      wait until rising_edge(clk);
    end procedure;

    -- Fills the queue while it is held, lets it go and watches every clock.
    procedure make_thirty_two_steps is
      variable changes : natural := 0;
      variable clocks : natural := 0;
      variable last_step : std_ulogic_vector(axes - 1 downto 0);
      variable pulses_before : naturals_t(axes - 1 downto 0);
    begin
      run <= '0';
      -- Axis 0 always forward, axis 1 always backward, the others to and fro in different ways.
      for i in 0 to depth - 1 loop
        append_tick(
          "000" & std_ulogic(to_unsigned(i, 5)(0)) & std_ulogic(to_unsigned(i, 5)(1)) &
          not std_ulogic(to_unsigned(i, 5)(0)) & "10");
      end loop;
      assert level = depth severity failure;
      pulses_before := pulses;
      last_step := step;
      run <= '1';
      wait until rising_edge(clk) and moving = '1';
      while moving loop
        wait until rising_edge(clk);
        clocks := clocks + 1;
        if step /= last_step and (step = "11111" or both_edges = "11111") then
          changes := changes + 1;
          assert step = "11111" or step = "00000" report "axes step apart" severity failure;
        end if;
        last_step := step;
      end loop;
      -- The first is due after two clocks, each other one two clocks later; the pins follow a clock later.
      assert clocks = 2 * depth + 1 report to_string(clocks) & " clocks" severity failure;
      for i in 1 to 4 loop
        wait until rising_edge(clk);
      end loop;
      for axis in 0 to axes - 1 loop
        assert pulses(axis) - pulses_before(axis) = depth severity failure;
      end loop;
      assert changes = depth report to_string(changes) & " steps" severity failure;
      assert stalls = 0 severity failure;
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    make_thirty_two_steps;
    assert positions(0) = depth and positions(1) = -depth and positions(2) = 0 and
      positions(3) = 0 and positions(4) = 0 severity failure;
    make_thirty_two_steps;
    wait until rising_edge(clk) and idle = '1';
    both_edges <= (others => '1');
    make_thirty_two_steps;
    assert positions(0) = 3 * depth and positions(1) = -3 * depth and positions(2) = 0 severity failure;
    assert segments = 3 * depth severity failure;

    finish;
  end process;

end architecture;
