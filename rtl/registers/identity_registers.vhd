-- SPDX-License-Identifier: Apache-2.0
-- Registers of `identity`. Generated from rtl/bus/identity.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.identity_registers_pkg.all;

entity identity_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    to_software : in identity_to_software_t
  );
end entity;

architecture rtl of identity_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(2 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal magic_word : std_ulogic_vector(31 downto 0);
  signal version_word : std_ulogic_vector(31 downto 0);
  signal clock_word : std_ulogic_vector(31 downto 0);
  signal memory_word : std_ulogic_vector(31 downto 0);
  signal motion_word : std_ulogic_vector(31 downto 0);
  signal thermal_word : std_ulogic_vector(31 downto 0);

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

  readable <= '1' when request.address(11 downto 2) <= 5 else '0';

  writable <= '0';

  magic_word <= to_word(to_software.magic)
    when request.address(11 downto 2) = 0 else (others => '0');
  version_word <= to_word(to_software.version)
    when request.address(11 downto 2) = 1 else (others => '0');
  clock_word <= to_word(to_software.clock)
    when request.address(11 downto 2) = 2 else (others => '0');
  memory_word <= to_word(to_software.memory)
    when request.address(11 downto 2) = 3 else (others => '0');
  motion_word <= to_word(to_software.motion)
    when request.address(11 downto 2) = 4 else (others => '0');
  thermal_word <= to_word(to_software.thermal)
    when request.address(11 downto 2) = 5 else (others => '0');

  read_word <= magic_word
    or version_word
    or clock_word
    or memory_word
    or motion_word
    or thermal_word;

end architecture;
