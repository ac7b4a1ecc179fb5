-- SPDX-License-Identifier: Apache-2.0
-- The pins of a stop_latch as two records, and what its benches do with them again and again.

library ieee;
use ieee.std_logic_1164.all;

use work.clocked_bench_pkg.all;
use work.step_generator_pkg.all;

package stop_latch_harness_pkg is

  type stop_latch_inputs_t is record
    reset : std_ulogic;
    active : std_ulogic;
    stop_on : stop_condition_t;
    end_stops : std_ulogic_vector(7 downto 0);
    emergency_stop : std_ulogic;
    watchdog_expired : std_ulogic;
    software_stop : std_ulogic;
    software_brake : std_ulogic;
    acknowledge : std_ulogic;
    standing : std_ulogic;
    no_ramp : std_ulogic;
  end record;

  constant stop_latch_in_reset : stop_latch_inputs_t := (
    reset => '1', stop_on => stop_condition_none, end_stops => x"00", others => '0');

  type stop_latch_outputs_t is record
    hit : std_ulogic;
    braking : std_ulogic;
    stop : std_ulogic;
    stop_begins : std_ulogic;
    stopped : std_ulogic;
    closed : std_ulogic;
    cause : stop_cause_t;
    watching : std_ulogic;
  end record;

  -- Until outputs follow their inputs within a clock.
  procedure settle;

  procedure acknowledge_stop (signal clk : in std_ulogic; signal inputs : inout stop_latch_inputs_t);

end package;

package body stop_latch_harness_pkg is

  procedure settle is
  begin
    wait for 1 ns;
  end procedure;

  procedure acknowledge_stop (signal clk : in std_ulogic; signal inputs : inout stop_latch_inputs_t) is
  begin
    inputs.acknowledge <= '1';
    wait_for_clock(clk);
    inputs.acknowledge <= '0';
  end procedure;

end package body;
