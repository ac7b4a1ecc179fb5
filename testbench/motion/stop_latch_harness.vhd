-- SPDX-License-Identifier: Apache-2.0
-- A stop_latch with its clock, for its benches.

library ieee;
use ieee.std_logic_1164.all;

use work.stop_latch_harness_pkg.all;

entity stop_latch_harness is
  port (
    clk : out std_ulogic := '0';
    inputs : in stop_latch_inputs_t;
    outputs : out stop_latch_outputs_t
  );
end entity;

architecture simulation of stop_latch_harness is
begin

  clk <= not clk after 10 ns;

  latch : entity work.stop_latch
    port map (
      clk => clk, reset => inputs.reset, active => inputs.active, stop_on => inputs.stop_on,
      end_stops => inputs.end_stops, emergency_stop => inputs.emergency_stop,
      watchdog_expired => inputs.watchdog_expired, software_stop => inputs.software_stop,
      software_brake => inputs.software_brake, acknowledge => inputs.acknowledge,
      standing => inputs.standing, no_ramp => inputs.no_ramp, hit => outputs.hit,
      braking => outputs.braking, stop => outputs.stop, stop_begins => outputs.stop_begins,
      stopped => outputs.stopped, closed => outputs.closed, cause => outputs.cause,
      watching => outputs.watching);

end architecture;
