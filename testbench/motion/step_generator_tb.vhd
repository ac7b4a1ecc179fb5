-- SPDX-License-Identifier: Apache-2.0
-- The step generator on the bus: settings, a segment, its pulses, errors and interrupts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_tb is
end entity;

architecture simulation of step_generator_tb is

  constant axes : positive := 2;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal step : std_ulogic_vector(axes - 1 downto 0);
  signal direction : std_ulogic_vector(axes - 1 downto 0);
  signal enable : std_ulogic_vector(axes - 1 downto 0);
  signal moving : std_ulogic;
  signal queue_interrupt : std_ulogic;
  signal stop_interrupt : std_ulogic;
  signal emergency_stop : std_ulogic := '0';
  signal x_pulses : natural := 0;

begin

  clk <= not clk after 10 ns;

  generator : entity work.step_generator
    generic map (axes => axes, queue_depth => 8)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      reset => reset, request => request, response => response,
      end_stops => x"00", emergency_stop => emergency_stop, start => '0', step => step,
      direction => direction, enable => enable, moving => moving,
      queue_interrupt => queue_interrupt, stop_interrupt => stop_interrupt);

  count : process
  begin
    wait until rising_edge(step(0));
    x_pulses <= x_pulses + 1;
  end process;

  test : process
    procedure write(address : unsigned(31 downto 0); data : word_t) is
    begin
      bus_write(clk, request, response, address, data);
    end procedure;

    procedure expect(address : unsigned(31 downto 0); data : word_t) is
      variable found : word_t;
    begin
      bus_read(clk, request, response, address, found);
      assert found = data report to_hstring(address) & " is " & to_hstring(found) severity failure;
    end procedure;

    procedure write_segment(x_steps : std_ulogic_vector(31 downto 0)) is
    begin
      write(step_generator_segment_flags_address, x"00000201");
      write(step_generator_segment_line_ticks_address, x"00000008");
      write(step_generator_segment_steps_address, x_steps);
      write(step_generator_segment_steps_address + 4, x"00000000");
      write(step_generator_segment_ticks_address, x"00000008");
      write(step_generator_segment_rate_low_address, x"00000000");
      write(step_generator_segment_acceleration_low_address, x"00000000");
      write(step_generator_segment_acceleration_high_address, x"00000000");
      write(step_generator_segment_jerk_low_address, x"00000000");
      write(step_generator_segment_jerk_high_address, x"00000000");
      write(step_generator_segment_rate_high_address, x"01000000");
      write(step_generator_segment_commit_address, x"00000000");
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);

    expect(step_generator_build_address, x"00000802");
    expect(step_generator_status_address, x"00080002");
    write(step_generator_motor_enable_address, x"00000002");
    wait until rising_edge(clk);
    assert enable = "10" severity failure;

    -- No steps without a driver.
    write_segment(x"00000005");
    expect(step_generator_errors_address, x"00000040");
    write(step_generator_command_address, x"00000010");
    write(step_generator_motor_enable_address, x"00000003");

    write_segment(x"00000005");
    expect(step_generator_status_address, x"00070100");
    -- What is queued keeps its drivers, and settings stay.
    write(step_generator_motor_enable_address, x"00000002");
    expect(step_generator_errors_address, x"00000020");
    write(step_generator_command_address, x"00000010");
    write(step_generator_rate_floor_address, x"00001234");
    expect(step_generator_errors_address, x"00000020");
    write(step_generator_command_address, x"00000010");
    assert enable = "11" severity failure;
    assert moving = '0' severity failure;
    write(step_generator_control_address, x"00000007");
    wait until moving = '1' for 1 us;
    assert moving = '1' severity failure;
    wait until moving = '0' for 100 us;
    wait for 3 us;
    assert x_pulses = 5 and direction(0) = '1' severity failure;
    expect(step_generator_status_address, x"00080002");
    expect(step_generator_position_address, x"FFFFFFFB");
    expect(step_generator_position_address + 4 * axes, x"00000000");
    assert queue_interrupt = '1' and stop_interrupt = '0' severity failure;

    write_segment(x"00000009");
    expect(step_generator_errors_address, x"00000004");
    write(step_generator_command_address, x"00000010");
    expect(step_generator_errors_address, x"00000000");

    emergency_stop <= '1';
    wait until rising_edge(clk);
    emergency_stop <= '0';
    assert enable = "00" report "a driver is enabled in an emergency" severity failure;
    wait until stop_interrupt = '1' for 1 us;
    assert stop_interrupt = '1' severity failure;
    write_segment(x"00000005");
    expect(step_generator_errors_address, x"00000008");
    write(step_generator_motor_enable_address, x"00000003");
    expect(step_generator_errors_address, x"00000028");
    write(step_generator_command_address, x"00000004");
    expect(step_generator_status_address, x"00080042");
    assert enable = "00" severity failure;
    write(step_generator_motor_enable_address, x"00000003");
    assert enable = "11" severity failure;
    write(step_generator_command_address, x"00000100");
    expect(step_generator_status_address, x"00080002");
    assert x_pulses = 5 severity failure;

    finish;
  end process;

end architecture;
