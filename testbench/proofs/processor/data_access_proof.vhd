-- SPDX-License-Identifier: Apache-2.0
-- Loads and stores access memory or bus by their address, with their bytes; a bus request is stable until
-- its response, and no other one begins meanwhile.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.data_width_pkg.all;
use work.instruction_set_pkg.all;
use work.memory_pkg.all;

entity data_access_proof is
  generic (
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    enable : in std_ulogic;
    store : in std_ulogic;
    address : in unsigned(31 downto 0);
    -- The immediate in it.
    offset : in unsigned(31 downto 0);
    size : in std_ulogic_vector(1 downto 0);
    store_data : in value_t;
    -- Previous content of the memory word.
    old_data : in value_t;
    bus_response : in bus_response_t
  );
end entity;

architecture proof of data_access_proof is

  constant memory_address : unsigned(31 downto 0) := x"80000000";

  signal word : value_t;
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal misaligned, to_memory, bus_active, done, error : std_ulogic;
  -- Specified.
  signal is_in_memory, is_aligned, begins, answered : std_ulogic;
  signal new_data, memory_data : value_t;
  signal started : std_ulogic := '0';
  signal busy, wrote : std_ulogic := '0';
  signal asked_address : unsigned(31 downto 0);
  signal asked_lanes : std_ulogic_vector(3 downto 0);
  signal asked_data, asked_bits : value_t;

  default clock is rising_edge(clk);

begin

  word <= 17x"0" & '0' & size & "00000" & "0100011";
  is_in_memory <= '1' when address >= memory_address and address < memory_address + memory_size_bytes
    else '0';
  is_aligned <= '0' when is_misaligned(word, address) else '1';
  new_data <= stored(word, old_data, store_data, address);
  answered <= bus_response.acknowledge or bus_response.error;
  begins <= enable and is_aligned and not is_in_memory and not busy;

  data_access : entity work.data_access
    generic map (
      memory_address => memory_address,
      memory_size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      reset => reset,
      enable => enable,
      store => store,
      base => address - offset,
      offset => offset,
      address => address,
      size => size,
      store_data => store_data,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => misaligned,
      to_memory => to_memory,
      bus_active => bus_active,
      done => done,
      error => error);

  write_memory : process (all)
  begin
    memory_data <= old_data;
    for lane in 0 to 3 loop
      if memory_request.write_bytes(lane) then
        memory_data(8 * lane + 7 downto 8 * lane) <= memory_request.data(8 * lane + 7 downto 8 * lane);
      end if;
    end loop;
  end process;

  choose_bits : for lane in 0 to 3 generate
    asked_bits(8 * lane + 7 downto 8 * lane) <= (others => asked_lanes(lane));
  end generate;

  follow : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    if begins then
      busy <= '1';
      wrote <= store;
      asked_address <= address;
      asked_lanes <= lanes(word, address);
      -- In the selected lanes.
      asked_data <= stored(word, x"00000000", store_data, address);
    elsif answered then
      busy <= '0';
    end if;
    if reset then
      busy <= '0';
    end if;
  end process;

  it_starts_with_reset : assume always (not started -> reset);
  size_is_legal : assume always (size /= "11");
  no_access_during_bus_access : assume always not (enable and bus_active);

  misaligned_is_right : assert always (misaligned = not is_aligned);
  to_memory_is_right : assert always (to_memory = is_in_memory);
  memory_access_is_requested : assert always
    ((enable and is_aligned and is_in_memory) -> memory_request.enable);
  only_aligned_memory_stores_write : assert always
    ((memory_request.enable = '1' and memory_request.write_bytes /= "0000") ->
     (enable and is_aligned and is_in_memory));
  memory_address_is_right : assert always (memory_request.address = address(31 downto 2));
  loads_write_nothing : assert always (not store -> memory_request.write_bytes = "0000");
  stores_write_their_bytes_only : assert always
    ((enable and is_aligned and is_in_memory and store) -> memory_data = new_data);

  strobe_is_held_until_response : assert always
    (started -> (bus_request.strobe = busy and bus_active = busy));
  bus_request_is_stable : assert always
    (busy -> (bus_request.write = wrote and bus_request.address = asked_address and
              bus_request.select_bytes = asked_lanes));
  byte_lanes_are_right : assert always
    ((busy and wrote) -> (bus_request.data and asked_bits) = asked_data);
  done_and_error_are_right : assert always
    (started -> (done = (busy and bus_response.acknowledge) and error = (busy and bus_response.error)));

end architecture;
