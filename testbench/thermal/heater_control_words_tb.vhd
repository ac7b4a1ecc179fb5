-- SPDX-License-Identifier: Apache-2.0
-- Every limit, status bit and trip of each channel leads to its own place, ticks are 1024 clocks, and a
-- second heater control, which gets no edge that may be left out, does the same.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_words_tb is
end entity;

architecture simulation of heater_control_words_tb is

  constant clock_frequency_hz : positive := 4_000_000;
  constant clock_period : time := 250 ns;
  -- As the register description says.
  constant tick_cycles : positive := 1024;
  constant conversion : positive := 300;
  constant watchdog_ticks : positive := 5;
  constant sensor_ticks : positive := 2;

  constant feed : natural := 0;
  constant watchdog : natural := 4;
  constant sensor_timeout : natural := 8;
  constant slot : natural := 12;
  constant clear : natural := 16;
  constant duty : natural := 20;
  constant minimum_count : natural := 36;
  constant maximum_count : natural := 52;
  constant status : natural := 68;
  constant hot_count : natural := 84;
  constant settle : natural := 100;
  constant supply_register : natural := 116;

  type outputs_t is record
    gates : std_ulogic_vector(1 downto 0);
    supply, interrupt, limits_locked : std_ulogic;
    response : bus_response_t;
  end record;

  type counts_t is array (0 to 1) of natural;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal made, rested : outputs_t;
  signal readings : sensor_reading_array_t(0 to 1) := (others => sensor_reading_none);
  signal emergency_stop, veto : std_ulogic := '0';
  signal counts : counts_t := (5_000, 5_000);
  signal sensor_works, sensor_is_valid : std_ulogic_vector(0 to 1) := "11";

  signal resting_clk, resting_bus_clk, at_rest : std_ulogic := '0';
  signal edge_is_left_out, bus_edge_is_left_out : std_ulogic := '0';
  signal pins_before : std_ulogic_vector(1 downto 0) := "00";
  signal clocks_left_out, clocks_run, gate_0_closed_at : natural := 0;

begin

  -- All in one moment, as from one clock tree.
  make_clocks : process
  begin
    wait for clock_period / 2;
    clk <= '1';
    resting_clk <= not edge_is_left_out;
    resting_bus_clk <= not bus_edge_is_left_out;
    wait for clock_period / 2;
    clk <= '0';
    resting_clk <= '0';
    resting_bus_clk <= '0';
  end process;

  control : entity work.heater_control
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => made.response, readings => readings,
      more_charges => to_unsigned(15, 8), limits_locked => made.limits_locked,
      emergency_stop => emergency_stop, veto => veto, gates => made.gates, supply => made.supply,
      interrupt => made.interrupt, at_rest => open);

  resting_control : entity work.heater_control
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk,
      clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
      request => request, response => rested.response, readings => readings,
      more_charges => to_unsigned(15, 8), limits_locked => rested.limits_locked,
      emergency_stop => emergency_stop, veto => veto, gates => rested.gates, supply => rested.supply,
      interrupt => rested.interrupt, at_rest => at_rest);

  leave_out_edges : process
    constant access_clocks : positive := 4;
    variable clocks_without_access : natural := 0;
  begin
    wait until rising_edge(clk);
    pins_before <= emergency_stop & veto;
    clocks_without_access := 0 when (request.strobe or reset) = '1' else clocks_without_access + 1;
    wait until falling_edge(clk);
    wait for clock_period / 4;
    edge_is_left_out <= '0';
    if at_rest = '1' and pins_before = (emergency_stop & veto) then
      edge_is_left_out <= '1';
      clocks_left_out <= clocks_left_out + 1;
    end if;
    bus_edge_is_left_out <= '1' when clocks_without_access > access_clocks and request.strobe = '0'
      and reset = '0' else '0';
  end process;

  compare : process
  begin
    wait until falling_edge(clk);
    assert rested = made report "a rest has changed something" severity failure;
  end process;

  -- Channel 1 half a conversion after channel 0.
  convert : process
  begin
    for channel in 0 to 1 loop
      for i in 1 to conversion / 2 loop
        wait until rising_edge(clk);
      end loop;
      if sensor_works(channel) then
        readings(channel) <= (
          updated => '1', valid => sensor_is_valid(channel), count => to_unsigned(counts(channel), 32));
        wait until rising_edge(clk);
        readings(channel).updated <= '0';
      end if;
    end loop;
  end process;

  watch_gate : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    clocks_run <= clocks_run + 1;
    if before = '1' and made.gates(0) = '0' then
      gate_0_closed_at <= clocks_run;
    end if;
    before := made.gates(0);
  end process;

  test : process
    type limits_t is array (0 to 3) of natural;
    constant limits : limits_t := (minimum_count, maximum_count, hot_count, settle);
    variable word : word_t;
    variable closed_before : natural;

    procedure write(offset : natural; value : natural; channel : natural := 0) is
    begin
      bus_write(clk, request, made.response, heater_control_address + offset + 4 * channel, value);
    end procedure;

    procedure expect(offset : natural; value : word_t; channel : natural := 0) is
    begin
      bus_read(clk, request, made.response, heater_control_address + offset + 4 * channel, word);
      assert word = value report "register " & to_string(offset) & " of channel " &
        to_string(channel) & " is " & to_hstring(word) & " instead of " & to_hstring(value) severity failure;
    end procedure;

    procedure expect(offset : natural; value : natural; channel : natural := 0) is
    begin
      expect(offset, word_t(to_unsigned(value, 32)), channel);
    end procedure;

    procedure clocks(count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
      wait for 1 ns;
    end procedure;

    procedure feed_it is
    begin
      write(feed, heater_control_feed_key_first);
      write(feed, heater_control_feed_key_second);
    end procedure;

    procedure clear_trips is
    begin
      bus_write(clk, request, made.response, heater_control_address + clear,
        word_t(shift_left(to_unsigned(heater_control_clear_key_clear_trips, 32), 16) or
          to_unsigned(3, 32)));
      clocks(3);
    end procedure;

    procedure lock(offset : natural; channel : natural) is
    begin
      case offset is
        when minimum_count => write(offset, 1_000 + channel, channel);
        when maximum_count => write(offset, 9_000 + channel, channel);
        when hot_count => write(offset, 4_000 + channel, channel);
        when others => write(offset, 200 + channel, channel);
      end case;
    end procedure;

    procedure start_over is
    begin
      reset <= '1';
      clocks(3);
      reset <= '0';
      clocks(4);
      write(watchdog, watchdog_ticks);
      write(sensor_timeout, sensor_ticks);
      write(slot, 100);
      clocks(conversion);
      feed_it;
      clocks(4);
    end procedure;

    -- Heats with one channel, and this cause closes its gate; the other one knows nothing of it.
    procedure heat(channel : natural) is
    begin
      clocks(2 * conversion);
      clear_trips;
      feed_it;
      clocks(4);
      write(duty, 65_535, channel);
      clocks(110);
      expect(status, x"0000003F", channel);
      assert made.gates(channel) = '1' and made.gates(1 - channel) = '0'
        report "gates " & to_string(made.gates) severity failure;
      expect(status, x"0000003E", 1 - channel);
    end procedure;

    procedure expect_trip(bit_number : natural; channel : natural) is
    begin
      assert made.gates = "00" and made.interrupt = '1' severity failure;
      bus_read(clk, request, made.response, heater_control_address + status + 4 * channel, word);
      assert unsigned(word(15 downto 8)) = 2 ** (bit_number - 8) and word(7) = '1'
        report "status " & to_hstring(word) & " instead of bit " & to_string(bit_number) severity failure;
      bus_read(
        clk, request, made.response, heater_control_address + status + 4 * (1 - channel), word);
      assert word(15 downto 7) = "000000000" report "the other channel: " & to_hstring(word) severity failure;
      write(duty, 0, channel);
    end procedure;
  begin
    -- A channel heats with all of its four limits, and with no three of them, whatever the other has.
    for channel in 0 to 1 loop
      for missing in 0 to 4 loop
        start_over;
        for limit in 0 to 3 loop
          lock(limits(limit), 1 - channel);
          if limit /= missing then
            lock(limits(limit), channel);
          end if;
        end loop;
        write(duty, 65_535, channel);
        clocks(110);
        if missing < 4 then
          expect_trip(13, channel);
        else
          assert made.gates = std_ulogic_vector(to_unsigned(channel + 1, 2)) severity failure;
        end if;
      end loop;
    end loop;
    expect(minimum_count, 1_000);
    expect(minimum_count, 1_001, 1);
    expect(maximum_count, 9_000);
    expect(maximum_count, 9_001, 1);
    expect(hot_count, 4_000);
    expect(hot_count, 4_001, 1);
    expect(settle, 200);
    expect(settle, 201, 1);
    expect(watchdog, watchdog_ticks);
    expect(sensor_timeout, sensor_ticks);
    -- A channel that is not there has no limits, and nothing to say.
    for channel in 2 to 3 loop
      expect(minimum_count, x"FFFFFFFF", channel);
      expect(maximum_count, 0, channel);
      expect(hot_count, 0, channel);
      expect(settle, 16#FFFFFF#, channel);
      expect(status, 0, channel);
    end loop;

    for channel in 0 to 1 loop
      -- Each cause has its own bit, and is the one of the channel's own sensor.
      write(duty, 0, 1 - channel);
      write(duty, 0, channel);
      heat(channel);
      counts(channel) <= 999;
      clocks(conversion + 10);
      expect_trip(11, channel);
      counts(channel) <= 5_000;
      heat(channel);
      counts(channel) <= 9_002;
      clocks(conversion + 10);
      expect_trip(12, channel);
      counts(channel) <= 5_000;
      heat(channel);
      sensor_is_valid(channel) <= '0';
      clocks(conversion + 10);
      assert made.gates = "00" severity failure;
      feed_it;
      clocks(3 * tick_cycles);
      expect_trip(9, channel);
      sensor_is_valid(channel) <= '1';
      heat(channel);
      sensor_works(channel) <= '0';
      clocks(3 * tick_cycles);
      expect_trip(10, channel);
      sensor_works(channel) <= '1';
      -- At rest only what is too hot.
      clocks(2 * conversion);
      clear_trips;
      feed_it;
      counts(channel) <= 9_002;
      clocks(2 * conversion);
      assert made.interrupt = '0' report "trips at rest" severity failure;
      counts(channel) <= 999;
      clocks(2 * conversion);
      expect_trip(11, channel);
      counts(channel) <= 5_000;
      -- Its watchdog, and a tick of so many clocks: two gates are closed so many ticks apart.
      heat(channel);
      clocks(watchdog_ticks * tick_cycles);
      expect_trip(8, channel);
      if channel = 0 then
        closed_before := gate_0_closed_at;
        heat(0);
        clocks(watchdog_ticks * tick_cycles);
        expect_trip(8, 0);
        assert (gate_0_closed_at - closed_before) mod tick_cycles = 0 and gate_0_closed_at /= closed_before
          report to_string(gate_0_closed_at - closed_before) & " clocks between two ticks" severity failure;
      end if;
    end loop;

    -- A pin changes at rest.
    clear_trips;
    feed_it;
    clocks(3);
    bus_write(clk, request, made.response, heater_control_address + supply_register,
      word_t(shift_left(to_unsigned(heater_control_supply_key_close, 32), 16)));
    wait until rising_edge(clk) and at_rest = '1';
    assert made.supply = '1' report "the supply is open" severity failure;
    -- A key that is none of the two does nothing.
    write(supply_register, 0);
    bus_write(clk, request, made.response, heater_control_address + supply_register, x"FFFF0000");
    wait until rising_edge(clk) and at_rest = '1';
    assert made.supply = '1' report "opened by a wrong key" severity failure;
    veto <= '1';
    clocks(8);
    assert made.supply = '0' and made.interrupt = '1' report "no veto at rest" severity failure;
    veto <= '0';
    clocks(8);
    bus_write(clk, request, made.response, heater_control_address + supply_register,
      word_t(shift_left(to_unsigned(heater_control_supply_key_close, 32), 16)));
    wait until rising_edge(clk) and at_rest = '1';
    assert made.supply = '1' and made.interrupt = '0' report "the supply is open" severity failure;
    emergency_stop <= '1';
    clocks(8);
    assert made.supply = '0' and made.interrupt = '1' report "no emergency stop at rest" severity failure;
    emergency_stop <= '0';
    expect(status, x"000040BC", 0);
    expect(status, x"000040BC", 1);
    assert clocks_left_out > 1_000 report to_string(clocks_left_out) & " clocks left out" severity failure;
    finish;
  end process;

end architecture;
