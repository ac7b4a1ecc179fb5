-- SPDX-License-Identifier: Apache-2.0
-- Registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.timer_registers_pkg.all;

entity timer_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out timer_from_software_t;
    to_software : in timer_to_software_t
  );
end entity;

architecture rtl of timer_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(1 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal time_low_word : std_ulogic_vector(31 downto 0);
  signal time_high_word : std_ulogic_vector(31 downto 0);
  signal compare_low_word : std_ulogic_vector(31 downto 0);
  signal compare_low_stored : timer_compare_low_t := timer_compare_low_after_reset;
  signal compare_high_word : std_ulogic_vector(31 downto 0);
  signal time_low_read : std_ulogic := '0';
  signal compare_high_written : std_ulogic := '0';

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
      register_index <= request.address(3 downto 2);
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

  readable <= '1' when request.address(11 downto 2) <= 3 else '0';

  writable <= '1' when (request.address(11 downto 2) >= 2 and request.address(11 downto 2) <= 3) else '0';

  time_low_word <= to_word(to_software.time_low)
    when request.address(11 downto 2) = 0 else (others => '0');
  time_high_word <= to_word(to_software.time_high)
    when request.address(11 downto 2) = 1 else (others => '0');
  compare_low_word <= to_word(compare_low_stored)
    when request.address(11 downto 2) = 2 else (others => '0');
  compare_high_word <= to_word(to_software.compare_high)
    when request.address(11 downto 2) = 3 else (others => '0');

  read_word <= time_low_word
    or time_high_word
    or compare_low_word
    or compare_high_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 2 then
      compare_low_stored <= to_timer_compare_low(written_data);
    end if;
    if reset then
      compare_low_stored <= timer_compare_low_after_reset;
    end if;
  end process;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    time_low_read <= access_begins and not request.write and (request.address(11 downto 2) ?= 0);
    compare_high_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 3);
    if reset then
      time_low_read <= '0';
      compare_high_written <= '0';
    end if;
  end process;

  from_software.time_low_read <= time_low_read;
  from_software.compare_low <= compare_low_stored;
  from_software.compare_high_written <= compare_high_written;
  from_software.compare_high <= to_timer_compare_high(written_data);

end architecture;
