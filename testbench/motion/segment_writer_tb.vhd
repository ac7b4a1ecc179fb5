-- SPDX-License-Identifier: Apache-2.0
-- Whole and executable segments pass, all others are refused with their reason.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.random_source_pkg.all;
use work.step_generator_pkg.all;

entity segment_writer_tb is
end entity;

architecture simulation of segment_writer_tb is

  constant axes : positive := 2;
  constant continues_line : natural := 2 ** continues_line_bit;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal write : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  signal commit : std_ulogic := '0';
  signal flush : std_ulogic := '0';
  signal queue_full : std_ulogic := '0';
  signal stopped : std_ulogic := '0';
  signal enabled : std_ulogic_vector(axes - 1 downto 0) := (others => '1');
  signal accepted : std_ulogic;
  signal refused : refusal_t;

begin

  clk <= not clk after 10 ns;

  writer : entity work.segment_writer
    generic map (axes => axes)
    port map (
      clk => clk, reset => reset, write => write, commit => commit, flush => flush,
      queue_full => queue_full, stopped => stopped, enabled => enabled, accepted => accepted,
      refused => refused);

  test : process
    procedure put(lane : lane_t; data : std_ulogic_vector(31 downto 0)) is
    begin
      write <= (valid => '1', lane => lane, data => data);
      wait until rising_edge(clk);
      write.valid <= '0';
    end procedure;

    procedure put(lane : lane_t; data : natural) is
    begin
      put(lane, std_ulogic_vector(to_unsigned(data, 32)));
    end procedure;

    procedure put_course is
    begin
      for lane in rate_low_lane to jerk_high_lane loop
        put(lane, 7);
      end loop;
    end procedure;

    procedure put_line(line_ticks, ticks, x_steps, y_steps : natural;
      flags : std_ulogic_vector(31 downto 0) := x"00000000") is
    begin
      put(flags_lane, flags);
      put(line_ticks_lane, line_ticks);
      put(steps_lane, x_steps);
      put(steps_lane + 1, y_steps);
      put(ticks_lane, ticks);
      put_course;
    end procedure;

    procedure put_continuation(ticks : natural) is
    begin
      put(flags_lane, continues_line);
      put(ticks_lane, ticks);
      put_course;
    end procedure;

    procedure expect(name : string; acceptance : std_ulogic; reason : refusal_t := refusal_none) is
    begin
      wait until rising_edge(clk);
      commit <= '1';
      wait for 1 ns;
      assert accepted = acceptance and refused = reason
        report name & ", incomplete " & to_string(refused.incomplete) & ", illegal " &
          to_string(refused.illegal) severity failure;
      wait until rising_edge(clk);
      commit <= '0';
      wait for 1 ns;
    end procedure;

    -- Any words, some left out, some of a segment or line that is given up for another: what counts is
    -- what was written since the flags, and of a line since its number of ticks.
    procedure write_anything is
      type some_words_t is array (0 to 5) of natural;
      constant tick_numbers : some_words_t := (0, 1, 4, 5, 6, 1000);
      variable random : random_source_t;
      variable left_of_line : natural := 0;
      variable flags : std_ulogic_vector(31 downto 0);
      variable of_line, ticks, x_steps, y_steps, limit, first : natural;
      variable too_many, continues, is_half, is_above, is_whole, is_legal : boolean;
      variable left_out : lane_t;
      -- What happens to one of the words: 1 lost in a full queue, 2 flushed, 3 reset.
      variable mishap, mishap_word : natural;
      variable rest_of_rate : natural;
      variable lane : natural;

      function is_above_bit(yes : boolean) return std_ulogic is
      begin
        if yes then
          return '1';
        end if;
        return '0';
      end function;

      impure function any_number return natural is
      begin
        return tick_numbers(random.between(0, 5));
      end function;
    begin
      for segment in 1 to 6000 loop
        if random.between(0, 3) = 0 then
          for word in 1 to random.between(1, 6) loop
            put(random.between(0, steps_lane + axes - 1), any_number);
          end loop;
        end if;
        continues := random.between(0, 2) = 0;
        flags := (others => '0');
        flags(24 + random.between(0, 3)) := '1';
        flags(28 + random.between(0, 3)) := '1';
        if continues then
          flags(continues_line_bit) := '1';
        end if;
        put(flags_lane, flags);
        is_legal := continues or (flags(27 downto 24) and flags(31 downto 28)) = x"0";
        of_line := any_number;
        too_many := random.between(0, 9) = 0;
        limit := left_of_line when continues else of_line;
        -- One that any number of ticks is within, most of the time.
        ticks := any_number when random.between(0, 2) = 0 else random.between(0, minimum(limit, 1000));
        x_steps := random.between(0, of_line + 1);
        y_steps := random.between(0, of_line + 1) when random.between(0, 5) = 0 else of_line;
        is_half := random.between(0, 2) = 0;
        is_above := random.between(0, 5) = 0;
        mishap := maximum(0, random.between(0, 15) - 12);
        mishap_word := random.between(0, steps_lane + axes - ticks_lane - 1);
        rest_of_rate := random.between(0, 1) * random.between(0, 1);
        left_out := flags_lane;
        if random.between(0, 3) = 0 then
          left_out := random.between(1, steps_lane + axes - 1);
        end if;
        is_whole := left_out = flags_lane or
          (continues and (left_out = line_ticks_lane or left_out >= steps_lane));

        -- Before the first line_ticks no number of ticks or steps means anything.
        if not continues and left_out /= line_ticks_lane and random.between(0, 2) = 0 then
          for word in 1 to random.between(1, 4) loop
            lane := random.between(ticks_lane, steps_lane + axes - 1);
            if lane = ticks_lane or lane >= steps_lane then
              put(lane, any_number * 1000);
            end if;
          end loop;
        end if;

        -- A line that is given up: its ticks and steps are not those of the next, if they are legal.
        if not continues and left_out /= line_ticks_lane and random.between(0, 2) = 0 then
          put(line_ticks_lane, 7);
          put(ticks_lane, 7);
          put(steps_lane, 7);
          put(steps_lane + 1, 7);
        end if;
        if not continues and left_out = line_ticks_lane then
          put(flags_lane, flags);
          put(steps_lane, 2000000);
          put(ticks_lane, 2000000);
          is_legal := true;
        end if;
        if left_out /= line_ticks_lane then
          if too_many then
            put(line_ticks_lane, std_ulogic_vector(to_unsigned(of_line, 32)) or x"80000000");
            is_legal := is_legal and continues;
          else
            put(line_ticks_lane, of_line);
          end if;
        end if;
        -- The others in any order.
        first := random.between(0, steps_lane + axes - ticks_lane - 1);
        for i in 0 to steps_lane + axes - ticks_lane - 1 loop
          lane := ticks_lane + (first + i) mod (steps_lane + axes - ticks_lane);
          if i = mishap_word and lane /= left_out then
            queue_full <= '1' when mishap = 1 else '0';
            flush <= '1' when mishap = 2 else '0';
            reset <= '1' when mishap = 3 else '0';
          end if;
          if lane = left_out and lane >= steps_lane then
            -- An axis that is not there.
            put(steps_lane + axes + random.between(0, 2), 0);
          elsif lane /= left_out then
            case lane is
              when ticks_lane => put(lane, ticks);
              when steps_lane => put(lane, x_steps);
              when steps_lane + 1 => put(lane, y_steps);
              when rate_low_lane => put(lane, rest_of_rate);
              when rate_high_lane =>
                if is_half then
                  put(lane, x"8000000" & ("000" & is_above_bit(is_above)));
                else
                  put(lane, x"7FFFFFFF");
                end if;
              when others => put(lane, random.between(0, 1000000));
            end case;
            if i = mishap_word and mishap /= 0 then
              is_whole := is_whole and mishap = 1 and continues and lane >= steps_lane;
              if mishap /= 1 then
                left_of_line := 0;
              end if;
            end if;
          end if;
          queue_full <= '0';
          flush <= '0';
          reset <= '0';
        end loop;

        is_legal := is_legal and ticks /= 0 and ticks <= limit and
          not (is_half and (is_above or rest_of_rate /= 0));
        if not continues then
          is_legal := is_legal and of_line /= 0 and x_steps <= of_line and y_steps <= of_line;
        end if;
        if not is_whole then
          expect("any segment with a word left out", '0', (incomplete => '1', others => '0'));
        elsif not is_legal then
          expect("any segment that cannot be executed", '0', (illegal => '1', others => '0'));
        else
          expect("any segment", '1');
          left_of_line := limit - ticks;
        end if;
        if random.between(0, 20) = 0 then
          flush <= '1';
          wait until rising_edge(clk);
          flush <= '0';
          left_of_line := 0;
        end if;
      end loop;
    end procedure;

    variable both : std_ulogic_vector(31 downto 0);
    constant full : refusal_t := (queue_full => '1', others => '0');
    constant incomplete : refusal_t := (incomplete => '1', others => '0');
    constant illegal : refusal_t := (illegal => '1', others => '0');
    constant disabled : refusal_t := (disabled => '1', others => '0');
    constant while_stopped : refusal_t := (while_stopped => '1', others => '0');
  begin
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);

    expect("nothing written", '0', incomplete);
    put_line(10, 10, 10, 3);
    expect("a whole line", '1');
    expect("the same again", '0', incomplete);

    -- Every single word is needed.
    for missing in 0 to steps_lane + axes - 1 loop
      put(flags_lane, 0);
      if missing /= line_ticks_lane then
        put(line_ticks_lane, 5);
      end if;
      for lane in ticks_lane to steps_lane + axes - 1 loop
        if lane /= missing then
          put(lane, 5);
        end if;
      end loop;
      if missing = flags_lane then
        expect("only forgotten by later flags", '1');
      else
        expect("word " & to_string(missing) & " is missing", '0', incomplete);
      end if;
    end loop;
    put(line_ticks_lane, 5);
    for lane in ticks_lane to steps_lane + axes - 1 loop
      put(lane, 5);
    end loop;
    expect("no flags", '0', incomplete);

    -- Ranges.
    put_line(10, 0, 1, 1);
    expect("no ticks", '0', illegal);
    put_line(10, 11, 1, 1);
    expect("more ticks than the line has", '0', illegal);
    put_line(10, 10, 11, 1);
    expect("more x steps than ticks", '0', illegal);
    put_line(10, 10, 1, 11);
    expect("more y steps than ticks", '0', illegal);
    put_line(0, 0, 0, 0);
    expect("a line of no ticks", '0', illegal);
    put_line(10, 10, 1, 1);
    put(line_ticks_lane, x"80000000");
    put(ticks_lane, 1);
    put(steps_lane, 1);
    put(steps_lane + 1, 1);
    expect("a line of 2^31 ticks", '0', illegal);
    put_line(10, 10, 1, 1);
    put(rate_high_lane, x"80000001");
    expect("a rate above 1/2", '0', illegal);
    put_line(10, 10, 1, 1);
    put(rate_high_lane, x"80000000");
    put(rate_low_lane, 1);
    expect("a rate just above 1/2", '0', illegal);
    put_line(10, 10, 1, 1);
    put(rate_high_lane, x"80000000");
    put(rate_low_lane, 0);
    expect("a rate of 1/2", '1');

    -- What was out of its range stays so until the next flags, whatever is written over it.
    for lane in ticks_lane to steps_lane + axes - 1 loop
      if lane = ticks_lane or lane = rate_high_lane or lane >= steps_lane then
        put(flags_lane, 0);
        put(line_ticks_lane, 10);
        put(lane, x"80000001");
        put(line_ticks_lane, 10);
        put(ticks_lane, 10);
        put_course;
        put(steps_lane, 1);
        put(steps_lane + 1, 1);
        expect("written over word " & to_string(lane) & " out of its range", '0', illegal);
      end if;
    end loop;
    put_line(10, 10, 1, 1);
    expect("after other flags", '1');
    -- Ticks and steps from before line_ticks do not count.
    put(flags_lane, 0);
    put(ticks_lane, 1);
    put(steps_lane, 1);
    put(steps_lane + 1, 1);
    put(line_ticks_lane, 10);
    put_course;
    expect("ticks and steps before line_ticks", '0', incomplete);

    -- No axis is ahead and behind.
    for axis in 0 to 3 loop
      both := (others => '0');
      both(24 + axis) := '1';
      both(28 + axis) := '1';
      put_line(10, 4, 1, 1, both);
      expect("axis " & to_string(axis) & " both ahead and behind", '0', illegal);
    end loop;
    put_line(10, 4, 1, 1, x"A5000000");
    expect("some axes ahead, the others behind", '1');

    -- A line is continued to its end and no further.
    put_line(10, 4, 10, 10);
    expect("first part", '1');
    put_continuation(7);
    expect("more than is left", '0', illegal);
    put(flags_lane, x"FF000000" or std_ulogic_vector(to_unsigned(continues_line, 32)));
    put(ticks_lane, 5);
    put_course;
    expect("second part, where ahead and behind mean nothing", '1');
    put_continuation(1);
    expect("last part", '1');
    put_continuation(1);
    expect("beyond the end", '0', illegal);

    -- No steps without a driver, also where a line goes on.
    enabled <= "10";
    put_line(10, 4, 1, 10);
    expect("steps without a driver", '0', disabled);
    put_line(10, 4, 0, 10);
    expect("steps of the other axis", '1');
    enabled <= "01";
    put_continuation(2);
    expect("the line's driver is off", '0', disabled);
    enabled <= "10";
    put_line(10, 4, 10, 0);
    expect("another line without its driver", '0', disabled);
    put_continuation(2);
    expect("which leaves the line before as it was", '1');
    enabled <= "11";

    -- What happens around a segment.
    put_line(10, 4, 10, 10);
    stopped <= '1';
    expect("stopped", '0', while_stopped);
    stopped <= '0';
    put_line(10, 4, 10, 10);
    queue_full <= '1';
    expect("full", '0', full);
    put_line(10, 4, 10, 10);
    queue_full <= '0';
    expect("written while full", '0', incomplete);
    put_line(10, 4, 10, 10);
    expect("first part again", '1');
    flush <= '1';
    wait until rising_edge(clk);
    flush <= '0';
    put_continuation(1);
    expect("the line was flushed", '0', illegal);
    -- A word of the same clock is forgotten, too.
    for with_reset in boolean loop
      flush <= '0' when with_reset else '1';
      reset <= '1' when with_reset else '0';
      put(flags_lane, 0);
      flush <= '0';
      reset <= '0';
      put(line_ticks_lane, 10);
      put(ticks_lane, 10);
      put(steps_lane, 1);
      put(steps_lane + 1, 1);
      put_course;
      expect("flags of the clock of a flush", '0', incomplete);
    end loop;

    write_anything;

    finish;
  end process;

end architecture;
