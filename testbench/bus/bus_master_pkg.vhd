-- SPDX-License-Identifier: Apache-2.0
-- The bus as a test bench uses it: one call per access, checked against the protocol.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;

package bus_master_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);

  -- One access of any kind. `failed` means that it was answered with `error`, `clocks` after how
  -- many. Fails the bench where there is no answer within 100 clocks.
  procedure bus_access (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    write : in std_ulogic;
    select_bytes : in std_ulogic_vector(3 downto 0);
    data : in word_t;
    read_data : out word_t;
    failed : out boolean;
    clocks : out natural);

  -- Whole words; an error fails the bench.
  procedure bus_write (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in word_t);
  procedure bus_write (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in natural);
  procedure bus_read (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : out word_t);

  -- Fails the bench where the register has another value.
  procedure bus_expect (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in word_t);

  -- Then a moment more, so that what follows the last edge has settled.
  procedure wait_clocks (signal clk : in std_ulogic; count : in natural);

end package;

package body bus_master_pkg is

  procedure bus_access (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    write : in std_ulogic;
    select_bytes : in std_ulogic_vector(3 downto 0);
    data : in word_t;
    read_data : out word_t;
    failed : out boolean;
    clocks : out natural) is
    variable waited : natural := 0;
  begin
    request <= (strobe => '1', write => write, address => address,
      select_bytes => select_bytes, data => data);
    loop
      wait until rising_edge(clk);
      waited := waited + 1;
      exit when response.acknowledge or response.error;
      is_answered_within_100_clocks : assert waited < 100
        report "no answer at " & to_hstring(address) severity failure;
    end loop;
    answers_one_way : assert not (response.acknowledge and response.error)
      report "acknowledge and error at once" severity error;
    read_data := response.data;
    failed := response.error = '1';
    clocks := waited;
    request <= bus_request_idle;
    wait until rising_edge(clk);
    falls_silent : assert response = bus_response_idle
      report "the answer lasts longer than a clock" severity error;
  end procedure;

  procedure bus_write (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in word_t) is
    variable ignored_data : word_t;
    variable failed : boolean;
    variable ignored_clocks : natural;
  begin
    bus_access(clk, request, response, address, '1', "1111", data, ignored_data, failed,
      ignored_clocks);
    is_acknowledged : assert not failed
      report "write of " & to_hstring(address) & " refused" severity error;
  end procedure;

  procedure bus_write (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in natural) is
  begin
    bus_write(clk, request, response, address, word_t(to_unsigned(data, 32)));
  end procedure;

  procedure bus_read (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : out word_t) is
    variable failed : boolean;
    variable ignored_clocks : natural;
  begin
    bus_access(clk, request, response, address, '0', "1111", (others => '0'), data, failed,
      ignored_clocks);
    is_acknowledged : assert not failed
      report "read of " & to_hstring(address) & " refused" severity error;
  end procedure;

  procedure bus_expect (
    signal clk : in std_ulogic;
    signal request : out bus_request_t;
    signal response : in bus_response_t;
    address : in unsigned(31 downto 0);
    data : in word_t) is
    variable found : word_t;
  begin
    bus_read(clk, request, response, address, found);
    reads_as_expected : assert found = data
      report to_hstring(address) & " is " & to_hstring(found) & " instead of " & to_hstring(data)
      severity failure;
  end procedure;

  procedure wait_clocks (signal clk : in std_ulogic; count : in natural) is
  begin
    for i in 1 to count loop
      wait until rising_edge(clk);
    end loop;
    wait for 1 ns;
  end procedure;

end package body;
