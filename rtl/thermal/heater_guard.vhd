-- SPDX-License-Identifier: Apache-2.0
-- One heater's gate and all that must hold for it to open. Acts without software; knows no bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity heater_guard is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Every tick_cycles clocks.
    tick : in std_ulogic;
    -- A slot of the pulse-density modulation begins.
    slot_start : in std_ulogic;
    -- Ones per 65535 slots. Not 0: the channel is asked to heat.
    duty : in unsigned(15 downto 0);
    -- Software has fed the watchdog in time.
    watchdog_alive : in std_ulogic;
    -- For one clock: it has been fed wrongly.
    watchdog_violated : in std_ulogic;
    -- For one clock: it gets hotter although the gate has long been closed.
    heats_unasked : in std_ulogic;
    -- Of this heater's own sensor.
    reading : in sensor_reading_t;
    sensor_timeout_ticks : in tick_count_t;
    minimum_count : in unsigned(31 downto 0);
    maximum_count : in unsigned(31 downto 0);
    -- All limits have been set, and locked.
    limits_set : in std_ulogic;
    -- Synchronous to clk.
    emergency_stop : in std_ulogic;
    -- Forget the trips; has no effect while duty is not 0.
    clear : in std_ulogic;
    gate : out std_ulogic := '0';
    -- No condition forbids heating.
    permitted : out std_ulogic;
    trips : out heater_trips_t
  );
end entity;

architecture rtl of heater_guard is

  -- Since the last valid conversion.
  signal sensor_age : tick_count_t := (others => '1');
  signal sensor_fresh : std_ulogic;
  signal too_hot : std_ulogic;
  signal too_cold : std_ulogic;
  signal requested : std_ulogic;
  signal latched : heater_trips_t := heater_trips_none;
  signal modulated : std_ulogic;
  signal may_heat : std_ulogic;

begin

  sensor_fresh <= '1' when sensor_age < sensor_timeout_ticks else '0';
  too_hot <= '1' when reading.count < minimum_count else '0';
  too_cold <= '1' when reading.count > maximum_count else '0';
  requested <= '1' when duty /= 0 else '0';

  may_heat <= watchdog_alive and reading.valid and sensor_fresh and limits_set
    and not too_hot and not too_cold and not watchdog_violated
    and not heats_unasked and not emergency_stop and not any_of(latched);

  permitted <= may_heat;
  trips <= latched;

  watch_sensor : process
  begin
    wait until rising_edge(clk);
    if reading.updated = '1' and reading.valid = '1' then
      sensor_age <= (others => '0');
    elsif tick = '1' and sensor_age /= (sensor_age'range => '1') then
      sensor_age <= sensor_age + 1;
    end if;
    if reset then
      sensor_age <= (others => '1');
    end if;
  end process;

  -- A condition that fails closes the gate at once; most are latched only while heat is requested.
  -- One faulty conversion is no trip, as long as a valid one follows within the sensor time-out.
  latch_trips : process
  begin
    wait until rising_edge(clk);
    if clear = '1' and requested = '0' then
      latched <= heater_trips_none;
    end if;
    if requested then
      if not watchdog_alive then
        latched.watchdog <= '1';
      end if;
      if sensor_fresh = '0' and reading.valid = '0' then
        latched.sensor_invalid <= '1';
      end if;
      if sensor_fresh = '0' and reading.valid = '1' and reading.updated = '0' then
        latched.sensor_stale <= '1';
      end if;
      if not limits_set then
        latched.limits_missing <= '1';
      elsif reading.valid = '1' and too_cold = '1' then
        latched.too_cold <= '1';
      end if;
    end if;
    -- Also at duty 0: a part that gets too hot at rest is heated by a fault.
    if limits_set = '1' and reading.valid = '1' and too_hot = '1' then
      latched.too_hot <= '1';
    end if;
    if watchdog_violated then
      latched.watchdog <= '1';
    end if;
    if heats_unasked then
      latched.heats_unasked <= '1';
    end if;
    if emergency_stop then
      latched.emergency_stop <= '1';
    end if;
    if reset then
      latched <= heater_trips_none;
    end if;
  end process;

  modulator : entity work.pulse_density
    generic map (width => 16)
    port map (
      clk => clk,
      reset => reset,
      advance => slot_start,
      density => duty,
      level => modulated);

  drive_gate : process
  begin
    wait until rising_edge(clk);
    gate <= modulated and requested and may_heat;
    if reset then
      gate <= '0';
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl a_gate_opens_only_while_the_watchdog_is_fed : assert always
  --   (not watchdog_alive -> next (not gate));
  -- psl a_gate_opens_only_on_a_valid_sensor : assert always
  --   (not reading.valid -> next (not gate));
  -- psl a_gate_opens_only_on_a_fresh_sensor : assert always
  --   (not sensor_fresh -> next (not gate));
  -- psl a_gate_opens_only_below_the_cut_off_temperature : assert always
  --   (too_hot -> next (not gate));
  -- psl a_gate_opens_only_above_the_lowest_temperature : assert always
  --   (too_cold -> next (not gate));
  -- psl a_gate_opens_only_with_limits_set : assert always (not limits_set -> next (not gate));
  -- psl a_gate_opens_only_without_emergency_stop : assert always
  --   (emergency_stop -> next (not gate));
  -- psl a_gate_opens_only_without_a_trip : assert always (any_of(latched) -> next (not gate));
  -- psl a_gate_opens_only_on_request : assert always (not requested -> next (not gate));

end architecture;
