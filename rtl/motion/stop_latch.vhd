-- SPDX-License-Identifier: Apache-2.0
-- Stops all motion at an end stop, the emergency stop input, the watchdog or software's command, at once or
-- along the brake's ramp, until acknowledged.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity stop_latch is
  port (
    -- May be gated while neither `hit`,
    -- `stop_begins` nor `watching` is high and nothing is acknowledged.
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- A segment is being executed, which this ends.
    active : in std_ulogic;
    stop_on : in stop_condition_t;

    -- Synchronous to clk, filtered, 1 = triggered.
    end_stops : in std_ulogic_vector(7 downto 0);
    emergency_stop : in std_ulogic;
    watchdog_expired : in std_ulogic;
    software_stop : in std_ulogic;
    -- Without effect on a brake that is on already.
    software_brake : in std_ulogic;
    -- Without effect while emergency_stop is high, and together with another stop or brake.
    acknowledge : in std_ulogic;
    -- The brake's ramp is at its end.
    standing : in std_ulogic;
    -- The brake has no ramp: what would brake stops at once.
    no_ramp : in std_ulogic;

    -- A stop has been requested in this clock: the moment to latch positions and time.
    hit : out std_ulogic;
    -- Motion comes to rest along the ramp, and then stops.
    braking : out std_ulogic := '0';
    -- The base makes no tick from this clock on.
    stop : out std_ulogic;
    -- The first clock of it.
    stop_begins : out std_ulogic;
    -- A stop waits for its acknowledgement.
    stopped : out std_ulogic := '0';
    -- From the clock of the hit until the acknowledgement: no segment is accepted.
    closed : out std_ulogic;
    cause : out stop_cause_t := stop_cause_none;
    -- An end stop has just changed.
    watching : out std_ulogic
  );
end entity;

architecture rtl of stop_latch is

  signal end_stops_before : std_ulogic_vector(7 downto 0) := x"00";
  signal wanted, changed : std_ulogic_vector(7 downto 0);
  -- End stops in the state that stops the segment.
  signal met : std_ulogic_vector(7 downto 0);
  -- Those that started the present brake, and have kept their level since.
  signal began_brake : std_ulogic_vector(7 downto 0) := x"00";
  -- End stops that stop a segment if one is executed, and those that stop this one.
  signal hits : std_ulogic_vector(7 downto 0);
  signal hits_of_segment : std_ulogic_vector(7 downto 0);
  signal end_stop_hit : std_ulogic;
  -- A stop without an end stop, and whether one that hits makes it.
  signal without_end_stop, with_end_stop : std_ulogic;
  signal at_once, along_ramp : std_ulogic;

begin

  watching <= '1' when end_stops /= end_stops_before else '0';

  wanted <= end_stops xor (7 downto 0 => stop_on.on_release);
  changed <= end_stops xor end_stops_before;
  met <= wanted and stop_on.mask and (changed or (7 downto 0 => not stop_on.on_change));
  -- The switch that brakes may stay triggered; any other, and this one once more, ends all motion.
  hits <= met when braking = '0' else met and not (began_brake and not changed);
  hits_of_segment <= hits and (7 downto 0 => active);
  end_stop_hit <= active and (or hits);

  without_end_stop <= emergency_stop or watchdog_expired or software_stop or
    (braking and (standing or not active)) or (no_ramp and (software_brake or braking));
  with_end_stop <= braking or no_ramp or not stop_on.brakes;
  at_once <= without_end_stop or (end_stop_hit and with_end_stop);
  along_ramp <= end_stop_hit or software_brake;

  stop <= at_once or stopped;
  -- The queue is cleared by it, far away: few gates lie behind the end stops.
  stop_begins <= (without_end_stop and not stopped) or
                 ((or hits) and (active and with_end_stop and not stopped));
  hit <= (at_once or along_ramp) and not (braking or stopped);
  closed <= at_once or along_ramp or braking or stopped;

  latch : process
  begin
    wait until rising_edge(clk);
    end_stops_before <= end_stops;
    began_brake <= began_brake and not changed;
    if hit then
      braking <= not at_once;
      began_brake <= hits_of_segment;
      cause <= (
        end_stops => hits_of_segment, emergency_input => emergency_stop, software => software_stop,
        watchdog => watchdog_expired, software_brake => software_brake);
    elsif stop_begins then
      -- A stop that cuts the ramp short is a cause as well.
      braking <= '0';
      cause.end_stops <= cause.end_stops or hits_of_segment;
      cause.emergency_input <= cause.emergency_input or emergency_stop;
      cause.software <= cause.software or software_stop;
      cause.watchdog <= cause.watchdog or watchdog_expired;
    end if;
    if stop_begins then
      stopped <= '1';
    elsif acknowledge and not (emergency_stop or software_stop or software_brake) then
      stopped <= '0';
    end if;
    if reset then
      braking <= '0';
      stopped <= '0';
    end if;
  end process;

end architecture;
