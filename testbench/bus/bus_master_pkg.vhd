-- SPDX-License-Identifier: Apache-2.0
-- The bus as a test bench uses it: one signal, one call per access, checked against the protocol.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;

package bus_master_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);

  type request_wires_t is record
    strobe : std_logic;
    write : std_logic;
    address : unsigned(31 downto 0);
    select_bytes : std_logic_vector(3 downto 0);
    data : std_logic_vector(31 downto 0);
  end record;

  type response_wires_t is record
    acknowledge : std_logic;
    error : std_logic;
    data : std_logic_vector(31 downto 0);
  end record;

  -- The bus and its clock as one resolved signal: the bench drives the request, the slave its response,
  -- `make_clock` the clock. A slave is joined to it by
  --   clk => master.clk, request => to_request(master.request), to_wires(response) => master.response
  -- in the bench itself: GHDL 5.0.1 loses a request on its way through an inout port, and a function of
  -- all of `master` would be called at each edge of the clock.
  type bus_master_t is record
    clk : std_logic;
    request : request_wires_t;
    response : response_wires_t;
  end record;

  constant request_wires_idle : request_wires_t := (
    strobe | write => '0', address => (others => '0'), select_bytes => (others => '0'),
    data => (others => '0'));

  -- The initial value: only the request is driven.
  constant bus_master_idle : bus_master_t := (
    clk => 'Z', request => request_wires_idle,
    response => (acknowledge | error => 'Z', data => (others => 'Z')));

  function to_request (wires : request_wires_t) return bus_request_t;
  function to_response (wires : response_wires_t) return bus_response_t;
  function to_wires (response : bus_response_t) return response_wires_t;

  -- Falls first, so that its first edge comes after half a period.
  procedure make_clock (signal clk : out std_logic; period : in time);

  -- One access of any kind. `failed` means that it was answered with `error`, `clocks` after how
  -- many. Fails the bench where there is no answer within 100 clocks.
  procedure bus_access (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    is_write : in std_ulogic;
    select_bytes : in std_ulogic_vector(3 downto 0);
    data : in word_t;
    read_data : out word_t;
    failed : out boolean;
    clocks : out natural);

  -- Whole words; an error fails the bench. A negative number is written as its two's complement.
  procedure write (signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in word_t);
  procedure write (signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in integer);
  procedure read (signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : out word_t);
  -- The low 31 bits.
  procedure read (signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : out natural);

  -- Fails the bench where the register has another value.
  procedure expect (signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in word_t);
  procedure expect (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in integer);

end package;

package body bus_master_pkg is

  function to_request (wires : request_wires_t) return bus_request_t is
  begin
    return (wires.strobe, wires.write, wires.address, wires.select_bytes, wires.data);
  end function;

  function to_response (wires : response_wires_t) return bus_response_t is
  begin
    return (wires.acknowledge, wires.error, wires.data);
  end function;

  function to_wires (response : bus_response_t) return response_wires_t is
  begin
    return (response.acknowledge, response.error, response.data);
  end function;

  procedure make_clock (signal clk : out std_logic; period : in time) is
  begin
    loop
      clk <= '0';
      wait for period / 2;
      clk <= '1';
      wait for period / 2;
    end loop;
  end procedure;

  procedure bus_access (
    signal master : inout bus_master_t;
    address : in unsigned(31 downto 0);
    is_write : in std_ulogic;
    select_bytes : in std_ulogic_vector(3 downto 0);
    data : in word_t;
    read_data : out word_t;
    failed : out boolean;
    clocks : out natural) is
    variable waited : natural := 0;
  begin
    master.request <= (
      strobe => '1', write => is_write, address => address, select_bytes => select_bytes, data => data);
    loop
      wait until rising_edge(master.clk);
      waited := waited + 1;
      exit when master.response.acknowledge or master.response.error;
      is_answered_within_100_clocks : assert waited < 100
        report "no answer at " & to_hstring(address) severity failure;
    end loop;
    answers_one_way : assert not (master.response.acknowledge and master.response.error)
      report "acknowledge and error at once" severity error;
    read_data := master.response.data;
    failed := master.response.error = '1';
    clocks := waited;
    master.request <= request_wires_idle;
    wait until rising_edge(master.clk);
    falls_silent : assert to_response(master.response) = bus_response_idle
      report "the answer lasts longer than a clock" severity error;
  end procedure;

  procedure write (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in word_t) is
    variable ignored_data : word_t;
    variable failed : boolean;
    variable ignored_clocks : natural;
  begin
    bus_access(master, address, '1', "1111", data, ignored_data, failed, ignored_clocks);
    is_acknowledged : assert not failed
      report "write of " & to_hstring(address) & " refused" severity error;
  end procedure;

  procedure write (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in integer) is
  begin
    write(master, address, word_t(to_signed(data, 32)));
  end procedure;

  procedure read (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : out word_t) is
    variable failed : boolean;
    variable ignored_clocks : natural;
  begin
    bus_access(master, address, '0', "1111", (others => '0'), data, failed, ignored_clocks);
    is_acknowledged : assert not failed
      report "read of " & to_hstring(address) & " refused" severity error;
  end procedure;

  procedure read (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : out natural) is
    variable word : word_t;
  begin
    read(master, address, word);
    data := to_integer(unsigned(word(30 downto 0)));
  end procedure;

  procedure expect (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in word_t) is
    variable found : word_t;
  begin
    read(master, address, found);
    reads_as_expected : assert found = data
      report to_hstring(address) & " is " & to_hstring(found) & " instead of " & to_hstring(data)
      severity failure;
  end procedure;

  procedure expect (
    signal master : inout bus_master_t; address : in unsigned(31 downto 0); data : in integer) is
  begin
    expect(master, address, word_t(to_signed(data, 32)));
  end procedure;

end package body;
