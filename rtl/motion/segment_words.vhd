-- SPDX-License-Identifier: Apache-2.0
-- Which word of a segment software writes in this clock, and into which lane of the queue it goes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_words is
  generic (
    axes : positive range 1 to axis_limit := 5
  );
  port (
    from_software : in step_generator_from_software_t;
    write : out lane_write_t
  );
end entity;

architecture rtl of segment_words is
begin

  gather_words : process (all)
    procedure put(lane : lane_t; data : std_ulogic_vector(31 downto 0)) is
    begin
      write <= (valid => '1', lane => lane, data => data);
    end procedure;
  begin
    -- Most words share the same data wires: no multiplexer where nothing is written.
    write <= (
      valid => '0', lane => 0, data => std_ulogic_vector(from_software.segment_ticks.ticks));
    if from_software.segment_flags_written then
      put(flags_lane, to_word(from_software.segment_flags));
    end if;
    if from_software.segment_line_ticks_written then
      put(line_ticks_lane, std_ulogic_vector(from_software.segment_line_ticks.ticks));
    end if;
    if from_software.segment_ticks_written then
      put(ticks_lane, std_ulogic_vector(from_software.segment_ticks.ticks));
    end if;
    if from_software.segment_rate_low_written then
      put(rate_low_lane, std_ulogic_vector(from_software.segment_rate_low.rate));
    end if;
    if from_software.segment_rate_high_written then
      put(rate_high_lane, std_ulogic_vector(from_software.segment_rate_high.rate));
    end if;
    if from_software.segment_acceleration_low_written then
      put(acceleration_low_lane, std_ulogic_vector(from_software.segment_acceleration_low.acceleration));
    end if;
    if from_software.segment_acceleration_high_written then
      put(acceleration_high_lane,
        std_ulogic_vector(from_software.segment_acceleration_high.acceleration));
    end if;
    if from_software.segment_jerk_low_written then
      put(jerk_low_lane, std_ulogic_vector(from_software.segment_jerk_low.jerk));
    end if;
    if from_software.segment_jerk_high_written then
      put(jerk_high_lane, std_ulogic_vector(from_software.segment_jerk_high.jerk));
    end if;
    for axis in 0 to axes - 1 loop
      if from_software.segment_steps_written(axis) then
        put(steps_lane + axis, std_ulogic_vector(from_software.segment_steps(axis).steps));
      end if;
    end loop;
  end process;

end architecture;
