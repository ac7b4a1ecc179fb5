-- SPDX-License-Identifier: Apache-2.0
-- Registers of `heater_control`. Generated from rtl/thermal/heater_control.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package heater_control_registers_pkg is

  constant heater_control_address : unsigned(31 downto 0) := x"F0006000";

  -- Restarts the watchdog.
  type heater_control_feed_t is record
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_feed_key_alive : natural := 65261;

  -- Time without a feed after which all gates close.
  type heater_control_watchdog_t is record
    ticks : unsigned(19 downto 0);
  end record;

  -- Time without a valid conversion after which a channel's gate closes for good.
  type heater_control_sensor_timeout_t is record
    ticks : unsigned(19 downto 0);
  end record;

  -- Shortest time that a gate keeps its level when it is modulated.
  type heater_control_slot_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Clears the trips of channels whose duty is 0.
  type heater_control_clear_t is record
    channels : std_ulogic_vector(3 downto 0);
    key : unsigned(15 downto 0);
  end record;
  constant heater_control_clear_key_clear_trips : natural := 49642;

  -- How much of the time the channel heats. A request: the hardware decides.
  type heater_control_duty_t is record
    density : unsigned(15 downto 0);
  end record;
  type heater_control_duty_array_t is array (0 to 3) of heater_control_duty_t;

  -- Smallest thermistor count at which the channel may heat: the cut-off temperature. Locks when written.
  type heater_control_minimum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_minimum_count_array_t is array (0 to 3) of heater_control_minimum_count_t;

  -- Largest thermistor count at which the channel may heat: too cold or open. Locks when written.
  type heater_control_maximum_count_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type heater_control_maximum_count_array_t is array (0 to 3) of heater_control_maximum_count_t;

  -- What the channel does, and what tripped it since its trips were cleared.
  type heater_control_status_t is record
    gate : std_ulogic;
    permitted : std_ulogic;
    minimum_locked : std_ulogic;
    maximum_locked : std_ulogic;
    tripped : std_ulogic;
    watchdog_trip : std_ulogic;
    sensor_invalid_trip : std_ulogic;
    sensor_stale_trip : std_ulogic;
    too_hot_trip : std_ulogic;
    too_cold_trip : std_ulogic;
    limits_missing_trip : std_ulogic;
    emergency_stop_trip : std_ulogic;
  end record;
  type heater_control_status_array_t is array (0 to 3) of heater_control_status_t;

  type heater_control_from_software_t is record
    feed : heater_control_feed_t;
    feed_written : std_ulogic;
    watchdog : heater_control_watchdog_t;
    watchdog_written : std_ulogic;
    sensor_timeout : heater_control_sensor_timeout_t;
    sensor_timeout_written : std_ulogic;
    slot : heater_control_slot_t;
    clear : heater_control_clear_t;
    clear_written : std_ulogic;
    duty : heater_control_duty_array_t;
    minimum_count : heater_control_minimum_count_array_t;
    minimum_count_written : std_ulogic_vector(0 to 3);
    maximum_count : heater_control_maximum_count_array_t;
    maximum_count_written : std_ulogic_vector(0 to 3);
  end record;

  type heater_control_to_software_t is record
    watchdog : heater_control_watchdog_t;
    sensor_timeout : heater_control_sensor_timeout_t;
    minimum_count : heater_control_minimum_count_array_t;
    maximum_count : heater_control_maximum_count_array_t;
    status : heater_control_status_array_t;
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.heater_control_registers_pkg.all;

entity heater_control_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out heater_control_from_software_t;
    to_software : in heater_control_to_software_t
  );
end entity;

architecture rtl of heater_control_registers is

  signal answered : std_ulogic := '0';
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal slot_stored : std_ulogic_vector(31 downto 0) := x"00000400";
  signal duty_0_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal duty_1_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal duty_2_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal duty_3_stored : std_ulogic_vector(31 downto 0) := x"00000000";

begin

  -- Answers in the clock after the strobe: whole words only, errors for everything not described.
  answer : process
    variable word : std_ulogic_vector(31 downto 0);
    variable known : boolean;
  begin
    wait until rising_edge(clk);
    if answered then
      response <= bus_response_idle;
      answered <= '0';
      from_software.feed_written <= '0';
      from_software.watchdog_written <= '0';
      from_software.sensor_timeout_written <= '0';
      from_software.clear_written <= '0';
      from_software.minimum_count_written <= (others => '0');
      from_software.maximum_count_written <= (others => '0');
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      written_data <= request.data;
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.feed_written <= '1';
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.watchdog.ticks);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.watchdog_written <= '1';
          end if;
        when 2 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.sensor_timeout.ticks);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.sensor_timeout_written <= '1';
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(23 downto 0) := slot_stored(23 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            slot_stored(23 downto 0) <= request.data(23 downto 0);
          end if;
        when 4 =>
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.clear_written <= '1';
          end if;
        when 5 =>
          if not request.write then
            known := true;
            word(15 downto 0) := duty_0_stored(15 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            duty_0_stored(15 downto 0) <= request.data(15 downto 0);
          end if;
        when 6 =>
          if not request.write then
            known := true;
            word(15 downto 0) := duty_1_stored(15 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            duty_1_stored(15 downto 0) <= request.data(15 downto 0);
          end if;
        when 7 =>
          if not request.write then
            known := true;
            word(15 downto 0) := duty_2_stored(15 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            duty_2_stored(15 downto 0) <= request.data(15 downto 0);
          end if;
        when 8 =>
          if not request.write then
            known := true;
            word(15 downto 0) := duty_3_stored(15 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            duty_3_stored(15 downto 0) <= request.data(15 downto 0);
          end if;
        when 9 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.minimum_count(0).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.minimum_count_written(0) <= '1';
          end if;
        when 10 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.minimum_count(1).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.minimum_count_written(1) <= '1';
          end if;
        when 11 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.minimum_count(2).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.minimum_count_written(2) <= '1';
          end if;
        when 12 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.minimum_count(3).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.minimum_count_written(3) <= '1';
          end if;
        when 13 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.maximum_count(0).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.maximum_count_written(0) <= '1';
          end if;
        when 14 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.maximum_count(1).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.maximum_count_written(1) <= '1';
          end if;
        when 15 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.maximum_count(2).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.maximum_count_written(2) <= '1';
          end if;
        when 16 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.maximum_count(3).cycles);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            from_software.maximum_count_written(3) <= '1';
          end if;
        when 17 =>
          if not request.write then
            known := true;
            word(0) := to_software.status(0).gate;
            word(1) := to_software.status(0).permitted;
            word(2) := to_software.status(0).minimum_locked;
            word(3) := to_software.status(0).maximum_locked;
            word(7) := to_software.status(0).tripped;
            word(8) := to_software.status(0).watchdog_trip;
            word(9) := to_software.status(0).sensor_invalid_trip;
            word(10) := to_software.status(0).sensor_stale_trip;
            word(11) := to_software.status(0).too_hot_trip;
            word(12) := to_software.status(0).too_cold_trip;
            word(13) := to_software.status(0).limits_missing_trip;
            word(14) := to_software.status(0).emergency_stop_trip;
          end if;
        when 18 =>
          if not request.write then
            known := true;
            word(0) := to_software.status(1).gate;
            word(1) := to_software.status(1).permitted;
            word(2) := to_software.status(1).minimum_locked;
            word(3) := to_software.status(1).maximum_locked;
            word(7) := to_software.status(1).tripped;
            word(8) := to_software.status(1).watchdog_trip;
            word(9) := to_software.status(1).sensor_invalid_trip;
            word(10) := to_software.status(1).sensor_stale_trip;
            word(11) := to_software.status(1).too_hot_trip;
            word(12) := to_software.status(1).too_cold_trip;
            word(13) := to_software.status(1).limits_missing_trip;
            word(14) := to_software.status(1).emergency_stop_trip;
          end if;
        when 19 =>
          if not request.write then
            known := true;
            word(0) := to_software.status(2).gate;
            word(1) := to_software.status(2).permitted;
            word(2) := to_software.status(2).minimum_locked;
            word(3) := to_software.status(2).maximum_locked;
            word(7) := to_software.status(2).tripped;
            word(8) := to_software.status(2).watchdog_trip;
            word(9) := to_software.status(2).sensor_invalid_trip;
            word(10) := to_software.status(2).sensor_stale_trip;
            word(11) := to_software.status(2).too_hot_trip;
            word(12) := to_software.status(2).too_cold_trip;
            word(13) := to_software.status(2).limits_missing_trip;
            word(14) := to_software.status(2).emergency_stop_trip;
          end if;
        when 20 =>
          if not request.write then
            known := true;
            word(0) := to_software.status(3).gate;
            word(1) := to_software.status(3).permitted;
            word(2) := to_software.status(3).minimum_locked;
            word(3) := to_software.status(3).maximum_locked;
            word(7) := to_software.status(3).tripped;
            word(8) := to_software.status(3).watchdog_trip;
            word(9) := to_software.status(3).sensor_invalid_trip;
            word(10) := to_software.status(3).sensor_stale_trip;
            word(11) := to_software.status(3).too_hot_trip;
            word(12) := to_software.status(3).too_cold_trip;
            word(13) := to_software.status(3).limits_missing_trip;
            word(14) := to_software.status(3).emergency_stop_trip;
          end if;
        when others =>
          null;
      end case;
      if known then
        response.acknowledge <= '1';
        response.data <= word;
      else
        response.error <= '1';
      end if;
    end if;
    if reset then
      response <= bus_response_idle;
      answered <= '0';
      from_software.feed_written <= '0';
      from_software.watchdog_written <= '0';
      from_software.sensor_timeout_written <= '0';
      from_software.clear_written <= '0';
      from_software.minimum_count_written <= (others => '0');
      from_software.maximum_count_written <= (others => '0');
      slot_stored <= x"00000400";
      duty_0_stored <= x"00000000";
      duty_1_stored <= x"00000000";
      duty_2_stored <= x"00000000";
      duty_3_stored <= x"00000000";
    end if;
  end process;

  from_software.feed.key <= unsigned(written_data(15 downto 0));

  from_software.watchdog.ticks <= unsigned(written_data(19 downto 0));

  from_software.sensor_timeout.ticks <= unsigned(written_data(19 downto 0));

  from_software.slot.cycles <= unsigned(slot_stored(23 downto 0));

  from_software.clear.channels <= written_data(3 downto 0);
  from_software.clear.key <= unsigned(written_data(31 downto 16));

  from_software.duty(0).density <= unsigned(duty_0_stored(15 downto 0));
  from_software.duty(1).density <= unsigned(duty_1_stored(15 downto 0));
  from_software.duty(2).density <= unsigned(duty_2_stored(15 downto 0));
  from_software.duty(3).density <= unsigned(duty_3_stored(15 downto 0));

  from_software.minimum_count(0).cycles <= unsigned(written_data(31 downto 0));
  from_software.minimum_count(1).cycles <= unsigned(written_data(31 downto 0));
  from_software.minimum_count(2).cycles <= unsigned(written_data(31 downto 0));
  from_software.minimum_count(3).cycles <= unsigned(written_data(31 downto 0));

  from_software.maximum_count(0).cycles <= unsigned(written_data(31 downto 0));
  from_software.maximum_count(1).cycles <= unsigned(written_data(31 downto 0));
  from_software.maximum_count(2).cycles <= unsigned(written_data(31 downto 0));
  from_software.maximum_count(3).cycles <= unsigned(written_data(31 downto 0));

end architecture;
