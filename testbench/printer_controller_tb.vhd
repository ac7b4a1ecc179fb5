-- SPDX-License-Identifier: Apache-2.0
-- The chip without a program is safe: whatever its inputs do, nothing steps, heats, blows or talks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity printer_controller_tb is
end entity;

architecture bench of printer_controller_tb is

  constant axes : positive := 5;
  constant heaters : positive := 2;
  constant clocks : positive := 20_000;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal receive : std_ulogic := '1';
  signal transmit : std_ulogic;
  signal step, direction, motor_enable : std_ulogic_vector(axes - 1 downto 0);
  signal end_stop : std_ulogic_vector(7 downto 0) := (others => '0');
  signal emergency_stop : std_ulogic := '0';
  signal sensor_sense : std_ulogic_vector(heaters - 1 downto 0) := (others => '0');
  signal sensor_drive_enable : std_ulogic_vector(3 * heaters - 1 downto 0);
  signal heater_gate : std_ulogic_vector(heaters - 1 downto 0);
  signal fan_gate : std_ulogic;

begin

  clk <= not clk after 10 ns;

  chip : entity work.printer_controller
    generic map (axes => axes, heaters => heaters)
    port map (
      clk => clk, reset => reset, receive => receive,
      transmit => transmit, step => step,
      direction => direction, motor_enable => motor_enable, end_stop => end_stop,
      emergency_stop => emergency_stop, motion_start => receive, sensor_drive_enable => sensor_drive_enable,
      sensor_drive_level => open, sensor_discharging => open, sensor_sense => sensor_sense,
      heater_gate => heater_gate, fan_gate => fan_gate, fault => open, sleeping => open);

  disturb : process
    variable seed_1, seed_2 : positive := 7;
    variable chance : real;
  begin
    for clock in 1 to 4 loop
      wait until rising_edge(clk);
    end loop;
    reset <= '0';
    for clock in 1 to clocks loop
      wait until rising_edge(clk);
      uniform(seed_1, seed_2, chance);
      receive <= '1' when chance > 0.3 else '0';
      emergency_stop <= '1' when chance > 0.98 else '0';
      sensor_sense <= std_ulogic_vector(to_unsigned(integer(floor(chance * 997.0)) mod 4, heaters));
      end_stop <= std_ulogic_vector(to_unsigned(integer(floor(chance * 9973.0)) mod 256, 8));
    end loop;
    report "printer_controller_tb passed";
    std.env.finish;
  end process;

  -- From the second clock after the reset on, when every register has its reset value.
  watch : process
  begin
    wait until reset = '0';
    wait until rising_edge(clk);
    loop
      wait until rising_edge(clk);
      assert heater_gate = (heater_gate'range => '0') report "a heater is on" severity failure;
      assert step = (step'range => '0') report "a motor steps" severity failure;
      assert motor_enable = (motor_enable'range => '0') report "a motor has current"
        severity failure;
      assert fan_gate = '0' report "the fan blows" severity failure;
      assert transmit = '1' report "the serial line is not idle" severity failure;
      assert sensor_drive_enable = (sensor_drive_enable'range => '0') report "a sensor is driven"
        severity failure;
    end loop;
  end process;

end architecture;
