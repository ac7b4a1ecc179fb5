-- SPDX-License-Identifier: Apache-2.0
-- What the step generator's face adds to its core: both words of a time beyond 2^32 clocks, drivers that stay on
-- until the last pulse has ended, an emergency at rest, and interrupts that a reset withdraws. A second
-- generator, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_generator_bench_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_face_tb is
end entity;

architecture simulation of step_generator_face_tb is

  constant axes : positive := 2;

  signal clk : std_ulogic;
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal step, direction, enable : std_ulogic_vector(axes - 1 downto 0);
  signal moving, idle, queue_interrupt, stop_interrupt : std_ulogic;
  signal emergency_stop : std_ulogic := '0';
  signal clocks_left_out : natural;

begin

  twins : entity work.step_generator_twins
    generic map (queue_depth => 4)
    port map (
      clk => clk, reset => reset, request => request, response => response, end_stops => x"00",
      emergency_stop => emergency_stop, start => '0', step => step, direction => direction,
      enable => enable, moving => moving, idle => idle, queue_interrupt => queue_interrupt,
      stop_interrupt => stop_interrupt, clocks_run => open, clocks_left_out => clocks_left_out);

  test : process
    alias snapshot_time is << signal .step_generator_face_tb.twins.generator.snapshot_time : time_t >>;
    alias stop_time is << signal .step_generator_face_tb.twins.generator.stop_time : time_t >>;
    alias rested_snapshot_time is
      << signal .step_generator_face_tb.twins.resting_generator.snapshot_time : time_t >>;
    alias rested_stop_time is
      << signal .step_generator_face_tb.twins.resting_generator.stop_time : time_t >>;
    variable word : word_t;
    variable status : step_generator_status_t;
    variable refused_at_level_0 : natural := 0;
    variable rested_before : natural;

    procedure write(address : unsigned(31 downto 0); data : natural) is
    begin
      bus_write(clk, request, response, address, data);
    end procedure;

    procedure expect(address : unsigned(31 downto 0); data : word_t) is
    begin
      bus_expect(clk, request, response, address, data);
    end procedure;
  begin
    wait_clocks(clk, 2);
    reset <= '0';
    wait_clocks(clk, 2);

    -- Nobody can simulate 2^32 clocks: the core's times are given.
    snapshot_time <= force x"0123456789ABCDEF";
    rested_snapshot_time <= force x"0123456789ABCDEF";
    stop_time <= force x"FEDCBA9876543210";
    rested_stop_time <= force x"FEDCBA9876543210";
    expect(step_generator_snapshot_time_low_address, x"89ABCDEF");
    expect(step_generator_snapshot_time_high_address, x"01234567");
    expect(step_generator_stop_time_low_address, x"76543210");
    expect(step_generator_stop_time_high_address, x"FEDCBA98");
    snapshot_time <= release;
    rested_snapshot_time <= release;
    stop_time <= release;
    rested_stop_time <= release;

    -- The queue is empty long before the last pulse has ended, and its driver stays on until then.
    write(step_generator_pulse_guard_address, pulse_guard(high => 200, low => 200));
    write(step_generator_motor_enable_address, 3);
    write(step_generator_control_address, run + both_interrupts);
    write_segment(clk, request, response, 1, 0, 8, ends_motion);
    write(step_generator_segment_commit_address, 0);
    wait until moving = '1' for 1 us;
    loop
      bus_read(clk, request, response, step_generator_status_address, word);
      status := to_step_generator_status(word);
      exit when not status.moving;
      write(step_generator_motor_enable_address, 0);
      if moving then
        assert enable = "11" report "a driver goes off in motion" severity failure;
        expect_error(clk, request, response, step_generator_errors_settings_bit);
        if status.level = 0 then
          refused_at_level_0 := refused_at_level_0 + 1;
        end if;
      end if;
    end loop;
    assert refused_at_level_0 > 5 report to_string(refused_at_level_0) severity failure;

    -- An emergency of one clock ends the rest of a generator that has stopped already.
    write(step_generator_motor_enable_address, 3);
    write(step_generator_command_address, stop_command);
    rested_before := clocks_left_out;
    wait_clocks(clk, 600);
    assert clocks_left_out > rested_before severity failure;
    assert enable = "11" severity failure;
    emergency_stop <= '1';
    wait_clocks(clk, 1);
    emergency_stop <= '0';
    wait_clocks(clk, 20);
    assert enable = "00" severity failure;
    bus_read(clk, request, response, step_generator_status_address, word);
    status := to_step_generator_status(word);
    assert status.positions_lost severity failure;

    -- A reset withdraws both interrupts in its first clock.
    assert queue_interrupt = '1' and stop_interrupt = '1' severity failure;
    reset <= '1';
    wait_clocks(clk, 1);
    wait for 1 ns;
    assert queue_interrupt = '0' and stop_interrupt = '0' severity failure;

    finish;
  end process;

end architecture;
