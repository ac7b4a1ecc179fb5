-- SPDX-License-Identifier: Apache-2.0
-- The interconnect accesses each slave in its window only, and answers for missing and
-- hanging slaves.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;

entity bus_interconnect_tb is
end entity;

architecture simulation of bus_interconnect_tb is

  constant base_addresses : bus_address_array_t := (
    0 => x"F0000000", 1 => x"F0001000", 2 => x"F0007000", 3 => x"F0010000", 4 => x"80000000");
  constant limit : positive := 16;
  -- Slave n answers n clocks after its strobe, except the last, which answers as `hanging_delay` says.
  constant hanging_slave : natural := 4;

  function answer_of (slave : natural; address : unsigned(31 downto 0)) return word_t is
  begin
    return std_ulogic_vector(to_unsigned(slave, 16)) & std_ulogic_vector(address(15 downto 0));
  end function;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal slave_requests : bus_request_array_t(base_addresses'range);
  signal slave_responses : bus_response_array_t(base_addresses'range) :=
    (others => bus_response_idle);
  signal hanging_delay : natural := natural'high;
  -- How often each slave was strobed.
  type counts_t is array (base_addresses'range) of natural;
  signal accesses : counts_t := (others => 0);

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  interconnect : entity work.bus_interconnect
    generic map (base_addresses => base_addresses, answer_limit_cycles => limit)
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, slave_requests => slave_requests,
      slave_responses => slave_responses);

  -- Answers a write at offset 4 with an error, all else with its number and the address's low half.
  each_slave : for slave in base_addresses'range generate
    answer : process
      variable delay : natural;
    begin
      wait until rising_edge(clk) and slave_requests(slave).strobe = '1';
      accesses(slave) <= accesses(slave) + 1;
      delay := hanging_delay when slave = hanging_slave else slave;
      for i in 1 to delay loop
        wait until rising_edge(clk);
        exit when slave_requests(slave).strobe = '0';
      end loop;
      if slave_requests(slave).strobe then
        if slave_requests(slave).write = '1' and slave_requests(slave).address(11 downto 0) = 4 then
          slave_responses(slave).error <= '1';
        else
          slave_responses(slave) <= (acknowledge => '1', error => '0',
            data => answer_of(slave, slave_requests(slave).address));
        end if;
        wait until rising_edge(clk);
        slave_responses(slave) <= bus_response_idle;
      end if;
    end process;
  end generate;

  check : process
    variable word : word_t;
    variable failed : boolean;
    variable clocks : natural;
    variable before : counts_t;

    procedure access_at (address : unsigned(31 downto 0); write : std_ulogic := '0') is
    begin
      before := accesses;
      bus_access(master, address, write, "1111", x"00000000", word, failed,
        clocks);
    end procedure;

    procedure check_strobed (expected_slave : integer) is
    begin
      for slave in base_addresses'range loop
        only_the_addressed_slave_is_strobed : assert
          (accesses(slave) /= before(slave)) = (slave = expected_slave)
          report "slave " & to_string(slave) severity error;
      end loop;
    end procedure;

    procedure answers_nothing_with_an_error (address : unsigned(31 downto 0)) is
    begin
      access_at(address);
      is_refused_in_two_clocks : assert failed and clocks = 2
        report to_hstring(address) & " after " & to_string(clocks) severity error;
      check_strobed(-1);
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    for slave in 0 to 3 loop
      for offset in 0 to 5 loop
        -- From the first to the last word of the window.
        access_at(base_addresses(slave) + 819 * offset);
        reaches_the_slave : assert not failed and clocks = slave + 2
          and word = answer_of(slave, base_addresses(slave) + 819 * offset)
          report "slave " & to_string(slave) & " gives " & to_hstring(word) severity error;
        check_strobed(slave);
      end loop;
      access_at(base_addresses(slave) + 4, write => '1');
      passes_a_slaves_error : assert failed and clocks = slave + 2 report "no error"
        severity error;
    end loop;

    answers_nothing_with_an_error(x"F0002000");
    answers_nothing_with_an_error(x"EFFFFFFC");
    answers_nothing_with_an_error(x"F0011000");
    answers_nothing_with_an_error(x"00000000");
    answers_nothing_with_an_error(x"FFFFFFFC");
    answers_nothing_with_an_error(x"70001000");

    -- The slowest answer that is waited for, the first that is not, and none at all.
    for delay in limit - 3 to limit + 3 loop
      hanging_delay <= delay;
      access_at(x"80000000");
      waits_as_long_as_it_says : assert failed = (delay + 2 > limit)
        report "delay " & to_string(delay) & " gives " & to_string(clocks) & " clocks"
        severity error;
      gives_up_in_time : assert clocks <= limit + 1 report to_string(clocks) severity error;
    end loop;
    hanging_delay <= natural'high;
    access_at(x"80000000");
    gives_up_a_slave_that_hangs : assert failed and clocks = limit + 1
      report to_string(clocks) & " clocks" severity error;
    access_at(base_addresses(1));
    goes_on_after_that : assert not failed and clocks = 3 report "fails" severity error;
    std.env.finish;
  end process;

end architecture;
