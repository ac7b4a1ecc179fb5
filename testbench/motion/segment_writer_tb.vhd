-- SPDX-License-Identifier: Apache-2.0
-- Whole and executable segments pass, all others are refused with their reason.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

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
  signal accepted : std_ulogic;
  signal refused : refusal_t;

begin

  clk <= not clk after 10 ns;

  writer : entity work.segment_writer
    generic map (axes => axes)
    port map (
      clk => clk, reset => reset, write => write, commit => commit, flush => flush,
      queue_full => queue_full, stopped => stopped, accepted => accepted, refused => refused);

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
      assert accepted = acceptance and refused = reason report name severity failure;
      wait until rising_edge(clk);
      commit <= '0';
      wait for 1 ns;
    end procedure;

    variable both : std_ulogic_vector(31 downto 0);
    constant full : refusal_t := (queue_full => '1', others => '0');
    constant incomplete : refusal_t := (incomplete => '1', others => '0');
    constant illegal : refusal_t := (illegal => '1', others => '0');
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

    finish;
  end process;

end architecture;
