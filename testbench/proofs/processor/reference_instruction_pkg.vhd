-- SPDX-License-Identifier: Apache-2.0
-- What the registers of the execute stage must hold of an instruction.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

package reference_instruction_pkg is

  type reference_instruction_t is record
    is_word : std_ulogic;
    control : control_t;
    immediate : word_t;
    first_index : register_index_t;
    second_index : register_index_t;
    -- Predicted.
    taken : std_ulogic;
    next_address : unsigned(31 downto 0);
    alternate_address : unsigned(31 downto 0);
    condition : redirect_condition_t;
  end record;

end package;
