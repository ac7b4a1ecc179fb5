-- SPDX-License-Identifier: Apache-2.0
-- The memory of the chip: program, data and stack, one port for instructions and one for data.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.memory_pkg.all;

entity memory is
  generic (
    -- A power of two.
    size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    instruction_request : in instruction_request_t;
    -- The half words asked for in the clock before, each in its place in a word; they stay until the
    -- next enabled request.
    instruction_data : out std_ulogic_vector(31 downto 0);
    data_request : in memory_request_t;
    -- The word asked for in the clock before; undefined after a write.
    data : out std_ulogic_vector(31 downto 0)
  );
end entity;

architecture rtl of memory is

  constant address_bits : positive := integer(ceil(log2(real(size_bytes)))) - 2;

  subtype word_address_t is natural range 0 to 2 ** address_bits - 1;

  signal upper_word, lower_word, data_word : word_address_t;

begin

  size_is_a_power_of_two : assert size_bytes = 4 * 2 ** address_bits
    report "the memory has " & integer'image(size_bytes) & " bytes" severity failure;

  upper_word <= to_integer(instruction_request.upper_address(address_bits + 1 downto 2));
  lower_word <= to_integer(instruction_request.lower_address(address_bits + 1 downto 2));
  data_word <= to_integer(data_request.address(address_bits + 1 downto 2));

  -- One array of bytes per lane: the form in which every tool finds block RAM with byte writes.
  lanes : for lane in 0 to 3 generate
    type bytes_t is array (2 ** address_bits - 1 downto 0) of std_ulogic_vector(7 downto 0);
    signal bytes : bytes_t;
    signal instruction_word : word_address_t;
  begin

    instruction_word <= lower_word when lane < 2 else upper_word;

    read_instruction : process
    begin
      wait until rising_edge(clk);
      if instruction_request.enable then
        instruction_data(8 * lane + 7 downto 8 * lane) <= bytes(instruction_word);
      end if;
    end process;

    access_data : process
    begin
      wait until rising_edge(clk);
      if data_request.enable then
        if data_request.write_bytes(lane) then
          bytes(data_word) <= data_request.data(8 * lane + 7 downto 8 * lane);
        else
          data(8 * lane + 7 downto 8 * lane) <= bytes(data_word);
        end if;
      end if;
    end process;

  end generate;

end architecture;
