-- SPDX-License-Identifier: Apache-2.0
-- Checks the segment that software writes: a commit passes only if it is complete and executable.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_writer is
  generic (
    axes : positive range 1 to axis_limit := 5
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- The words: flags first, line_ticks before ticks and steps, the others in any order. Each may
    -- be written again, and the last value counts; but a write of line_ticks discards ticks and
    -- steps written before it. A word out of its range makes the segment illegal until the next
    -- flags, also where another is written over it. Ticks and steps before the first line_ticks
    -- have no range.
    write : in lane_write_t;
    -- All words are written, the last of them two clocks ago at least: append the segment.
    commit : in std_ulogic;
    -- Discard the words written so far, and the line that a segment could continue.
    flush : in std_ulogic;

    queue_full : in std_ulogic;
    -- A stop or brake begins, goes on, or waits for its acknowledgement.
    stopped : in std_ulogic;
    -- Motor drivers: no axis makes steps without its own.
    enabled : in std_ulogic_vector(axes - 1 downto 0);

    -- In the clock of `commit`.
    accepted : out std_ulogic;
    refused : out refusal_t
  );
end entity;

architecture rtl of segment_writer is

  subtype lane_set_t is std_ulogic_vector(steps_lane + axes - 1 downto 0);
  constant all_lanes : lane_set_t := (others => '1');

  -- What a continued line has already.
  function lanes_of_line return lane_set_t is
    variable lanes : lane_set_t := (others => '0');
  begin
    lanes(line_ticks_lane) := '1';
    lanes(lane_set_t'high downto steps_lane) := (others => '1');
    return lanes;
  end function;

  -- The word of the clock before, which is checked now: the comparison takes a clock of its own. A
  -- bus access takes longer, so software sees no difference.
  signal word : lane_write_t := (valid => '0', lane => 0, data => (others => '0'));
  -- It was written while the queue was full.
  signal word_is_lost : std_ulogic := '0';
  signal written : lane_set_t := (others => '0');
  signal illegal : std_ulogic := '0';
  signal continues_line : std_ulogic := '0';
  -- Upper bound of ticks and steps, once it is known.
  signal limit : ticks_t := (others => '0');
  signal limit_known : std_ulogic := '0';
  signal ticks : ticks_t := (others => '0');
  -- Ticks of the last committed line that no segment has yet.
  signal line_left : ticks_t := (others => '0');
  signal rate_is_half : std_ulogic := '0';
  signal rate_low_is_zero : std_ulogic := '0';

  -- Axes with steps, of the line being written and of the last committed one.
  signal moves, line_moves : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal moving_axes : std_ulogic_vector(axes - 1 downto 0);
  signal driven : std_ulogic;

  signal complete : std_ulogic;
  signal executable : std_ulogic;

begin

  complete <= '1' when written = all_lanes else '0';
  executable <= not illegal and (not rate_is_half or rate_low_is_zero);
  moving_axes <= line_moves when continues_line = '1' else moves;
  driven <= not (or (moving_axes and not enabled));

  judge : process (all)
  begin
    accepted <= '0';
    refused <= refusal_none;
    if commit then
      if stopped then
        refused.while_stopped <= '1';
      elsif queue_full then
        refused.queue_full <= '1';
      elsif not complete then
        refused.incomplete <= '1';
      elsif not executable then
        refused.illegal <= '1';
      elsif not driven then
        refused.disabled <= '1';
      else
        accepted <= '1';
      end if;
    end if;
  end process;

  inspect : process
    variable exceeds_limit : boolean;
    variable is_zero : boolean;
    variable flags : step_generator_segment_flags_t;
  begin
    wait until rising_edge(clk);
    word <= write;
    word_is_lost <= queue_full;

    if word.valid then
      exceeds_limit := unsigned(word.data) > limit;
      is_zero := unsigned(word.data) = 0;
      case word.lane is
        when flags_lane =>
          written <= (others => '0');
          written(flags_lane) <= not word_is_lost;
          flags := to_step_generator_segment_flags(word.data);
          illegal <= not flags.continues_line and (or (flags.ahead and flags.behind));
          continues_line <= flags.continues_line;
          limit_known <= flags.continues_line;
          if flags.continues_line then
            written <= lanes_of_line;
            written(flags_lane) <= not word_is_lost;
            limit <= line_left;
          end if;
        when line_ticks_lane =>
          if not continues_line then
            written(lane_set_t'high downto steps_lane) <= (others => '0');
            written(ticks_lane) <= '0';
            written(line_ticks_lane) <= not word_is_lost;
            limit <= unsigned(word.data(30 downto 0));
            limit_known <= '1';
            if is_zero or word.data(31) = '1' then
              illegal <= '1';
            end if;
          end if;
        when ticks_lane =>
          written(ticks_lane) <= limit_known and not word_is_lost;
          ticks <= unsigned(word.data(30 downto 0));
          if limit_known = '1' and (is_zero or exceeds_limit) then
            illegal <= '1';
          end if;
        when rate_low_lane =>
          written(rate_low_lane) <= not word_is_lost;
          rate_low_is_zero <= '1' when is_zero else '0';
        when rate_high_lane =>
          written(rate_high_lane) <= not word_is_lost;
          rate_is_half <= word.data(31);
          if word.data(31) = '1' and unsigned(word.data(30 downto 0)) /= 0 then
            illegal <= '1';
          end if;
        when acceleration_low_lane to jerk_high_lane =>
          written(word.lane) <= not word_is_lost;
        when others =>
          if not continues_line then
            for axis in 0 to axes - 1 loop
              if word.lane = steps_lane + axis then
                written(steps_lane + axis) <= limit_known and not word_is_lost;
                moves(axis) <= '0' when is_zero else '1';
                if limit_known = '1' and exceeds_limit then
                  illegal <= '1';
                end if;
              end if;
            end loop;
          end if;
      end case;
    end if;

    if commit then
      written <= (others => '0');
      if accepted then
        line_left <= limit - ticks;
        line_moves <= moving_axes;
      end if;
    end if;

    if reset or flush then
      word.valid <= '0';
      written <= (others => '0');
      line_left <= (others => '0');
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl a_commit_finds_its_words_judged : assert always (commit -> not word.valid) abort reset;

end architecture;
