-- SPDX-License-Identifier: Apache-2.0
-- Registers of `fan`. Generated from rtl/thermal/fan.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.fan_registers_pkg.all;

entity fan_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out fan_from_software_t
  );
end entity;

architecture rtl of fan_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(0 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal duty_word : std_ulogic_vector(31 downto 0);
  signal duty_stored : fan_duty_t := fan_duty_after_reset;
  signal period_word : std_ulogic_vector(31 downto 0);
  signal period_stored : fan_period_t := fan_period_after_reset;

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
      register_index <= request.address(2 downto 2);
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

  readable <= '1' when request.address(11 downto 2) <= 1 else '0';

  writable <= '1' when request.address(11 downto 2) <= 1 else '0';

  duty_word <= to_word(duty_stored)
    when request.address(11 downto 2) = 0 else (others => '0');
  period_word <= to_word(period_stored)
    when request.address(11 downto 2) = 1 else (others => '0');

  read_word <= duty_word
    or period_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 0 then
      duty_stored <= to_fan_duty(written_data);
    end if;
    if writing = '1' and register_index = 1 then
      period_stored <= to_fan_period(written_data);
    end if;
    if reset then
      duty_stored <= fan_duty_after_reset;
      period_stored <= fan_period_after_reset;
    end if;
  end process;

  from_software.duty <= duty_stored;
  from_software.period <= period_stored;

end architecture;
