-- SPDX-License-Identifier: Apache-2.0
-- Registers of `temperature_converter`. Generated from rtl/thermal/temperature_converter.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package temperature_converter_registers_pkg is

  constant temperature_converter_address : unsigned(31 downto 0) := x"F0005000";

  -- How conversions are made; changes take effect with the next conversion.
  type temperature_converter_control_t is record
    enable : std_ulogic;
    references : std_ulogic;
    dither_cycles : unsigned(7 downto 0);
    more_charges : unsigned(7 downto 0);
  end record;

  -- Time to discharge the capacitor before each charge.
  type temperature_converter_discharge_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Longest time that one charge may take.
  type temperature_converter_timeout_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Time between conversions, with the capacitor discharged.
  type temperature_converter_pause_t is record
    cycles : unsigned(23 downto 0);
  end record;

  -- Below this thermistor count the thermistor is taken as shorted.
  type temperature_converter_short_limit_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- Outcome of the channel's newest conversion.
  type temperature_converter_status_t is record
    state : unsigned(2 downto 0);
    conversions : unsigned(7 downto 0);
  end record;
  type temperature_converter_status_array_t is array (0 to 3) of temperature_converter_status_t;
  constant temperature_converter_status_state_never : natural := 0;
  constant temperature_converter_status_state_ok : natural := 1;
  constant temperature_converter_status_state_open : natural := 2;
  constant temperature_converter_status_state_shorted : natural := 3;
  constant temperature_converter_status_state_stuck : natural := 4;
  constant temperature_converter_status_state_time_out : natural := 5;

  -- Time since the channel's newest conversion.
  type temperature_converter_age_t is record
    ticks : unsigned(19 downto 0);
  end record;
  type temperature_converter_age_array_t is array (0 to 3) of temperature_converter_age_t;

  -- Clocks of all charges through the thermistor.
  type temperature_converter_thermistor_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_thermistor_array_t is array (0 to 3) of temperature_converter_thermistor_t;

  -- Clocks of all charges through the low reference resistor.
  type temperature_converter_reference_low_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_low_array_t is array (0 to 3) of temperature_converter_reference_low_t;

  -- Clocks of all charges through the high reference resistor.
  type temperature_converter_reference_high_t is record
    cycles : unsigned(31 downto 0);
  end record;
  type temperature_converter_reference_high_array_t is array (0 to 3) of temperature_converter_reference_high_t;

  type temperature_converter_from_software_t is record
    control : temperature_converter_control_t;
    discharge : temperature_converter_discharge_t;
    timeout : temperature_converter_timeout_t;
    pause : temperature_converter_pause_t;
    short_limit : temperature_converter_short_limit_t;
  end record;

  type temperature_converter_to_software_t is record
    status : temperature_converter_status_array_t;
    age : temperature_converter_age_array_t;
    thermistor : temperature_converter_thermistor_array_t;
    reference_low : temperature_converter_reference_low_array_t;
    reference_high : temperature_converter_reference_high_array_t;
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.temperature_converter_registers_pkg.all;

entity temperature_converter_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out temperature_converter_from_software_t;
    to_software : in temperature_converter_to_software_t
  );
end entity;

architecture rtl of temperature_converter_registers is

  signal answered : std_ulogic := '0';
  signal control_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal discharge_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal timeout_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal pause_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal short_limit_stored : std_ulogic_vector(31 downto 0) := x"00000000";

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
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if not request.write then
            known := true;
            word(0 downto 0) := control_stored(0 downto 0);
            word(1 downto 1) := control_stored(1 downto 1);
            word(15 downto 8) := control_stored(15 downto 8);
            word(23 downto 16) := control_stored(23 downto 16);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            control_stored(0 downto 0) <= request.data(0 downto 0);
            control_stored(1 downto 1) <= request.data(1 downto 1);
            control_stored(15 downto 8) <= request.data(15 downto 8);
            control_stored(23 downto 16) <= request.data(23 downto 16);
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(23 downto 0) := discharge_stored(23 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            discharge_stored(23 downto 0) <= request.data(23 downto 0);
          end if;
        when 2 =>
          if not request.write then
            known := true;
            word(23 downto 0) := timeout_stored(23 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            timeout_stored(23 downto 0) <= request.data(23 downto 0);
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(23 downto 0) := pause_stored(23 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            pause_stored(23 downto 0) <= request.data(23 downto 0);
          end if;
        when 4 =>
          if not request.write then
            known := true;
            word(31 downto 0) := short_limit_stored(31 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            short_limit_stored(31 downto 0) <= request.data(31 downto 0);
          end if;
        when 5 =>
          if not request.write then
            known := true;
            word(2 downto 0) := std_ulogic_vector(to_software.status(0).state);
            word(15 downto 8) := std_ulogic_vector(to_software.status(0).conversions);
          end if;
        when 6 =>
          if not request.write then
            known := true;
            word(2 downto 0) := std_ulogic_vector(to_software.status(1).state);
            word(15 downto 8) := std_ulogic_vector(to_software.status(1).conversions);
          end if;
        when 7 =>
          if not request.write then
            known := true;
            word(2 downto 0) := std_ulogic_vector(to_software.status(2).state);
            word(15 downto 8) := std_ulogic_vector(to_software.status(2).conversions);
          end if;
        when 8 =>
          if not request.write then
            known := true;
            word(2 downto 0) := std_ulogic_vector(to_software.status(3).state);
            word(15 downto 8) := std_ulogic_vector(to_software.status(3).conversions);
          end if;
        when 9 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.age(0).ticks);
          end if;
        when 10 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.age(1).ticks);
          end if;
        when 11 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.age(2).ticks);
          end if;
        when 12 =>
          if not request.write then
            known := true;
            word(19 downto 0) := std_ulogic_vector(to_software.age(3).ticks);
          end if;
        when 13 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.thermistor(0).cycles);
          end if;
        when 14 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.thermistor(1).cycles);
          end if;
        when 15 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.thermistor(2).cycles);
          end if;
        when 16 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.thermistor(3).cycles);
          end if;
        when 17 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_low(0).cycles);
          end if;
        when 18 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_low(1).cycles);
          end if;
        when 19 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_low(2).cycles);
          end if;
        when 20 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_low(3).cycles);
          end if;
        when 21 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_high(0).cycles);
          end if;
        when 22 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_high(1).cycles);
          end if;
        when 23 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_high(2).cycles);
          end if;
        when 24 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.reference_high(3).cycles);
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
      control_stored <= x"00000000";
      discharge_stored <= x"00000000";
      timeout_stored <= x"00000000";
      pause_stored <= x"00000000";
      short_limit_stored <= x"00000000";
    end if;
  end process;

  from_software.control.enable <= control_stored(0);
  from_software.control.references <= control_stored(1);
  from_software.control.dither_cycles <= unsigned(control_stored(15 downto 8));
  from_software.control.more_charges <= unsigned(control_stored(23 downto 16));

  from_software.discharge.cycles <= unsigned(discharge_stored(23 downto 0));

  from_software.timeout.cycles <= unsigned(timeout_stored(23 downto 0));

  from_software.pause.cycles <= unsigned(pause_stored(23 downto 0));

  from_software.short_limit.cycles <= unsigned(short_limit_stored(31 downto 0));

end architecture;
