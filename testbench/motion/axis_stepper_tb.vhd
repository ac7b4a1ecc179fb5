-- SPDX-License-Identifier: Apache-2.0
-- The axis shares out ticks exactly, keeps every guard time, and says when it is not ready.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.random_source_pkg.all;
use work.step_generator_pkg.all;

entity axis_stepper_tb is
end entity;

architecture simulation of axis_stepper_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal guard : guard_t := guard_after_reset;
  signal both_edges : std_ulogic := '0';
  signal begin_line : std_ulogic := '0';
  signal steps : ticks_t := (others => '0');
  signal backward : std_ulogic := '0';
  signal ahead : std_ulogic := '0';
  signal behind : std_ulogic := '0';
  signal line_ticks : ticks_t := (others => '0');
  signal due : std_ulogic := '0';
  signal ready : std_ulogic;
  signal tick : std_ulogic;
  signal step : std_ulogic;
  signal direction : std_ulogic;
  signal busy : std_ulogic;
  signal working : std_ulogic;
  signal position : position_t;
  signal set_position : std_ulogic := '0';
  signal new_position : position_t := (others => '0');
  signal stalls : count_t;
  signal pulses : natural;

begin

  clk <= not clk after 10 ns;
  tick <= due and ready;

  axis : entity work.axis_stepper
    port map (
      clk => clk, reset => reset, guard => guard, both_edges => both_edges,
      begin_line => begin_line, steps => steps,
      backward => backward, ahead => ahead, behind => behind, line_ticks => line_ticks, due => due,
      ready => ready, tick => tick, step => step, direction => direction, busy => busy,
      working => working, position => position, set_position => set_position, new_position => new_position,
      stalls => stalls);

  monitor : entity work.pulse_monitor
    port map (
      clk => clk, reset => reset, guard => guard, both_edges => both_edges, step => step,
      direction => direction,
      position => position, set_position => set_position, new_position => new_position,
      pulses => pulses);

  -- Without work, and two clocks after a line or a tick, an edge of the clock changes nothing that is seen.
  watch_work : process
    variable seen, before : std_ulogic_vector(4 downto 0);
    variable quiet_clocks : natural := 0;
    variable had_work : std_ulogic := '1';
  begin
    wait until rising_edge(clk);
    seen := step & direction & ready & busy & working;
    no_change_without_work : assert had_work = '1' or quiet_clocks < 2 or seen = before
      report "changes without work" severity failure;
    before := seen;
    had_work := working;
    quiet_clocks := 0 when (begin_line or tick or reset) = '1' else quiet_clocks + 1;
    if busy then
      a_pulse_is_work : assert working = '1' severity failure;
    end if;
    if quiet_clocks > 30 and guard.direction_setup < 10 and guard.high < 10 then
      work_has_an_end : assert working = '0' report "works for ever" severity failure;
    end if;
  end process;

  test : process
    variable random : random_source_t;

    procedure clocks(count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure start_line(count, of_ticks : natural; negative : std_ulogic;
      early, late : std_ulogic := '0') is
    begin
      steps <= to_unsigned(count, 31);
      backward <= negative;
      ahead <= early;
      behind <= late;
      begin_line <= '1';
      wait until rising_edge(clk);
      line_ticks <= to_unsigned(of_ticks, 31);
      begin_line <= '0';
      ahead <= late;
      behind <= early;
      wait until rising_edge(clk);
    end procedure;

    -- A tick as soon as the axis is ready, and the clock after it.
    procedure make_tick is
    begin
      due <= '1';
      wait until rising_edge(clk) and ready = '1';
      due <= '0';
      wait until rising_edge(clk);
    end procedure;

    procedure set_guard(high, low, setup, hold : natural; falling_too : std_ulogic := '0') is
    begin
      clocks(20);
      guard <= (
        high => to_unsigned(high, 12), low => to_unsigned(low, 12),
        direction_setup => to_unsigned(setup, 12), direction_hold => to_unsigned(hold, 12));
      both_edges <= falling_too;
    end procedure;

    variable pulses_before : natural;
    variable position_before : position_t;
    variable stalls_before : count_t;
    variable falling_too : std_ulogic;
    variable count : natural;
    variable of_ticks : natural;
    variable negative : std_ulogic;
    variable start : natural;
    variable made : natural;
  begin
    clocks(2);
    reset <= '0';

    -- Every tick a step, every second clock, at the shortest guard; also where the direction changes.
    set_guard(1, 1, 1, 1);
    for line in 1 to 4 loop
      start_line(5, 5, not direction);
      for i in 1 to 5 loop
        make_tick;
      end loop;
    end loop;
    clocks(1);
    assert pulses = 20 report "20 ticks made " & to_string(pulses) & " pulses" severity failure;
    assert stalls = 0 report "the shortest guard delayed the base" severity failure;
    assert position = 0 report "forth and back do not cancel" severity failure;

    -- Zero clocks count as one.
    set_guard(0, 0, 0, 0);
    start_line(3, 3, '1');
    for i in 1 to 3 loop
      make_tick;
    end loop;
    clocks(1);
    assert position = -3 severity failure;
    assert stalls = 0 severity failure;

    -- The guard delays, by the clocks that are missing.
    set_guard(4, 5, 6, 7);
    clocks(20);
    start_line(2, 2, '1');
    stalls_before := stalls;
    make_tick;
    make_tick;
    clocks(1);
    assert stalls = stalls_before + 4 + 5 - 2
      report "the second tick was delayed by " & to_string(to_integer(stalls - stalls_before))
      severity failure;

    -- A tick without a step is not delayed, whatever the guard still forbids.
    set_guard(20, 20, 20, 20);
    clocks(60);
    start_line(1, 3, direction);
    stalls_before := stalls;
    pulses_before := pulses;
    for i in 1 to 3 loop
      make_tick;
    end loop;
    assert stalls = stalls_before and pulses = pulses_before + 1
      report "a tick without a step was delayed" severity failure;
    clocks(60);

    -- Busy for the pulse and the pause after it: another could rise in the clock in which this has ended.
    for high in 1 to 4 loop
      for low in 1 to 4 loop
        for falling_counts in 0 to 1 loop
          set_guard(high, low, 9, 9);
          both_edges <= '1' when falling_counts = 1 else '0';
          clocks(1);
          made := 0;
          for toggles in 0 to falling_counts loop
            start_line(1, 1, direction);
            make_tick;
            while busy = '1' loop
              made := made + 1;
              clocks(1);
            end loop;
          end loop;
          count := high + low - 1 - falling_counts;
          assert made = count
            report "busy for " & to_string(made) & " clocks instead of " & to_string(count)
            severity failure;
          clocks(20);
        end loop;
      end loop;
    end loop;

    -- A direction that turns back in time is not turned at all.
    clocks(20);
    assert direction = '1' severity failure;
    start_line(0, 2, '0');
    clocks(20);
    assert direction = '1' report "an axis without steps has turned" severity failure;

    -- With both edges every tick toggles the pin, which then stays, and this is a step.
    set_guard(1, 1, 1, 1, falling_too => '1');
    stalls_before := stalls;
    start_line(7, 7, not direction);
    pulses_before := pulses;
    for i in 1 to 7 loop
      make_tick;
      assert (step = '1') = (i mod 2 = 1) severity failure;
    end loop;
    clocks(50);
    assert step = '1' and busy = '0' severity failure;
    assert pulses = pulses_before + 7 and stalls = stalls_before severity failure;
    set_guard(4, 9, 1, 1, falling_too => '1');
    start_line(3, 3, direction);
    stalls_before := stalls;
    make_tick;
    make_tick;
    assert stalls = stalls_before + 9 - 2 report "low too short" severity failure;
    make_tick;
    assert stalls = stalls_before + 9 - 2 + 4 - 2 report "high too short" severity failure;
    clocks(1);

    -- Any line under any guard: exactly its steps, in its direction, each at its tick, and the monitor
    -- keeps watch.
    for line in 1 to 300 loop
      if line mod 10 = 0 then
        clocks(20);
        -- With a high pin it cannot change to pulses.
        falling_too := '1' when line mod 40 = 0 or step = '1' else '0';
        set_guard(random.between(0, 6), random.between(0, 6), random.between(0, 9), random.between(0, 9),
          falling_too);
      end if;
      of_ticks := random.between(1, 40);
      count := random.between(0, of_ticks);
      negative := '1' when random.between(0, 1) = 1 else '0';
      pulses_before := pulses;
      position_before := position;
      case random.between(0, 2) is
        when 0 =>
          start := of_ticks / 2;
          start_line(count, of_ticks, negative);
        when 1 =>
          start := of_ticks / 2 + of_ticks / 4;
          start_line(count, of_ticks, negative, early => '1', late => '0');
        when others =>
          start := of_ticks / 4;
          start_line(count, of_ticks, negative, early => '0', late => '1');
      end case;
      for i in 1 to of_ticks loop
        clocks(random.between(0, 3));
        make_tick;
        made := to_integer(abs (position - position_before));
        assert made = (i * count + start) / of_ticks
          report to_string(made) & " of " & to_string(count) & " steps after " & to_string(i) &
            " of " & to_string(of_ticks) & " ticks from " & to_string(start)
          severity failure;
      end loop;
      clocks(1);
      assert pulses - pulses_before = count
        report to_string(count) & " steps asked, " & to_string(pulses - pulses_before) & " made"
        severity failure;
      if negative = '1' then
        assert position = position_before - count severity failure;
      else
        assert position = position_before + count severity failure;
      end if;
    end loop;

    clocks(20);
    assert busy = '0' report "still busy long after the last pulse" severity failure;
    new_position <= to_signed(-1000, 32);
    set_position <= '1';
    clocks(1);
    set_position <= '0';
    clocks(1);
    assert position = -1000 severity failure;

    -- A reset ends a pulse, its pause, every guard time and a turn at once, and counts from 0.
    for case_of_reset in 1 to 4 loop
      set_guard(20, 20, 20, 20);
      clocks(30);
      start_line(2, 2, '1');
      make_tick;
      due <= '1';
      case case_of_reset is
        when 1 => clocks(2);
        when 2 => clocks(25);
        when 3 =>
          due <= '0';
          start_line(1, 1, '0');
        when others => clocks(45);
      end case;
      due <= '0';
      reset <= '1';
      wait until rising_edge(clk);
      reset <= '0';
      wait for 1 ns;
      assert step = '0' and direction = '0' and busy = '0' and working = '0' and ready = '1'
        report "not at rest after reset " & to_string(case_of_reset) severity failure;
      assert position = 0 and stalls = 0
        report "counts after reset " & to_string(case_of_reset) severity failure;
      start_line(1, 1, '0');
      make_tick;
      assert stalls = 0 and position = 1
        report "a guard time outlasts reset " & to_string(case_of_reset) severity failure;
      clocks(50);
    end loop;

    finish;
  end process;

end architecture;
