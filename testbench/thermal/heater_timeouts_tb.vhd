-- SPDX-License-Identifier: Apache-2.0
-- Each time-out is what software writes, at most the maximum; after a reset the default.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.heater_control_registers_pkg.all;
use work.random_source_pkg.all;
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

    constant longest : positive := 3 * ticks_per_s;

    variable random : random_source_t;
    variable patience, sensor_patience : natural;

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

    -- A word that is too long is so by any of its bits, and as often as it is written.
    for bit_number in 0 to tick_count_bits - 1 loop
      for times in 1 to 2 loop
        write(2 ** bit_number, -1);
        write(-1, 2 ** bit_number);
        expect(minimum(2 ** bit_number, longest), minimum(2 ** bit_number, longest), "a bit of each");
      end loop;
    end loop;

    -- In any order, mostly near the maximum.
    patience := to_integer(watchdog_timeout);
    sensor_patience := to_integer(sensor_timeout);
    for i in 1 to 2000 loop
      case random.between(0, 3) is
        when 0 =>
          patience := random.between(longest - 2, longest + 2);
          write(patience, -1);
        when 1 =>
          sensor_patience := random.between(longest - 2, longest + 2);
          write(-1, sensor_patience);
        when 2 =>
          patience := random.between(0, 2 ** tick_count_bits - 1);
          write(patience, -1);
        when others =>
          sensor_patience := random.between(0, 2 ** tick_count_bits - 1);
          write(-1, sensor_patience);
      end case;
      patience := minimum(patience, longest);
      sensor_patience := minimum(sensor_patience, longest);
      expect(patience, sensor_patience, "any order");
    end loop;
    reset <= '1';
    expect(1000, 1000, "reset again");
    finish;
  end process;

end architecture;
