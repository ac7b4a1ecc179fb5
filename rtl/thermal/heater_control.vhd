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
    -- Shortest charge, in 2^-20 s, that a cut-off may ask for: 3.8 us, where the hottest machine at 300
    -- degrees
    -- (169 Ohm with the pin, 68 nF) has 8.0 us with nominal parts and 5.1 with the worst.
    least_charge : positive range 1 to 64 := 4;
    -- Software cannot make a settling time longer than this.
    maximum_settle_s : positive range 1 to 150 := 120
  );
  port (
    -- Edges may be left out while `at_rest` is high, but for the one after a change of `emergency_stop`.
    clk : in std_ulogic;
    -- The same clock, never left out.
    always_clk : in std_ulogic;
    -- The same clock for the registers; edges may be left out while no access is made.
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
    -- Something outside the chip forbids the supply, as a watch over its clock does. Asynchronous.
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

  signal ticks_per_s, default_timeout, maximum_timeout : tick_count_t;

  signal from_software : heater_control_from_software_t;
  signal to_software : heater_control_to_software_t;

  signal tick : std_ulogic := '0';
  signal tick_phase : natural range 0 to tick_cycles - 1 := 0;
  signal tick_ends : std_ulogic;
  signal slot_start : std_ulogic := '0';
  signal slot_phase : unsigned(23 downto 0) := (others => '0');
  -- Of a slot, a clock after software sets it, so that no sum is compared.
  signal last_phase : unsigned(23 downto 0) := (others => '0');
  signal slot_ends : std_ulogic;

  signal watchdog_timeout : tick_count_t := (others => '0');
  signal sensor_timeout : tick_count_t := (others => '0');
  signal watchdog_alive, watchdog_violated : std_ulogic;
  signal first_key, second_key : std_ulogic;

  -- Bounds of the limits for the present number of charges, a clock after it.
  signal charges : unsigned(8 downto 0);
  signal least_count, most_count : unsigned(31 downto 0) := (others => '0');
  signal longest_settle : settle_t;
  signal any_locked : std_ulogic_vector(channels - 1 downto 0);

  signal close_supply, open_supply, all_at_rest : std_ulogic;
  signal trip_opened, watchdog_opened, emergency_stop_opened, veto_opened : std_ulogic;

  signal clear : std_ulogic;
  signal emergency_stop_synchronized, veto_synchronized, pins_settling : std_ulogic;
  signal reading_comes, alarm : std_ulogic;
  signal tripped : std_ulogic_vector(channels - 1 downto 0);

begin

  default_timeout_is_within_the_maximum : assert default_timeout_s <= maximum_timeout_s
    severity failure;

  -- At most 100 MHz, so 5 s fit into a tick count.
  ticks_per_s <= resize(clock_frequency_hz / tick_cycles, tick_count_bits);
  default_timeout <= resize(ticks_per_s * default_timeout_s, tick_count_bits);
  maximum_timeout <= resize(ticks_per_s * maximum_timeout_s, tick_count_bits);

  tick_ends <= '1' when tick_phase = tick_cycles - 1 else '0';
  slot_ends <= '1' when slot_phase >= last_phase else '0';

  find_last_phase : process
  begin
    wait until rising_edge(bus_clk);
    last_phase <= (others => '0');
    if from_software.slot.cycles /= 0 then
      last_phase <= from_software.slot.cycles - 1;
    end if;
  end process;

  count_phases : process
  begin
    wait until rising_edge(always_clk);
    if tick_ends then
      tick_phase <= 0;
    else
      tick_phase <= tick_phase + 1;
    end if;
    slot_phase <= slot_phase + 1;
    if slot_ends then
      slot_phase <= (others => '0');
    end if;
    if reset then
      tick_phase <= 0;
      slot_phase <= (others => '0');
    end if;
  end process;

  make_ticks : process
  begin
    wait until rising_edge(clk);
    tick <= tick_ends;
    slot_start <= slot_ends;
  end process;

  note_readings : process (all)
  begin
    reading_comes <= '0';
    for channel in readings'range loop
      if readings(channel).updated then
        reading_comes <= '1';
      end if;
    end loop;
  end process;

  alarm <= tick_ends or slot_ends or reading_comes or pins_settling;

  -- A tick may end the watchdog's patience, which trips a channel, which interrupts.
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

  set_timeouts : process
  begin
    wait until rising_edge(clk);
    if from_software.watchdog_written then
      watchdog_timeout <= maximum_timeout when from_software.watchdog.ticks > maximum_timeout
        else from_software.watchdog.ticks;
    end if;
    if from_software.sensor_timeout_written then
      sensor_timeout <= maximum_timeout when from_software.sensor_timeout.ticks > maximum_timeout
        else from_software.sensor_timeout.ticks;
    end if;
    if reset then
      watchdog_timeout <= default_timeout;
      sensor_timeout <= default_timeout;
    end if;
  end process;

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
  charges <= resize(more_charges, 9) + 1;
  longest_settle <= resize(ticks_per_s * maximum_settle_s, longest_settle'length);
  find_bounds : process
  begin
    wait until rising_edge(clk);
    least_count <= resize(
      resize(shift_right(clock_frequency_hz * to_unsigned(least_charge, 7), 20), 14) * charges, 32);
    most_count <= clock_frequency_hz(26 downto 4) * charges;
  end process;

  limits_locked <= or any_locked;

  to_software.watchdog.ticks <= watchdog_timeout;
  to_software.sensor_timeout.ticks <= sensor_timeout;

  -- What it shows before real samples have come through makes no difference: the watchdog is not fed yet.
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
      signal written : unsigned(31 downto 0);
      signal minimum_count, maximum_count, hot_count : unsigned(31 downto 0);
      signal settle_ticks : settle_t;
      signal minimum_locked, maximum_locked, hot_locked, settle_locked, refused : std_ulogic;
      signal limits_set : std_ulogic;
      signal clear_this : std_ulogic;
      signal heats_unasked : std_ulogic;
      signal permitted : std_ulogic;
      signal trips : heater_trips_t;
    begin

      -- One word goes to all registers.
      written <= from_software.minimum_count(channel).cycles;

      limits : entity work.heater_limits
        port map (
          clk => clk,
          reset => reset,
          least_count => least_count,
          most_count => most_count,
          least_hot_count => shift_left(least_count, 3),
          longest_settle => longest_settle,
          written => written,
          minimum_written => from_software.minimum_count_written(channel),
          maximum_written => from_software.maximum_count_written(channel),
          hot_written => from_software.hot_count_written(channel),
          settle_written => from_software.settle_written(channel),
          forget_refused => clear_this,
          minimum_count => minimum_count,
          maximum_count => maximum_count,
          hot_count => hot_count,
          settle_ticks => settle_ticks,
          minimum_locked => minimum_locked,
          maximum_locked => maximum_locked,
          hot_locked => hot_locked,
          settle_locked => settle_locked,
          refused => refused);

      limits_set <= minimum_locked and maximum_locked and hot_locked and settle_locked;
      any_locked(channel) <= minimum_locked or maximum_locked or hot_locked or settle_locked;
      clear_this <= clear and from_software.clear.channels(channel);

      guard : entity work.heater_guard
        port map (
          clk => clk,
          reset => reset,
          tick => tick,
          slot_start => slot_start,
          duty => from_software.duty(channel).density,
          watchdog_alive => watchdog_alive,
          watchdog_violated => watchdog_violated,
          heats_unasked => heats_unasked,
          reading => readings(channel),
          sensor_timeout_ticks => sensor_timeout,
          minimum_count => minimum_count,
          maximum_count => maximum_count,
          limits_set => limits_set,
          emergency_stop => emergency_stop_synchronized,
          clear => clear_this,
          gate => gates(channel),
          permitted => permitted,
          trips => trips);

      unasked : entity work.unasked_heat_watch
        port map (
          clk => clk,
          reset => reset,
          tick => tick,
          gate => gates(channel),
          reading => readings(channel),
          limits_set => limits_set,
          settle_ticks => settle_ticks,
          hot_count => hot_count,
          found => heats_unasked);

      tripped(channel) <= any_of(trips);

      to_software.minimum_count(channel).cycles <= minimum_count;
      to_software.maximum_count(channel).cycles <= maximum_count;
      to_software.hot_count(channel).cycles <= hot_count;
      to_software.settle(channel).ticks <= settle_ticks;
      to_software.status(channel) <= (
        gate => gates(channel),
        permitted => permitted,
        minimum_locked => minimum_locked,
        maximum_locked => maximum_locked,
        hot_locked => hot_locked,
        settle_locked => settle_locked,
        refused => refused,
        tripped => tripped(channel),
        watchdog_trip => trips.watchdog,
        sensor_invalid_trip => trips.sensor_invalid,
        sensor_stale_trip => trips.sensor_stale,
        too_hot_trip => trips.too_hot,
        too_cold_trip => trips.too_cold,
        limits_missing_trip => trips.limits_missing,
        emergency_stop_trip => trips.emergency_stop,
        heats_unasked_trip => trips.heats_unasked);
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
