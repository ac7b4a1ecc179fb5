-- SPDX-License-Identifier: Apache-2.0
-- Heater control: one guarded gate per heater, their common supply, a watchdog over the software, limits that
-- lock. Heater n is guarded by sensor n. All of it works with the processor hung.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control is
  generic (
    -- Heaters, each with its sensor.
    channels : positive range 1 to 4 := 2;
    -- Watchdog and sensor time-out after reset.
    default_timeout_s : positive range 1 to 5 := 1;
    -- Software cannot make them longer than this.
    maximum_timeout_s : positive range 1 to 5 := 3;
    -- Shortest charge, in 2^-20 s, that a cut-off may request: 3.8 us, where the hottest machine at 300
    -- degrees (169 Ohm with the pin, 68 nF) has 8.0 us with nominal parts and 5.1 with the worst.
    least_charge : positive range 1 to 64 := 4;
    -- Software cannot make a settling time longer than this.
    maximum_settle_s : positive range 1 to 150 := 120
  );
  port (
    -- May be gated while `at_rest` is high, except for the edge after a change of `emergency_stop`.
    clk : in std_ulogic;
    -- The same clock, never gated.
    always_clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    -- Of `clk`: a constant on a board, chosen for each run in co-simulation.
    clock_frequency_hz : in unsigned(31 downto 0);
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- From the temperature converter.
    readings : in sensor_reading_array_t(0 to channels - 1);
    -- Charges of a conversion, less one: the scale of the counts. Stays while `limits_locked`.
    more_charges : in unsigned(7 downto 0);
    -- Some limit of some channel is set.
    limits_locked : out std_ulogic;
    -- Closes all gates and trips all channels. Asynchronous.
    emergency_stop : in std_ulogic;
    -- Veto on the supply from outside the chip, for example by a clock watch. Asynchronous.
    veto : in std_ulogic;
    gates : out std_ulogic_vector(channels - 1 downto 0);
    -- The heaters' power is on: a relay or contactor in front of all gates.
    supply : out std_ulogic;
    -- A trip is latched on some channel, or something has opened the supply.
    interrupt : out std_ulogic := '0';
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of heater_control is

  signal ticks_per_s : tick_count_t;

  signal from_software : heater_control_from_software_t;
  signal to_software : heater_control_to_software_t;

  signal tick, slot_start, time_alarm : std_ulogic;
  signal watchdog_timeout, sensor_timeout : tick_count_t;
  signal watchdog_alive, watchdog_violated : std_ulogic;
  signal first_key, second_key : std_ulogic;

  -- Bounds of the limits for the present number of charges, a clock after it.
  signal least_of_one, most_of_one, least_count, most_count : unsigned(31 downto 0);
  -- Of all charges but one.
  signal least_of_more, most_of_more : unsigned(31 downto 0) := (others => '0');
  signal longest_settle : settle_t;
  signal any_locked : std_ulogic_vector(channels - 1 downto 0);

  signal close_supply, open_supply, all_at_rest : std_ulogic;
  signal trip_opened, watchdog_opened, emergency_stop_opened, veto_opened : std_ulogic;

  signal clear : std_ulogic;
  signal emergency_stop_synchronized, veto_synchronized, pins_settling : std_ulogic;
  signal reading_comes, alarm : std_ulogic;
  signal tripped : std_ulogic_vector(channels - 1 downto 0);

begin

  -- At most 100 MHz, so 5 s fit into a tick count.
  ticks_per_s <= resize(clock_frequency_hz / tick_cycles, tick_count_bits);

  timing : entity work.heater_timing
    port map (
      clk => clk,
      always_clk => always_clk,
      bus_clk => bus_clk,
      reset => reset,
      slot_cycles => from_software.slot.cycles,
      tick => tick,
      slot_start => slot_start,
      alarm => time_alarm);

  note_readings : process (all)
  begin
    reading_comes <= '0';
    for channel in readings'range loop
      if readings(channel).updated then
        reading_comes <= '1';
      end if;
    end loop;
  end process;

  alarm <= time_alarm or reading_comes or pins_settling;

  -- A tick may let the watchdog expire, which trips a channel, which interrupts.
  watch_rest : entity work.rest_watch
    generic map (settling_clocks => 9)
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset,
      strobe => request.strobe,
      working => '0',
      alarm => alarm,
      at_rest => at_rest);

  first_key <= '1' when from_software.feed.key = heater_control_feed_key_first else '0';
  second_key <= '1' when from_software.feed.key = heater_control_feed_key_second else '0';

  clear <= '1' when from_software.clear_written = '1'
    and from_software.clear.key = heater_control_clear_key_clear_trips else '0';

  timeouts : entity work.heater_timeouts
    generic map (default_timeout_s => default_timeout_s, maximum_timeout_s => maximum_timeout_s)
    port map (
      clk => clk,
      reset => reset,
      ticks_per_s => ticks_per_s,
      from_software => from_software,
      watchdog_timeout => watchdog_timeout,
      sensor_timeout => sensor_timeout);

  watch_software : entity work.feed_watchdog
    port map (
      clk => clk,
      reset => reset,
      tick => tick,
      timeout_ticks => watchdog_timeout,
      fed => from_software.feed_written,
      first_key => first_key,
      second_key => second_key,
      alive => watchdog_alive,
      violated => watchdog_violated);

  -- A change of settings is two clocks older than the next write to a limit, and none comes in its clock.
  -- The multipliers of an FPGA are slow: nothing is added up before them.
  least_of_one <= resize(
    resize(shift_right(clock_frequency_hz * to_unsigned(least_charge, 7), 20), 14), 32);
  most_of_one <= resize(clock_frequency_hz(26 downto 4), 32);
  least_count <= least_of_more + least_of_one;
  most_count <= most_of_more + most_of_one;
  find_bounds : process
  begin
    wait until rising_edge(clk);
    least_of_more <= resize(least_of_one(13 downto 0) * more_charges, 32);
    most_of_more <= resize(most_of_one(22 downto 0) * more_charges, 32);
    longest_settle <= resize(ticks_per_s * maximum_settle_s, longest_settle'length);
  end process;

  limits_locked <= or any_locked;

  to_software.watchdog.ticks <= watchdog_timeout;
  to_software.sensor_timeout.ticks <= sensor_timeout;

  -- Its value before the first real sample makes no difference: the watchdog is not fed yet.
  stop_pins : entity work.synchronizer
    generic map (width => 2)
    port map (
      clk => clk,
      asynchronous => (0 => emergency_stop, 1 => veto),
      synchronous(0) => emergency_stop_synchronized,
      synchronous(1) => veto_synchronized,
      settling => pins_settling);

  each_channel : for channel in 0 to to_software.status'high generate
    present : if channel < channels generate
      heater : entity work.heater_channel
        generic map (channel => channel)
        port map (
          clk => clk,
          reset => reset,
          tick => tick,
          slot_start => slot_start,
          from_software => from_software,
          clear => clear,
          least_count => least_count,
          most_count => most_count,
          longest_settle => longest_settle,
          watchdog_alive => watchdog_alive,
          watchdog_violated => watchdog_violated,
          reading => readings(channel),
          sensor_timeout_ticks => sensor_timeout,
          emergency_stop => emergency_stop_synchronized,
          gate => gates(channel),
          any_locked => any_locked(channel),
          minimum_count => to_software.minimum_count(channel).cycles,
          maximum_count => to_software.maximum_count(channel).cycles,
          hot_count => to_software.hot_count(channel).cycles,
          settle_ticks => to_software.settle(channel).ticks,
          status => to_software.status(channel));

      tripped(channel) <= to_software.status(channel).tripped;
    end generate;

    absent : if channel >= channels generate
      to_software.minimum_count(channel).cycles <= (others => '1');
      to_software.maximum_count(channel).cycles <= (others => '0');
      to_software.hot_count(channel).cycles <= (others => '0');
      to_software.settle(channel).ticks <= (others => '1');
      to_software.status(channel) <= (others => '0');
    end generate;
  end generate;

  find_rest : process (all)
  begin
    all_at_rest <= '1';
    for channel in from_software.duty'range loop
      if from_software.duty(channel).density /= 0 then
        all_at_rest <= '0';
      end if;
    end loop;
  end process;

  close_supply <= '1' when from_software.supply_written = '1'
    and from_software.supply.key = heater_control_supply_key_close else '0';
  open_supply <= '1' when from_software.supply_written = '1'
    and from_software.supply.key = heater_control_supply_key_open else '0';

  common_supply : entity work.heater_supply
    port map (
      clk => clk,
      reset => reset,
      close => close_supply,
      open_again => open_supply,
      all_at_rest => all_at_rest,
      tripped => or tripped,
      watchdog_alive => watchdog_alive,
      emergency_stop => emergency_stop_synchronized,
      veto => veto_synchronized,
      closed => supply,
      trip_opened => trip_opened,
      watchdog_opened => watchdog_opened,
      emergency_stop_opened => emergency_stop_opened,
      veto_opened => veto_opened,
      refused => to_software.supply.refused);

  to_software.supply.closed <= supply;
  to_software.supply.trip_opened <= trip_opened;
  to_software.supply.watchdog_opened <= watchdog_opened;
  to_software.supply.emergency_stop_opened <= emergency_stop_opened;
  to_software.supply.veto_opened <= veto_opened;
  to_software.supply.key <= (others => '0');

  report_trips : process
  begin
    wait until rising_edge(clk);
    interrupt <= (or tripped) or trip_opened or watchdog_opened or emergency_stop_opened or veto_opened;
    if reset then
      interrupt <= '0';
    end if;
  end process;

  registers : entity work.heater_control_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software);

end architecture;
