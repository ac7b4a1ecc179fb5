-- SPDX-License-Identifier: Apache-2.0
-- The 32 registers: two are read within the clock, one is written at its end. x0 is never written.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity register_file is
  port (
    clk : in std_ulogic;
    first_index : in register_index_t;
    first : out word_t;
    second_index : in register_index_t;
    second : out word_t;
    -- A read of the same register gives the old value in this clock.
    write : in std_ulogic;
    write_index : in register_index_t;
    write_data : in word_t
  );
end entity;

architecture rtl of register_file is

  type registers_t is array (31 downto 0) of word_t;
  -- Initial contents, for x0's sake: with them it needs no gates of its own.
  signal registers : registers_t := (others => (others => '0'));

begin

  first <= registers(to_integer(unsigned(first_index)));
  second <= registers(to_integer(unsigned(second_index)));

  store : process
  begin
    wait until rising_edge(clk);
    x0_is_never_written : assert not (write = '1' and write_index = "00000") severity failure;
    if write then
      registers(to_integer(unsigned(write_index))) <= write_data;
    end if;
  end process;

end architecture;
