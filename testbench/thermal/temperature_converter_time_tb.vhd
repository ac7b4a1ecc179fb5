-- SPDX-License-Identifier: Apache-2.0
-- Time that carries into its highest bits, and overflows, disturbs no conversion. A reading of any channel
-- that becomes void is reported in the same clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity temperature_converter_time_tb is
end entity;

architecture simulation of temperature_converter_time_tb is

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal discharging, sense : std_ulogic_vector(1 downto 0);
  signal readings : sensor_reading_array_t(0 to 1);
  signal limits_locked : std_ulogic := '0';

  type ohms_t is array (0 to 1) of real;
  constant ohms : ohms_t := (1_000.0, 5_000.0);

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  converter : entity work.temperature_converter
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(100_000_000, 32), reset => reset,
      request => to_request(master.request), to_wires(response) => master.response,
      more_charges => open, limits_locked => limits_locked, drive_enable => drive_enable,
      drive_level => drive_level, discharging => discharging, sense => sense, readings => readings);

  sensors : for channel in 0 to 1 generate
    circuit : entity work.sensor_circuit
      generic map (clocks_per_ohm => 0.0272)
      port map (
        clk => clk, drive_enable => drive_enable(3 * channel + 2 downto 3 * channel),
        drive_level => drive_level(3 * channel + 2 downto 3 * channel), thermistor_ohms => ohms(channel),
        sense => sense(channel));
  end generate;

  watch_void : process
    variable before : std_ulogic_vector(1 downto 0) := "00";
  begin
    wait until rising_edge(clk);
    for channel in readings'range loop
      says_that_it_is_void : assert before(channel) = '0' or readings(channel).valid = '1'
        or readings(channel).updated = '1' or reset = '1'
        report "channel " & to_string(channel) severity error;
      before(channel) := readings(channel).valid and not reset;
    end loop;
  end process;

  check : process

    alias now_cycles is << signal .temperature_converter_time_tb.converter.now_cycles : cycles_t >>;

    procedure write_control (charges : positive) is
    begin
      write(master, temperature_converter_control_address, to_word(temperature_converter_control_t'(
        enable => '1', references => '1', dither_cycles => x"01",
        more_charges => to_unsigned(charges - 1, 8))));
    end procedure;

    procedure expect_valid is
    begin
      for channel in readings'range loop
        is_valid : assert readings(channel).valid report "channel " & to_string(channel) severity error;
      end loop;
    end procedure;

    procedure expect_void is
    begin
      for channel in readings'range loop
        is_void : assert not readings(channel).valid report "channel " & to_string(channel) severity error;
      end loop;
    end procedure;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 10);
    write(master, temperature_converter_discharge_address, 200);
    write(master, temperature_converter_timeout_address, 5_000);
    write(master, temperature_converter_pause_address, 0);
    write_control(charges => 4);
    wait_clocks(clk, 20_000);
    expect_valid;

    for bit_number in cycles_t'high - 1 to cycles_t'length loop
      now_cycles <= force shift_left(to_unsigned(1, cycles_t'length), bit_number) - 20_000;
      wait_clocks(clk, 1);
      wait until falling_edge(clk);
      now_cycles <= release;
      wait_clocks(clk, 15_000);
      for i in 1 to 10_000 loop
        wait_clocks(clk, 1);
        expect_valid;
      end loop;
    end loop;

    write_control(charges => 5);
    wait_clocks(clk, 3);
    expect_void;
    wait_clocks(clk, 20_000);
    expect_valid;
    limits_locked <= '1';
    wait_clocks(clk, 3);
    expect_void;
    wait_clocks(clk, 20_000);
    expect_valid;
    std.env.finish;
  end process;

end architecture;
