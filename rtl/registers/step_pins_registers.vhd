-- SPDX-License-Identifier: Apache-2.0
-- Registers of `step_pins`. Generated from rtl/motion/step_pins.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.step_pins_registers_pkg.all;

entity step_pins_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out step_pins_from_software_t;
    to_software : in step_pins_to_software_t
  );
end entity;

architecture rtl of step_pins_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(2 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal control_word : std_ulogic_vector(31 downto 0);
  signal step_word : std_ulogic_vector(31 downto 0);
  signal step_stored : step_pins_step_t := step_pins_step_after_reset;
  signal direction_word : std_ulogic_vector(31 downto 0);
  signal direction_stored : step_pins_direction_t := step_pins_direction_after_reset;
  signal stop_word : std_ulogic_vector(31 downto 0);
  signal status_word : std_ulogic_vector(31 downto 0);
  signal control_written : std_ulogic := '0';
  signal stop_written : std_ulogic := '0';
  signal status_written : std_ulogic := '0';

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
      register_index <= request.address(4 downto 2);
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

  readable <= '1' when request.address(11 downto 2) <= 4 else '0';

  writable <= '1' when request.address(11 downto 2) <= 4 else '0';

  control_word <= to_word(to_software.control)
    when request.address(11 downto 2) = 0 else (others => '0');
  step_word <= to_word(step_stored)
    when request.address(11 downto 2) = 1 else (others => '0');
  direction_word <= to_word(direction_stored)
    when request.address(11 downto 2) = 2 else (others => '0');
  stop_word <= to_word(to_software.stop)
    when request.address(11 downto 2) = 3 else (others => '0');
  status_word <= to_word(to_software.status)
    when request.address(11 downto 2) = 4 else (others => '0');

  read_word <= control_word
    or step_word
    or direction_word
    or stop_word
    or status_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 1 then
      step_stored <= to_step_pins_step(written_data);
    end if;
    if writing = '1' and register_index = 2 then
      direction_stored <= to_step_pins_direction(written_data);
    end if;
    if reset then
      step_stored <= step_pins_step_after_reset;
      direction_stored <= step_pins_direction_after_reset;
    end if;
  end process;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    control_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 0);
    stop_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 3);
    status_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 4);
    if reset then
      control_written <= '0';
      stop_written <= '0';
      status_written <= '0';
    end if;
  end process;

  from_software.control_written <= control_written;
  from_software.control <= to_step_pins_control(written_data);
  from_software.step <= step_stored;
  from_software.direction <= direction_stored;
  from_software.stop_written <= stop_written;
  from_software.stop <= to_step_pins_stop(written_data);
  from_software.status_written <= status_written;
  from_software.status <= to_step_pins_status(written_data);

end architecture;
