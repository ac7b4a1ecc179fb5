-- SPDX-License-Identifier: Apache-2.0
-- Registers of `heater_control`. Generated from rtl/thermal/heater_control.toml: do not edit.

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

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(4 downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  signal watchdog_word : std_ulogic_vector(31 downto 0);
  signal sensor_timeout_word : std_ulogic_vector(31 downto 0);
  signal slot_word : std_ulogic_vector(31 downto 0);
  signal slot_stored : heater_control_slot_t := heater_control_slot_after_reset;
  signal duty_0_word : std_ulogic_vector(31 downto 0);
  signal duty_0_stored : heater_control_duty_t := heater_control_duty_after_reset;
  signal duty_1_word : std_ulogic_vector(31 downto 0);
  signal duty_1_stored : heater_control_duty_t := heater_control_duty_after_reset;
  signal duty_2_word : std_ulogic_vector(31 downto 0);
  signal duty_2_stored : heater_control_duty_t := heater_control_duty_after_reset;
  signal duty_3_word : std_ulogic_vector(31 downto 0);
  signal duty_3_stored : heater_control_duty_t := heater_control_duty_after_reset;
  signal minimum_count_0_word : std_ulogic_vector(31 downto 0);
  signal minimum_count_1_word : std_ulogic_vector(31 downto 0);
  signal minimum_count_2_word : std_ulogic_vector(31 downto 0);
  signal minimum_count_3_word : std_ulogic_vector(31 downto 0);
  signal maximum_count_0_word : std_ulogic_vector(31 downto 0);
  signal maximum_count_1_word : std_ulogic_vector(31 downto 0);
  signal maximum_count_2_word : std_ulogic_vector(31 downto 0);
  signal maximum_count_3_word : std_ulogic_vector(31 downto 0);
  signal status_0_word : std_ulogic_vector(31 downto 0);
  signal status_1_word : std_ulogic_vector(31 downto 0);
  signal status_2_word : std_ulogic_vector(31 downto 0);
  signal status_3_word : std_ulogic_vector(31 downto 0);
  signal hot_count_0_word : std_ulogic_vector(31 downto 0);
  signal hot_count_1_word : std_ulogic_vector(31 downto 0);
  signal hot_count_2_word : std_ulogic_vector(31 downto 0);
  signal hot_count_3_word : std_ulogic_vector(31 downto 0);
  signal settle_0_word : std_ulogic_vector(31 downto 0);
  signal settle_1_word : std_ulogic_vector(31 downto 0);
  signal settle_2_word : std_ulogic_vector(31 downto 0);
  signal settle_3_word : std_ulogic_vector(31 downto 0);
  signal supply_word : std_ulogic_vector(31 downto 0);
  signal feed_written : std_ulogic := '0';
  signal watchdog_written : std_ulogic := '0';
  signal sensor_timeout_written : std_ulogic := '0';
  signal clear_written : std_ulogic := '0';
  signal minimum_count_0_written : std_ulogic := '0';
  signal minimum_count_1_written : std_ulogic := '0';
  signal minimum_count_2_written : std_ulogic := '0';
  signal minimum_count_3_written : std_ulogic := '0';
  signal maximum_count_0_written : std_ulogic := '0';
  signal maximum_count_1_written : std_ulogic := '0';
  signal maximum_count_2_written : std_ulogic := '0';
  signal maximum_count_3_written : std_ulogic := '0';
  signal hot_count_0_written : std_ulogic := '0';
  signal hot_count_1_written : std_ulogic := '0';
  signal hot_count_2_written : std_ulogic := '0';
  signal hot_count_3_written : std_ulogic := '0';
  signal settle_0_written : std_ulogic := '0';
  signal settle_1_written : std_ulogic := '0';
  signal settle_2_written : std_ulogic := '0';
  signal settle_3_written : std_ulogic := '0';
  signal supply_written : std_ulogic := '0';

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

  readable <= '1' when (request.address(11 downto 2) >= 1 and request.address(11 downto 2) <= 3)
    or (request.address(11 downto 2) >= 5 and request.address(11 downto 2) <= 29) else '0';

  writable <= '1' when request.address(11 downto 2) <= 16
    or (request.address(11 downto 2) >= 21 and request.address(11 downto 2) <= 29) else '0';

  watchdog_word <= to_word(to_software.watchdog)
    when request.address(11 downto 2) = 1 else (others => '0');
  sensor_timeout_word <= to_word(to_software.sensor_timeout)
    when request.address(11 downto 2) = 2 else (others => '0');
  slot_word <= to_word(slot_stored)
    when request.address(11 downto 2) = 3 else (others => '0');
  duty_0_word <= to_word(duty_0_stored)
    when request.address(11 downto 2) = 5 else (others => '0');
  duty_1_word <= to_word(duty_1_stored)
    when request.address(11 downto 2) = 6 else (others => '0');
  duty_2_word <= to_word(duty_2_stored)
    when request.address(11 downto 2) = 7 else (others => '0');
  duty_3_word <= to_word(duty_3_stored)
    when request.address(11 downto 2) = 8 else (others => '0');
  minimum_count_0_word <= to_word(to_software.minimum_count(0))
    when request.address(11 downto 2) = 9 else (others => '0');
  minimum_count_1_word <= to_word(to_software.minimum_count(1))
    when request.address(11 downto 2) = 10 else (others => '0');
  minimum_count_2_word <= to_word(to_software.minimum_count(2))
    when request.address(11 downto 2) = 11 else (others => '0');
  minimum_count_3_word <= to_word(to_software.minimum_count(3))
    when request.address(11 downto 2) = 12 else (others => '0');
  maximum_count_0_word <= to_word(to_software.maximum_count(0))
    when request.address(11 downto 2) = 13 else (others => '0');
  maximum_count_1_word <= to_word(to_software.maximum_count(1))
    when request.address(11 downto 2) = 14 else (others => '0');
  maximum_count_2_word <= to_word(to_software.maximum_count(2))
    when request.address(11 downto 2) = 15 else (others => '0');
  maximum_count_3_word <= to_word(to_software.maximum_count(3))
    when request.address(11 downto 2) = 16 else (others => '0');
  status_0_word <= to_word(to_software.status(0))
    when request.address(11 downto 2) = 17 else (others => '0');
  status_1_word <= to_word(to_software.status(1))
    when request.address(11 downto 2) = 18 else (others => '0');
  status_2_word <= to_word(to_software.status(2))
    when request.address(11 downto 2) = 19 else (others => '0');
  status_3_word <= to_word(to_software.status(3))
    when request.address(11 downto 2) = 20 else (others => '0');
  hot_count_0_word <= to_word(to_software.hot_count(0))
    when request.address(11 downto 2) = 21 else (others => '0');
  hot_count_1_word <= to_word(to_software.hot_count(1))
    when request.address(11 downto 2) = 22 else (others => '0');
  hot_count_2_word <= to_word(to_software.hot_count(2))
    when request.address(11 downto 2) = 23 else (others => '0');
  hot_count_3_word <= to_word(to_software.hot_count(3))
    when request.address(11 downto 2) = 24 else (others => '0');
  settle_0_word <= to_word(to_software.settle(0))
    when request.address(11 downto 2) = 25 else (others => '0');
  settle_1_word <= to_word(to_software.settle(1))
    when request.address(11 downto 2) = 26 else (others => '0');
  settle_2_word <= to_word(to_software.settle(2))
    when request.address(11 downto 2) = 27 else (others => '0');
  settle_3_word <= to_word(to_software.settle(3))
    when request.address(11 downto 2) = 28 else (others => '0');
  supply_word <= to_word(to_software.supply)
    when request.address(11 downto 2) = 29 else (others => '0');

  read_word <= watchdog_word
    or sensor_timeout_word
    or slot_word
    or duty_0_word
    or duty_1_word
    or duty_2_word
    or duty_3_word
    or minimum_count_0_word
    or minimum_count_1_word
    or minimum_count_2_word
    or minimum_count_3_word
    or maximum_count_0_word
    or maximum_count_1_word
    or maximum_count_2_word
    or maximum_count_3_word
    or status_0_word
    or status_1_word
    or status_2_word
    or status_3_word
    or hot_count_0_word
    or hot_count_1_word
    or hot_count_2_word
    or hot_count_3_word
    or settle_0_word
    or settle_1_word
    or settle_2_word
    or settle_3_word
    or supply_word;

  store : process
  begin
    wait until rising_edge(clk);
    if writing = '1' and register_index = 3 then
      slot_stored <= to_heater_control_slot(written_data);
    end if;
    if writing = '1' and register_index = 5 then
      duty_0_stored <= to_heater_control_duty(written_data);
    end if;
    if writing = '1' and register_index = 6 then
      duty_1_stored <= to_heater_control_duty(written_data);
    end if;
    if writing = '1' and register_index = 7 then
      duty_2_stored <= to_heater_control_duty(written_data);
    end if;
    if writing = '1' and register_index = 8 then
      duty_3_stored <= to_heater_control_duty(written_data);
    end if;
    if reset then
      slot_stored <= heater_control_slot_after_reset;
      duty_0_stored <= heater_control_duty_after_reset;
      duty_1_stored <= heater_control_duty_after_reset;
      duty_2_stored <= heater_control_duty_after_reset;
      duty_3_stored <= heater_control_duty_after_reset;
    end if;
  end process;

  -- Which register it is, is found out before the clock in which the hardware needs it. Only what
  -- can be written, or read, has such an event: the address alone says that it is known.
  find_events : process
  begin
    wait until rising_edge(clk);
    feed_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 0);
    watchdog_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 1);
    sensor_timeout_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 2);
    clear_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 4);
    minimum_count_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 9);
    minimum_count_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 10);
    minimum_count_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 11);
    minimum_count_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 12);
    maximum_count_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 13);
    maximum_count_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 14);
    maximum_count_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 15);
    maximum_count_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 16);
    hot_count_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 21);
    hot_count_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 22);
    hot_count_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 23);
    hot_count_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 24);
    settle_0_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 25);
    settle_1_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 26);
    settle_2_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 27);
    settle_3_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 28);
    supply_written <= access_begins and whole_write and (request.address(11 downto 2) ?= 29);
    if reset then
      feed_written <= '0';
      watchdog_written <= '0';
      sensor_timeout_written <= '0';
      clear_written <= '0';
      minimum_count_0_written <= '0';
      minimum_count_1_written <= '0';
      minimum_count_2_written <= '0';
      minimum_count_3_written <= '0';
      maximum_count_0_written <= '0';
      maximum_count_1_written <= '0';
      maximum_count_2_written <= '0';
      maximum_count_3_written <= '0';
      hot_count_0_written <= '0';
      hot_count_1_written <= '0';
      hot_count_2_written <= '0';
      hot_count_3_written <= '0';
      settle_0_written <= '0';
      settle_1_written <= '0';
      settle_2_written <= '0';
      settle_3_written <= '0';
      supply_written <= '0';
    end if;
  end process;

  from_software.feed_written <= feed_written;
  from_software.feed <= to_heater_control_feed(written_data);
  from_software.watchdog_written <= watchdog_written;
  from_software.watchdog <= to_heater_control_watchdog(written_data);
  from_software.sensor_timeout_written <= sensor_timeout_written;
  from_software.sensor_timeout <= to_heater_control_sensor_timeout(written_data);
  from_software.slot <= slot_stored;
  from_software.clear_written <= clear_written;
  from_software.clear <= to_heater_control_clear(written_data);
  from_software.duty(0) <= duty_0_stored;
  from_software.duty(1) <= duty_1_stored;
  from_software.duty(2) <= duty_2_stored;
  from_software.duty(3) <= duty_3_stored;
  from_software.minimum_count_written(0) <= minimum_count_0_written;
  from_software.minimum_count(0) <= to_heater_control_minimum_count(written_data);
  from_software.minimum_count_written(1) <= minimum_count_1_written;
  from_software.minimum_count(1) <= to_heater_control_minimum_count(written_data);
  from_software.minimum_count_written(2) <= minimum_count_2_written;
  from_software.minimum_count(2) <= to_heater_control_minimum_count(written_data);
  from_software.minimum_count_written(3) <= minimum_count_3_written;
  from_software.minimum_count(3) <= to_heater_control_minimum_count(written_data);
  from_software.maximum_count_written(0) <= maximum_count_0_written;
  from_software.maximum_count(0) <= to_heater_control_maximum_count(written_data);
  from_software.maximum_count_written(1) <= maximum_count_1_written;
  from_software.maximum_count(1) <= to_heater_control_maximum_count(written_data);
  from_software.maximum_count_written(2) <= maximum_count_2_written;
  from_software.maximum_count(2) <= to_heater_control_maximum_count(written_data);
  from_software.maximum_count_written(3) <= maximum_count_3_written;
  from_software.maximum_count(3) <= to_heater_control_maximum_count(written_data);
  from_software.hot_count_written(0) <= hot_count_0_written;
  from_software.hot_count(0) <= to_heater_control_hot_count(written_data);
  from_software.hot_count_written(1) <= hot_count_1_written;
  from_software.hot_count(1) <= to_heater_control_hot_count(written_data);
  from_software.hot_count_written(2) <= hot_count_2_written;
  from_software.hot_count(2) <= to_heater_control_hot_count(written_data);
  from_software.hot_count_written(3) <= hot_count_3_written;
  from_software.hot_count(3) <= to_heater_control_hot_count(written_data);
  from_software.settle_written(0) <= settle_0_written;
  from_software.settle(0) <= to_heater_control_settle(written_data);
  from_software.settle_written(1) <= settle_1_written;
  from_software.settle(1) <= to_heater_control_settle(written_data);
  from_software.settle_written(2) <= settle_2_written;
  from_software.settle(2) <= to_heater_control_settle(written_data);
  from_software.settle_written(3) <= settle_3_written;
  from_software.settle(3) <= to_heater_control_settle(written_data);
  from_software.supply_written <= supply_written;
  from_software.supply <= to_heater_control_supply(written_data);

end architecture;
