-- SPDX-License-Identifier: Apache-2.0
-- Each time-out is what software writes, at most the maximum; after a reset the default.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_timeouts_tb is
end entity;

architecture simulation of heater_timeouts_tb is

  constant ticks_per_s : positive := 1000;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal from_software : heater_control_from_software_t;
  signal watchdog_timeout, sensor_timeout : tick_count_t;

begin

  clk <= not clk after 10 ns;

  timeouts : entity work.heater_timeouts
    generic map (default_timeout_s => 1, maximum_timeout_s => 3)
    port map (
      clk => clk, reset => reset, ticks_per_s => to_unsigned(ticks_per_s, tick_count_bits),
      from_software => from_software, watchdog_timeout => watchdog_timeout,
      sensor_timeout => sensor_timeout);

  test : process

    procedure expect(watchdog, sensor : natural; what : string) is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
      of_the_watchdog : assert watchdog_timeout = watchdog
        report what & ": " & to_string(to_integer(watchdog_timeout)) severity failure;
      of_the_sensors : assert sensor_timeout = sensor
        report what & ": " & to_string(to_integer(sensor_timeout)) severity failure;
    end procedure;

    procedure write(watchdog, sensor : integer) is
    begin
      from_software.watchdog_written <= '1' when watchdog >= 0 else '0';
      from_software.sensor_timeout_written <= '1' when sensor >= 0 else '0';
      -- One word of the bus goes to both.
      from_software.watchdog.ticks <= to_unsigned(maximum(watchdog, sensor), tick_count_bits);
      from_software.sensor_timeout.ticks <= to_unsigned(maximum(watchdog, sensor), tick_count_bits);
      wait until rising_edge(clk);
      from_software.watchdog_written <= '0';
      from_software.sensor_timeout_written <= '0';
    end procedure;

  begin
    from_software.watchdog_written <= '0';
    from_software.sensor_timeout_written <= '0';
    expect(1000, 1000, "reset");
    reset <= '0';
    expect(1000, 1000, "default");
    write(5, -1);
    expect(5, 1000, "watchdog alone");
    write(-1, 7);
    expect(5, 7, "sensors alone");
    write(3000, -1);
    expect(3000, 7, "longest");
    write(3001, -1);
    expect(3000, 7, "too long");
    write(2999, -1);
    expect(2999, 7, "almost longest");
    write(-1, 3001);
    expect(2999, 3000, "too long for sensors");
    write(-1, 2999);
    expect(2999, 2999, "almost longest for sensors");
    write(0, -1);
    expect(0, 2999, "none");
    reset <= '1';
    expect(1000, 1000, "reset again");
    finish;
  end process;

end architecture;
