-- SPDX-License-Identifier: Apache-2.0
-- Finds where an instruction of 16 or 32 bits has the numbers of the two registers that it reads.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity register_selector is
  port (
    -- The bits behind a shorter instruction are of no meaning.
    instruction : in word_t;
    -- Of no meaning where the instruction is illegal or reads no such register.
    first : out register_choice_t;
    second : out register_choice_t
  );
end entity;

architecture rtl of register_selector is

  signal is_word, quadrant_0, quadrant_1, quadrant_2 : std_ulogic;
  signal first_is_short, first_is_sp, second_is_zero : std_ulogic;

begin

  is_word <= instruction(1) and instruction(0);
  quadrant_0 <= not instruction(1) and not instruction(0);
  quadrant_1 <= not instruction(1) and instruction(0);
  quadrant_2 <= instruction(1) and not instruction(0);

  -- Four bits tell it in all compressed instructions that are legal. Their branches compare with x0.
  first_is_sp <= (quadrant_0 and not instruction(14)) or (quadrant_2 and instruction(14));
  first_is_short <= (quadrant_0 and instruction(14)) or (quadrant_1 and instruction(15));
  second_is_zero <= quadrant_1 and instruction(14);

  first <= (
    place => (is_word or first_is_sp) & (is_word or not (first_is_sp or first_is_short)),
    short => "01" & instruction(9 downto 7),
    long => instruction(11 downto 7),
    implied => "00010",
    of_word => instruction(19 downto 15));
  second <= (
    place => (is_word or second_is_zero) & (is_word or quadrant_2),
    short => "01" & instruction(4 downto 2),
    long => instruction(6 downto 2),
    implied => "00000",
    of_word => instruction(24 downto 20));

end architecture;
