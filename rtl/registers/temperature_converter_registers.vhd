-- SPDX-License-Identifier: Apache-2.0
-- Registers of `temperature_converter`. Generated from rtl/thermal/temperature_converter.toml: do not edit.

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

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(4 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal control_word : std_ulogic_vector(31 downto 0);
  signal discharge_word : std_ulogic_vector(31 downto 0);
  signal timeout_word : std_ulogic_vector(31 downto 0);
  signal pause_word : std_ulogic_vector(31 downto 0);
  signal short_limit_word : std_ulogic_vector(31 downto 0);
  signal status_0_word : std_ulogic_vector(31 downto 0);
  signal status_1_word : std_ulogic_vector(31 downto 0);
  signal status_2_word : std_ulogic_vector(31 downto 0);
  signal status_3_word : std_ulogic_vector(31 downto 0);
  signal age_0_word : std_ulogic_vector(31 downto 0);
  signal age_1_word : std_ulogic_vector(31 downto 0);
  signal age_2_word : std_ulogic_vector(31 downto 0);
  signal age_3_word : std_ulogic_vector(31 downto 0);
  signal thermistor_0_word : std_ulogic_vector(31 downto 0);
  signal thermistor_1_word : std_ulogic_vector(31 downto 0);
  signal thermistor_2_word : std_ulogic_vector(31 downto 0);
  signal thermistor_3_word : std_ulogic_vector(31 downto 0);
  signal reference_low_0_word : std_ulogic_vector(31 downto 0);
  signal reference_low_1_word : std_ulogic_vector(31 downto 0);
  signal reference_low_2_word : std_ulogic_vector(31 downto 0);
  signal reference_low_3_word : std_ulogic_vector(31 downto 0);
  signal reference_high_0_word : std_ulogic_vector(31 downto 0);
  signal reference_high_1_word : std_ulogic_vector(31 downto 0);
  signal reference_high_2_word : std_ulogic_vector(31 downto 0);
  signal reference_high_3_word : std_ulogic_vector(31 downto 0);
  signal settings_lock_word : std_ulogic_vector(31 downto 0);
  signal control_written : std_ulogic := '0';
  signal discharge_written : std_ulogic := '0';
  signal timeout_written : std_ulogic := '0';
  signal pause_written : std_ulogic := '0';
  signal short_limit_written : std_ulogic := '0';
  signal settings_lock_written : std_ulogic := '0';

begin

  access_begins <= request.strobe and not answered;

  -- Answers in the clock after the strobe; an error for everything that is not described.
  answer : process
  begin
    wait until rising_edge(clk);
    answered <= access_begins;
    writing <= access_begins and known and request.write;
    response.acknowledge <= access_begins and known;
    response.error <= access_begins and not known;
    response.data <= (others => '0');
    if access_begins then
      response.data <= read_word;
      written_data <= request.data;
      register_index <= request.address(6 downto 2);
    end if;
    if reset then
      answered <= '0';
      writing <= '0';
      response <= bus_response_idle;
    end if;
  end process;

  -- Whole words only.
  whole_write <= request.write and (and request.select_bytes);
  known <= writable and whole_write when request.write = '1' else readable;

  readable <= '1' when request.address(11 downto 2) <= 25 else '0';

  writable <= '1' when request.address(11 downto 2) <= 4
    or request.address(11 downto 2) = 25 else '0';

  control_word <= to_word(to_software.control)
    when request.address(11 downto 2) = 0 else (others => '0');
  discharge_word <= to_word(to_software.discharge)
    when request.address(11 downto 2) = 1 else (others => '0');
  timeout_word <= to_word(to_software.timeout)
    when request.address(11 downto 2) = 2 else (others => '0');
  pause_word <= to_word(to_software.pause)
    when request.address(11 downto 2) = 3 else (others => '0');
  short_limit_word <= to_word(to_software.short_limit)
    when request.address(11 downto 2) = 4 else (others => '0');
  status_0_word <= to_word(to_software.status(0))
    when request.address(11 downto 2) = 5 else (others => '0');
  status_1_word <= to_word(to_software.status(1))
    when request.address(11 downto 2) = 6 else (others => '0');
  status_2_word <= to_word(to_software.status(2))
    when request.address(11 downto 2) = 7 else (others => '0');
  status_3_word <= to_word(to_software.status(3))
    when request.address(11 downto 2) = 8 else (others => '0');
  age_0_word <= to_word(to_software.age(0))
    when request.address(11 downto 2) = 9 else (others => '0');
  age_1_word <= to_word(to_software.age(1))
    when request.address(11 downto 2) = 10 else (others => '0');
  age_2_word <= to_word(to_software.age(2))
    when request.address(11 downto 2) = 11 else (others => '0');
  age_3_word <= to_word(to_software.age(3))
    when request.address(11 downto 2) = 12 else (others => '0');
  thermistor_0_word <= to_word(to_software.thermistor(0))
    when request.address(11 downto 2) = 13 else (others => '0');
  thermistor_1_word <= to_word(to_software.thermistor(1))
    when request.address(11 downto 2) = 14 else (others => '0');
  thermistor_2_word <= to_word(to_software.thermistor(2))
    when request.address(11 downto 2) = 15 else (others => '0');
  thermistor_3_word <= to_word(to_software.thermistor(3))
    when request.address(11 downto 2) = 16 else (others => '0');
  reference_low_0_word <= to_word(to_software.reference_low(0))
    when request.address(11 downto 2) = 17 else (others => '0');
  reference_low_1_word <= to_word(to_software.reference_low(1))
    when request.address(11 downto 2) = 18 else (others => '0');
  reference_low_2_word <= to_word(to_software.reference_low(2))
    when request.address(11 downto 2) = 19 else (others => '0');
  reference_low_3_word <= to_word(to_software.reference_low(3))
    when request.address(11 downto 2) = 20 else (others => '0');
  reference_high_0_word <= to_word(to_software.reference_high(0))
    when request.address(11 downto 2) = 21 else (others => '0');
  reference_high_1_word <= to_word(to_software.reference_high(1))
    when request.address(11 downto 2) = 22 else (others => '0');
  reference_high_2_word <= to_word(to_software.reference_high(2))
    when request.address(11 downto 2) = 23 else (others => '0');
  reference_high_3_word <= to_word(to_software.reference_high(3))
    when request.address(11 downto 2) = 24 else (others => '0');
  settings_lock_word <= to_word(to_software.settings_lock)
    when request.address(11 downto 2) = 25 else (others => '0');

  read_word <= control_word
    or discharge_word
    or timeout_word
    or pause_word
    or short_limit_word
    or status_0_word
    or status_1_word
    or status_2_word
    or status_3_word
    or age_0_word
    or age_1_word
    or age_2_word
    or age_3_word
    or thermistor_0_word
    or thermistor_1_word
    or thermistor_2_word
    or thermistor_3_word
    or reference_low_0_word
    or reference_low_1_word
    or reference_low_2_word
    or reference_low_3_word
    or reference_high_0_word
    or reference_high_1_word
    or reference_high_2_word
    or reference_high_3_word
    or settings_lock_word;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    control_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 0);
    discharge_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 1);
    timeout_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 2);
    pause_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 3);
    short_limit_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 4);
    settings_lock_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 25);
    if reset then
      control_written <= '0';
      discharge_written <= '0';
      timeout_written <= '0';
      pause_written <= '0';
      short_limit_written <= '0';
      settings_lock_written <= '0';
    end if;
  end process;

  from_software.control_written <= control_written;
  from_software.control <= to_temperature_converter_control(written_data);
  from_software.discharge_written <= discharge_written;
  from_software.discharge <= to_temperature_converter_discharge(written_data);
  from_software.timeout_written <= timeout_written;
  from_software.timeout <= to_temperature_converter_timeout(written_data);
  from_software.pause_written <= pause_written;
  from_software.pause <= to_temperature_converter_pause(written_data);
  from_software.short_limit_written <= short_limit_written;
  from_software.short_limit <= to_temperature_converter_short_limit(written_data);
  from_software.settings_lock_written <= settings_lock_written;
  from_software.settings_lock <= to_temperature_converter_settings_lock(written_data);

end architecture;
