-- SPDX-License-Identifier: Apache-2.0
-- Sends loads and stores to the memory or over the bus, stored bytes in the lanes where they
-- belong.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity data_access is
  generic (
    memory_address : unsigned(31 downto 0);
    -- The memory holds 2 to this power bytes.
    memory_address_bits : positive;
    -- But for the last quarter of them.
    memory_lacks_quarter : boolean := false
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- A load or store is executed in this clock.
    enable : in std_ulogic;
    store : in std_ulogic;
    -- Its base, its constant, and their sum.
    base : in unsigned(31 downto 0);
    offset : in unsigned(31 downto 0);
    address : in unsigned(31 downto 0);
    -- In the coding of funct3.
    size : in std_ulogic_vector(1 downto 0);
    store_data : in word_t;
    memory_request : out memory_request_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    -- Not at a multiple of its size; nothing is accessed then.
    misaligned : out std_ulogic;
    to_memory : out std_ulogic;
    -- The bus has the request: from the clock after `enable` to that of the response.
    bus_active : out std_ulogic;
    done : out std_ulogic;
    error : out std_ulogic
  );
end entity;

architecture rtl of data_access is

  signal lanes : std_ulogic_vector(3 downto 0);
  signal lane_data : word_t;
  constant memory_number : unsigned(31 downto memory_address_bits) :=
    memory_address(31 downto memory_address_bits);
  signal is_right : unsigned(31 downto memory_address_bits + 1);
  subtype before is natural range 30 downto memory_address_bits;
  signal behind_right : unsigned(32 downto memory_address_bits + 1);
  signal in_lacking_quarter, in_memory, aligned : std_ulogic;

begin

  -- Told without the sum's upper bits, which come late: where the lowest of them is right, each further one
  -- is right if the carry into it is the one that a right bit before it leaves behind.
  is_right <=
    (base(is_right'range) xor offset(is_right'range) xor memory_number(is_right'range)) xnor
    ((base(before) and offset(before)) or
     ((base(before) or offset(before)) and not memory_number(before)));
  -- By a chain of carries.
  behind_right <= ('0' & is_right) + 1;
  in_lacking_quarter <= address(memory_address_bits - 1) and address(memory_address_bits - 2)
    when memory_lacks_quarter else '0';
  in_memory <= behind_right(32) and not in_lacking_quarter and
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

  -- Whether an access is one of the memory comes late in the clock; reading it in vain does no harm.
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
