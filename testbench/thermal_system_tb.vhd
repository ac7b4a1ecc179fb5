-- SPDX-License-Identifier: Apache-2.0
-- The parts of heat are joined: a reading reaches the guard of its heater, a locked limit the converter's
-- settings, and emergency stop and veto the supply.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.clocked_bench_pkg.all;
use work.clocks_pkg.all;
use work.fan_registers_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.temperature_converter_registers_pkg.all;

entity thermal_system_tb is
end entity;

architecture bench of thermal_system_tb is

  -- Clocks until the capacitor of each channel is charged.
  constant charge_clocks : positive := 400;

  constant converter : natural := 0;
  constant heaters : natural := 1;
  constant fan : natural := 2;

  signal master : bus_master_t := bus_master_idle;
  signal resets : resets_t := (others => '1');
  signal requests : bus_request_array_t(0 to 2);
  signal responses : bus_response_array_t(0 to 2);
  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal sense, gates : std_ulogic_vector(1 downto 0) := "00";
  signal supply, interrupt, fan_gate, at_rest : std_ulogic;
  signal veto, emergency_stop : std_ulogic := '0';

  alias clk is master.clk;

begin

  make_clock(master.clk, 250 ns);

  fabric : entity work.bus_interconnect
    generic map (base_addresses => (temperature_converter_address, heater_control_address, fan_address))
    port map (
      clk => clk, reset => resets.processor, request => to_request(master.request),
      to_wires(response) => master.response, slave_requests => requests,
      slave_responses => responses);

  thermal : entity work.thermal_system
    generic map (heaters => 2)
    port map (
      clocks => (others => clk), resets => resets,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32),
      converter_request => requests(converter), converter_response => responses(converter),
      heaters_request => requests(heaters), heaters_response => responses(heaters),
      fan_request => requests(fan), fan_response => responses(fan),
      sensor_drive_enable => drive_enable, sensor_drive_level => drive_level,
      sensor_discharging => open, sensor_sense => sense, heater_gate => gates,
      heater_supply => supply, heater_supply_veto => veto, emergency_stop => emergency_stop,
      fan_gate => fan_gate, heater_interrupt => interrupt, at_rest => at_rest);

  -- Any resistor charges the capacitor alike.
  each_sensor : for channel in 0 to 1 generate
    charge : process
      variable charged : natural := 0;
      constant highest : natural := 3 * channel + 2;
      constant lowest : natural := 3 * channel;
    begin
      wait until rising_edge(clk);
      if (drive_enable(highest downto lowest) and drive_level(highest downto lowest)) /= "000" then
        charged := charged + 1;
      elsif drive_enable(highest downto lowest) /= "000" then
        charged := 0;
      end if;
      sense(channel) <= '1' when charged >= charge_clocks else '0';
    end process;
  end generate;

  test : process

    -- Of one channel; the second cannot heat.
    procedure set_limits is
    begin
      write(master, heater_control_minimum_count_address, 300);
      write(master, heater_control_maximum_count_address, 2000);
      write(master, heater_control_hot_count_address, 1000);
      write(master, heater_control_settle_address, 100);
    end procedure;

    variable word : word_t;

  begin
    wait_clocks(clk, 4);
    resets <= (others => '0');
    -- References off, a charge for each conversion, enabled.
    write(master, temperature_converter_discharge_address, 50);
    write(master, temperature_converter_timeout_address, 5000);
    write(master, temperature_converter_pause_address, 10);
    write(master, temperature_converter_control_address, 1);
    wait_clocks(clk, 3000);
    set_limits;
    wait_clocks(clk, 3000);
    feed_watchdog(master);
    switch_supply(master, heater_control_supply_key_close);
    closes : assert supply = '1' severity failure;
    write(master, heater_control_duty_address, 65535);
    wait_clocks(clk, 20_000);
    heats_its_own_heater : assert gates = "01" severity failure;

    -- The scale of the counts stays.
    write(master, temperature_converter_discharge_address, 60);
    read(master, temperature_converter_discharge_address, word);
    keeps_the_scale : assert unsigned(word) = 50 severity failure;
    read(master, temperature_converter_settings_lock_address, word);
    refuses_another : assert word(temperature_converter_settings_lock_refused_bit) = '1' severity failure;

    emergency_stop <= '1';
    wait_clocks(clk, 6);
    stops : assert gates = "00" and supply = '0' severity failure;
    wait_clocks(clk, 2);
    interrupts : assert interrupt = '1' severity failure;
    emergency_stop <= '0';
    write(master, heater_control_duty_address, 0);
    wait_clocks(clk, 4);
    clear_trips(master);
    switch_supply(master, heater_control_supply_key_close);
    closes_again : assert supply = '1' severity failure;
    veto <= '1';
    wait_clocks(clk, 4);
    is_vetoed : assert supply = '0' severity failure;

    blows_not : assert fan_gate = '0' severity failure;
    write(master, fan_period_address, 10);
    write(master, fan_duty_address, 255);
    wait until fan_gate = '1' for 10 ms;
    blows : assert fan_gate = '1' severity failure;
    std.env.finish;
  end process;

end architecture;
