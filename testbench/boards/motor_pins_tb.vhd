-- SPDX-License-Identifier: Apache-2.0
-- What the chip wants of each motor reaches the right pin, at the right level, on both wirings of the DE2-70.

library ieee;
use ieee.std_logic_1164.all;

entity motor_pins_tb is
end entity;

architecture simulation of motor_pins_tb is

  constant period : time := 20 ns;

  signal reference_clk, watch_clk : std_ulogic := '0';
  signal step, direction, motor_enable_n : std_ulogic_vector(4 downto 0);
  signal step_2012, direction_2012, motor_reset_n : std_ulogic_vector(4 downto 0);

begin

  reference_clk <= not reference_clk after period / 2;
  watch_clk <= not watch_clk after 17.4 ns;

  board : entity work.de2_70
    port map (
      clock_50mhz => reference_clk, clock_28mhz => watch_clk, uart_rxd => '1', uart_txd => open, led => open,
      emergency_stop => '0', step => step, direction => direction, motor_enable_n => motor_enable_n,
      end_stop => x"00", heater_gate => open, heater_supply => open, fan_gate => open,
      sensor_resistor => open, sensor_sense => "00", tck => '1', tms => '1', tdi => '1', tdo => open);

  board_2012 : entity work.de2_70_reprap_2012
    port map (
      clock_50mhz => reference_clk, clock_28mhz => watch_clk, uart_rxd => '1', uart_txd => open, led => open,
      emergency_stop => '0', step => step_2012, direction => direction_2012, motor_reset_n => motor_reset_n,
      end_stop => "000", heater_gate => open, heater_supply => open, fan_gate => open,
      sensor_resistor => open, sensor_sense => "00", tck => '1', tms => '1', tdi => '1', tdo => open);

  check : process
    alias enabled is << signal board.board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias stepping is << signal board.board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias forward is << signal board.board.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias enabled_2012 is << signal board_2012.board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias stepping_2012 is << signal board_2012.board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias forward_2012 is << signal board_2012.board.direction_level : std_ulogic_vector(4 downto 0) >>;
    variable one : std_ulogic_vector(4 downto 0);
    -- Of 2012, the fifth motor does as the third.
    variable twin : std_ulogic_vector(4 downto 0);
  begin
    -- The loop locks within 20 us, and the reset ends.
    wait for 30 us;
    for motor in 0 to 4 loop
      one := (others => '0');
      one(motor) := '1';
      twin := (4 => one(2), 3 => one(3), 2 => one(2), 1 => one(1), 0 => one(0));
      enabled <= force one;
      stepping <= force one;
      forward <= force not one;
      enabled_2012 <= force one;
      stepping_2012 <= force one;
      forward_2012 <= force not one;
      wait for 2 * period;
      enables : assert motor_enable_n = not one
        report "enables " & to_string(motor_enable_n) severity error;
      steps : assert step = one and direction = not one
        report "steps " & to_string(step) & " " & to_string(direction) severity error;
      wakes : assert motor_reset_n = twin report "wakes " & to_string(motor_reset_n) severity error;
      steps_both_z : assert step_2012 = twin and direction_2012 = not twin
        report "steps " & to_string(step_2012) & " " & to_string(direction_2012) severity error;
    end loop;
    report "motor_pins_tb passed";
    std.env.finish;
  end process;

end architecture;
