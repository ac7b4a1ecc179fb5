-- SPDX-License-Identifier: Apache-2.0
-- Takes a byte, half word or word out of a loaded word and extends it to 32 bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity load_result is
  port (
    loaded : in word_t;
    -- In the coding of funct3: bit 2 unsigned, "00" byte, "01" half word, "10" word.
    size : in std_ulogic_vector(2 downto 0);
    -- The lower two bits of the address.
    byte_index : in std_ulogic_vector(1 downto 0);
    result : out word_t
  );
end entity;

architecture rtl of load_result is

  signal fill_index : std_ulogic_vector(1 downto 0);
  signal low_byte : std_ulogic_vector(7 downto 0);
  signal second_byte : std_ulogic_vector(7 downto 0);
  signal sign, fill : std_ulogic;

begin

  low_byte <= loaded(31 downto 24) when byte_index(1) and byte_index(0) else
              loaded(23 downto 16) when byte_index(1) else
              loaded(15 downto 8) when byte_index(0) else
              loaded(7 downto 0);
  second_byte <= loaded(31 downto 24) when byte_index(1) else loaded(15 downto 8);

  -- Straight from what was loaded, which comes late in the clock: the last bit of the last byte taken.
  fill_index <= byte_index(1) & (byte_index(0) or size(0));
  sign <= loaded(31) when fill_index(1) and fill_index(0) else
          loaded(23) when fill_index(1) else
          loaded(15) when fill_index(0) else
          loaded(7);
  fill <= sign and not size(2);

  result(7 downto 0) <= low_byte;
  result(15 downto 8) <= second_byte when size(1) or size(0) else (others => fill);
  result(31 downto 16) <= loaded(31 downto 16) when size(1) else (others => fill);

end architecture;
