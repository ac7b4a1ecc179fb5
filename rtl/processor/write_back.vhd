-- SPDX-License-Identifier: Apache-2.0
-- Write-back: the pipeline register after execute, and the multiplexer of results, of which the late ones
-- (loads, products, Zbb) are available only here.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity write_back is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- From execute: the instruction completes; its control signals; its result, unless it is late.
    complete : in std_ulogic;
    control : in control_t;
    instruction : in word_t;
    result : in word_t;
    -- A trap is taken; it is an interrupt.
    trapped : in std_ulogic;
    interrupted : in std_ulogic;
    -- A load or store accesses the memory, not the bus; its byte offset.
    to_memory : in std_ulogic;
    byte_index : in std_ulogic_vector(1 downto 0);
    -- The instruction held waits for the bus; the bus acknowledges, with its read data as `result`.
    bus_active : in std_ulogic;
    bus_done : in std_ulogic;
    -- Late results.
    product : in word_t;
    manipulated : in word_t := (others => '0');
    memory_data : in word_t;
    -- An instruction retires at the end of this clock, from the bus or from execute.
    retire : out std_ulogic;
    writing : out writing_t;
    writing_instruction : out word_t;
    -- The result (for the trace and the debug module), and its parts, of which all but one are zero: what
    -- settles late in the clock, a product, and the rest.
    value : out word_t;
    value_late : out word_t;
    value_product : out word_t;
    value_early : out word_t
  );
end entity;

architecture rtl of write_back is

  -- No write before the first reset, not even to x0.
  constant empty : writing_t := (
    destination => "00000", from_memory => lanes_of('0', "000", "00"),
    from_bus => lanes_of('0', "000", "00"), others => '0');
  signal held : writing_t := empty;
  signal from_memory, from_bus, writing_result : word_t;
  signal on_bus : std_ulogic;

begin

  on_bus <= (control.load or control.store) and not to_memory;
  retire <= bus_done when bus_active else complete and not on_bus;

  hold : process
  begin
    wait until rising_edge(clk);
    held.trapped <= trapped;
    held.interrupted <= interrupted;
    held.valid <= retire;
    if bus_active then
      held.writes <= bus_done and held.write_pending;
    else
      held.writes <= complete and control.writes and not on_bus;
      held.write_pending <= control.writes;
      held.destination <= control.destination;
      held.multiply <= control.multiply;
      held.manipulate <= control.manipulate;
      held.load <= control.load;
      held.from_memory <= lanes_of(control.load and to_memory, control.funct3, byte_index);
      held.from_bus <= lanes_of(control.load and not to_memory, control.funct3, byte_index);
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

  -- One each for memory and bus: saves a multiplexer between block RAM and operands.
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

  -- Memory data settles last, then products.
  value_late <= from_memory;
  value_product <= product and (31 downto 0 => held.multiply);
  value_early <= from_bus when held.load else
                 manipulated when held.manipulate else
                 writing_result and (31 downto 0 => not held.multiply);
  value <= value_late or (value_product or value_early);
  writing <= held;

end architecture;
