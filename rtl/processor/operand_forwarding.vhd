-- SPDX-License-Identifier: Apache-2.0
-- Operand read in decode, with forwarding from execute, write-back and register write, so that operands are
-- registered when execute begins; detects load-use hazards.

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
    -- write-back only. It is the OR of a part that settles late in the clock and one that settles early.
    execute_writes : in std_ulogic;
    execute_destination : in register_index_t;
    execute_late : in std_ulogic;
    execute_result_late : in word_t;
    execute_result_early : in word_t;
    -- Write-back; its result is the OR of two such parts and of one that settles between them.
    write : in std_ulogic;
    destination : in register_index_t;
    write_data_late : in word_t;
    write_data_product : in word_t;
    write_data_early : in word_t;
    -- Register write: the same a clock later.
    register_write : in register_write_t;
    -- The operands of the instruction in execute. Load-use hazard: one of them is a late result; the
    -- instruction stalls until this is written and forwarded, in the clock of `forward_late_result`.
    forward_late_result : in std_ulogic;
    hazard : out std_ulogic;
    first : out word_t;
    second : out word_t
  );
end entity;

architecture rtl of operand_forwarding is

  signal first_in_register, second_in_register, first_written, second_written : word_t;
  -- Settle early in the clock.
  signal first_early, second_early, first_settled, second_settled : word_t;
  -- All but what write-back's memory data adds.
  signal first_rest, second_rest : word_t;
  signal first_hazard, second_hazard : std_ulogic := '0';
  signal update_first, update_second, first_from_write_back, second_from_write_back : std_ulogic;
  signal first_matches, second_matches, first_from_execute, second_from_execute : std_ulogic;
  signal first_is_written, second_is_written : std_ulogic;
  signal first_from_write_back_only, second_from_write_back_only : std_ulogic;

begin

  register_file : entity work.register_file
    port map (
      clk => clk,
      first_index => first_index,
      first => first_in_register,
      second_index => second_index,
      second => second_in_register,
      write => register_write.enable,
      write_index => register_write.destination,
      write_data => register_write.data);

  first_matches <= execute_writes and (execute_destination ?= first_index);
  second_matches <= execute_writes and (execute_destination ?= second_index) and not second_is_immediate;
  -- A late result is don't care here: its hazard stalls the instruction.
  first_from_execute <= first_matches and not first_hazard;
  second_from_execute <= second_matches and not second_hazard;
  first_from_write_back <= first_hazard or (write and (destination ?= first_index));
  second_from_write_back <= second_hazard or
                            (write and (destination ?= second_index) and not second_is_immediate);
  -- The register file reads what it held before this clock's write.
  first_is_written <= register_write.enable and (register_write.destination ?= first_index);
  second_is_written <= register_write.enable and (register_write.destination ?= second_index);
  first_written <= register_write.data when first_is_written else first_in_register;
  second_written <= immediate when second_is_immediate else
                    register_write.data when second_is_written else
                    second_in_register;
  first_early <= write_data_early when first_from_write_back else first_written;
  second_early <= write_data_early when second_from_write_back else second_written;

  -- Execute holds the newer result. Critical path: memory data passes one gate, the results of execute two,
  -- products three.
  first_settled <= execute_result_early when first_from_execute else first_early;
  second_settled <= execute_result_early when second_from_execute else second_early;
  first_rest <= (execute_result_late and (31 downto 0 => first_from_execute)) or
                ((write_data_product and (31 downto 0 => first_from_write_back_only)) or first_settled);
  second_rest <= (execute_result_late and (31 downto 0 => second_from_execute)) or
                 ((write_data_product and (31 downto 0 => second_from_write_back_only)) or second_settled);
  first_from_write_back_only <= first_from_write_back and not first_from_execute;
  second_from_write_back_only <= second_from_write_back and not second_from_execute;

  update_first <= advance or (forward_late_result and first_hazard);
  update_second <= advance or (forward_late_result and second_hazard);

  select_operands : process
  begin
    wait until rising_edge(clk);
    if update_first then
      first <= first_rest or (write_data_late and (31 downto 0 => first_from_write_back_only));
      first_hazard <= advance and executable and first_matches and execute_late and reads_first;
    end if;
    if update_second then
      second <= second_rest or (write_data_late and (31 downto 0 => second_from_write_back_only));
      second_hazard <= advance and executable and second_matches and execute_late and reads_second;
    end if;
  end process;

  hazard <= first_hazard or second_hazard;

end architecture;
