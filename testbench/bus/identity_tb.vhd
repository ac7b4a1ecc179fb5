-- SPDX-License-Identifier: Apache-2.0
-- The identity block reads as its generics, and cannot be written.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.identity_registers_pkg.all;

entity identity_tb is
end entity;

architecture simulation of identity_tb is

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  identity : entity work.identity
    generic map (
      memory_size_bytes => 131_072, axes => 6, queue_depth => 300, sensors => 3, heaters => 4)
    port map (
      clk => clk, clock_frequency_hz => to_unsigned(12_345_678, 32), reset => reset,
      request => to_request(master.request), to_wires(response) => master.response);

  check : process
    type words_t is array (natural range <>) of word_t;
    constant expected : words_t := (
      0 => to_word(identity_magic_t'(word => to_unsigned(identity_magic_word_stepfabric, 32))),
      1 => to_word(identity_version_t'(major => 16x"0", minor => 8x"1", patch => 8x"0")),
      2 => word_t(to_unsigned(12_345_678, 32)),
      3 => word_t(to_unsigned(131_072, 32)),
      4 => to_word(identity_motion_t'(axes => to_unsigned(6, 8), queue_depth => to_unsigned(300, 16))),
      5 => to_word(identity_thermal_t'(sensors => to_unsigned(3, 8), heaters => to_unsigned(4, 8))));
    variable word : word_t;
    variable failed : boolean;
    variable clocks : natural;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    for index in expected'range loop
      read(master, identity_address + 4 * index, word);
      reports_what_it_was_built_with : assert word = expected(index)
        report "word " & to_string(index) & " is " & to_hstring(word) severity error;
      bus_access(master, identity_address + 4 * index, '1', "1111", x"FFFFFFFF",
        word, failed, clocks);
      refuses_writes : assert failed and clocks = 2 report "written" severity error;
      read(master, identity_address + 4 * index, word);
      keeps_its_values : assert word = expected(index) report to_hstring(word) severity error;
    end loop;
    bus_access(master, identity_address + 4 * expected'length, '0', "1111",
      x"00000000", word, failed, clocks);
    refuses_unknown_registers : assert failed report "answered" severity error;
    std.env.finish;
  end process;

end architecture;
