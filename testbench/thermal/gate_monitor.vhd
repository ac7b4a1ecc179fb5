-- SPDX-License-Identifier: Apache-2.0
-- An independent statement of the conditions of a heater's gate: a gate is open only if all of them
-- held in the clock before.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity gate_monitor is
  port (
    clk, reset, tick : in std_ulogic;
    duty : in unsigned(15 downto 0);
    watchdog_alive, watchdog_violated, heats_unasked : in std_ulogic;
    reading : in sensor_reading_t;
    sensor_timeout_ticks : in tick_count_t;
    minimum_count, maximum_count : in unsigned(31 downto 0);
    limits_set, emergency_stop : in std_ulogic;
    gate : in std_ulogic;
    trips : in heater_trips_t;
    clocks_open : out natural := 0
  );
end entity;

architecture simulation of gate_monitor is
begin

  watch_gate : process
    variable ticks_since_valid : natural := 1_000_000;
    variable safe_before : boolean := false;
    variable reset_before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    opens_only_when_safe : assert gate = '0' or safe_before report "open" severity error;
    a_reset_clears_trips : assert reset_before = '0' or trips = heater_trips_none
      report "tripped in reset" severity error;
    reset_before := reset;
    if gate then
      clocks_open <= clocks_open + 1;
    end if;
    safe_before := watchdog_alive = '1' and reading.valid = '1' and limits_set = '1'
      and emergency_stop = '0' and reading.count >= minimum_count and reading.count <= maximum_count
      and ticks_since_valid < sensor_timeout_ticks and duty /= 0 and reset = '0'
      and watchdog_violated = '0' and heats_unasked = '0' and trips = heater_trips_none;
    if reading.updated = '1' and reading.valid = '1' then
      ticks_since_valid := 0;
    elsif tick then
      ticks_since_valid := ticks_since_valid + 1;
    end if;
    if reset then
      ticks_since_valid := 1_000_000;
    end if;
  end process;

end architecture;
