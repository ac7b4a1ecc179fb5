-- SPDX-License-Identifier: Apache-2.0
-- The memory-mapped bus: Wishbone B4 classic with one master, as a pair of records.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package bus_pkg is

  -- From the master. With one master CYC and STB are the same wire: `strobe`. It stays high, with
  -- the other signals unchanged, until the clock in which the response is seen; then it is low for
  -- at least one clock.
  type bus_request_t is record
    strobe : std_ulogic;
    write : std_ulogic;
    -- Byte address.
    address : unsigned(31 downto 0);
    -- One bit per byte lane, bit 0 for data(7 downto 0).
    select_bytes : std_ulogic_vector(3 downto 0);
    data : std_ulogic_vector(31 downto 0);
  end record;

  -- From a slave, in the clock after its first strobe at the earliest: for one clock `acknowledge` (with
  -- the data of a read) or `error`; otherwise all zero.
  type bus_response_t is record
    acknowledge : std_ulogic;
    error : std_ulogic;
    data : std_ulogic_vector(31 downto 0);
  end record;

  type bus_request_array_t is array (natural range <>) of bus_request_t;
  type bus_response_array_t is array (natural range <>) of bus_response_t;
  type bus_address_array_t is array (natural range <>) of unsigned(31 downto 0);

  constant bus_request_idle : bus_request_t := (
    strobe => '0', write => '0', address => (others => '0'), select_bytes => (others => '0'),
    data => (others => '0'));
  constant bus_response_idle : bus_response_t := (
    acknowledge => '0', error => '0', data => (others => '0'));

end package;
