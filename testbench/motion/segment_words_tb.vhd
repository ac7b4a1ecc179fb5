-- SPDX-License-Identifier: Apache-2.0
-- Each register of a segment goes into its own lane, and nothing is written where no register is.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity segment_words_tb is
end entity;

architecture simulation of segment_words_tb is

  constant axes : positive := 5;

  signal from_software : step_generator_from_software_t;
  signal write : lane_write_t;

begin

  words : entity work.segment_words
    generic map (axes => axes)
    port map (from_software => from_software, write => write);

  test : process

    variable software : step_generator_from_software_t;
    variable used : std_ulogic_vector(31 downto 0);

    -- The register file gives the word of the bus to all registers.
    procedure put_on_all(word : std_ulogic_vector(31 downto 0)) is
    begin
      software.segment_flags := to_step_generator_segment_flags(word);
      software.segment_line_ticks.ticks := unsigned(word);
      software.segment_ticks.ticks := unsigned(word);
      software.segment_rate_low.rate := unsigned(word);
      software.segment_rate_high.rate := unsigned(word);
      software.segment_acceleration_low.acceleration := unsigned(word);
      software.segment_acceleration_high.acceleration := unsigned(word);
      software.segment_jerk_low.jerk := unsigned(word);
      software.segment_jerk_high.jerk := unsigned(word);
      for axis in software.segment_steps'range loop
        software.segment_steps(axis).steps := unsigned(word);
      end loop;
    end procedure;

    procedure put_nothing is
    begin
      software.segment_flags_written := '0';
      software.segment_line_ticks_written := '0';
      software.segment_ticks_written := '0';
      software.segment_rate_low_written := '0';
      software.segment_rate_high_written := '0';
      software.segment_acceleration_low_written := '0';
      software.segment_acceleration_high_written := '0';
      software.segment_jerk_low_written := '0';
      software.segment_jerk_high_written := '0';
      software.segment_steps_written := (others => '0');
    end procedure;

    procedure choose(lane : lane_t) is
    begin
      put_nothing;
      case lane is
        when flags_lane => software.segment_flags_written := '1';
        when line_ticks_lane => software.segment_line_ticks_written := '1';
        when ticks_lane => software.segment_ticks_written := '1';
        when rate_low_lane => software.segment_rate_low_written := '1';
        when rate_high_lane => software.segment_rate_high_written := '1';
        when acceleration_low_lane => software.segment_acceleration_low_written := '1';
        when acceleration_high_lane => software.segment_acceleration_high_written := '1';
        when jerk_low_lane => software.segment_jerk_low_written := '1';
        when jerk_high_lane => software.segment_jerk_high_written := '1';
        when others => software.segment_steps_written(lane - steps_lane) := '1';
      end case;
    end procedure;

    type words_t is array (natural range <>) of std_ulogic_vector(31 downto 0);
    constant samples : words_t := (x"1234_5678", x"8765_4321", x"FFFF_FFFF", x"0000_0001");

  begin
    for sample in samples'range loop
      put_on_all(samples(sample));
      put_nothing;
      from_software <= software;
      wait for 1 ns;
      nothing_is_written : assert write.valid = '0' severity failure;
      for lane in lane_t loop
        choose(lane);
        from_software <= software;
        wait for 1 ns;
        -- Of the flags two bits are none.
        used := x"FFFF_FFFF";
        if lane = flags_lane then
          used := to_word(to_step_generator_segment_flags(x"FFFF_FFFF"));
        end if;
        if lane < steps_lane + axes then
          is_written : assert write.valid = '1' and write.lane = lane
            report "lane " & to_string(lane) & " goes to " & to_string(write.lane) severity failure;
          is_the_word : assert write.data = (samples(sample) and used)
            report "lane " & to_string(lane) severity failure;
        else
          an_absent_axis_is_ignored : assert write.valid = '0' severity failure;
        end if;
      end loop;
    end loop;
    finish;
  end process;

end architecture;
