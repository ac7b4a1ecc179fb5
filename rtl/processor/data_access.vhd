-- SPDX-License-Identifier: Apache-2.0
-- Load/store unit: requests to the memory or the bus, with store data in its byte lanes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity data_access is
  generic (
    memory_address : unsigned(31 downto 0);
    memory_size_bytes : positive
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- A load or store is executed in this clock.
    enable : in std_ulogic;
    store : in std_ulogic;
    -- Base, immediate and their sum, the address.
    base : in unsigned(31 downto 0);
    offset : in unsigned(31 downto 0);
    address : in unsigned(31 downto 0);
    -- As funct3(1 downto 0).
    size : in std_ulogic_vector(1 downto 0);
    store_data : in word_t;
    memory_request : out memory_request_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    -- The address is not a multiple of the size: no access is made.
    misaligned : out std_ulogic;
    to_memory : out std_ulogic;
    -- A bus access is in progress: from the clock after `enable` to that of the response.
    bus_active : out std_ulogic;
    done : out std_ulogic;
    error : out std_ulogic
  );
end entity;

architecture rtl of data_access is

  signal lanes : std_ulogic_vector(3 downto 0);
  signal lane_data : word_t;
  constant memory_address_bits : positive := address_bits_of(memory_size_bytes);
  constant memory_number : unsigned(31 downto memory_address_bits) :=
    memory_address(31 downto memory_address_bits);
  signal bit_matches : unsigned(31 downto memory_address_bits + 1);
  subtype lower_bits is natural range 30 downto memory_address_bits;
  signal matches_carry : unsigned(32 downto memory_address_bits + 1);
  signal beyond_end, in_memory, aligned : std_ulogic;

begin

  -- Critical path: address decoding without waiting for the upper bits of the sum. If the lowest of them
  -- matches the memory's, each further one matches if its carry in is what a matching bit below it generates.
  bit_matches <=
    (base(bit_matches'range) xor offset(bit_matches'range) xor memory_number(bit_matches'range)) xnor
    ((base(lower_bits) and offset(lower_bits)) or
     ((base(lower_bits) or offset(lower_bits)) and not memory_number(lower_bits)));
  -- AND of all, by a carry chain.
  matches_carry <= ('0' & bit_matches) + 1;
  beyond_end <= is_beyond_memory(address, memory_size_bytes);
  in_memory <= matches_carry(32) and not beyond_end and
               (address(memory_address_bits) xnor memory_number(memory_address_bits));
  aligned <= not ((size(0) and address(0)) or (size(1) and (address(0) or address(1))));
  misaligned <= not aligned;
  to_memory <= in_memory;

  lanes <= "1111" when size(1) else
           address(1) & address(1) & not address(1) & not address(1) when size(0) else
           (address(1) and address(0)) & (address(1) and not address(0)) &
           (not address(1) and address(0)) & (address(1) nor address(0));
  lane_data <= store_data when size(1) else
               store_data(15 downto 0) & store_data(15 downto 0) when size(0) else
               store_data(7 downto 0) & store_data(7 downto 0) & store_data(7 downto 0) &
               store_data(7 downto 0);

  -- `in_memory` settles late. Without it, the memory is also read on bus accesses, which has no effect.
  memory_request.enable <= enable;
  memory_request.write_bytes <= lanes and (3 downto 0 => store and in_memory and aligned);
  memory_request.address <= address(31 downto 2);
  memory_request.data <= lane_data;

  use_bus : process
  begin
    wait until rising_edge(clk);
    if bus_request.strobe then
      if bus_response.acknowledge or bus_response.error then
        bus_request.strobe <= '0';
      end if;
    elsif enable and aligned and not in_memory then
      bus_request.strobe <= '1';
      bus_request.write <= store;
      bus_request.address <= address;
      bus_request.select_bytes <= lanes;
      bus_request.data <= lane_data;
    end if;

    if reset then
      bus_request.strobe <= '0';
    end if;
  end process;

  bus_active <= bus_request.strobe;
  done <= bus_request.strobe and bus_response.acknowledge;
  error <= bus_request.strobe and bus_response.error;

end architecture;
