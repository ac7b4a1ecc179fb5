-- SPDX-License-Identifier: Apache-2.0
-- What step_generator.vhd adds to its core: both words of a time beyond 2^32 clocks, threshold and
-- highest level of the queue, the rate floor, drivers that stay on until the last pulse has ended,
-- an emergency at rest, and interrupts that a reset withdraws. A second generator with gated clocks
-- does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_face_tb is
end entity;

architecture simulation of step_generator_face_tb is

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : generator_inputs_t := generator_inputs_none;
  signal outputs : generator_outputs_t;
  signal clocks_left_out : natural;

  alias clk is master.clk;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => 4)
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      clocks_run => open, clocks_left_out => clocks_left_out);

  test : process
    alias snapshot_time is << signal .step_generator_face_tb.twins.generator.snapshot_time : time_t >>;
    alias stop_time is << signal .step_generator_face_tb.twins.generator.stop_time : time_t >>;
    alias rested_snapshot_time is
      << signal .step_generator_face_tb.twins.resting_generator.snapshot_time : time_t >>;
    alias rested_stop_time is
      << signal .step_generator_face_tb.twins.resting_generator.stop_time : time_t >>;
    constant one_time : time_t := x"0123456789ABCDEF";
    constant other_time : time_t := x"FEDCBA9876543210";
    variable word : word_t;
    variable status : step_generator_status_t;
    variable refused_at_level_0 : natural := 0;
    variable left_out_before : natural;
  begin
    wait_clocks(clk, 2);
    reset <= '0';
    wait_clocks(clk, 2);

    -- 2^32 clocks take too long to simulate, so the core's times are forced.
    snapshot_time <= force one_time;
    rested_snapshot_time <= force one_time;
    stop_time <= force other_time;
    rested_stop_time <= force other_time;
    expect(master, step_generator_snapshot_time_low_address, x"89ABCDEF");
    expect(master, step_generator_snapshot_time_high_address, x"01234567");
    expect(master, step_generator_stop_time_low_address, x"76543210");
    expect(master, step_generator_stop_time_high_address, x"FEDCBA98");
    snapshot_time <= release;
    rested_snapshot_time <= release;
    stop_time <= release;
    rested_stop_time <= release;

    -- The queue asks for more at the threshold that software sets, and keeps its highest level; axes that are
    -- not there read as 0.
    write(master, step_generator_motor_enable_address, 3);
    write(master, step_generator_control_address, 2 * one_of_threshold + both_interrupts);
    for level in 1 to 3 loop
      append_segment(master, 1, 1, 8);
      wait_clocks(clk, 2);
      assert (outputs.queue_interrupt = '1') = (level <= 2) severity failure;
    end loop;
    write(master, step_generator_command_address, flush_command);
    expect(master, step_generator_status_address, 4 * one_free + idle_status);
    expect(master, step_generator_max_level_address, 3);
    expect(master, step_generator_position_address + 4 * (axis_limit - 1), 0);
    expect(master, step_generator_snapshot_position_address + 4 * (axis_limit - 1), 0);
    expect(master, step_generator_stop_position_address + 4 * (axis_limit - 1), 0);
    expect(master, step_generator_axis_stalls_address + 4 * (axis_limit - 1), 0);

    -- Eight ticks at the floor of 1/16 tick per clock, where the segment has a rate of 0.
    write(master, step_generator_rate_floor_address, 2 ** 28);
    write(master, step_generator_control_address, run + both_interrupts);
    append_segment(master, 1, 0, 8, rate_high => 0);
    wait until outputs.moving = '1' for 1 us;
    wait until outputs.moving = '0' for 3 us;
    assert outputs.moving = '0' report "slower than the rate floor" severity failure;
    wait_until_idle(clk, outputs.idle);

    -- The queue is empty long before the last pulse has ended, and its driver stays on until then.
    write(master, step_generator_pulse_guard_address, pulse_guard(high => 200, low => 200));
    append_segment(master, 1, 0, 8);
    wait until outputs.moving = '1' for 1 us;
    loop
      read(master, step_generator_status_address, word);
      status := to_step_generator_status(word);
      exit when not status.moving;
      write(master, step_generator_motor_enable_address, 0);
      if outputs.moving then
        assert outputs.enable = "11" report "a driver goes off in motion" severity failure;
        expect_error(master, step_generator_errors_settings_bit);
        if status.level = 0 then
          refused_at_level_0 := refused_at_level_0 + 1;
        end if;
      end if;
    end loop;
    assert refused_at_level_0 > 5 report to_string(refused_at_level_0) severity failure;

    -- An emergency of one clock ends the rest of a generator that has stopped already.
    write(master, step_generator_motor_enable_address, 3);
    write(master, step_generator_command_address, stop_command);
    left_out_before := clocks_left_out;
    wait_clocks(clk, 600);
    assert clocks_left_out > left_out_before and outputs.enable = "11" severity failure;
    inputs.emergency_stop <= '1';
    wait_clocks(clk, 1);
    inputs.emergency_stop <= '0';
    wait_clocks(clk, 20);
    assert outputs.enable = "00" severity failure;
    read(master, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.positions_lost severity failure;

    -- A reset withdraws both interrupts in its first clock.
    write(master, step_generator_command_address, stop_command);
    wait_clocks(clk, 3);
    assert outputs.queue_interrupt = '1' and outputs.stop_interrupt = '1' severity failure;
    reset <= '1';
    wait_clocks(clk, 1);
    wait for 1 ns;
    assert outputs.queue_interrupt = '0' and outputs.stop_interrupt = '0' severity failure;

    finish;
  end process;

end architecture;
