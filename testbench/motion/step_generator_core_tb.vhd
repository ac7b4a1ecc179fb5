-- SPDX-License-Identifier: Apache-2.0
-- Random lines through queue, base and axes: exact counts, guards, positions; then each kind of stop and
-- command, and what they leave behind.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.random_source_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_core_tb is
end entity;

architecture simulation of step_generator_core_tb is

  constant continues_line : natural := 2 ** step_generator_segment_flags_continues_line_bit;
  constant stop_brakes : natural := 2 ** step_generator_segment_flags_stop_brakes_bit;
  constant waits_for_start : natural := 2 ** step_generator_segment_flags_waits_for_start_bit;

  constant axes : positive := 3;
  constant depth : positive := 4;

  signal clk : std_ulogic := '0';
  -- The same edges, or none while it rests.
  signal bus_clk : std_ulogic := '0';
  signal bus_rests : boolean := false;
  -- Clocks since the reset.
  signal clocks_run : natural := 0;
  signal reset : std_ulogic := '1';
  signal guards : guard_array_t(axes - 1 downto 0) := (
    0 => (high => to_unsigned(1, 12), low => to_unsigned(1, 12),
      direction_setup => to_unsigned(1, 12), direction_hold => to_unsigned(1, 12)),
    1 => (high => to_unsigned(3, 12), low => to_unsigned(5, 12),
      direction_setup => to_unsigned(2, 12), direction_hold => to_unsigned(4, 12)),
    2 => (high => to_unsigned(12, 12), low => to_unsigned(9, 12),
      direction_setup => to_unsigned(10, 12), direction_hold => to_unsigned(10, 12)));
  signal both_edges : std_ulogic_vector(axes - 1 downto 0) := "010";
  signal write : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  signal commit : std_ulogic := '0';
  signal refused : refusal_t;
  signal flush : std_ulogic := '0';
  signal level : natural range 0 to depth;
  signal max_level : natural range 0 to depth;
  signal moving : std_ulogic;
  signal idle : std_ulogic;
  signal segments : count_t;
  signal underruns : count_t;
  signal stalls : count_t;
  signal axis_stalls : count_array_t(axes - 1 downto 0);
  signal end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop : std_ulogic := '0';
  signal software_stop : std_ulogic := '0';
  signal software_brake : std_ulogic := '0';
  signal braking : std_ulogic;
  signal start : std_ulogic := '0';
  signal software_start : std_ulogic := '0';
  signal run : std_ulogic := '1';
  signal enabled : std_ulogic_vector(axes - 1 downto 0) := (others => '1');
  signal watchdog_limit : natural := 0;
  signal feed_watchdog : std_ulogic := '0';
  signal waiting : std_ulogic;
  signal override : unsigned(17 downto 0) := to_unsigned(65536, 18);
  signal scale : scale_t;
  signal held : std_ulogic;
  signal acknowledge_stop : std_ulogic := '0';
  signal stopped : std_ulogic;
  signal stop_cause : stop_cause_t;
  signal stop_positions : position_array_t(axes - 1 downto 0);
  signal stop_time : time_t;
  signal positions : position_array_t(axes - 1 downto 0);
  signal set_position : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal new_position : position_t := (others => '0');
  signal position_refused : std_ulogic;
  signal snapshot : std_ulogic := '0';
  signal snapshot_positions : position_array_t(axes - 1 downto 0);
  signal snapshot_time : time_t;
  signal step : std_ulogic_vector(axes - 1 downto 0);
  signal direction : std_ulogic_vector(axes - 1 downto 0);
  type naturals_t is array (natural range <>) of natural;
  signal pulses : naturals_t(axes - 1 downto 0);

begin

  -- Both in one moment, as from one clock tree.
  make_clocks : process
  begin
    wait for 10 ns;
    clk <= '1';
    bus_clk <= '0' when bus_rests else '1';
    wait for 10 ns;
    clk <= '0';
    bus_clk <= '0';
  end process;

  count_clocks : process
  begin
    wait until rising_edge(clk);
    clocks_run <= 0 when reset else clocks_run + 1;
  end process;

  core : entity work.step_generator_core
    generic map (axes => axes, queue_depth => depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => bus_clk, reset => reset, guards => guards,
      both_edges => both_edges,
      rate_floor => to_unsigned(2 ** 20, 31), enabled => enabled, run => run, start => start,
      software_start => software_start, waiting => waiting,
      override => override, override_slope => x"01000000", brake_slope => x"00200000",
      scale => scale, held => held, watchdog_limit => to_unsigned(watchdog_limit, 32),
      feed_watchdog => feed_watchdog,
      braking => braking, software_brake => software_brake, write => write,
      commit => commit, refused => refused, flush => flush,
      level => level, max_level => max_level, moving => moving, idle => idle,
      segments => segments, underruns => underruns, stalls => stalls,
      axis_stalls => axis_stalls, end_stops => end_stops, emergency_stop => emergency_stop,
      software_stop => software_stop, acknowledge_stop => acknowledge_stop, stopped => stopped,
      stop_cause => stop_cause, stop_positions => stop_positions, stop_time => stop_time,
      positions => positions, set_position => set_position, new_position => new_position,
      position_refused => position_refused, snapshot => snapshot,
      snapshot_positions => snapshot_positions, snapshot_time => snapshot_time, step => step,
      direction => direction);

  monitors : for axis in 0 to axes - 1 generate
    signal position_is_set : std_ulogic;
  begin
    position_is_set <= set_position(axis) and not position_refused;
    monitor : entity work.pulse_monitor
      port map (
        clk => clk, reset => reset, guard => guards(axis), both_edges => both_edges(axis), step => step(axis),
        direction => direction(axis), position => positions(axis),
        set_position => position_is_set, new_position => new_position, pulses => pulses(axis));
  end generate;

  test : process
    variable random : random_source_t;

    procedure put(lane : lane_t; data : natural) is
    begin
      write <= (valid => '1', lane => lane, data => std_ulogic_vector(to_unsigned(data, 32)));
      wait until rising_edge(clk);
      write.valid <= '0';
    end procedure;

    procedure put_course(ticks, rate_high : natural) is
    begin
      put(ticks_lane, ticks);
      put(rate_low_lane, 0);
      put(rate_high_lane, rate_high);
      for lane in acceleration_low_lane to jerk_high_lane loop
        put(lane, 0);
      end loop;
      wait until rising_edge(clk);
      commit <= '1';
      wait until rising_edge(clk);
      commit <= '0';
      wait until rising_edge(clk);
    end procedure;

    procedure clocks(number : natural) is
    begin
      for i in 1 to number loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure wait_for_space is
    begin
      if level = depth then
        wait until rising_edge(clk) and level < depth;
      end if;
    end procedure;

    procedure pulse(signal command : out std_ulogic) is
    begin
      command <= '1';
      clocks(1);
      command <= '0';
    end procedure;

    procedure acknowledge is
    begin
      pulse(acknowledge_stop);
      clocks(1);
      assert stopped = '0' severity failure;
    end procedure;

    -- The end of a segment: a step of each axis every tick, of which each takes 16 clocks.
    procedure put_steps(ticks : natural) is
    begin
      put(steps_lane, ticks);
      put(steps_lane + 1, ticks);
      put(steps_lane + 2, ticks);
      put(ticks_lane, ticks);
      put(rate_low_lane, 0);
      put(rate_high_lane, 2 ** 28);
      for lane in acceleration_low_lane to jerk_high_lane loop
        put(lane, 0);
      end loop;
      clocks(1);
    end procedure;

    procedure put_words(ticks : natural; flags : natural := 0) is
    begin
      put(flags_lane, flags);
      put(line_ticks_lane, ticks);
      put_steps(ticks);
    end procedure;

    procedure put_line(ticks : natural; flags : natural := 0) is
    begin
      put_words(ticks, flags);
      pulse(commit);
      assert refused = refusal_none severity failure;
      clocks(1);
    end procedure;

    -- The commit that is due is refused for this reason alone.
    type reason_t is (incomplete, queue_full, while_stopped, disabled);
    procedure expect_refusal(reason : reason_t) is
      variable expected : refusal_t := refusal_none;
    begin
      case reason is
        when incomplete => expected.incomplete := '1';
        when queue_full => expected.queue_full := '1';
        when while_stopped => expected.while_stopped := '1';
        when disabled => expected.disabled := '1';
      end case;
      pulse(commit);
      assert refused = expected report "a commit is not refused as " & reason_t'image(reason)
        severity failure;
      clocks(1);
    end procedure;

    procedure expect_stop(cause : stop_cause_t) is
    begin
      clocks(3);
      assert stopped = '1' and moving = '0' and level = 0 and braking = '0' severity failure;
      assert stop_cause = cause severity failure;
      acknowledge;
    end procedure;

    procedure wait_until_idle is
    begin
      wait until rising_edge(clk) and idle = '1' for 1 ms;
      assert idle = '1' severity failure;
    end procedure;

    type integers_t is array (natural range <>) of integer;
    variable expected : integers_t(axes - 1 downto 0) := (others => 0);
    variable expected_pulses : naturals_t(axes - 1 downto 0) := (others => 0);
    variable line_ticks : natural;
    variable steps : natural;
    variable backward : natural;
    variable starts : natural;
    variable pulses_at_stop : naturals_t(axes - 1 downto 0);
    variable expected_time : natural;
    variable expected_positions : position_array_t(axes - 1 downto 0);
    variable segments_before : count_t;
  begin
    random.seed(3, 5);
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';

    for line in 1 to 60 loop
      wait_for_space;
      line_ticks := random.between(1, 20);
      backward := random.between(0, 7);
      -- Some axes ahead, some behind.
      starts := 0;
      for axis in 0 to axes - 1 loop
        case random.between(0, 2) is
          when 1 => starts := starts + 2 ** (24 + axis);
          when 2 => starts := starts + 2 ** (28 + axis);
          when others => null;
        end case;
      end loop;
      put(flags_lane, starts + backward);
      put(line_ticks_lane, line_ticks);
      for axis in 0 to axes - 1 loop
        steps := random.between(0, line_ticks);
        put(steps_lane + axis, steps);
        expected_pulses(axis) := expected_pulses(axis) + steps;
        if (backward / 2 ** axis) mod 2 = 1 then
          expected(axis) := expected(axis) - steps;
        else
          expected(axis) := expected(axis) + steps;
        end if;
      end loop;
      put_course(line_ticks, 2 ** random.between(26, 30));
    end loop;
    wait_until_idle;
    for axis in 0 to axes - 1 loop
      assert positions(axis) = expected(axis) report "axis " & to_string(axis) severity failure;
      assert pulses(axis) = expected_pulses(axis) severity failure;
    end loop;
    assert segments = 60 and max_level >= 2 severity failure;
    assert axis_stalls(2) > 0 and stalls >= axis_stalls(2) severity failure;
    assert axis_stalls(0) = 0 report "the fast axis was late" severity failure;

    -- Positions are set at rest, and refused in motion.
    new_position <= to_signed(-77, 32);
    set_position <= "010";
    wait for 1 ns;
    assert position_refused = '0' severity failure;
    wait until rising_edge(clk);
    set_position <= "000";
    new_position <= to_signed(12345, 32);
    put(flags_lane, 16#40000#);
    put(line_ticks_lane, 1000);
    for axis in 0 to axes - 1 loop
      put(steps_lane + axis, 1000);
    end loop;
    put_course(600, 2 ** 24);
    put(flags_lane, 16#40000# + continues_line);
    put_course(400, 2 ** 24);
    wait until rising_edge(clk) and moving = '1';
    set_position <= "010";
    wait for 1 ns;
    assert position_refused = '1' severity failure;
    wait until rising_edge(clk);
    set_position <= "000";

    -- A hold comes along its ramp of 256 clocks, and nothing moves until it is over.
    wait until rising_edge(step(0));
    assert positions(1) = -76 severity failure;
    clocks(300);
    override <= to_unsigned(0, 18);
    clocks(250);
    assert held = '0' and moving = '1' severity failure;
    clocks(12);
    assert held = '1' and moving = '1' and scale = 0 severity failure;
    pulses_at_stop := pulses;
    clocks(2000);
    assert pulses = pulses_at_stop severity failure;
    override <= to_unsigned(2 * 65536, 18);
    clocks(520);
    assert held = '0' and scale = 2 * scale_of_one severity failure;

    -- The end stop hits: no step from its clock on.
    clocks(1000);
    wait until falling_edge(clk);
    end_stops <= x"04";
    pulses_at_stop := pulses;
    clocks(1000);
    assert stopped = '1' and moving = '0' and level = 0 severity failure;
    assert stop_cause.end_stops = x"04" severity failure;
    assert stop_positions = positions severity failure;
    assert stop_time = clocks_run - 999
      report "the stop is of clock " & to_string(to_integer(stop_time)) & ", now " &
        to_string(clocks_run) severity failure;
    for axis in 0 to axes - 1 loop
      assert pulses(axis) <= pulses_at_stop(axis) + 1 severity failure;
    end loop;

    -- The brake: positions of the hit are latched, motion goes on along the ramp, then it is a stop.
    override <= to_unsigned(65536, 18);
    end_stops <= x"00";
    acknowledge_stop <= '1';
    clocks(1);
    acknowledge_stop <= '0';
    put(flags_lane, 16#40000# + stop_brakes + waits_for_start);
    put(line_ticks_lane, 5000);
    for axis in 0 to axes - 1 loop
      put(steps_lane + axis, 5000 - axis);
    end loop;
    put_course(5000, 2 ** 24);
    clocks(10);
    assert waiting = '1' and moving = '0' severity failure;
    start <= '1';
    clocks(3);
    assert waiting = '0' and moving = '1' severity failure;
    clocks(2000);
    end_stops <= x"04";
    clocks(2);
    assert braking = '1' and stopped = '0' severity failure;
    assert stop_positions = positions severity failure;
    -- 2048 clocks at half of 2^-8 ticks per clock on average: 4 ticks.
    pulses_at_stop := pulses;
    clocks(2052);
    assert stopped = '1' and moving = '0' and level = 0 and idle = '1' severity failure;
    assert pulses(0) - pulses_at_stop(0) = 4
      report to_string(pulses(0) - pulses_at_stop(0)) & " steps along the ramp" severity failure;
    assert positions(0) - stop_positions(0) = 4 severity failure;
    end_stops <= x"00";
    acknowledge;

    -- Without `run` nothing starts; a segment that waits starts at software's word, too.
    run <= '0';
    put_line(20);
    clocks(50);
    assert moving = '0' and level = 1 and idle = '0' severity failure;
    run <= '1';
    wait_until_idle;
    put_line(20, waits_for_start);
    clocks(50);
    assert waiting = '1' and moving = '0' severity failure;
    pulse(software_start);
    clocks(3);
    assert waiting = '0' and moving = '1' severity failure;
    wait_until_idle;

    -- A start that stays high starts once.
    start <= '0';
    clocks(2);
    start <= '1';
    clocks(3);
    put_line(20, waits_for_start);
    clocks(50);
    assert waiting = '1' and moving = '0' severity failure;

    -- A flush leaves nothing: neither what is queued nor what is half written.
    put_line(20);
    assert level = 2 severity failure;
    put(flags_lane, 0);
    put(line_ticks_lane, 20);
    pulse(flush);
    clocks(1);
    assert level = 0 and waiting = '0' and idle = '1' and moving = '0' severity failure;
    put_steps(20);
    expect_refusal(incomplete);
    put_line(20);
    assert level = 1 or moving = '1' report "nothing is accepted after a flush" severity failure;
    wait_until_idle;

    -- No line for an axis without its driver.
    enabled <= "101";
    put_words(20);
    expect_refusal(disabled);
    enabled <= "111";

    -- A full queue takes no more, and as soon as it has room it does.
    run <= '0';
    for i in 1 to depth loop
      put_line(20);
    end loop;
    assert level = depth severity failure;
    put_words(20);
    expect_refusal(queue_full);
    run <= '1';
    wait until rising_edge(clk) and level < depth;
    clocks(2);
    put_line(20);
    wait_until_idle;
    assert max_level = depth severity failure;

    -- A snapshot takes positions and time of its clock; what stopped before stays as it was.
    put_line(100);
    clocks(150);
    for i in 1 to 3 loop
      -- One in each half of a step.
      clocks(37);
      wait until falling_edge(clk);
      expected_time := clocks_run;
      expected_positions := positions;
      snapshot <= '1';
      clocks(1);
      snapshot <= '0';
      clocks(20);
      assert snapshot_time = expected_time report "the snapshot is of clock " &
        to_string(to_integer(snapshot_time)) & " instead of " & to_string(expected_time) severity failure;
      assert snapshot_positions = expected_positions severity failure;
    end loop;

    -- The watchdog: fed it lets motion be, then it ends it.
    watchdog_limit <= 100;
    pulse(feed_watchdog);
    for i in 1 to 4 loop
      clocks(80);
      pulse(feed_watchdog);
    end loop;
    assert moving = '1' and stopped = '0' severity failure;
    clocks(90);
    assert stopped = '0' severity failure;
    clocks(15);
    watchdog_limit <= 0;
    expect_stop((end_stops => x"00", watchdog => '1', others => '0'));

    -- The emergency input, and software.
    put_line(100);
    clocks(100);
    pulse(emergency_stop);
    expect_stop((end_stops => x"00", emergency_input => '1', others => '0'));
    put_line(100);
    clocks(100);
    pulse(software_stop);
    expect_stop((end_stops => x"00", software => '1', others => '0'));
    put_line(100);
    clocks(100);
    pulse(software_brake);
    clocks(1);
    assert braking = '1' and stopped = '0' and moving = '1' severity failure;
    put_words(20);
    expect_refusal(while_stopped);
    clocks(2100);
    expect_stop((end_stops => x"00", software_brake => '1', others => '0'));

    -- A stop comes while the bus rests, with a segment half written: the rest of it is not taken for a
    -- segment, and the next one is taken. Twice, for what counts modulo 2.
    for i in 1 to 2 loop
      put(flags_lane, 0);
      put(line_ticks_lane, 20);
      clocks(2);
      bus_rests <= true;
      clocks(5);
      pulse(emergency_stop);
      clocks(5);
      bus_rests <= false;
      clocks(1);
      acknowledge;
      put_steps(20);
      expect_refusal(incomplete);
      segments_before := segments;
      put_line(20);
      wait_until_idle;
      assert segments = segments_before + 1 severity failure;
    end loop;
    for axis in 0 to axes - 1 loop
      assert stop_positions(axis) /= positions(axis) severity failure;
    end loop;

    finish;
  end process;

end architecture;
