-- SPDX-License-Identifier: Apache-2.0
-- Decides whether the instruction in the execute stage traps, or an
-- access on the bus, and with which cause.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity trap_control is
  generic (
    -- The first address behind the memory.
    memory_end : unsigned(31 downto 0)
  );
  port (
    executing : in executing_t;
    kind : in decoded_t;
    -- It is an instruction of this processor.
    legal : in std_ulogic;
    -- It has the operands that it needs.
    ready : in std_ulogic;
    -- Of the instruction executed.
    address : in unsigned(31 downto 0);
    instruction : in word_t;
    -- Taken instead of the instruction, or of the next where none is executed now.
    take_interrupt : in std_ulogic;
    interrupt_cause : in std_ulogic_vector(4 downto 0);
    next_address : in unsigned(31 downto 0);
    csr_legal : in std_ulogic;
    -- Of the load or the store.
    data_address : in unsigned(31 downto 0);
    data_misaligned : in std_ulogic;
    -- The bus, at work for the instruction before, refuses its access; nothing is ready meanwhile.
    bus_error : in std_ulogic;
    bus_store : in std_ulogic;
    -- For an access that the bus refuses, address and value are those of the clock in which it was
    -- executed.
    trap : out trap_t
  );
end entity;

architecture rtl of trap_control is

  signal illegal, misaligned, exception : std_ulogic;
  signal value_is_address, value_is_instruction, value_is_data_address : std_ulogic;
  signal fetch_address : unsigned(31 downto 0);

begin

  illegal <= not legal or (kind.csr and not csr_legal);
  misaligned <= (kind.load or kind.store) and data_misaligned;
  exception <= executing.fetch_fault or illegal or kind.environment_call or kind.breakpoint or
               misaligned;

  trap.enable <= take_interrupt or bus_error or (executing.valid and ready and exception);
  trap.interrupt <= take_interrupt;
  trap.address <= address when executing.valid else next_address;
  trap.cause <= interrupt_cause when take_interrupt else
                "001" & bus_store & '1' when bus_error else
                cause_instruction_access when executing.fetch_fault else
                cause_illegal_instruction when illegal else
                cause_environment_call when kind.environment_call else
                cause_breakpoint when kind.breakpoint else
                "001" & kind.store & '0';
  -- Where an instruction begins within the memory and ends outside, only its end is at fault.
  fetch_address <= memory_end when executing.leaves_memory else address;
  -- Zero for interrupts and ecall.
  value_is_address <= not take_interrupt and (executing.fetch_fault or (kind.breakpoint and not illegal));
  value_is_instruction <= not take_interrupt and not executing.fetch_fault and illegal;
  value_is_data_address <= not take_interrupt and not executing.fetch_fault and not illegal and
                           not kind.environment_call and not kind.breakpoint;
  trap.value <= (std_ulogic_vector(fetch_address) and (31 downto 0 => value_is_address)) or
                (instruction and (31 downto 0 => value_is_instruction)) or
                (std_ulogic_vector(data_address) and (31 downto 0 => value_is_data_address));

end architecture;
