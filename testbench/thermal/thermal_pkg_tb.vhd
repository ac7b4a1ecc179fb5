-- SPDX-License-Identifier: Apache-2.0
-- What a reading, settings and trips are before there are any, and that any single trip counts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.thermal_pkg.all;

entity thermal_pkg_tb is
end entity;

architecture simulation of thermal_pkg_tb is
begin

  test : process
    variable trips : heater_trips_t;
  begin
    -- All registers of settings read 0 after reset.
    assert converter_settings_none.references = '0' report "references" severity failure;
    assert converter_settings_none.dither_cycles = 0 report "dither" severity failure;
    assert converter_settings_none.more_charges = 0 report "charges" severity failure;
    assert converter_settings_none.discharge_cycles = 0 report "discharge" severity failure;
    assert converter_settings_none.timeout_cycles = 0 report "timeout" severity failure;
    assert converter_settings_none.pause_cycles = 0 report "pause" severity failure;
    assert converter_settings_none.short_limit = 0 report "short limit" severity failure;

    -- No reading is neither new nor valid, and as hot as can be.
    assert sensor_reading_none.updated = '0' and sensor_reading_none.valid = '0'
      and sensor_reading_none.count = 0 report "no reading" severity failure;

    assert any_of(heater_trips_none) = '0' report "no trip" severity failure;
    for trip in 0 to 7 loop
      trips := heater_trips_none;
      case trip is
        when 0 => trips.watchdog := '1';
        when 1 => trips.sensor_invalid := '1';
        when 2 => trips.sensor_stale := '1';
        when 3 => trips.too_hot := '1';
        when 4 => trips.too_cold := '1';
        when 5 => trips.limits_missing := '1';
        when 6 => trips.emergency_stop := '1';
        when 7 => trips.heats_unasked := '1';
      end case;
      assert any_of(trips) = '1' report "trip " & integer'image(trip) & " alone" severity failure;
    end loop;

    finish;
  end process;

end architecture;
