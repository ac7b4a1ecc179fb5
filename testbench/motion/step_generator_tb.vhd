-- SPDX-License-Identifier: Apache-2.0
-- The step generator on the bus: settings, a segment, its pulses, errors and interrupts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_tb is
end entity;

architecture simulation of step_generator_tb is

  constant axes : positive := 2;

  -- Offsets in the order of the register description.
  constant build : natural := 16#000#;
  constant control : natural := 16#004#;
  constant command : natural := 16#008#;
  constant status : natural := 16#00C#;
  constant errors : natural := 16#010#;
  constant motor_enable : natural := 16#014#;
  constant rate_floor : natural := 16#018#;
  constant segment_flags : natural := 16#030#;
  constant segment_line_ticks : natural := 16#034#;
  constant segment_ticks : natural := 16#038#;
  constant segment_rate_low : natural := 16#03C#;
  constant segment_rate_high : natural := 16#040#;
  constant segment_jerk_high : natural := 16#050#;
  constant segment_steps : natural := 16#054#;
  constant segment_commit : natural := 16#074#;
  constant position : natural := 16#0B8#;

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
    procedure access_bus(offset : natural; write : std_ulogic; data : std_ulogic_vector) is
    begin
      request <= (
        strobe => '1', write => write, address => step_generator_address + offset,
        select_bytes => "1111", data => data);
      wait until rising_edge(clk) and (response.acknowledge or response.error) = '1' for 1 us;
      assert response.acknowledge = '1' report "no acknowledge at " & to_hstring(to_unsigned(offset, 12))
        severity failure;
      request.strobe <= '0';
      wait until rising_edge(clk);
    end procedure;

    procedure write(offset : natural; data : std_ulogic_vector(31 downto 0)) is
    begin
      access_bus(offset, '1', data);
    end procedure;

    procedure expect(offset : natural; data : std_ulogic_vector(31 downto 0)) is
    begin
      request <= (
        strobe => '1', write => '0', address => step_generator_address + offset,
        select_bytes => "1111", data => x"00000000");
      wait until rising_edge(clk) and response.acknowledge = '1' for 1 us;
      assert response.data = data
        report to_hstring(to_unsigned(offset, 12)) & " is " & to_hstring(response.data) severity failure;
      request.strobe <= '0';
      wait until rising_edge(clk);
    end procedure;

    procedure write_segment(x_steps : std_ulogic_vector(31 downto 0)) is
    begin
      write(segment_flags, x"00000201");
      write(segment_line_ticks, x"00000008");
      write(segment_steps, x_steps);
      write(segment_steps + 4, x"00000000");
      write(segment_ticks, x"00000008");
      for i in 0 to (segment_jerk_high - segment_rate_low) / 4 loop
        write(segment_rate_low + 4 * i, x"00000000");
      end loop;
      write(segment_rate_high, x"01000000");
      write(segment_commit, x"00000000");
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);

    expect(build, x"00000802");
    expect(status, x"00080002");
    write(motor_enable, x"00000002");
    wait until rising_edge(clk);
    assert enable = "10" severity failure;

    -- No steps without a driver.
    write_segment(x"00000005");
    expect(errors, x"00000040");
    write(command, x"00000010");
    write(motor_enable, x"00000003");

    write_segment(x"00000005");
    expect(status, x"00070100");
    -- What is queued keeps its drivers, and settings stay.
    write(motor_enable, x"00000002");
    expect(errors, x"00000020");
    write(command, x"00000010");
    write(rate_floor, x"00001234");
    expect(errors, x"00000020");
    write(command, x"00000010");
    assert enable = "11" severity failure;
    assert moving = '0' severity failure;
    write(control, x"00000007");
    wait until moving = '1' for 1 us;
    assert moving = '1' severity failure;
    wait until moving = '0' for 100 us;
    wait for 3 us;
    assert x_pulses = 5 and direction(0) = '1' severity failure;
    expect(status, x"00080002");
    expect(position, x"FFFFFFFB");
    expect(position + 4 * axes, x"00000000");
    assert queue_interrupt = '1' and stop_interrupt = '0' severity failure;

    write_segment(x"00000009");
    expect(errors, x"00000004");
    write(command, x"00000010");
    expect(errors, x"00000000");

    emergency_stop <= '1';
    wait until rising_edge(clk);
    emergency_stop <= '0';
    assert enable = "00" report "a driver is enabled in an emergency" severity failure;
    wait until stop_interrupt = '1' for 1 us;
    assert stop_interrupt = '1' severity failure;
    write_segment(x"00000005");
    expect(errors, x"00000008");
    write(motor_enable, x"00000003");
    expect(errors, x"00000028");
    write(command, x"00000004");
    expect(status, x"00080042");
    assert enable = "00" severity failure;
    write(motor_enable, x"00000003");
    assert enable = "11" severity failure;
    write(command, x"00000100");
    expect(status, x"00080002");
    assert x_pulses = 5 severity failure;

    finish;
  end process;

end architecture;
