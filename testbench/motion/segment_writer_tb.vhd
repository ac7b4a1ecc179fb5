-- SPDX-License-Identifier: Apache-2.0
-- Whole and executable segments pass, all others are refused with their reason.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.segment_writer_harness_pkg.all;
use work.step_generator_pkg.all;

entity segment_writer_tb is
end entity;

architecture simulation of segment_writer_tb is

  signal clk : std_ulogic;
  signal inputs : segment_writer_inputs_t := segment_writer_in_reset;
  signal outputs : segment_writer_outputs_t;

begin

  writer : entity work.segment_writer_harness
    port map (clk => clk, inputs => inputs, outputs => outputs);

  test : process
    procedure put_line(line_ticks, ticks, x_steps, y_steps : natural;
      flags : std_ulogic_vector(31 downto 0) := x"00000000") is
    begin
      put(clk, inputs, flags_lane, flags);
      put(clk, inputs, line_ticks_lane, line_ticks);
      put(clk, inputs, steps_lane, x_steps);
      put(clk, inputs, steps_lane + 1, y_steps);
      put(clk, inputs, ticks_lane, ticks);
      put_course(clk, inputs);
    end procedure;

    procedure put_continuation(ticks : natural) is
    begin
      put(clk, inputs, flags_lane, continues_line);
      put(clk, inputs, ticks_lane, ticks);
      put_course(clk, inputs);
    end procedure;

    variable both : std_ulogic_vector(31 downto 0);
  begin
    wait until rising_edge(clk);
    inputs.reset <= '0';
    wait until rising_edge(clk);

    expect(clk, inputs, outputs, "nothing written", '0', incomplete);
    put_line(10, 10, 10, 3);
    expect(clk, inputs, outputs, "a whole line", '1');
    expect(clk, inputs, outputs, "the same again", '0', incomplete);

    -- Every single word is needed.
    for missing in 0 to steps_lane + axes - 1 loop
      put(clk, inputs, flags_lane, 0);
      if missing /= line_ticks_lane then
        put(clk, inputs, line_ticks_lane, 5);
      end if;
      for lane in ticks_lane to steps_lane + axes - 1 loop
        if lane /= missing then
          put(clk, inputs, lane, 5);
        end if;
      end loop;
      if missing = flags_lane then
        expect(clk, inputs, outputs, "only forgotten by later flags", '1');
      else
        expect(clk, inputs, outputs, "word " & to_string(missing) & " is missing", '0', incomplete);
      end if;
    end loop;
    put(clk, inputs, line_ticks_lane, 5);
    for lane in ticks_lane to steps_lane + axes - 1 loop
      put(clk, inputs, lane, 5);
    end loop;
    expect(clk, inputs, outputs, "no flags", '0', incomplete);

    -- Ranges.
    put_line(10, 0, 1, 1);
    expect(clk, inputs, outputs, "no ticks", '0', illegal);
    put_line(10, 11, 1, 1);
    expect(clk, inputs, outputs, "more ticks than the line has", '0', illegal);
    put_line(10, 10, 11, 1);
    expect(clk, inputs, outputs, "more x steps than ticks", '0', illegal);
    put_line(10, 10, 1, 11);
    expect(clk, inputs, outputs, "more y steps than ticks", '0', illegal);
    put_line(0, 0, 0, 0);
    expect(clk, inputs, outputs, "a line of no ticks", '0', illegal);
    put_line(10, 10, 1, 1);
    put(clk, inputs, line_ticks_lane, x"80000000");
    put(clk, inputs, ticks_lane, 1);
    put(clk, inputs, steps_lane, 1);
    put(clk, inputs, steps_lane + 1, 1);
    expect(clk, inputs, outputs, "a line of 2^31 ticks", '0', illegal);
    put_line(10, 10, 1, 1);
    put(clk, inputs, rate_high_lane, x"80000001");
    expect(clk, inputs, outputs, "a rate above 1/2", '0', illegal);
    put_line(10, 10, 1, 1);
    put(clk, inputs, rate_high_lane, x"80000000");
    put(clk, inputs, rate_low_lane, 1);
    expect(clk, inputs, outputs, "a rate just above 1/2", '0', illegal);
    put_line(10, 10, 1, 1);
    put(clk, inputs, rate_high_lane, x"80000000");
    put(clk, inputs, rate_low_lane, 0);
    expect(clk, inputs, outputs, "a rate of 1/2", '1');

    -- What was out of its range stays so until the next flags, whatever is written over it.
    for lane in ticks_lane to steps_lane + axes - 1 loop
      if lane = ticks_lane or lane = rate_high_lane or lane >= steps_lane then
        put(clk, inputs, flags_lane, 0);
        put(clk, inputs, line_ticks_lane, 10);
        put(clk, inputs, lane, x"80000001");
        put(clk, inputs, line_ticks_lane, 10);
        put(clk, inputs, ticks_lane, 10);
        put_course(clk, inputs);
        put(clk, inputs, steps_lane, 1);
        put(clk, inputs, steps_lane + 1, 1);
        expect(clk, inputs, outputs, "written over word " & to_string(lane)
          & " out of its range", '0', illegal);
      end if;
    end loop;
    put_line(10, 10, 1, 1);
    expect(clk, inputs, outputs, "after other flags", '1');
    -- Ticks and steps from before line_ticks do not count.
    put(clk, inputs, flags_lane, 0);
    put(clk, inputs, ticks_lane, 1);
    put(clk, inputs, steps_lane, 1);
    put(clk, inputs, steps_lane + 1, 1);
    put(clk, inputs, line_ticks_lane, 10);
    put_course(clk, inputs);
    expect(clk, inputs, outputs, "ticks and steps before line_ticks", '0', incomplete);

    -- No axis is ahead and behind.
    for axis in 0 to 3 loop
      both := (others => '0');
      both(24 + axis) := '1';
      both(28 + axis) := '1';
      put_line(10, 4, 1, 1, both);
      expect(clk, inputs, outputs, "axis " & to_string(axis) & " both ahead and behind", '0', illegal);
    end loop;
    put_line(10, 4, 1, 1, x"A5000000");
    expect(clk, inputs, outputs, "some axes ahead, the others behind", '1');

    -- A line is continued to its end and no further.
    put_line(10, 4, 10, 10);
    expect(clk, inputs, outputs, "first part", '1');
    put_continuation(7);
    expect(clk, inputs, outputs, "more than is left", '0', illegal);
    put(clk, inputs, flags_lane, x"FF000000" or std_ulogic_vector(to_unsigned(continues_line, 32)));
    put(clk, inputs, ticks_lane, 5);
    put_course(clk, inputs);
    expect(clk, inputs, outputs, "second part, where ahead and behind mean nothing", '1');
    put_continuation(1);
    expect(clk, inputs, outputs, "last part", '1');
    put_continuation(1);
    expect(clk, inputs, outputs, "beyond the end", '0', illegal);

    -- No steps without a driver, also where a line goes on.
    inputs.enabled <= "10";
    put_line(10, 4, 1, 10);
    expect(clk, inputs, outputs, "steps without a driver", '0', disabled);
    put_line(10, 4, 0, 10);
    expect(clk, inputs, outputs, "steps of the other axis", '1');
    inputs.enabled <= "01";
    put_continuation(2);
    expect(clk, inputs, outputs, "the line's driver is off", '0', disabled);
    inputs.enabled <= "10";
    put_line(10, 4, 10, 0);
    expect(clk, inputs, outputs, "another line without its driver", '0', disabled);
    put_continuation(2);
    expect(clk, inputs, outputs, "which leaves the line before as it was", '1');
    inputs.enabled <= "11";

    -- What happens around a segment.
    put_line(10, 4, 10, 10);
    inputs.stopped <= '1';
    expect(clk, inputs, outputs, "stopped", '0', while_stopped);
    inputs.stopped <= '0';
    put_line(10, 4, 10, 10);
    inputs.queue_full <= '1';
    expect(clk, inputs, outputs, "full", '0', full);
    put_line(10, 4, 10, 10);
    inputs.queue_full <= '0';
    expect(clk, inputs, outputs, "written while full", '0', incomplete);
    put_line(10, 4, 10, 10);
    expect(clk, inputs, outputs, "first part again", '1');
    inputs.flush <= '1';
    wait until rising_edge(clk);
    inputs.flush <= '0';
    put_continuation(1);
    expect(clk, inputs, outputs, "the line was flushed", '0', illegal);
    -- A word of the same clock is forgotten, too.
    for with_reset in boolean loop
      inputs.flush <= '0' when with_reset else '1';
      inputs.reset <= '1' when with_reset else '0';
      put(clk, inputs, flags_lane, 0);
      inputs.flush <= '0';
      inputs.reset <= '0';
      put(clk, inputs, line_ticks_lane, 10);
      put(clk, inputs, ticks_lane, 10);
      put(clk, inputs, steps_lane, 1);
      put(clk, inputs, steps_lane + 1, 1);
      put_course(clk, inputs);
      expect(clk, inputs, outputs, "flags of the clock of a flush", '0', incomplete);
    end loop;

    finish;
  end process;

end architecture;
