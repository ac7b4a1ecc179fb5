-- SPDX-License-Identifier: Apache-2.0
-- Keeps segments in order, one memory per word, and has the next one ready as a whole.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_queue is
  generic (
    axes : positive range 1 to axis_limit := 5;
    -- Segments that fit.
    depth : positive range 2 to 255 := 32
  );
  port (
    clk : in std_ulogic;
    -- The same clock for words written; may be gated while none is written.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;

    -- Words of the segment after the last one; lost while the queue is full.
    write : in lane_write_t;
    -- The segment that was written counts from now on.
    append : in std_ulogic;
    -- Forget all segments.
    flush : in std_ulogic;

    level : out natural range 0 to depth;
    -- The highest that `level` was, up to the clock before.
    max_level : out natural range 0 to depth;
    full : out std_ulogic;

    -- The oldest segment: ready two clocks after its commit, at the earliest in the clock after the `take`
    -- before it.
    head_valid : out std_ulogic := '0';
    head : out segment_t;
    head_steps : out ticks_array_t(axes - 1 downto 0);
    -- Only with head_valid: the segment is consumed.
    take : in std_ulogic
  );
end entity;

architecture rtl of segment_queue is

  type word_array_t is array (natural range <>) of std_ulogic_vector(31 downto 0);
  signal words : word_array_t(steps_lane + axes - 1 downto 0);
  signal flags : step_generator_segment_flags_t;

  subtype slot_t is natural range 0 to depth - 1;
  -- The next segment that becomes the head, and the one being written.
  signal unread : slot_t := 0;
  signal last : slot_t := 0;
  signal count : natural range 0 to depth := 0;
  signal highest_count : natural range 0 to depth := 0;
  signal fetch : std_ulogic;

  function slot_after(slot : slot_t) return slot_t is
  begin
    if slot = depth - 1 then
      return 0;
    end if;
    return slot + 1;
  end function;

begin

  level <= count;
  max_level <= highest_count;
  full <= '1' when count = depth else '0';
  fetch <= '1' when (count > 1 and take = '1') or (count /= 0 and head_valid = '0') else '0';

  lanes : for lane in words'range generate
    signal memory : word_array_t(depth - 1 downto 0) := (others => (others => '0'));
  begin
    write_memory : process
    begin
      wait until rising_edge(bus_clk);
      if write.valid = '1' and write.lane = lane and count /= depth then
        memory(last) <= write.data;
      end if;
    end process;

    read_memory : process
    begin
      wait until rising_edge(clk);
      if fetch then
        words(lane) <= memory(unread);
      end if;
    end process;
  end generate;

  flags <= to_step_generator_segment_flags(words(flags_lane));
  head.backward <= flags.backward;
  head.ahead <= x"0" & flags.ahead;
  head.behind <= x"0" & flags.behind;
  head.continues_line <= flags.continues_line;
  head.ends_motion <= flags.ends_motion;
  head.waits_for_start <= flags.waits_for_start;
  head.stop_on <= (
    mask => flags.stop_mask,
    on_change => flags.stop_on_change,
    on_release => flags.stop_on_release,
    brakes => flags.stop_brakes);
  head.line_ticks <= unsigned(words(line_ticks_lane)(30 downto 0));
  head.ticks <= unsigned(words(ticks_lane)(30 downto 0));
  head.rate <= unsigned(words(rate_high_lane)) & unsigned(words(rate_low_lane));
  head.acceleration <=
    signed(words(acceleration_high_lane)) & signed(words(acceleration_low_lane));
  head.jerk <= signed(words(jerk_high_lane)) & signed(words(jerk_low_lane));
  steps : for axis in head_steps'range generate
    head_steps(axis) <= unsigned(words(steps_lane + axis)(30 downto 0));
  end generate;

  count_segments : process
    variable next_count : natural range 0 to depth;
  begin
    wait until rising_edge(clk);
    next_count := count;
    if append then
      last <= slot_after(last);
      next_count := next_count + 1;
    end if;
    if take then
      next_count := next_count - 1;
      head_valid <= '0';
    end if;
    if fetch then
      unread <= slot_after(unread);
      head_valid <= '1';
    end if;
    count <= next_count;
    -- A clock later: `take` settles late in the clock.
    if count > highest_count then
      highest_count <= count;
    end if;

    if reset or flush then
      unread <= 0;
      last <= 0;
      count <= 0;
      head_valid <= '0';
    end if;
    if reset then
      highest_count <= 0;
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl nothing_is_appended_to_a_full_queue : assert always (append -> count /= depth) abort reset;
  -- psl nothing_is_taken_before_it_is_ready : assert always (take -> head_valid) abort reset;

end architecture;
