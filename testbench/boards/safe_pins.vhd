-- SPDX-License-Identifier: Apache-2.0
-- Takes a board from power-up through its reset to a clock that fails: nothing heats, steps or has current.

library ieee;
use ieee.std_logic_1164.all;

entity safe_pins is
  generic (
    reference_period : time := 20 ns;
    watch_period : time
  );
  port (
    reference_clk : out std_ulogic := '0';
    watch_clk : out std_ulogic := '0';
    transmit : in std_ulogic;
    step : in std_ulogic_vector;
    direction : in std_ulogic_vector;
    motor_enable_n : in std_ulogic_vector;
    heater_gate : in std_ulogic_vector;
    heater_supply : in std_ulogic;
    fan_gate : in std_ulogic;
    -- Open, which a pull in this bench makes 'L'.
    sensor_resistor : in std_logic_vector
  );
end entity;

architecture simulation of safe_pins is

  signal reference, watch : std_ulogic := '0';
  signal reference_runs, watch_runs : boolean := false;

begin

  reference <= not reference after reference_period / 2 when reference_runs;
  watch <= not watch after watch_period / 2 when watch_runs;
  reference_clk <= reference;
  watch_clk <= watch;

  proceed : process
  begin
    -- Configured, with both oscillators still at rest.
    wait for 2 us;
    watch_runs <= true;
    wait for 2 us;
    -- 1000 periods until the clock is steady, and 16 clocks; then a processor without a program.
    reference_runs <= true;
    wait for 100 us;
    reference_runs <= false;
    wait for 100 us;
    reference_runs <= true;
    wait for 50 us;
    report "safe_pins passed";
    std.env.finish;
  end process;

  -- At every change, and from the first instant on.
  check : process
    constant off : std_ulogic_vector(31 downto 0) := (others => '0');
    constant disabled : std_ulogic_vector(31 downto 0) := (others => '1');
  begin
    wait for 1 ps;
    loop
      nothing_heats : assert heater_gate = off(heater_gate'length - 1 downto 0)
        report "a heater's gate is " & to_string(heater_gate) severity error;
      the_supply_is_open : assert heater_supply = '0'
        report "the heaters' supply is " & to_string(heater_supply) severity error;
      the_fan_is_off : assert fan_gate = '0' report "the fan is " & to_string(fan_gate) severity error;
      no_driver_is_enabled : assert motor_enable_n = disabled(motor_enable_n'length - 1 downto 0)
        report "drivers are enabled: " & to_string(motor_enable_n) severity error;
      nothing_steps : assert step = off(step'length - 1 downto 0)
        report "steps: " & to_string(step) severity error;
      directions_rest : assert direction = off(direction'length - 1 downto 0)
        report "directions: " & to_string(direction) severity error;
      nothing_is_sent : assert transmit = '1' report "the serial line is busy" severity error;
      no_sensor_is_driven : assert sensor_resistor = (sensor_resistor'range => 'L')
        report "a sensor is driven: " & to_string(sensor_resistor) severity error;
      wait on heater_gate, heater_supply, fan_gate, motor_enable_n, step, direction, transmit,
        sensor_resistor;
    end loop;
  end process;

end architecture;
