-- SPDX-License-Identifier: Apache-2.0
-- Collects the operands of an instruction while it is decoded, so that they stand ready when it executes:
-- from the registers, and results that are not in them yet.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity operand_reader is
  port (
    clk : in std_ulogic;
    -- The instruction decoded goes on to execute; which registers it reads, and its constant, where
    -- this is the second operand.
    read : in std_ulogic;
    -- ... as one to be executed.
    is_able : in std_ulogic;
    first_index : in register_index_t;
    second_index : in register_index_t;
    reads_first : in std_ulogic;
    reads_second : in std_ulogic;
    second_is_constant : in std_ulogic;
    constant_operand : in word_t;
    -- The instruction in execute: what it writes with this clock, if it is completed; its result comes
    -- one clock later than others.
    next_writes : in std_ulogic;
    next_destination : in register_index_t;
    next_is_late : in std_ulogic;
    next_result : in word_t;
    -- Write back: what is written with this clock, and its two parts, of which one is zero: one comes
    -- late in the clock.
    write : in std_ulogic;
    destination : in register_index_t;
    write_data : in word_t;
    write_data_late : in word_t;
    write_data_early : in word_t;
    -- The operands of the instruction in execute; they are missing as long as its `awaits`. It takes
    -- what it awaits with the clock in which this is written, and `await_result` is high.
    await_result : in std_ulogic;
    awaits : out std_ulogic;
    first : out word_t;
    second : out word_t
  );
end entity;

architecture rtl of operand_reader is

  signal first_in_register, second_in_register : word_t;
  -- What is known early in the clock.
  signal first_early, second_early : word_t;
  signal first_awaits, second_awaits : std_ulogic := '0';
  signal take_first, take_second, first_is_written, second_is_written : std_ulogic;
  signal first_matches, second_matches, first_comes, second_comes : std_ulogic;

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

  first_matches <= next_writes and (next_destination ?= first_index);
  second_matches <= next_writes and (next_destination ?= second_index) and not second_is_constant;
  -- Of a late result, which is awaited, anything is taken.
  first_comes <= first_matches and not first_awaits;
  second_comes <= second_matches and not second_awaits;
  first_is_written <= first_awaits or (write and (destination ?= first_index));
  second_is_written <= second_awaits or (write and (destination ?= second_index) and not second_is_constant);
  first_early <= write_data_early when first_is_written else first_in_register;
  second_early <= write_data_early when second_is_written else
                  constant_operand when second_is_constant else
                  second_in_register;

  take_first <= read or (await_result and first_awaits);
  take_second <= read or (await_result and second_awaits);

  collect : process
  begin
    wait until rising_edge(clk);
    if take_first then
      -- The newer before the older.
      first <= next_result when first_comes else
               first_early or (write_data_late and (31 downto 0 => first_is_written));
      first_awaits <= read and is_able and first_matches and next_is_late and reads_first;
    end if;
    if take_second then
      second <= next_result when second_comes else
                second_early or (write_data_late and (31 downto 0 => second_is_written));
      second_awaits <= read and is_able and second_matches and next_is_late and reads_second;
    end if;
  end process;

  awaits <= first_awaits or second_awaits;

end architecture;
