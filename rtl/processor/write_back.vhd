-- SPDX-License-Identifier: Apache-2.0
-- Holds the instruction that execute has completed, and gives what it writes to its register: some results
-- come only now.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity write_back is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Of execute: the instruction is completed there; what it is; its result, if it has one already.
    complete : in std_ulogic;
    kind : in decoded_t;
    instruction : in word_t;
    result : in word_t;
    -- It has trapped, or an interrupt was taken.
    trapped : in std_ulogic;
    interrupted : in std_ulogic;
    -- A load or store of the memory, else over the bus; its place in the word.
    to_memory : in std_ulogic;
    byte_index : in std_ulogic_vector(1 downto 0);
    -- The bus is at work for the instruction held, with this clock the last; what it brings is `result`.
    bus_active : in std_ulogic;
    bus_done : in std_ulogic;
    -- Come one clock after execution.
    product : in word_t;
    manipulated : in word_t := (others => '0');
    memory_data : in word_t;
    -- An instruction is completed with this clock, on the bus or in execute.
    retire : out std_ulogic;
    writing : out writing_t;
    writing_instruction : out word_t;
    -- What is written, and its two parts, of which one is zero: what comes late in the clock, and all else.
    value : out word_t;
    value_late : out word_t;
    value_early : out word_t
  );
end entity;

architecture rtl of write_back is

  -- Nothing is written before the first reset, not even to x0.
  constant nothing : writing_t := (
    destination => "00000", from_memory => lanes_of('0', "000", "00"),
    from_bus => lanes_of('0', "000", "00"), others => '0');
  signal held : writing_t := nothing;
  signal from_memory, from_bus, writing_result : word_t;
  signal on_bus : std_ulogic;

begin

  on_bus <= (kind.load or kind.store) and not to_memory;
  retire <= bus_done when bus_active else complete and not on_bus;

  hold : process
  begin
    wait until rising_edge(clk);
    held.trapped <= trapped;
    held.interrupted <= interrupted;
    held.valid <= retire;
    if bus_active then
      held.writes <= bus_done and held.wanted;
    else
      held.writes <= complete and kind.writes and not on_bus;
      held.wanted <= kind.writes;
      held.destination <= kind.destination;
      held.multiply <= kind.multiply;
      held.manipulate <= kind.manipulate;
      held.load <= kind.load;
      held.from_memory <= lanes_of(kind.load and to_memory, kind.funct3, byte_index);
      held.from_bus <= lanes_of(kind.load and not to_memory, kind.funct3, byte_index);
      writing_instruction <= instruction;
    end if;
    writing_result <= result;

    if reset then
      held.valid <= '0';
      held.trapped <= '0';
      held.interrupted <= '0';
      held.writes <= '0';
    end if;
  end process;

  -- Two of them: one choice less between a block RAM and the registers.
  load_from_memory : entity work.load_result
    port map (
      loaded => memory_data,
      lanes => held.from_memory,
      result => from_memory);

  load_from_bus : entity work.load_result
    port map (
      loaded => writing_result,
      lanes => held.from_bus,
      result => from_bus);

  -- What the memory brings comes last, then products.
  value_late <= from_memory or (product and (31 downto 0 => held.multiply));
  value_early <= from_bus when held.load else
                 manipulated when held.manipulate else
                 writing_result and (31 downto 0 => not held.multiply);
  value <= value_late or value_early;
  writing <= held;

end architecture;
