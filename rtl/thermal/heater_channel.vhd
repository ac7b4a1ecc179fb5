-- SPDX-License-Identifier: Apache-2.0
-- One heater with its sensor: limits that lock, the guard of its gate, the watch for unasked heat.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_channel is
  generic (
    -- Its number in the registers.
    channel : natural range 0 to 3 := 0
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- For one clock: of all time-outs; of the duty.
    tick : in std_ulogic;
    slot_start : in std_ulogic;
    from_software : in heater_control_from_software_t;
    -- Software clears trips; the register says of which channels.
    clear : in std_ulogic;
    -- Bounds of the limits for the present number of charges.
    least_count : in unsigned(31 downto 0);
    most_count : in unsigned(31 downto 0);
    longest_settle : in settle_t;
    watchdog_alive : in std_ulogic;
    watchdog_violated : in std_ulogic;
    reading : in sensor_reading_t;
    sensor_timeout_ticks : in tick_count_t;
    -- Synchronous.
    emergency_stop : in std_ulogic;
    gate : out std_ulogic;
    -- Some limit is set.
    any_locked : out std_ulogic;
    -- The limits as they are, and everything else that software reads.
    minimum_count : out unsigned(31 downto 0);
    maximum_count : out unsigned(31 downto 0);
    hot_count : out unsigned(31 downto 0);
    settle_ticks : out settle_t;
    status : out heater_control_status_t
  );
end entity;

architecture rtl of heater_channel is

  signal minimum_locked, maximum_locked, hot_locked, settle_locked, refused : std_ulogic;
  signal limits_set : std_ulogic;
  signal clear_this : std_ulogic;
  signal heats_unasked : std_ulogic;
  signal permitted : std_ulogic;
  signal trips : heater_trips_t;

begin

  clear_this <= clear and from_software.clear.channels(channel);

  limits : entity work.heater_limits
    port map (
      clk => clk,
      reset => reset,
      least_count => least_count,
      most_count => most_count,
      least_hot_count => shift_left(least_count, 3),
      longest_settle => longest_settle,
      -- All registers share one word of write data.
      written => from_software.minimum_count(channel).cycles,
      minimum_written => from_software.minimum_count_written(channel),
      maximum_written => from_software.maximum_count_written(channel),
      hot_written => from_software.hot_count_written(channel),
      settle_written => from_software.settle_written(channel),
      forget_refused => clear_this,
      minimum_count => minimum_count,
      maximum_count => maximum_count,
      hot_count => hot_count,
      settle_ticks => settle_ticks,
      minimum_locked => minimum_locked,
      maximum_locked => maximum_locked,
      hot_locked => hot_locked,
      settle_locked => settle_locked,
      refused => refused);

  any_locked <= minimum_locked or maximum_locked or hot_locked or settle_locked;
  limits_set <= minimum_locked and maximum_locked and hot_locked and settle_locked;

  guard : entity work.heater_guard
    port map (
      clk => clk,
      reset => reset,
      tick => tick,
      slot_start => slot_start,
      duty => from_software.duty(channel).density,
      watchdog_alive => watchdog_alive,
      watchdog_violated => watchdog_violated,
      heats_unasked => heats_unasked,
      reading => reading,
      sensor_timeout_ticks => sensor_timeout_ticks,
      minimum_count => minimum_count,
      maximum_count => maximum_count,
      limits_set => limits_set,
      emergency_stop => emergency_stop,
      clear => clear_this,
      gate => gate,
      permitted => permitted,
      trips => trips);

  unasked : entity work.unasked_heat_watch
    port map (
      clk => clk,
      reset => reset,
      tick => tick,
      gate => gate,
      reading => reading,
      limits_set => limits_set,
      settle_ticks => settle_ticks,
      hot_count => hot_count,
      found => heats_unasked);

  status <= (
    gate => gate,
    permitted => permitted,
    minimum_locked => minimum_locked,
    maximum_locked => maximum_locked,
    hot_locked => hot_locked,
    settle_locked => settle_locked,
    refused => refused,
    tripped => any_of(trips),
    watchdog_trip => trips.watchdog,
    sensor_invalid_trip => trips.sensor_invalid,
    sensor_stale_trip => trips.sensor_stale,
    too_hot_trip => trips.too_hot,
    too_cold_trip => trips.too_cold,
    limits_missing_trip => trips.limits_missing,
    emergency_stop_trip => trips.emergency_stop,
    heats_unasked_trip => trips.heats_unasked);

end architecture;
