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

  signal half_word : std_ulogic_vector(15 downto 0);
  signal low_byte : std_ulogic_vector(7 downto 0);
  signal fill_half_word, fill_byte : std_ulogic;

begin

  half_word <= loaded(31 downto 16) when byte_index(1) else loaded(15 downto 0);
  low_byte <= half_word(15 downto 8) when byte_index(0) else half_word(7 downto 0);
  fill_half_word <= half_word(15) and not size(2);
  fill_byte <= low_byte(7) and not size(2);

  result <= loaded when size(1) else
            (31 downto 16 => fill_half_word) & half_word when size(0) else
            (31 downto 8 => fill_byte) & low_byte;

end architecture;
