-- SPDX-License-Identifier: Apache-2.0
-- Gives the registers that an instruction reads: asked for while it is decoded, there when it executes,
-- together with the results of the two instructions before it, which have not come into them yet.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity operand_reader is
  port (
    clk : in std_ulogic;
    -- The instruction decoded goes on to execute; which registers it reads.
    read : in std_ulogic;
    first_choice : in register_choice_t;
    second_choice : in register_choice_t;
    -- What the instruction in execute will write, if it is completed with this clock.
    next_writes : in std_ulogic;
    next_destination : in register_index_t;
    -- Write back: the result as it came out of execute, and what is written in this clock, which is the
    -- same unless it comes late.
    result : in word_t;
    write : in std_ulogic;
    destination : in register_index_t;
    write_data : in word_t;
    -- The instruction in execute stays there for the late result of the one before: the result's register
    -- must take `last_written` with this clock.
    await_result : in std_ulogic;
    last_written : out word_t;
    -- The registers for the instruction in execute, and whether they are taken from `result`.
    first : out word_t;
    first_is_result : out std_ulogic;
    second : out word_t;
    second_is_result : out std_ulogic
  );
end entity;

architecture rtl of operand_reader is

  signal first_stored, second_stored : word_t;
  signal first_is_written, second_is_written : std_ulogic;

begin

  register_file : entity work.register_file
    port map (
      clk => clk,
      read => read,
      first_index => chosen(first_choice),
      first => first_stored,
      second_index => chosen(second_choice),
      second => second_stored,
      write => write,
      write_index => destination,
      write_data => write_data);

  find_results : process
  begin
    wait until rising_edge(clk);
    if read then
      first_is_result <= next_writes and is_chosen(first_choice, next_destination);
      second_is_result <= next_writes and is_chosen(second_choice, next_destination);
      first_is_written <= write and is_chosen(first_choice, destination);
      second_is_written <= write and is_chosen(second_choice, destination);
    elsif await_result then
      -- The late result becomes what was written last, and what this was stands for the result; but
      -- where it is older than the late result and meant for the same register, it has had its day.
      first_is_result <= first_is_written and not first_is_result;
      second_is_result <= second_is_written and not second_is_result;
      first_is_written <= first_is_result;
      second_is_written <= second_is_result;
    end if;
    if write then
      last_written <= write_data;
    end if;
  end process;

  -- The newer before the older.
  first <= result when first_is_result else
           last_written when first_is_written else
           first_stored;
  second <= result when second_is_result else
            last_written when second_is_written else
            second_stored;

end architecture;
