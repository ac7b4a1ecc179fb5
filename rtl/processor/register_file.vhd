-- SPDX-License-Identifier: Apache-2.0
-- Register file: two asynchronous read ports, one synchronous write port. x0 is never written.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity register_file is
  port (
    clk : in std_ulogic;
    -- Read before write: the old value in the clock of a write.
    first_index : in register_index_t;
    first : out word_t;
    second_index : in register_index_t;
    second : out word_t;
    write : in std_ulogic;
    write_index : in register_index_t;
    write_data : in word_t
  );
end entity;

architecture rtl of register_file is

  -- Two halves, each as deep as an FPGA's distributed memory.
  type half_t is array (15 downto 0) of word_t;
  -- Initialised so that x0 reads zero without extra gates.
  signal lower, upper : half_t := (others => (others => '0'));
  signal first_lower, first_upper, second_lower, second_upper : word_t;

begin

  write_register : process
  begin
    wait until rising_edge(clk);
    x0_is_never_written : assert not (write = '1' and write_index = "00000") severity failure;
    if write and not write_index(4) then
      lower(to_integer(unsigned(write_index(3 downto 0)))) <= write_data;
    end if;
    if write and write_index(4) then
      upper(to_integer(unsigned(write_index(3 downto 0)))) <= write_data;
    end if;
  end process;

  first_lower <= lower(to_integer(unsigned(first_index(3 downto 0))));
  first_upper <= upper(to_integer(unsigned(first_index(3 downto 0))));
  second_lower <= lower(to_integer(unsigned(second_index(3 downto 0))));
  second_upper <= upper(to_integer(unsigned(second_index(3 downto 0))));
  first <= first_upper when first_index(4) else first_lower;
  second <= second_upper when second_index(4) else second_lower;

end architecture;
