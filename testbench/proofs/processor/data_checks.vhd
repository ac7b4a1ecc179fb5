-- SPDX-License-Identifier: Apache-2.0
-- Loads return what was stored, in memory and over the bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.data_width_pkg.all;
use work.instruction_set_pkg.all;

entity data_checks is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- A retirement or trap; a retirement; one that writes this value.
    event, completed, writes : in std_ulogic;
    value : in value_t;
    word : in value_t;
    -- What a store stores.
    second : in value_t;
    data_address : in unsigned(31 downto 0);
    -- A load or store outside of the memory; one that must go over the bus.
    over_bus, requests_bus : in std_ulogic;
    bus_request : in bus_request_t;
    bus_response : in bus_response_t;
    -- Any word of the data, with its initial value.
    data_place : in unsigned(31 downto 2);
    data_at_first : in value_t;
    -- Of the last response.
    bus_failed : buffer std_ulogic;
    -- The proof assumes that the bus responds then.
    bus_must_respond : out std_ulogic
  );
end entity;

architecture proof of data_checks is

  constant most_clocks_of_bus : positive := 2;

  signal kind : kind_t;
  signal word_in_memory : value_t := (others => '0');
  -- The last bus response without an event since.
  signal bus_answered : std_ulogic := '0';
  signal bus_wrote : std_ulogic;
  signal bus_address : unsigned(31 downto 0);
  signal bus_lanes : std_ulogic_vector(3 downto 0);
  signal bus_data, bus_written : value_t;
  signal bus_waited : natural range 0 to most_clocks_of_bus := 0;

  default clock is rising_edge(clk);

begin

  kind <= kind_of(word);

  follow_memory : process
  begin
    wait until rising_edge(clk);
    if completed = '1' and kind = store and data_address(31 downto 2) = data_place then
      word_in_memory <= stored(word, word_in_memory, second, data_address);
    end if;
    if reset then
      word_in_memory <= data_at_first;
    end if;
  end process;

  watch_bus : process
  begin
    wait until rising_edge(clk);
    if event then
      bus_answered <= '0';
    end if;
    bus_waited <= 0;
    if bus_request.strobe = '1' and bus_response.acknowledge = '0' and bus_response.error = '0' and
       bus_waited < most_clocks_of_bus then
      bus_waited <= bus_waited + 1;
    end if;
    if bus_request.strobe = '1' and (bus_response.acknowledge = '1' or bus_response.error = '1') then
      bus_answered <= '1';
      bus_failed <= bus_response.error;
      bus_wrote <= bus_request.write;
      bus_address <= bus_request.address;
      bus_lanes <= bus_request.select_bytes;
      bus_data <= bus_response.data;
      bus_written <= bus_request.data;
    end if;
    if reset then
      bus_answered <= '0';
      bus_waited <= 0;
    end if;
  end process;

  bus_must_respond <= '1' when bus_request.strobe = '1' and bus_waited = most_clocks_of_bus else '0';

  loads_return_stored_data : assert always
    ((writes = '1' and kind = load and over_bus = '0' and data_address(31 downto 2) = data_place) ->
     value = loaded(word, word_in_memory, data_address));
  bus_request_is_right : assert always
    (requests_bus ->
     (bus_answered = '1' and bus_address = data_address and (bus_wrote = '1') = (kind = store) and
      bus_lanes = lanes(word, data_address) and
      (kind = load or stored(word, bus_written, second, data_address) = bus_written)));
  no_other_bus_request : assert always ((event and not requests_bus) -> not bus_answered);
  bus_loads_are_right : assert always
    ((writes = '1' and kind = load and requests_bus = '1') ->
     value = loaded(word, bus_data, data_address));

end architecture;
