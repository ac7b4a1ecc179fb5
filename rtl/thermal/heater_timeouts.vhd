-- SPDX-License-Identifier: Apache-2.0
-- The time-outs that software may set within bounds: of the watchdog over software, and of the sensors.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_timeouts is
  generic (
    -- Both after reset; software cannot make them longer than the maximum.
    default_timeout_s : positive range 1 to 5 := 1;
    maximum_timeout_s : positive range 1 to 5 := 3
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    ticks_per_s : in tick_count_t;
    from_software : in heater_control_from_software_t;
    watchdog_timeout : out tick_count_t := (others => '0');
    sensor_timeout : out tick_count_t := (others => '0')
  );
end entity;

architecture rtl of heater_timeouts is

  signal default_timeout : tick_count_t;
  -- A clock after the frequency, which is constant.
  signal maximum_timeout : tick_count_t := (others => '0');

begin

  default_timeout_is_within_the_maximum : assert default_timeout_s <= maximum_timeout_s
    severity failure;

  -- At most 100 MHz, so 5 s fit into a tick count.
  default_timeout <= resize(ticks_per_s * default_timeout_s, tick_count_bits);

  set_timeouts : process
  begin
    wait until rising_edge(clk);
    maximum_timeout <= resize(ticks_per_s * maximum_timeout_s, tick_count_bits);
    if from_software.watchdog_written then
      watchdog_timeout <= maximum_timeout when from_software.watchdog.ticks > maximum_timeout
        else from_software.watchdog.ticks;
    end if;
    if from_software.sensor_timeout_written then
      sensor_timeout <= maximum_timeout when from_software.sensor_timeout.ticks > maximum_timeout
        else from_software.sensor_timeout.ticks;
    end if;
    if reset then
      watchdog_timeout <= default_timeout;
      sensor_timeout <= default_timeout;
    end if;
  end process;

end architecture;
