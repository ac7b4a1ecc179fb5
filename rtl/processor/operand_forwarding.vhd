-- SPDX-License-Identifier: Apache-2.0
-- Operand read in decode, with forwarding from execute and write-back, so that operands are registered when
-- execute begins; detects load-use hazards.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity operand_forwarding is
  port (
    clk : in std_ulogic;
    -- The pipeline advances: the instruction in decode, with its source registers and immediate, is issued.
    advance : in std_ulogic;
    -- It is valid, legal and without fetch fault.
    executable : in std_ulogic;
    first_index : in register_index_t;
    second_index : in register_index_t;
    reads_first : in std_ulogic;
    reads_second : in std_ulogic;
    second_is_immediate : in std_ulogic;
    immediate : in word_t;
    -- The instruction in execute: its destination, and its result, if this is not late, that is available in
    -- write-back only.
    execute_writes : in std_ulogic;
    execute_destination : in register_index_t;
    execute_late : in std_ulogic;
    execute_result : in word_t;
    -- Write-back; `write_data` is the OR of a part that settles late in the clock and one that settles early.
    write : in std_ulogic;
    destination : in register_index_t;
    write_data : in word_t;
    write_data_late : in word_t;
    write_data_early : in word_t;
    -- The operands of the instruction in execute. Load-use hazard: one of them is a late result; the
    -- instruction stalls until this is written and forwarded, in the clock of `forward_late_result`.
    forward_late_result : in std_ulogic;
    hazard : out std_ulogic;
    first : out word_t;
    second : out word_t
  );
end entity;

architecture rtl of operand_forwarding is

  signal first_in_register, second_in_register : word_t;
  -- Settle early in the clock.
  signal first_early, second_early : word_t;
  signal first_hazard, second_hazard : std_ulogic := '0';
  signal update_first, update_second, first_from_write_back, second_from_write_back : std_ulogic;
  signal first_matches, second_matches, first_from_execute, second_from_execute : std_ulogic;

begin

  register_file : entity work.register_file
    port map (
      clk => clk,
      first_index => first_index,
      first => first_in_register,
      second_index => second_index,
      second => second_in_register,
      write => write,
      write_index => destination,
      write_data => write_data);

  first_matches <= execute_writes and (execute_destination ?= first_index);
  second_matches <= execute_writes and (execute_destination ?= second_index) and not second_is_immediate;
  -- A late result is don't care here: its hazard stalls the instruction.
  first_from_execute <= first_matches and not first_hazard;
  second_from_execute <= second_matches and not second_hazard;
  first_from_write_back <= first_hazard or (write and (destination ?= first_index));
  second_from_write_back <= second_hazard or
                            (write and (destination ?= second_index) and not second_is_immediate);
  first_early <= write_data_early when first_from_write_back else first_in_register;
  second_early <= write_data_early when second_from_write_back else
                  immediate when second_is_immediate else
                  second_in_register;

  update_first <= advance or (forward_late_result and first_hazard);
  update_second <= advance or (forward_late_result and second_hazard);

  select_operands : process
  begin
    wait until rising_edge(clk);
    if update_first then
      -- Execute holds the newer result.
      first <= execute_result when first_from_execute else
               first_early or (write_data_late and (31 downto 0 => first_from_write_back));
      first_hazard <= advance and executable and first_matches and execute_late and reads_first;
    end if;
    if update_second then
      second <= execute_result when second_from_execute else
                second_early or (write_data_late and (31 downto 0 => second_from_write_back));
      second_hazard <= advance and executable and second_matches and execute_late and reads_second;
    end if;
  end process;

  hazard <= first_hazard or second_hazard;

end architecture;
