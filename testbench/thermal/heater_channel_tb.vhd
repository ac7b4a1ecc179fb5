-- SPDX-License-Identifier: Apache-2.0
-- A channel takes its own limits, duty and clearing from software, and none of another channel.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

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

    procedure clocks(number : positive) is
    begin
      for i in 1 to number loop
        wait until rising_edge(clk);
      end loop;
      wait for 1 ns;
    end procedure;

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

    procedure set_limits(channel : natural) is
    begin
      put(hottest);
      from_software.minimum_count_written(channel) <= '1';
      clocks(1);
      write_nothing;
      put(coldest);
      from_software.maximum_count_written(channel) <= '1';
      clocks(1);
      write_nothing;
      put(hot);
      from_software.hot_count_written(channel) <= '1';
      clocks(1);
      write_nothing;
      put(10);
      from_software.settle_written(channel) <= '1';
      clocks(1);
      write_nothing;
      clocks(1);
    end procedure;

    procedure convert(count : natural) is
    begin
      reading <= (updated => '1', valid => '1', count => to_unsigned(count, 32));
      clocks(1);
      reading.updated <= '0';
      clocks(3);
    end procedure;

    procedure clear_trips(channel : natural) is
    begin
      from_software.clear.channels <= (others => '0');
      from_software.clear.channels(channel) <= '1';
      clear <= '1';
      clocks(1);
      clear <= '0';
      clocks(2);
    end procedure;

    procedure ask(channel : natural; density : natural) is
    begin
      from_software.duty(channel).density <= to_unsigned(density, 16);
      clocks(3);
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
    clocks(3);
    reset <= '0';
    clocks(2);

    for channel in 0 to 3 loop
      if channel /= own then
        set_limits(channel);
        takes_only_its_own_limits : assert any_locked = '0' and status.refused = '0' severity failure;
      end if;
    end loop;
    put(hottest);
    from_software.minimum_count_written(own) <= '1';
    clocks(1);
    write_nothing;
    one_limit_locks : assert any_locked = '1' and status.minimum_locked = '1' severity failure;
    limits_are_not_complete : assert status.maximum_locked = '0' and status.permitted = '0' severity failure;
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
    shows_it : assert status.too_hot_trip = '1' and status.tripped = '1' severity failure;
    convert(50_000);
    ask(own, 0);
    clear_trips(0);
    stays_until_its_own_clearing : assert status.tripped = '1' severity failure;
    clear_trips(own);
    is_cleared : assert status.tripped = '0' and status.refused = '0' severity failure;

    -- With the gate closed for the settling time the count falls by more than an eighth.
    for i in 1 to 20 loop
      tick <= '1';
      clocks(1);
      tick <= '0';
      clocks(1);
    end loop;
    convert(50_000);
    convert(30_000);
    unasked_heat_is_found : assert status.heats_unasked_trip = '1' severity failure;
    clear_trips(own);

    emergency_stop <= '1';
    clocks(2);
    emergency_stop <= '0';
    stops : assert status.emergency_stop_trip = '1' severity failure;
    clear_trips(own);
    watchdog_alive <= '0';
    ask(own, 1);
    the_watchdog_trips : assert status.watchdog_trip = '1' severity failure;
    reset <= '1';
    clocks(2);
    reset_forgets : assert any_locked = '0' and status.tripped = '0' severity failure;
    finish;
  end process;

end architecture;
