-- SPDX-License-Identifier: Apache-2.0
-- Registers of `end_stops`. Generated from rtl/motion/end_stops.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.end_stops_registers_pkg.all;

entity end_stops_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out end_stops_from_software_t;
    to_software : in end_stops_to_software_t
  );
end entity;

architecture rtl of end_stops_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(1 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal status_word : std_ulogic_vector(31 downto 0);
  signal filter_word : std_ulogic_vector(31 downto 0);
  signal filter_stored : end_stops_filter_t := end_stops_filter_after_reset;
  signal polarity_word : std_ulogic_vector(31 downto 0);
  signal polarity_stored : end_stops_polarity_t := end_stops_polarity_after_reset;
  signal enable_word : std_ulogic_vector(31 downto 0);
  signal enable_stored : end_stops_enable_t := end_stops_enable_after_reset;

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

  writable <= '1' when (request.address(11 downto 2) >= 1 and request.address(11 downto 2) <= 3) else '0';

  status_word <= to_word(to_software.status)
    when request.address(11 downto 2) = 0 else (others => '0');
  filter_word <= to_word(filter_stored)
    when request.address(11 downto 2) = 1 else (others => '0');
  polarity_word <= to_word(polarity_stored)
    when request.address(11 downto 2) = 2 else (others => '0');
  enable_word <= to_word(enable_stored)
    when request.address(11 downto 2) = 3 else (others => '0');

  read_word <= status_word
    or filter_word
    or polarity_word
    or enable_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 1 then
      filter_stored <= to_end_stops_filter(written_data);
    end if;
    if writing = '1' and register_index = 2 then
      polarity_stored <= to_end_stops_polarity(written_data);
    end if;
    if writing = '1' and register_index = 3 then
      enable_stored <= to_end_stops_enable(written_data);
    end if;
    if reset then
      filter_stored <= end_stops_filter_after_reset;
      polarity_stored <= end_stops_polarity_after_reset;
      enable_stored <= end_stops_enable_after_reset;
    end if;
  end process;

  from_software.filter <= filter_stored;
  from_software.polarity <= polarity_stored;
  from_software.enable <= enable_stored;

end architecture;
