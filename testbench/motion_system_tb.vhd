-- SPDX-License-Identifier: Apache-2.0
-- The parts of motion are joined: the emergency stop reaches generator and pins, an end stop its register and
-- the generator, software's pins the chip's only with the strap.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.clocked_bench_pkg.all;
use work.clocks_pkg.all;
use work.end_stops_registers_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_registers_pkg.all;
use work.step_pins_registers_pkg.all;

entity motion_system_tb is
end entity;

architecture bench of motion_system_tb is

  constant generator : natural := 0;
  constant switches : natural := 1;
  constant pins : natural := 2;

  signal master : bus_master_t := bus_master_idle;
  signal resets : resets_t := (others => '1');
  signal requests : bus_request_array_t(0 to 2);
  signal responses : bus_response_array_t(0 to 2);
  signal software_stepping, emergency_stop, motion_start : std_ulogic := '0';
  signal end_stop : std_ulogic_vector(7 downto 0) := (others => '0');
  signal step, direction, motor_enable : std_ulogic_vector(1 downto 0);
  signal queue_interrupt, stop_interrupt, axes_at_rest, end_stops_at_rest : std_ulogic;

  alias clk is master.clk;

begin

  make_clock(master.clk, 20 ns);

  fabric : entity work.bus_interconnect
    generic map (base_addresses => (step_generator_address, end_stops_address, step_pins_address))
    port map (
      clk => clk, reset => resets.processor, request => to_request(master.request),
      to_wires(response) => master.response, slave_requests => requests,
      slave_responses => responses);

  motion : entity work.motion_system
    generic map (axes => 2, queue_depth => 4)
    port map (
      clocks => (others => clk), resets => resets,
      step_generator_request => requests(generator), step_generator_response => responses(generator),
      end_stops_request => requests(switches), end_stops_response => responses(switches),
      step_pins_request => requests(pins), step_pins_response => responses(pins),
      software_stepping => software_stepping, end_stop => end_stop,
      emergency_stop => emergency_stop, motion_start => motion_start, step => step,
      direction => direction, motor_enable => motor_enable, queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt, axes_at_rest => axes_at_rest,
      end_stops_at_rest => end_stops_at_rest);

  test : process

    -- One line of 1000 ticks, with a step of axis 0 in each.
    procedure append(flags : natural) is
    begin
      append_segment(master, 1000, 0, 1000, flags);
    end procedure;

    procedure expect_status(idle, stopped : std_ulogic; what : string) is
      variable word : word_t;
    begin
      read(master, step_generator_status_address, word);
      is_idle : assert word(step_generator_status_idle_bit) = idle report what severity failure;
      is_stopped : assert word(step_generator_status_stopped_bit) = stopped report what severity failure;
    end procedure;

    variable word : word_t;

  begin
    wait_clocks(clk, 4);
    resets <= (others => '0');
    wait_clocks(clk, 20);
    rests : assert axes_at_rest = '1' and end_stops_at_rest = '1' severity failure;

    -- Motors, and a start in common.
    write(master, step_generator_motor_enable_address, 3);
    wait_clocks(clk, 2);
    enables_motors : assert motor_enable = "11" severity failure;
    write(master, step_generator_control_address, 1);
    append(ends_motion + waits + one_backward);
    wait_clocks(clk, 200);
    waits_for_the_start : assert step = "00" severity failure;
    motion_start <= '1';
    wait_clocks(clk, 1);
    is_awake_for_an_input : assert axes_at_rest = '0' severity failure;
    wait until step = "01" for 10 us;
    steps : assert step = "01" and direction = "01" severity failure;
    motion_start <= '0';

    -- The emergency stop.
    emergency_stop <= '1';
    wait_clocks(clk, 6);
    takes_the_current : assert motor_enable = "00" severity failure;
    expect_status('0', '1', "emergency stop");
    emergency_stop <= '0';
    wait_clocks(clk, 200);
    makes_no_step : assert step = "00" severity failure;
    write(master, step_generator_command_address, acknowledge_command);
    write(master, step_generator_motor_enable_address, 3);
    expect_status('1', '0', "acknowledged");

    -- End stop 5 ends a segment with its bit in the mask, and is in the register.
    write(master, end_stops_filter_address, 0);
    write(master, end_stops_enable_address, 16#20#);
    append(ends_motion + one_backward + 2 ** 5 * one_of_mask);
    wait_clocks(clk, 100);
    expect_status('0', '0', "moves");
    end_stop <= x"DF";
    wait_clocks(clk, 20);
    expect_status('0', '0', "other end stops");
    end_stop <= x"20";
    wait_clocks(clk, 20);
    read(master, end_stops_status_address, word);
    shows_the_switch : assert word(5) = '1' severity failure;
    wait_clocks(clk, 200);
    expect_status('1', '1', "the end stop of the mask");
    end_stop <= x"00";
    write(master, step_generator_command_address, acknowledge_command);

    -- Interrupts: of a queue with room, of a stop.
    write(master, step_generator_control_address, 7);
    wait_clocks(clk, 3);
    asks_for_segments : assert queue_interrupt = '1' and stop_interrupt = '0' severity failure;
    write(master, step_generator_command_address, stop_command);
    wait_clocks(clk, 4);
    reports_a_stop : assert stop_interrupt = '1' severity failure;
    write(master, step_generator_command_address, acknowledge_command);

    -- Software's pins.
    write(master, step_pins_control_address, 1);
    write(master, step_pins_step_address, 2);
    wait_clocks(clk, 4);
    are_the_generators_without_the_strap : assert step = "00" severity failure;
    software_stepping <= '1';
    wait_clocks(clk, 4);
    -- The emergency stop holds for them too.
    write(master, step_pins_stop_address, 1);
    write(master, step_pins_step_address, 0);
    write(master, step_pins_control_address, 1);
    write(master, step_pins_step_address, 2);
    write(master, step_pins_direction_address, 1);
    wait_clocks(clk, 4);
    are_softwares_with_the_strap : assert step = "10" and direction = "01" severity failure;
    std.env.finish;
  end process;

end architecture;
