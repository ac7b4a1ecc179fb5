-- SPDX-License-Identifier: Apache-2.0
-- Heater control: one guarded gate per heater, a watchdog over the software, limits that lock. Heater n is
-- guarded by sensor n. All of it works with the processor hung.

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
    maximum_timeout_s : positive range 1 to 5 := 3
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
    -- Closes all gates and trips all channels. Asynchronous.
    emergency_stop : in std_ulogic;
    gates : out std_ulogic_vector(channels - 1 downto 0);
    -- A trip is latched on some channel.
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
  -- Until the watchdog barks; 0 from reset on.
  signal watchdog_ticks_left : tick_count_t := (others => '0');
  signal watchdog_alive : std_ulogic := '0';
  signal fed : std_ulogic;

  signal clear : std_ulogic;
  signal emergency_stop_synchronized, emergency_stop_settling : std_ulogic;
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

  alarm <= tick_ends or slot_ends or reading_comes or emergency_stop_settling;

  -- A tick may end the watchdog's patience, which trips a channel, which interrupts.
  watch_rest : entity work.rest_watch
    generic map (settling_clocks => 7)
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset,
      strobe => request.strobe,
      working => '0',
      alarm => alarm,
      at_rest => at_rest);

  fed <= '1' when from_software.feed_written = '1'
    and from_software.feed.key = heater_control_feed_key_alive else '0';

  clear <= '1' when from_software.clear_written = '1'
    and from_software.clear.key = heater_control_clear_key_clear_trips else '0';

  watch_software : process
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
    watchdog_alive <= '1' when watchdog_ticks_left /= 0 else '0';
    if fed then
      watchdog_ticks_left <= watchdog_timeout;
    elsif tick = '1' and watchdog_ticks_left /= 0 then
      watchdog_ticks_left <= watchdog_ticks_left - 1;
    end if;
    if reset then
      watchdog_timeout <= default_timeout;
      sensor_timeout <= default_timeout;
      watchdog_ticks_left <= (others => '0');
      watchdog_alive <= '0';
    end if;
  end process;

  to_software.watchdog.ticks <= watchdog_timeout;
  to_software.sensor_timeout.ticks <= sensor_timeout;

  -- What it shows before real samples have come through makes no difference: the watchdog is not fed yet.
  emergency_stop_pin : entity work.synchronizer
    port map (
      clk => clk,
      asynchronous(0) => emergency_stop,
      synchronous(0) => emergency_stop_synchronized,
      settling => emergency_stop_settling);

  each_channel : for channel in 0 to to_software.status'high generate
    present : if channel < channels generate
      signal minimum_count : unsigned(31 downto 0) := (others => '1');
      signal maximum_count : unsigned(31 downto 0) := (others => '0');
      signal minimum_locked : std_ulogic := '0';
      signal maximum_locked : std_ulogic := '0';
      signal limits_set : std_ulogic;
      signal clear_this : std_ulogic;
      signal permitted : std_ulogic;
      signal trips : heater_trips_t;
    begin

      lock_limits : process
      begin
        wait until rising_edge(clk);
        if from_software.minimum_count_written(channel) = '1' and minimum_locked = '0' then
          minimum_count <= from_software.minimum_count(channel).cycles;
          minimum_locked <= '1';
        end if;
        if from_software.maximum_count_written(channel) = '1' and maximum_locked = '0' then
          maximum_count <= from_software.maximum_count(channel).cycles;
          maximum_locked <= '1';
        end if;
        if reset then
          minimum_count <= (others => '1');
          maximum_count <= (others => '0');
          minimum_locked <= '0';
          maximum_locked <= '0';
        end if;
      end process;

      limits_set <= minimum_locked and maximum_locked;
      clear_this <= clear and from_software.clear.channels(channel);

      guard : entity work.heater_guard
        port map (
          clk => clk,
          reset => reset,
          tick => tick,
          slot_start => slot_start,
          duty => from_software.duty(channel).density,
          watchdog_alive => watchdog_alive,
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

      tripped(channel) <= any_of(trips);

      to_software.minimum_count(channel).cycles <= minimum_count;
      to_software.maximum_count(channel).cycles <= maximum_count;
      to_software.status(channel) <= (
        gate => gates(channel),
        permitted => permitted,
        minimum_locked => minimum_locked,
        maximum_locked => maximum_locked,
        tripped => tripped(channel),
        watchdog_trip => trips.watchdog,
        sensor_invalid_trip => trips.sensor_invalid,
        sensor_stale_trip => trips.sensor_stale,
        too_hot_trip => trips.too_hot,
        too_cold_trip => trips.too_cold,
        limits_missing_trip => trips.limits_missing,
        emergency_stop_trip => trips.emergency_stop);
    end generate;

    absent : if channel >= channels generate
      to_software.minimum_count(channel).cycles <= (others => '1');
      to_software.maximum_count(channel).cycles <= (others => '0');
      to_software.status(channel) <= (others => '0');
    end generate;
  end generate;

  report_trips : process
  begin
    wait until rising_edge(clk);
    interrupt <= or tripped;
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
