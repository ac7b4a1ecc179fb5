-- SPDX-License-Identifier: Apache-2.0
-- Routes each access of the one master to the slave in whose 4 KiB window it lies; every access
-- is answered.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;

entity bus_interconnect is
  generic (
    -- Where the window of each slave begins, multiples of 4096.
    base_addresses : bus_address_array_t := (0 => x"F0000000", 1 => x"F0001000");
    -- Clocks that an access may take; after that it ends with an error. Not less than the slowest
    -- slave needs.
    answer_limit_cycles : positive := 16
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    slave_requests : out bus_request_array_t(base_addresses'range);
    slave_responses : in bus_response_array_t(base_addresses'range)
  );
end entity;

architecture rtl of bus_interconnect is

  -- One bit per slave: the address lies in its window.
  signal selected : std_ulogic_vector(base_addresses'range);
  -- The slave that was strobed in the clock before, without an answer then: only its answer counts.
  -- Registers, because answers go far into the processor.
  signal asked : std_ulogic_vector(base_addresses'range) := (others => '0');
  signal answered : std_ulogic;
  signal joined : bus_response_t;

  signal waited_cycles : natural range 0 to answer_limit_cycles := 0;
  signal given_up : std_ulogic := '0';

begin

  check_windows : for slave in base_addresses'range generate
    window_begins_at_4_kib : assert base_addresses(slave)(11 downto 0) = 0 severity failure;
  end generate;

  select_slave : for slave in base_addresses'range generate
    selected(slave) <= '1' when request.address(31 downto 12) = base_addresses(slave)(31 downto 12)
      else '0';
    slave_requests(slave) <= (
      strobe => request.strobe and selected(slave),
      write => request.write,
      address => request.address,
      select_bytes => request.select_bytes,
      data => request.data
    );
  end generate;

  join_responses : process (all)
    variable sum : bus_response_t;
  begin
    sum := bus_response_idle;
    for slave in base_addresses'range loop
      if asked(slave) then
        sum.acknowledge := sum.acknowledge or slave_responses(slave).acknowledge;
        sum.error := sum.error or slave_responses(slave).error;
        sum.data := sum.data or slave_responses(slave).data;
      end if;
    end loop;
    joined <= sum;
  end process;

  answered <= joined.acknowledge or joined.error;
  -- A response in the clock of the time-out is too late.
  response <= (acknowledge => '0', error => '1', data => (others => '0')) when given_up else joined;

  -- An access to no slave gets an error in the clock after the strobe, like a refusal by a slave.
  watch : process
  begin
    wait until rising_edge(clk);
    asked <= selected and (selected'range => request.strobe and not answered and not given_up);
    given_up <= '0';
    waited_cycles <= 0;
    if request.strobe and not answered and not given_up then
      waited_cycles <= waited_cycles + 1;
      if (or selected) = '0' or waited_cycles + 1 >= answer_limit_cycles then
        given_up <= '1';
      end if;
    end if;
    if reset then
      asked <= (others => '0');
      given_up <= '0';
      waited_cycles <= 0;
    end if;
  end process;

end architecture;
