-- SPDX-License-Identifier: Apache-2.0
-- Trap decision: whether the instruction in execute, or the bus access in progress, traps, with mcause,
-- mepc and mtval. The highest-priority cause wins.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity trap_control is
  generic (
    -- First address after the memory.
    memory_end : unsigned(31 downto 0)
  );
  port (
    executing : in executing_t;
    control : in control_t;
    -- The instruction is implemented.
    legal : in std_ulogic;
    -- It has its operands: no load-use hazard, no bus access in progress.
    ready : in std_ulogic;
    -- Of the instruction in execute.
    address : in unsigned(31 downto 0);
    instruction : in word_t;
    -- An interrupt is taken before the instruction in execute, or before the next if there is none.
    take_interrupt : in std_ulogic;
    interrupt_cause : in std_ulogic_vector(4 downto 0);
    next_address : in unsigned(31 downto 0);
    csr_legal : in std_ulogic;
    -- Of a load or store.
    data_address : in unsigned(31 downto 0);
    data_misaligned : in std_ulogic;
    -- The bus answers the access of the previous instruction with an error; `ready` is low meanwhile.
    bus_error : in std_ulogic;
    bus_store : in std_ulogic;
    -- For a bus error, `address` and `value` are those of the clock in which the access was executed.
    trap : out trap_t
  );
end entity;

architecture rtl of trap_control is

  signal illegal, misaligned, exception : std_ulogic;
  signal value_is_address, value_is_instruction, value_is_data_address : std_ulogic;
  signal fetch_address : unsigned(31 downto 0);

begin

  illegal <= not legal or (control.csr and not csr_legal);
  misaligned <= (control.load or control.store) and data_misaligned;
  exception <= executing.fetch_fault or illegal or control.environment_call or control.breakpoint or
               misaligned;

  trap.enable <= take_interrupt or bus_error or (executing.valid and ready and exception);
  trap.interrupt <= take_interrupt;
  trap.address <= address when executing.valid else next_address;
  trap.cause <= interrupt_cause when take_interrupt else
                "001" & bus_store & '1' when bus_error else
                cause_instruction_access when executing.fetch_fault else
                cause_illegal_instruction when illegal else
                cause_environment_call when control.environment_call else
                cause_breakpoint when control.breakpoint else
                "001" & control.store & '0';
  -- An instruction that crosses the end of the memory faults at its second half.
  fetch_address <= memory_end when executing.crosses_memory_end else address;
  -- AND-OR multiplexer; zero for interrupts and ecall.
  value_is_address <= not take_interrupt and (executing.fetch_fault or (control.breakpoint and not illegal));
  value_is_instruction <= not take_interrupt and not executing.fetch_fault and illegal;
  value_is_data_address <= not take_interrupt and not executing.fetch_fault and not illegal and
                           not control.environment_call and not control.breakpoint;
  trap.value <= (std_ulogic_vector(fetch_address) and (31 downto 0 => value_is_address)) or
                (instruction and (31 downto 0 => value_is_instruction)) or
                (std_ulogic_vector(data_address) and (31 downto 0 => value_is_data_address));

end architecture;
