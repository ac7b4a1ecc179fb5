-- SPDX-License-Identifier: Apache-2.0
-- Reads and writes memory and peripherals for a debugger, also while the processor runs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

-- It uses clocks in which the processor does not need the memory's data port, so instruction times are
-- unchanged; on the bus the processor waits for it, as for a slow peripheral.
entity system_bus_access is
  generic (
    memory_address : unsigned(31 downto 0) := x"80000000";
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- For one clock: `written` goes to sbcs, sbaddress0 or sbdata0; sbdata0 was read.
    write_control : in std_ulogic;
    write_address : in std_ulogic;
    write_data : in std_ulogic;
    read_data : in std_ulogic;
    written : in word_t;
    -- sbcs, sbaddress0, sbdata0 (section 3.12 of the specification).
    control : out word_t;
    address : out unsigned(31 downto 0);
    data : out word_t;
    -- The memory's data port is granted in this clock.
    port_free : in std_ulogic;
    memory_request : out memory_request_t;
    memory_data : in word_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t
  );
end entity;

architecture rtl of system_bus_access is

  constant memory_address_bits : positive := address_bits_of(memory_size_bytes);

  -- sbcs.sberror, table 3.12.
  subtype error_t is std_ulogic_vector(2 downto 0);
  constant error_none : error_t := "000";
  constant error_address : error_t := "010";
  constant error_alignment : error_t := "011";
  constant error_size : error_t := "100";

  type state_t is (idle, wait_for_port, receive, wait_for_bus);

  signal state : state_t := idle;
  signal busy, busy_error, read_on_address, increment, read_on_data : std_ulogic := '0';
  signal size : std_ulogic_vector(2 downto 0) := "010";
  signal error : error_t := error_none;
  signal writes : std_ulogic;

  signal touched, begins_read, begin_access : std_ulogic;
  signal access_address : unsigned(31 downto 0);
  signal aligned, in_memory : std_ulogic;
  signal lanes : std_ulogic_vector(3 downto 0);
  signal lane_data, received, shifted : word_t;
  signal waits_for_port, waits_for_bus, ends_well : std_ulogic;

begin

  memory_lies_at_a_multiple_of_its_size : assert
    to_integer(memory_address(memory_address_bits - 1 downto 0)) = 0 severity failure;

  busy <= '0' when state = idle else '1';
  control <= (29 => '1', 22 => busy_error, 21 => busy, 20 => read_on_address,
              19 => size(2), 18 => size(1), 17 => size(0), 16 => increment, 15 => read_on_data,
              14 => error(2), 13 => error(1), 12 => error(0),
              10 => '1',  -- Addresses of 32 bits; accesses of 32, 16 and 8.
              2 => '1', 1 => '1', 0 => '1', others => '0');

  touched <= write_address or write_data or read_data;
  begins_read <= (write_address and read_on_address) or (read_data and read_on_data);
  begin_access <= (begins_read or write_data) and not busy and not busy_error and (nor error);
  access_address <= unsigned(written) when write_address else address;
  aligned <= not ((size(0) and access_address(0)) or
                  (size(1) and (access_address(0) or access_address(1))));

  in_memory <= (address(31 downto memory_address_bits) ?=
                memory_address(31 downto memory_address_bits)) and
               not is_beyond_memory(address, memory_size_bytes);
  lanes <= "1111" when size(1) else
           address(1) & address(1) & not address(1) & not address(1) when size(0) else
           (address(1) and address(0)) & (address(1) and not address(0)) &
           (not address(1) and address(0)) & (address(1) nor address(0));
  lane_data <= data when size(1) else
               data(15 downto 0) & data(15 downto 0) when size(0) else
               data(7 downto 0) & data(7 downto 0) & data(7 downto 0) & data(7 downto 0);

  waits_for_port <= '1' when state = wait_for_port else '0';
  waits_for_bus <= '1' when state = wait_for_bus else '0';
  memory_request <= (
    enable => waits_for_port and in_memory and port_free,
    write_bytes => lanes and (3 downto 0 => writes),
    address => address(31 downto 2),
    data => lane_data);
  bus_request <= (
    strobe => waits_for_bus,
    write => writes,
    address => address,
    select_bytes => lanes,
    data => lane_data);

  received <= memory_data when state = receive else bus_response.data;
  shifted <= received when size(1) else
             x"0000" & received(31 downto 16) when size(0) and address(1) else
             x"0000" & received(15 downto 0) when size(0) else
             x"000000" & received(31 downto 24) when address(1) and address(0) else
             x"000000" & received(23 downto 16) when address(1) else
             x"000000" & received(15 downto 8) when address(0) else
             x"000000" & received(7 downto 0);
  ends_well <= '1' when state = receive else waits_for_bus and bus_response.acknowledge;

  follow : process
  begin
    wait until rising_edge(clk);
    if write_control then
      read_on_address <= written(20);
      size <= written(19 downto 17);
      increment <= written(16);
      read_on_data <= written(15);
      busy_error <= busy_error and not written(22);
      error <= error and not written(14 downto 12);
    end if;

    if touched and busy then
      busy_error <= '1';
    else
      if write_address then
        address <= unsigned(written);
      end if;
      if write_data then
        data <= written;
      end if;
    end if;

    case state is
      when idle =>
        if begin_access then
          writes <= write_data;
          if size(2) or (size(1) and size(0)) then
            error <= error_size;
          elsif not aligned then
            error <= error_alignment;
          else
            state <= wait_for_port;
          end if;
        end if;

      when wait_for_port =>
        if not in_memory then
          state <= wait_for_bus;
        elsif port_free then
          state <= receive;
        end if;

      when receive =>
        state <= idle;

      when wait_for_bus =>
        if bus_response.acknowledge or bus_response.error then
          state <= idle;
        end if;
        if bus_response.error then
          error <= error_address;
        end if;
    end case;

    if ends_well then
      if not writes then
        data <= shifted;
      end if;
      if increment then
        address <= address + 4 when size(1) else address + 2 when size(0) else address + 1;
      end if;
    end if;

    -- A bus access cannot be cancelled.
    if reset then
      if state /= wait_for_bus then
        state <= idle;
      end if;
      busy_error <= '0';
      read_on_address <= '0';
      size <= "010";
      increment <= '0';
      read_on_data <= '0';
      error <= error_none;
    end if;
  end process;

end architecture;
