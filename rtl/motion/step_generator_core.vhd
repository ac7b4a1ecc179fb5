-- SPDX-License-Identifier: Apache-2.0
-- The step generator without its registers: queue, time base, axes and stops, wired together.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity step_generator_core is
  generic (
    axes : positive range 1 to axis_limit := 5;
    queue_depth : positive range 2 to 255 := 32
  );
  port (
    -- May be gated while neither `working` nor `alarm` nor a command is high, from 3 clocks on.
    clk : in std_ulogic;
    -- The same clock for what moves between ticks, never gated.
    always_clk : in std_ulogic;
    -- The same clock for segments being written; may be gated while none is written.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;

    -- Settings, to be changed when idle, edges of a pin that is low.
    guards : in guard_array_t(axes - 1 downto 0);
    both_edges : in std_ulogic_vector(axes - 1 downto 0);
    rate_floor : in unsigned(30 downto 0);
    -- Motor drivers, to be switched off only when nothing moves or is queued, or by the emergency stop.
    enabled : in std_ulogic_vector(axes - 1 downto 0);
    -- Motion may start from rest.
    run : in std_ulogic;
    -- A segment that waits may start: a rising edge of the input, synchronous to clk, or software's word.
    start : in std_ulogic;
    software_start : in std_ulogic;
    waiting : out std_ulogic;

    -- The time of the base, at any moment: in 2^-16, its slope in 2^-32 per clock.
    override : in unsigned(17 downto 0);
    override_slope : in slope_t;
    brake_slope : in slope_t;
    scale : out scale_t;
    -- A segment is being executed, but the time base is stopped.
    held : out std_ulogic;

    -- The segment being written.
    write : in lane_write_t;
    commit : in std_ulogic;
    refused : out refusal_t;
    flush : in std_ulogic;
    level : out natural range 0 to queue_depth;
    max_level : out natural range 0 to queue_depth;

    -- A segment is executed.
    moving : out std_ulogic;
    -- None is, none is queued, every pulse is finished, and all guard times are over.
    idle : out std_ulogic;
    segments : out count_t;
    underruns : out count_t;
    stalls : out count_t;
    axis_stalls : out count_array_t(axes - 1 downto 0);

    -- Synchronous to clk, filtered, 1 = triggered.
    end_stops : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    software_stop : in std_ulogic;
    software_brake : in std_ulogic;
    acknowledge_stop : in std_ulogic;
    -- Clocks of motion without feeding, 0 = no limit.
    watchdog_limit : in unsigned(31 downto 0);
    feed_watchdog : in std_ulogic;
    braking : out std_ulogic;
    stopped : out std_ulogic;
    stop_cause : out stop_cause_t;
    stop_positions : out position_array_t(axes - 1 downto 0);
    stop_time : out time_t := (others => '0');

    positions : out position_array_t(axes - 1 downto 0);
    -- Only when idle, otherwise refused in the same clock.
    set_position : in std_ulogic_vector(axes - 1 downto 0);
    new_position : in position_t;
    position_refused : out std_ulogic;
    snapshot : in std_ulogic;
    snapshot_positions : out position_array_t(axes - 1 downto 0);
    snapshot_time : out time_t := (others => '0');

    step : out std_ulogic_vector(axes - 1 downto 0);
    -- 1 = negative.
    direction : out std_ulogic_vector(axes - 1 downto 0);

    -- For a rest_watch.
    working : out std_ulogic;
    alarm : out std_ulogic
  );
end entity;

architecture rtl of step_generator_core is

  signal now : time_t := (others => '0');
  signal forget, writer_forgets : std_ulogic;
  -- Modulo 2 only.
  signal forgettings, forgettings_seen : std_ulogic := '0';
  signal append, full : std_ulogic;
  -- In the clock before. Only a commit fills the queue, and no write follows in the next clock; so
  -- the writer may use this value, and is gated with bus_clk.
  signal was_full : std_ulogic := '0';

  signal head_valid : std_ulogic;
  signal head : segment_t;
  signal head_steps : ticks_array_t(axes - 1 downto 0);
  signal three_quarters, executed_ticks : ticks_t := (others => '0');
  signal line_ticks : ticks_t;
  signal first_errors : ticks_array_t(axes - 1 downto 0);

  -- The base is active, makes a tick, takes the head, and stalls or not, in this clock.
  signal early_active, early_tick, early_take, due : std_ulogic;
  signal early_stop_on : stop_condition_t;
  -- In the clock before.
  signal executing, late_tick, take, begin_line, was_due : std_ulogic := '0';
  -- Unless an emergency has come between.
  signal tick : std_ulogic;

  signal start_before : std_ulogic := '0';
  signal start_now, advance, stalled, accelerating, decelerating, standing : std_ulogic;
  signal leap, longest_leap : leap_t;

  signal ready, axis_working, allowed_position : std_ulogic_vector(axes - 1 downto 0);
  signal scaling, watching : std_ulogic;

  -- Of the segment being executed: of the base's, before the axes execute anything.
  signal stop_on : stop_condition_t := stop_condition_none;
  signal watchdog_expired, stop, stop_begins, hit, closed : std_ulogic;
  signal was_hit : std_ulogic := '0';
  -- Of the clock before, to keep the slope off the critical path.
  signal no_ramp : std_ulogic := '0';

begin

  forget <= flush or stop_begins;

  -- A stop may come while bus_clk is gated: the writer then discards its words before it is written
  -- to again.
  writer_forgets <= forget or (forgettings xor forgettings_seen);

  count_forgettings : process
  begin
    wait until rising_edge(clk);
    forgettings <= (forgettings xor forget) and not reset;
  end process;

  see_forgettings : process
  begin
    wait until rising_edge(bus_clk);
    forgettings_seen <= (forgettings xor forget) and not reset;
  end process;

  see_fullness : process
  begin
    wait until rising_edge(bus_clk);
    was_full <= full and not reset;
    a_full_queue_is_seen_in_time : assert reset = '1' or (commit or write.valid) = '0' or
      full = '0' or was_full = '1' severity failure;
  end process;

  writer : entity work.segment_writer
    generic map (axes => axes)
    port map (
      clk => bus_clk, reset => reset, write => write, commit => commit, flush => writer_forgets,
      queue_full => was_full, stopped => closed, enabled => enabled, accepted => append, refused => refused);

  queue : entity work.segment_queue
    generic map (axes => axes, depth => queue_depth)
    port map (
      clk => clk, bus_clk => bus_clk, reset => reset, write => write, append => append,
      flush => forget,
      level => level, max_level => max_level, full => full, head_valid => head_valid,
      head => head, head_steps => head_steps, take => take and head_valid);

  pace : entity work.feed_override
    port map (
      clk => clk, reset => reset, moving => early_active, target => override, slope => override_slope,
      accelerating => accelerating, decelerating => decelerating, braking => braking,
      brake_slope => brake_slope, stalled => stalled, longest_leap => longest_leap,
      advance => advance, leap => leap, scale => scale, standing => standing, working => scaling);

  moving <= early_active or executing;
  held <= moving and standing;
  start_now <= software_start or (start and not start_before);

  base : entity work.time_base
    port map (
      clk => clk, always_clk => always_clk, reset => reset, advance => advance, leap => leap,
      longest_leap => longest_leap, run => run, start => start_now, stop => stop, rate_floor => rate_floor,
      head_valid => head_valid, head => head, take => early_take, due => due, axes_ready => and ready,
      tick => early_tick, stalled => stalled, accelerating => accelerating, decelerating => decelerating,
      active => early_active, stop_on => early_stop_on, waiting => waiting, segments => segments,
      underruns => underruns, stalls => stalls);

  -- The base's carry settles late in the clock: queue, axes and stops follow it a clock later.
  follow_base : process
  begin
    wait until rising_edge(clk);
    late_tick <= early_tick and not reset;
    take <= early_take and not reset;
    begin_line <= early_take and not head.continues_line and not reset;
    was_due <= due and not reset;
    executing <= early_active and not stop and not reset;
    was_hit <= hit and not reset;
    -- Without motion it does not count: so it is known here before the head is taken.
    stop_on <= early_stop_on when early_active = '1' else head.stop_on;
  end process;

  tick <= late_tick and not emergency_stop;

  keep_time : process
  begin
    wait until rising_edge(always_clk);
    now <= now + 1;
    if reset then
      now <= (others => '0');
    end if;
  end process;

  keep_line : process
  begin
    wait until rising_edge(clk);
    start_before <= start;
    no_ramp <= '1' when brake_slope = 0 else '0';
    if hit then
      stop_time <= now;
    end if;
    if snapshot then
      snapshot_time <= now;
    end if;
    if begin_line then
      executed_ticks <= line_ticks;
    end if;
    -- The head is there from the clock of the base's take on, at the latest.
    three_quarters <= shift_right(head.line_ticks, 1) + shift_right(head.line_ticks, 2);
  end process;

  line_ticks <= head.line_ticks when begin_line = '1' else executed_ticks;

  idle <= '1' when moving = '0' and level = 0 and (or axis_working) = '0' else '0';
  allowed_position <= set_position when idle = '1' else (others => '0');
  position_refused <= (or set_position) and not idle;

  working <= scaling or (or axis_working);
  alarm <= due or early_take or hit or stop_begins or watching or (start xor start_before);

  each_axis : for axis in 0 to axes - 1 generate
    -- Any start below the line's ticks makes exactly its steps. A quarter of the ticks more or less, and they
    -- come a quarter of a step early or late.
    first_errors(axis) <= three_quarters when head.ahead(axis) = '1' else
                          shift_right(head.line_ticks, 2) when head.behind(axis) = '1' else
                          shift_right(head.line_ticks, 1);

    stepper : entity work.axis_stepper
      port map (
        clk => clk, reset => reset, guard => guards(axis), both_edges => both_edges(axis),
        begin_line => begin_line,
        steps => head_steps(axis), backward => head.backward(axis), first_error => first_errors(axis),
        line_ticks => line_ticks, ready => ready(axis), was_due => was_due,
        tick => tick, step => step(axis), direction => direction(axis),
        busy => open, working => axis_working(axis),
        position => positions(axis), set_position => allowed_position(axis),
        new_position => new_position, stalls => axis_stalls(axis));

    at_stop : entity work.position_latch
      port map (
        clk => clk, capture => was_hit, position => positions(axis),
        captured_position => stop_positions(axis));

    at_snapshot : entity work.position_latch
      port map (
        clk => clk, capture => snapshot, position => positions(axis),
        captured_position => snapshot_positions(axis));

    -- psl default clock is rising_edge(clk);
    -- The tick of the clock before the stop is made.
    -- psl no_step_after_a_stop : assert always
    --   ((stop = '1' and tick = '0' and step(axis) = '0') -> next (step(axis) = '0')) abort reset;
  end generate;

  watch : entity work.motion_watchdog
    port map (
      clk => always_clk, reset => reset, limit => watchdog_limit, moving => moving, feed => feed_watchdog,
      expired => watchdog_expired);

  stops : entity work.stop_latch
    port map (
      clk => clk, reset => reset, active => moving, stop_on => stop_on,
      end_stops => end_stops, emergency_stop => emergency_stop, watchdog_expired => watchdog_expired,
      software_stop => software_stop, software_brake => software_brake, acknowledge => acknowledge_stop,
      -- A base at rest has nothing left to brake.
      standing => standing or not early_active, no_ramp => no_ramp, hit => hit, braking => braking,
      stop => stop, stop_begins => stop_begins, stopped => stopped, closed => closed, cause => stop_cause,
      watching => watching);

end architecture;
