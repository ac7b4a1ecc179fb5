-- SPDX-License-Identifier: Apache-2.0
-- Loads and stores go where their address says, with the bytes that they mean; one on the bus stays there
-- unchanged until it is answered, and no other begins meanwhile.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.instruction_set_pkg.all;
use work.memory_pkg.all;

entity data_access_proof is
  generic (
    -- All of the 2^memory_address_bits, or without their last quarter.
    memory_address_bits : positive := 16;
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    enable : in std_ulogic;
    store : in std_ulogic;
    address : in unsigned(31 downto 0);
    -- The constant in it.
    offset : in unsigned(31 downto 0);
    size : in std_ulogic_vector(1 downto 0);
    store_data : in value_t;
    -- What stood in memory before.
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
  -- Of the specification.
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
      memory_address_bits => memory_address_bits,
      memory_lacks_quarter => memory_size_bytes /= 2 ** memory_address_bits)
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
      -- Of the lanes that are asked for.
      asked_data <= stored(word, x"00000000", store_data, address);
    elsif answered then
      busy <= '0';
    end if;
    if reset then
      busy <= '0';
    end if;
  end process;

  it_starts_with_reset : assume always (not started -> reset);
  the_size_is_one_of_three : assume always (size /= "11");
  nothing_begins_while_the_bus_is_at_work : assume always not (enable and bus_active);

  misaligned_is_what_the_instruction_set_says : assert always (misaligned = not is_aligned);
  the_memory_is_where_it_is : assert always (to_memory = is_in_memory);
  what_is_its_own_reaches_the_memory : assert always
    ((enable and is_aligned and is_in_memory) -> memory_request.enable);
  only_what_is_aligned_and_its_own_is_written : assert always
    ((memory_request.enable = '1' and memory_request.write_bytes /= "0000") ->
     (enable and is_aligned and is_in_memory));
  the_memory_is_asked_at_the_address : assert always (memory_request.address = address(31 downto 2));
  loads_write_nothing : assert always (not store -> memory_request.write_bytes = "0000");
  stores_write_their_bytes_only : assert always
    ((enable and is_aligned and is_in_memory and store) -> memory_data = new_data);

  the_bus_is_asked_until_it_answers : assert always
    (started -> (bus_request.strobe = busy and bus_active = busy));
  what_is_asked_stays : assert always
    (busy -> (bus_request.write = wrote and bus_request.address = asked_address and
              bus_request.select_bytes = asked_lanes));
  each_lane_has_its_byte : assert always
    ((busy and wrote) -> (bus_request.data and asked_bits) = asked_data);
  an_answer_is_passed_on : assert always
    (started -> (done = (busy and bus_response.acknowledge) and error = (busy and bus_response.error)));

end architecture;
