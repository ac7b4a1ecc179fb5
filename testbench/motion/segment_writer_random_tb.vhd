-- SPDX-License-Identifier: Apache-2.0
-- Any words in any order: what passes is whole and executable, what is refused is not.
--
-- Some are left out, some belong to a segment or line that is given up for another: what counts is what
-- was written since the flags, and of a line since its number of ticks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.random_source_pkg.all;
use work.segment_writer_harness_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_writer_random_tb is
end entity;

architecture simulation of segment_writer_random_tb is

  signal clk : std_ulogic;
  signal inputs : segment_writer_inputs_t := segment_writer_in_reset;
  signal outputs : segment_writer_outputs_t;

begin

  writer : entity work.segment_writer_harness
    port map (clk => clk, inputs => inputs, outputs => outputs);

  test : process
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
    wait until rising_edge(clk);
    inputs.reset <= '0';
    wait until rising_edge(clk);

    for segment in 1 to 6000 loop
      if random.between(0, 3) = 0 then
        for word in 1 to random.between(1, 6) loop
          put(clk, inputs, random.between(0, steps_lane + axes - 1), any_number);
        end loop;
      end if;
      continues := random.between(0, 2) = 0;
      flags := (others => '0');
      flags(24 + random.between(0, 3)) := '1';
      flags(28 + random.between(0, 3)) := '1';
      if continues then
        flags(step_generator_segment_flags_continues_line_bit) := '1';
      end if;
      put(clk, inputs, flags_lane, flags);
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
            put(clk, inputs, lane, any_number * 1000);
          end if;
        end loop;
      end if;

      -- A line that is given up: its ticks and steps are not those of the next, if they are legal.
      if not continues and left_out /= line_ticks_lane and random.between(0, 2) = 0 then
        put(clk, inputs, line_ticks_lane, 7);
        put(clk, inputs, ticks_lane, 7);
        put(clk, inputs, steps_lane, 7);
        put(clk, inputs, steps_lane + 1, 7);
      end if;
      if not continues and left_out = line_ticks_lane then
        put(clk, inputs, flags_lane, flags);
        put(clk, inputs, steps_lane, 2000000);
        put(clk, inputs, ticks_lane, 2000000);
        is_legal := true;
      end if;
      if left_out /= line_ticks_lane then
        if too_many then
          put(clk, inputs, line_ticks_lane, std_ulogic_vector(to_unsigned(of_line, 32)) or x"80000000");
          is_legal := is_legal and continues;
        else
          put(clk, inputs, line_ticks_lane, of_line);
        end if;
      end if;
      -- The others in any order.
      first := random.between(0, steps_lane + axes - ticks_lane - 1);
      for i in 0 to steps_lane + axes - ticks_lane - 1 loop
        lane := ticks_lane + (first + i) mod (steps_lane + axes - ticks_lane);
        if i = mishap_word and lane /= left_out then
          inputs.queue_full <= '1' when mishap = 1 else '0';
          inputs.flush <= '1' when mishap = 2 else '0';
          inputs.reset <= '1' when mishap = 3 else '0';
        end if;
        if lane = left_out and lane >= steps_lane then
          -- An axis that is not there.
          put(clk, inputs, steps_lane + axes + random.between(0, 2), 0);
        elsif lane /= left_out then
          case lane is
            when ticks_lane => put(clk, inputs, lane, ticks);
            when steps_lane => put(clk, inputs, lane, x_steps);
            when steps_lane + 1 => put(clk, inputs, lane, y_steps);
            when rate_low_lane => put(clk, inputs, lane, rest_of_rate);
            when rate_high_lane =>
              if is_half then
                put(clk, inputs, lane, x"8000000" & ("000" & is_above_bit(is_above)));
              else
                put(clk, inputs, lane, x"7FFFFFFF");
              end if;
            when others => put(clk, inputs, lane, random.between(0, 1000000));
          end case;
          if i = mishap_word and mishap /= 0 then
            is_whole := is_whole and mishap = 1 and continues and lane >= steps_lane;
            if mishap /= 1 then
              left_of_line := 0;
            end if;
          end if;
        end if;
        inputs.queue_full <= '0';
        inputs.flush <= '0';
        inputs.reset <= '0';
      end loop;

      is_legal := is_legal and ticks /= 0 and ticks <= limit and
        not (is_half and (is_above or rest_of_rate /= 0));
      if not continues then
        is_legal := is_legal and of_line /= 0 and x_steps <= of_line and y_steps <= of_line;
      end if;
      if not is_whole then
        expect(clk, inputs, outputs, "any segment with a word left out", '0', (incomplete => '1',
          others => '0'));
      elsif not is_legal then
        expect(clk, inputs, outputs, "any segment that cannot be executed", '0', (illegal => '1',
          others => '0'));
      else
        expect(clk, inputs, outputs, "any segment", '1');
        left_of_line := limit - ticks;
      end if;
      if random.between(0, 20) = 0 then
        inputs.flush <= '1';
        wait until rising_edge(clk);
        inputs.flush <= '0';
        left_of_line := 0;
      end if;
    end loop;

    finish;
  end process;

end architecture;
