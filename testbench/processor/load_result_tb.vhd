-- SPDX-License-Identifier: Apache-2.0
-- Bytes and half words from each offset, sign- or zero-extended; zero if it is no load.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity load_result_tb is
end entity;

architecture tb of load_result_tb is

  signal loaded, result : word_t := x"8172f304";
  signal lanes : load_lanes_t := lanes_of('0', "000", "00");

begin

  uut : entity work.load_result
    port map (loaded => loaded, lanes => lanes, result => result);

  check : process
    procedure expect(code : std_ulogic_vector(2 downto 0); place : natural; wanted : word_t) is
    begin
      lanes <= lanes_of('0', code, std_ulogic_vector(to_unsigned(place, 2)));
      wait for 1 ns;
      assert result = x"00000000" severity failure;
      lanes <= lanes_of('1', code, std_ulogic_vector(to_unsigned(place, 2)));
      wait for 1 ns;
      assert result = wanted report to_string(code) & " at " & integer'image(place) & " gives " &
        to_hstring(result) severity failure;
    end procedure;
  begin
    expect("000", 0, x"00000004");
    expect("000", 1, x"fffffff3");
    expect("000", 2, x"00000072");
    expect("000", 3, x"ffffff81");
    expect("100", 0, x"00000004");
    expect("100", 1, x"000000f3");
    expect("100", 2, x"00000072");
    expect("100", 3, x"00000081");
    expect("001", 0, x"fffff304");
    expect("001", 2, x"ffff8172");
    expect("101", 0, x"0000f304");
    expect("101", 2, x"00008172");
    expect("010", 0, x"8172f304");
    std.env.finish;
  end process;

end architecture;
