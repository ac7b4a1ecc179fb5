-- SPDX-License-Identifier: Apache-2.0
-- Two chips do the same, whatever their inputs do: one with one clock, one whose clocks are gated at rest.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.clocks_pkg.all;

entity printer_core_tb is
end entity;

architecture bench of printer_core_tb is

  constant heaters : positive := 2;
  constant axes : positive := 5;
  constant clocks_to_run : positive := 20_000;

  -- What drives the chip: reset, receive, emergency stop, motion start, veto, sense, end stops.
  signal inputs : std_ulogic_vector(14 downto 0) := (14 => '1', 13 => '1', others => '0');

  type outputs_t is record
    transmit : std_ulogic;
    step, direction, motor_enable : std_ulogic_vector(axes - 1 downto 0);
    drive_enable, drive_level : std_ulogic_vector(3 * heaters - 1 downto 0);
    gate : std_ulogic_vector(heaters - 1 downto 0);
    supply, fan, fault, sleeping, retired : std_ulogic;
  end record;
  type outputs_array_t is array (0 to 1) of outputs_t;
  signal outputs : outputs_array_t;

  type clocks_array_t is array (0 to 1) of clocks_t;
  constant low : clocks_t := (others => '0');
  -- The second is the one with gated clocks.
  signal clocks : clocks_array_t := (low, low);
  type rests_t is array (0 to 1) of clocks_at_rest_t;
  signal rests : rests_t;

  type counts_t is record
    registers, axes, peripherals : natural;
  end record;
  signal left_out : counts_t := (0, 0, 0);

begin

  each_chip : for chip in 0 to 1 generate
    core : entity work.printer_core
      generic map (memory_size_bytes => 32_768, axes => axes, heaters => heaters)
      port map (
        clocks => clocks(chip), at_rest => rests(chip), clock_frequency_hz => to_unsigned(4_000_000, 32),
        software_stepping => '0', retired => outputs(chip).retired, reset => inputs(14),
        receive => inputs(13), transmit => outputs(chip).transmit, step => outputs(chip).step,
        direction => outputs(chip).direction, motor_enable => outputs(chip).motor_enable,
        end_stop => inputs(7 downto 0), emergency_stop => inputs(12), motion_start => inputs(11),
        sensor_drive_enable => outputs(chip).drive_enable,
        sensor_drive_level => outputs(chip).drive_level, sensor_discharging => open,
        sensor_sense => inputs(9 downto 8), heater_gate => outputs(chip).gate,
        heater_supply => outputs(chip).supply, heater_supply_veto => inputs(10),
        fan_gate => outputs(chip).fan, fault => outputs(chip).fault, tck => '0', tms => '1', tdi => '0',
        tdo => open, sleeping => outputs(chip).sleeping);
  end generate;

  run : process

    variable seed_1, seed_2 : positive := 11;
    variable chance : real;
    variable toggled : natural;
    variable input_has_changed : boolean := true;

    -- All in one moment, as from one clock tree.
    procedure clock is
      variable gated : clocks_t;
    begin
      wait for 100 ns;
      gated := (others => '1');
      if not input_has_changed then
        gated.processor := not rests(1).processor;
        gated.registers := not rests(1).registers;
        gated.axes := not rests(1).axes;
        gated.peripherals := not rests(1).peripherals;
      end if;
      clocks <= (0 => (others => '1'), 1 => gated);
      if gated.registers = '0' then
        left_out.registers <= left_out.registers + 1;
      end if;
      if gated.axes = '0' then
        left_out.axes <= left_out.axes + 1;
      end if;
      if gated.peripherals = '0' then
        left_out.peripherals <= left_out.peripherals + 1;
      end if;
      wait for 100 ns;
      clocks <= (low, low);
      input_has_changed := false;
    end procedure;

    procedure change(bit_number : natural; level : std_ulogic) is
    begin
      if inputs(bit_number) /= level then
        inputs(bit_number) <= level;
        input_has_changed := true;
      end if;
    end procedure;

  begin
    for i in 1 to 10 loop
      input_has_changed := true;
      clock;
    end loop;
    change(14, '0');
    for i in 1 to clocks_to_run loop
      clock;
      do_the_same : assert outputs(0) = outputs(1) report "clock " & to_string(i) severity failure;
      -- Longer times without a change come, so that all rest in between.
      uniform(seed_1, seed_2, chance);
      if chance < 0.02 then
        uniform(seed_1, seed_2, chance);
        toggled := integer(floor(chance * 13.999));
        change(toggled, not inputs(toggled));
      end if;
      -- A reset between.
      if i mod 6000 = 0 then
        change(14, '1');
      elsif i mod 6000 = 3 then
        change(14, '0');
      end if;
    end loop;
    edges_were_left_out : assert left_out.axes > clocks_to_run / 4
      and left_out.peripherals > clocks_to_run / 20 and left_out.registers > clocks_to_run / 4
      report to_string(left_out.axes) & " " & to_string(left_out.peripherals) & " " &
        to_string(left_out.registers) severity failure;
    std.env.finish;
  end process;

end architecture;
