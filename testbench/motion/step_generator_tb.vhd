-- SPDX-License-Identifier: Apache-2.0
-- The step generator on the bus: settings, a segment, its pulses, errors and interrupts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_tb is
end entity;

architecture simulation of step_generator_tb is

  constant axes : positive := 2;
  constant queue_depth : positive := 8;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal step : std_ulogic_vector(axes - 1 downto 0);
  signal direction : std_ulogic_vector(axes - 1 downto 0);
  signal enable : std_ulogic_vector(axes - 1 downto 0);
  signal moving : std_ulogic;
  signal queue_interrupt : std_ulogic;
  signal stop_interrupt : std_ulogic;
  signal emergency_stop : std_ulogic := '0';
  signal x_pulses : natural := 0;

  alias clk is master.clk;

begin

  make_clock(master.clk, 20 ns);

  generator : entity work.step_generator
    generic map (axes => axes, queue_depth => queue_depth)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset,
      request => to_request(master.request), to_wires(response) => master.response, end_stops => x"00",
      emergency_stop => emergency_stop, start => '0', step => step, direction => direction,
      enable => enable, moving => moving, queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt);

  count : process
  begin
    wait until rising_edge(step(0));
    x_pulses <= x_pulses + 1;
  end process;

  test : process
    -- Backward, 256 clocks a tick.
    procedure append(x_steps : natural) is
    begin
      append_segment(master, x_steps, 0, 8, ends_motion + one_backward, rate_high => 2 ** 24);
    end procedure;

    constant settings : natural := 2 ** step_generator_errors_settings_bit;
    constant while_stopped : natural := 2 ** step_generator_errors_while_stopped_bit;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);

    expect(master, step_generator_build_address,
      axes + queue_depth * 2 ** step_generator_build_queue_depth_bits'low);
    expect(master, step_generator_status_address, queue_depth * one_free + idle_status);
    write(master, step_generator_motor_enable_address, 2);
    wait until rising_edge(clk);
    assert enable = "10" severity failure;

    -- No steps without a driver.
    append(5);
    expect(master, step_generator_errors_address, 2 ** step_generator_errors_disabled_bit);
    write(master, step_generator_command_address, clear_errors_command);
    write(master, step_generator_motor_enable_address, 3);

    append(5);
    expect(master, step_generator_status_address, (queue_depth - 1) * one_free + one_queued);
    -- What is queued keeps its drivers, and settings stay.
    write(master, step_generator_motor_enable_address, 2);
    expect(master, step_generator_errors_address, settings);
    write(master, step_generator_command_address, clear_errors_command);
    write(master, step_generator_rate_floor_address, 16#1234#);
    expect(master, step_generator_errors_address, settings);
    write(master, step_generator_command_address, clear_errors_command);
    assert enable = "11" severity failure;
    assert moving = '0' severity failure;
    write(master, step_generator_control_address, run + both_interrupts);
    wait until moving = '1' for 1 us;
    assert moving = '1' severity failure;
    wait until moving = '0' for 100 us;
    wait for 3 us;
    assert x_pulses = 5 and direction(0) = '1' severity failure;
    expect(master, step_generator_status_address, queue_depth * one_free + idle_status);
    expect(master, step_generator_position_address, -5);
    expect(master, step_generator_position_address + 4 * axes, 0);
    assert queue_interrupt = '1' and stop_interrupt = '0' severity failure;

    append(9);
    expect(master, step_generator_errors_address, 2 ** step_generator_errors_illegal_bit);
    write(master, step_generator_command_address, clear_errors_command);
    expect(master, step_generator_errors_address, 0);

    emergency_stop <= '1';
    wait until rising_edge(clk);
    emergency_stop <= '0';
    assert enable = "00" report "a driver is enabled in an emergency" severity failure;
    wait until stop_interrupt = '1' for 1 us;
    assert stop_interrupt = '1' severity failure;
    append(5);
    expect(master, step_generator_errors_address, while_stopped);
    write(master, step_generator_motor_enable_address, 3);
    expect(master, step_generator_errors_address, settings + while_stopped);
    write(master, step_generator_command_address, acknowledge_command);
    expect(master, step_generator_status_address,
      queue_depth * one_free + positions_lost_status + idle_status);
    assert enable = "00" severity failure;
    write(master, step_generator_motor_enable_address, 3);
    assert enable = "11" severity failure;
    write(master, step_generator_command_address, positions_known_command);
    expect(master, step_generator_status_address, queue_depth * one_free + idle_status);
    assert x_pulses = 5 severity failure;

    finish;
  end process;

end architecture;
