-- SPDX-License-Identifier: Apache-2.0
-- Each pin of each top entity belongs to the signal of the chip that it is called after, at its level.

library ieee;
use ieee.std_logic_1164.all;
use work.pin_types.all;

entity pin_order_tb is
end entity;

architecture simulation of pin_order_tb is

  constant boards : positive := 4;

  type All_chips is array (0 to boards - 1) of Chip_outputs;
  type All_inputs is array (0 to boards - 1) of Inputs;
  type All_pins is array (0 to boards - 1) of Pins;

  signal reference_clk, slow_clk, watch_clk : std_ulogic := '0';
  signal chip : All_chips;
  signal outside, seen : All_inputs;
  signal pin : All_pins;
  signal done : std_ulogic_vector(boards - 1 downto 0);

begin

  reference_clk <= not reference_clk after 10 ns;
  slow_clk <= not slow_clk after 20 ns;
  watch_clk <= not watch_clk after 17.4 ns;

  board_115 : entity work.de2_115
    port map (
      clock_50mhz => reference_clk, clock_25mhz => watch_clk,
      uart_rxd => outside(0).receive, uart_txd => pin(0).transmit,
      led => pin(0).led, emergency_stop => outside(0).emergency_stop,
      step => pin(0).step, direction => pin(0).direction, motor_enable_n => pin(0).enable,
      end_stop => outside(0).end_stop, heater_gate => pin(0).heater,
      heater_supply => pin(0).supply, fan_gate => pin(0).fan,
      sensor_resistor => pin(0).resistor, sensor_sense => outside(0).sense,
      tck => outside(0).jtag(2), tms => outside(0).jtag(1), tdi => outside(0).jtag(0), tdo => open);
  pin(0).resistor <= (others => 'L');

  check_de2_115 : entity work.pin_order
    generic map (board => "de2_115")
    port map (
      chip => chip(0), outside => outside(0), seen => seen(0), pin => pin(0), done => done(0));

  set_de2_115 : process
    alias step is << signal board_115.board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias direction is << signal board_115.board.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias enable is << signal board_115.board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias heater is << signal board_115.board.heater_level : std_ulogic_vector(1 downto 0) >>;
    alias supply is << signal board_115.board.supply_closed : std_ulogic >>;
    alias fan is << signal board_115.board.fan_level : std_ulogic >>;
    alias transmit is << signal board_115.board.transmit_level : std_ulogic >>;
    alias fault is << signal board_115.board.fault : std_ulogic >>;
    alias driven is << signal board_115.board.drive_enable : std_ulogic_vector(5 downto 0) >>;
    alias level is << signal board_115.drive_level : std_ulogic_vector(5 downto 0) >>;
  begin
    wait on chip(0);
    step <= force chip(0).step;
    direction <= force chip(0).direction;
    enable <= force chip(0).enable;
    heater <= force chip(0).heater;
    supply <= force chip(0).supply;
    fan <= force chip(0).fan;
    transmit <= force chip(0).transmit;
    fault <= force chip(0).fault;
    driven <= force chip(0).driven;
    level <= force chip(0).level;
  end process;

  seen(0) <= (
    << signal board_115.board.chip.end_stop : std_ulogic_vector(7 downto 0) >>,
    << signal board_115.board.chip.sensor_sense : std_ulogic_vector(1 downto 0) >>,
    << signal board_115.board.chip.emergency_stop : std_ulogic >>,
    << signal board_115.board.chip.receive : std_ulogic >>,
    << signal board_115.board.chip.tck : std_ulogic >> & << signal board_115.board.chip.tms : std_ulogic >> &
    << signal board_115.board.chip.tdi : std_ulogic >>);

  board_70 : entity work.de2_70
    port map (
      clock_50mhz => reference_clk, clock_28mhz => watch_clk,
      uart_rxd => outside(1).receive, uart_txd => pin(1).transmit,
      led => pin(1).led, emergency_stop => outside(1).emergency_stop,
      step => pin(1).step, direction => pin(1).direction, motor_enable_n => pin(1).enable,
      end_stop => outside(1).end_stop, heater_gate => pin(1).heater,
      heater_supply => pin(1).supply, fan_gate => pin(1).fan,
      sensor_resistor => pin(1).resistor, sensor_sense => outside(1).sense,
      tck => outside(1).jtag(2), tms => outside(1).jtag(1), tdi => outside(1).jtag(0), tdo => open);
  pin(1).resistor <= (others => 'L');

  check_de2_70 : entity work.pin_order
    generic map (board => "de2_70")
    port map (
      chip => chip(1), outside => outside(1), seen => seen(1), pin => pin(1), done => done(1));

  set_de2_70 : process
    alias step is << signal board_70.board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias direction is << signal board_70.board.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias enable is << signal board_70.board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias heater is << signal board_70.board.heater_level : std_ulogic_vector(1 downto 0) >>;
    alias supply is << signal board_70.board.supply_closed : std_ulogic >>;
    alias fan is << signal board_70.board.fan_level : std_ulogic >>;
    alias transmit is << signal board_70.board.transmit_level : std_ulogic >>;
    alias fault is << signal board_70.board.fault : std_ulogic >>;
    alias driven is << signal board_70.board.drive_enable : std_ulogic_vector(5 downto 0) >>;
    alias level is << signal board_70.drive_level : std_ulogic_vector(5 downto 0) >>;
  begin
    wait on chip(1);
    step <= force chip(1).step;
    direction <= force chip(1).direction;
    enable <= force chip(1).enable;
    heater <= force chip(1).heater;
    supply <= force chip(1).supply;
    fan <= force chip(1).fan;
    transmit <= force chip(1).transmit;
    fault <= force chip(1).fault;
    driven <= force chip(1).driven;
    level <= force chip(1).level;
  end process;

  seen(1) <= (
    << signal board_70.board.chip.end_stop : std_ulogic_vector(7 downto 0) >>,
    << signal board_70.board.chip.sensor_sense : std_ulogic_vector(1 downto 0) >>,
    << signal board_70.board.chip.emergency_stop : std_ulogic >>,
    << signal board_70.board.chip.receive : std_ulogic >>,
    << signal board_70.board.chip.tck : std_ulogic >> & << signal board_70.board.chip.tms : std_ulogic >> &
    << signal board_70.board.chip.tdi : std_ulogic >>);

  board_2012 : entity work.de2_70_reprap_2012
    port map (
      clock_50mhz => reference_clk, clock_28mhz => watch_clk,
      uart_rxd => outside(2).receive, uart_txd => pin(2).transmit,
      led => pin(2).led, emergency_stop => outside(2).emergency_stop,
      step => pin(2).step, direction => pin(2).direction, motor_reset_n => pin(2).enable,
      end_stop => outside(2).end_stop(2 downto 0), heater_gate => pin(2).heater,
      heater_supply => pin(2).supply, fan_gate => pin(2).fan,
      sensor_resistor => pin(2).resistor, sensor_sense => outside(2).sense,
      tck => outside(2).jtag(2), tms => outside(2).jtag(1), tdi => outside(2).jtag(0), tdo => open);
  pin(2).resistor <= (others => 'L');

  check_de2_70_reprap_2012 : entity work.pin_order
    generic map (board => "de2_70_reprap_2012", enable_level => '1', has_second_z => true, end_stops => 3)
    port map (
      chip => chip(2), outside => outside(2), seen => seen(2), pin => pin(2), done => done(2));

  set_de2_70_reprap_2012 : process
    alias step is << signal board_2012.board.step_level : std_ulogic_vector(4 downto 0) >>;
    alias direction is << signal board_2012.board.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias enable is << signal board_2012.board.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias heater is << signal board_2012.board.heater_level : std_ulogic_vector(1 downto 0) >>;
    alias supply is << signal board_2012.board.supply_closed : std_ulogic >>;
    alias fan is << signal board_2012.board.fan_level : std_ulogic >>;
    alias transmit is << signal board_2012.board.transmit_level : std_ulogic >>;
    alias fault is << signal board_2012.board.fault : std_ulogic >>;
    alias driven is << signal board_2012.board.drive_enable : std_ulogic_vector(5 downto 0) >>;
    alias level is << signal board_2012.drive_level : std_ulogic_vector(5 downto 0) >>;
  begin
    wait on chip(2);
    step <= force chip(2).step;
    direction <= force chip(2).direction;
    enable <= force chip(2).enable;
    heater <= force chip(2).heater;
    supply <= force chip(2).supply;
    fan <= force chip(2).fan;
    transmit <= force chip(2).transmit;
    fault <= force chip(2).fault;
    driven <= force chip(2).driven;
    level <= force chip(2).level;
  end process;

  seen(2) <= (
    << signal board_2012.board.chip.end_stop : std_ulogic_vector(7 downto 0) >>,
    << signal board_2012.board.chip.sensor_sense : std_ulogic_vector(1 downto 0) >>,
    << signal board_2012.board.chip.emergency_stop : std_ulogic >>,
    << signal board_2012.board.chip.receive : std_ulogic >>,
    << signal board_2012.board.chip.tck : std_ulogic >> &
    << signal board_2012.board.chip.tms : std_ulogic >> &
    << signal board_2012.board.chip.tdi : std_ulogic >>);

  board_ulx3s : entity work.ulx3s
    port map (
      clk_25mhz => slow_clk,
      ftdi_txd => outside(3).receive, ftdi_rxd => pin(3).transmit, ftdi_ndtr => '0',
      wifi_en => open, wifi_gpio0 => open,
      motion_start => '0',
      led => pin(3).led, emergency_stop => outside(3).emergency_stop,
      step => pin(3).step, direction => pin(3).direction, motor_enable_n => pin(3).enable,
      end_stop => outside(3).end_stop, heater_gate => pin(3).heater,
      heater_supply => pin(3).supply, fan_gate => pin(3).fan,
      sensor_resistor => pin(3).resistor, sensor_sense => outside(3).sense,
      tck => outside(3).jtag(2), tms => outside(3).jtag(1), tdi => outside(3).jtag(0), tdo => open);
  pin(3).resistor <= (others => 'L');

  check_ulx3s : entity work.pin_order
    generic map (board => "ulx3s")
    port map (
      chip => chip(3), outside => outside(3), seen => seen(3), pin => pin(3), done => done(3));

  set_ulx3s : process
    alias step is << signal board_ulx3s.step_level : std_ulogic_vector(4 downto 0) >>;
    alias direction is << signal board_ulx3s.direction_level : std_ulogic_vector(4 downto 0) >>;
    alias enable is << signal board_ulx3s.motor_enable : std_ulogic_vector(4 downto 0) >>;
    alias heater is << signal board_ulx3s.heater_level : std_ulogic_vector(1 downto 0) >>;
    alias supply is << signal board_ulx3s.supply_closed : std_ulogic >>;
    alias fan is << signal board_ulx3s.fan_level : std_ulogic >>;
    alias transmit is << signal board_ulx3s.transmit_level : std_ulogic >>;
    alias fault is << signal board_ulx3s.fault : std_ulogic >>;
    alias driven is << signal board_ulx3s.drive_enable : std_ulogic_vector(5 downto 0) >>;
    alias level is << signal board_ulx3s.drive_level : std_ulogic_vector(5 downto 0) >>;
  begin
    wait on chip(3);
    step <= force chip(3).step;
    direction <= force chip(3).direction;
    enable <= force chip(3).enable;
    heater <= force chip(3).heater;
    supply <= force chip(3).supply;
    fan <= force chip(3).fan;
    transmit <= force chip(3).transmit;
    fault <= force chip(3).fault;
    driven <= force chip(3).driven;
    level <= force chip(3).level;
  end process;

  seen(3) <= (
    << signal board_ulx3s.chip.end_stop : std_ulogic_vector(7 downto 0) >>,
    << signal board_ulx3s.chip.sensor_sense : std_ulogic_vector(1 downto 0) >>,
    << signal board_ulx3s.chip.emergency_stop : std_ulogic >>,
    << signal board_ulx3s.chip.receive : std_ulogic >>,
    << signal board_ulx3s.chip.tck : std_ulogic >> & << signal board_ulx3s.chip.tms : std_ulogic >> &
    << signal board_ulx3s.chip.tdi : std_ulogic >>);

  end_test : process
  begin
    wait until done = (done'range => '1');
    report "pin_order_tb passed";
    std.env.finish;
  end process;

end architecture;
