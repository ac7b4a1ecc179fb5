-- SPDX-License-Identifier: Apache-2.0
-- A channel takes its own limits, duty and clearing from software, and none of another channel.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_channel_tb is
end entity;

architecture simulation of heater_channel_tb is

  constant own : natural := 2;

  constant coldest : positive := 90_000;
  constant hottest : positive := 1_000;
  constant hot : positive := 40_000;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal from_software : heater_control_from_software_t;
  signal clear, tick, emergency_stop : std_ulogic := '0';
  signal watchdog_alive : std_ulogic := '1';
  signal reading : sensor_reading_t := sensor_reading_none;
  signal gate, any_locked : std_ulogic;
  signal minimum_count, maximum_count, hot_count : unsigned(31 downto 0);
  signal settle_ticks : settle_t;
  signal status : heater_control_status_t;

begin

  clk <= not clk after 10 ns;

  heater : entity work.heater_channel
    generic map (channel => own)
    port map (
      clk => clk, reset => reset, tick => tick, slot_start => '1', from_software => from_software,
      clear => clear, least_count => 32x"100", most_count => 32x"100000", longest_settle => 24x"1000",
      watchdog_alive => watchdog_alive, watchdog_violated => '0', reading => reading,
      sensor_timeout_ticks => to_unsigned(50, tick_count_bits), emergency_stop => emergency_stop,
      gate => gate, any_locked => any_locked, minimum_count => minimum_count,
      maximum_count => maximum_count, hot_count => hot_count, settle_ticks => settle_ticks,
      status => status);

  test : process

    -- The register file gives the word of the bus to all registers.
    procedure put(value : natural) is
    begin
      for channel in 0 to 3 loop
        from_software.minimum_count(channel).cycles <= to_unsigned(value, 32);
        from_software.maximum_count(channel).cycles <= to_unsigned(value, 32);
        from_software.hot_count(channel).cycles <= to_unsigned(value, 32);
        from_software.settle(channel).ticks <= to_unsigned(value, 24);
      end loop;
    end procedure;

    procedure write_nothing is
    begin
      from_software.minimum_count_written <= "0000";
      from_software.maximum_count_written <= "0000";
      from_software.hot_count_written <= "0000";
      from_software.settle_written <= "0000";
    end procedure;

    type limit_t is (minimum_limit, maximum_limit, hot_limit, settle_limit);

    procedure set_limit(channel : natural; limit : limit_t) is
    begin
      case limit is
        when minimum_limit =>
          put(hottest);
          from_software.minimum_count_written(channel) <= '1';
        when maximum_limit =>
          put(coldest);
          from_software.maximum_count_written(channel) <= '1';
        when hot_limit =>
          put(hot);
          from_software.hot_count_written(channel) <= '1';
        when settle_limit =>
          put(10);
          from_software.settle_written(channel) <= '1';
      end case;
      wait_clocks(clk, 1);
      write_nothing;
    end procedure;

    procedure set_limits(channel : natural) is
    begin
      for limit in limit_t loop
        set_limit(channel, limit);
      end loop;
      wait_clocks(clk, 1);
    end procedure;

    procedure start_over is
    begin
      reset <= '1';
      wait_clocks(clk, 2);
      reset <= '0';
      wait_clocks(clk, 2);
    end procedure;

    impure function locked return std_ulogic_vector is
    begin
      return status.minimum_locked & status.maximum_locked & status.hot_locked & status.settle_locked;
    end function;

    -- These trips and no others, in the order of the arguments.
    procedure expect_trips(trips : std_ulogic_vector(0 to 7); what : string) is
      variable shown : std_ulogic_vector(0 to 7);
    begin
      shown := status.watchdog_trip & status.sensor_invalid_trip & status.sensor_stale_trip &
        status.too_hot_trip & status.too_cold_trip & status.limits_missing_trip &
        status.emergency_stop_trip & status.heats_unasked_trip;
      shows_its_cause_alone : assert shown = trips and status.tripped = (or trips)
        report what & ": " & to_string(shown) severity failure;
    end procedure;

    procedure convert(count : natural) is
    begin
      reading <= (updated => '1', valid => '1', count => to_unsigned(count, 32));
      wait_clocks(clk, 1);
      reading.updated <= '0';
      wait_clocks(clk, 3);
    end procedure;

    procedure pass(ticks : positive) is
    begin
      for i in 1 to ticks loop
        tick <= '1';
        wait_clocks(clk, 1);
        tick <= '0';
        wait_clocks(clk, 1);
      end loop;
    end procedure;

    procedure clear_trips(channel : natural) is
    begin
      from_software.clear.channels <= (others => '0');
      from_software.clear.channels(channel) <= '1';
      clear <= '1';
      wait_clocks(clk, 1);
      clear <= '0';
      wait_clocks(clk, 2);
    end procedure;

    procedure ask(channel : natural; density : natural) is
    begin
      from_software.duty(channel).density <= to_unsigned(density, 16);
      wait_clocks(clk, 3);
    end procedure;

    procedure expect_gate(level : std_ulogic; what : string) is
    begin
      is_as_expected : assert gate = level and status.gate = level report what severity failure;
    end procedure;

  begin
    write_nothing;
    put(0);
    for channel in 0 to 3 loop
      from_software.duty(channel).density <= (others => '0');
    end loop;
    from_software.clear.channels <= (others => '0');
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 2);

    for channel in 0 to 3 loop
      if channel /= own then
        set_limits(channel);
        takes_only_its_own_limits : assert any_locked = '0' and status.refused = '0' severity failure;
      end if;
    end loop;

    -- One limit locks the scale in which it is counted; all must be set before it may heat.
    for limit in limit_t loop
      start_over;
      set_limit(own, limit);
      wait_clocks(clk, 1);
      one_limit_locks : assert any_locked = '1'
        and locked = std_ulogic_vector(shift_right(to_unsigned(8, 4), limit_t'pos(limit)))
        report limit_t'image(limit) & " locks " & to_string(locked) severity failure;
      start_over;
      for other in limit_t loop
        if other /= limit then
          set_limit(own, other);
        end if;
      end loop;
      wait_clocks(clk, 1);
      reading <= (updated => '1', valid => '1', count => to_unsigned(50_000, 32));
      wait_clocks(clk, 1);
      reading.updated <= '0';
      from_software.duty(own).density <= to_unsigned(65535, 16);
      wait_clocks(clk, 3);
      does_not_heat_without : assert
        gate = '0' and status.permitted = '0' and status.limits_missing_trip = '1'
        report limit_t'image(limit) severity failure;
      from_software.duty(own).density <= (others => '0');
    end loop;
    start_over;
    set_limit(own, minimum_limit);
    set_limits(own);
    the_second_write_is_refused : assert status.refused = '1' severity failure;
    limits_are_what_was_written : assert minimum_count = hottest and maximum_count = coldest
      and hot_count = hot and settle_ticks = 10 severity failure;

    convert(50_000);
    is_permitted : assert status.permitted = '1' severity failure;
    for channel in 0 to 3 loop
      if channel /= own then
        ask(channel, 65535);
        expect_gate('0', "another channel's duty");
      end if;
    end loop;
    ask(own, 65535);
    expect_gate('1', "own duty");

    convert(hottest - 1);
    expect_gate('0', "too hot");
    expect_trips("00010000", "too hot");
    convert(50_000);
    ask(own, 0);
    clear_trips(0);
    stays_until_its_own_clearing : assert status.tripped = '1' severity failure;
    clear_trips(own);
    expect_trips("00000000", "cleared");
    is_cleared : assert status.refused = '0' severity failure;

    ask(own, 65535);
    convert(coldest + 1);
    expect_trips("00001000", "too cold");
    convert(50_000);
    ask(own, 0);
    clear_trips(own);
    ask(own, 65535);
    reading <= (updated => '1', valid => '0', count => to_unsigned(50_000, 32));
    wait_clocks(clk, 1);
    reading.updated <= '0';
    wait_clocks(clk, 3);
    expect_trips("00000000", "one invalid conversion");
    pass(60);
    expect_trips("01000000", "invalid");
    convert(50_000);
    ask(own, 0);
    clear_trips(own);
    ask(own, 65535);
    pass(60);
    expect_trips("00100000", "no reading");
    convert(50_000);
    ask(own, 0);
    clear_trips(own);

    -- With the gate closed for the settling time the count falls by more than an eighth.
    pass(20);
    convert(50_000);
    convert(30_000);
    expect_trips("00000001", "unasked heat");
    clear_trips(own);

    emergency_stop <= '1';
    wait_clocks(clk, 2);
    emergency_stop <= '0';
    expect_trips("00000010", "emergency stop");
    clear_trips(own);
    watchdog_alive <= '0';
    ask(own, 1);
    expect_trips("10000000", "watchdog");
    reset <= '1';
    wait_clocks(clk, 2);
    reset_forgets : assert any_locked = '0' and status.tripped = '0' severity failure;
    finish;
  end process;

end architecture;
