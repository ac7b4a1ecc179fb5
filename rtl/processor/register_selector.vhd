-- SPDX-License-Identifier: Apache-2.0
-- Extracts the source register numbers of an instruction of 16 or 32 bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity register_selector is
  port (
    -- The upper half of a compressed instruction is don't care.
    instruction : in word_t;
    is_word : in std_ulogic;
    -- Don't care for illegal instructions and where no such register is read.
    first : out register_index_t;
    second : out register_index_t
  );
end entity;

architecture rtl of register_selector is

  signal quadrant_0, quadrant_1, quadrant_2 : std_ulogic;
  signal first_is_short, first_is_sp, second_is_short, second_is_zero : std_ulogic;

begin

  quadrant_0 <= not instruction(1) and not instruction(0);
  quadrant_1 <= not instruction(1) and instruction(0);
  quadrant_2 <= instruction(1) and not instruction(0);

  -- Four bits suffice for all legal compressed instructions. c.beqz and c.bnez compare with x0.
  first_is_sp <= (quadrant_0 and not instruction(14)) or (quadrant_2 and instruction(14));
  first_is_short <= (quadrant_0 and instruction(14)) or (quadrant_1 and instruction(15));
  second_is_zero <= quadrant_1 and instruction(14);
  second_is_short <= not instruction(1);

  first <= instruction(19 downto 15) when is_word else
           "00010" when first_is_sp else
           "01" & instruction(9 downto 7) when first_is_short else
           instruction(11 downto 7);
  second <= instruction(24 downto 20) when is_word else
            "00000" when second_is_zero else
            "01" & instruction(4 downto 2) when second_is_short else
            instruction(6 downto 2);

end architecture;
