-- SPDX-License-Identifier: Apache-2.0
-- The pins of a segment_writer of two axes as records, and the segments that its benches write.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

package segment_writer_harness_pkg is

  constant axes : positive := 2;
  constant continues_line : natural := 2 ** step_generator_segment_flags_continues_line_bit;

  constant full : refusal_t := (queue_full => '1', others => '0');
  constant incomplete : refusal_t := (incomplete => '1', others => '0');
  constant illegal : refusal_t := (illegal => '1', others => '0');
  constant disabled : refusal_t := (disabled => '1', others => '0');
  constant while_stopped : refusal_t := (while_stopped => '1', others => '0');

  type segment_writer_inputs_t is record
    reset : std_ulogic;
    write : lane_write_t;
    commit : std_ulogic;
    flush : std_ulogic;
    queue_full : std_ulogic;
    stopped : std_ulogic;
    enabled : std_ulogic_vector(axes - 1 downto 0);
  end record;

  constant segment_writer_in_reset : segment_writer_inputs_t := (
    reset => '1', write => (valid => '0', lane => 0, data => (others => '0')),
    enabled => (others => '1'), others => '0');

  type segment_writer_outputs_t is record
    accepted : std_ulogic;
    refused : refusal_t;
  end record;

  procedure put (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    lane : in lane_t; data : in std_ulogic_vector(31 downto 0));

  procedure put (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    lane : in lane_t; data : in natural);

  -- Rate, acceleration and jerk.
  procedure put_course (signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t);

  -- A commit, which must be accepted, or refused for this reason.
  procedure expect (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    signal outputs : in segment_writer_outputs_t; name : in string; acceptance : in std_ulogic;
    reason : in refusal_t := refusal_none);

end package;

package body segment_writer_harness_pkg is

  procedure put (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    lane : in lane_t; data : in std_ulogic_vector(31 downto 0)) is
  begin
    inputs.write <= (valid => '1', lane => lane, data => data);
    wait until rising_edge(clk);
    inputs.write.valid <= '0';
  end procedure;

  procedure put (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    lane : in lane_t; data : in natural) is
  begin
    put(clk, inputs, lane, std_ulogic_vector(to_unsigned(data, 32)));
  end procedure;

  procedure put_course (signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t) is
  begin
    for lane in rate_low_lane to jerk_high_lane loop
      put(clk, inputs, lane, 7);
    end loop;
  end procedure;

  procedure expect (
    signal clk : in std_ulogic; signal inputs : inout segment_writer_inputs_t;
    signal outputs : in segment_writer_outputs_t; name : in string; acceptance : in std_ulogic;
    reason : in refusal_t := refusal_none) is
  begin
    wait until rising_edge(clk);
    inputs.commit <= '1';
    wait for 1 ns;
    assert outputs.accepted = acceptance and outputs.refused = reason
      report name & ", incomplete " & to_string(outputs.refused.incomplete) & ", illegal " &
        to_string(outputs.refused.illegal) severity failure;
    wait until rising_edge(clk);
    inputs.commit <= '0';
    wait for 1 ns;
  end procedure;

end package body;
