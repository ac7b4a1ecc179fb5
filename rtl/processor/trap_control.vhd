-- SPDX-License-Identifier: Apache-2.0
-- Decides whether the instruction in the execute stage traps, and with which cause.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity trap_control is
  port (
    executing : in executing_t;
    -- Of the instruction executed.
    address : in unsigned(31 downto 0);
    instruction : in word_t;
    -- Taken instead of the instruction, or of the next where none is executed now.
    take_interrupt : in std_ulogic;
    interrupt_cause : in std_ulogic_vector(4 downto 0);
    next_address : in unsigned(31 downto 0);
    csr_legal : in std_ulogic;
    jump : in std_ulogic;
    -- Of the jump, the load or the store.
    target : in unsigned(31 downto 0);
    data_misaligned : in std_ulogic;
    data_error : in std_ulogic;
    trap : out trap_t
  );
end entity;

architecture rtl of trap_control is

  signal illegal, misaligned_jump, misaligned_data, exception : std_ulogic;

begin

  illegal <= executing.refused or (executing.csr and not csr_legal);
  misaligned_jump <= jump and target(1);
  misaligned_data <= (executing.load or executing.store) and data_misaligned;
  exception <= illegal or executing.environment_call or executing.breakpoint or misaligned_jump or
               misaligned_data or data_error;

  trap.enable <= take_interrupt or (executing.valid and exception);
  trap.interrupt <= take_interrupt;
  trap.address <= address when executing.valid else next_address;
  trap.cause <= interrupt_cause when take_interrupt else
                cause_instruction_access when executing.fetch_fault else
                cause_illegal_instruction when illegal else
                cause_environment_call when executing.environment_call else
                cause_breakpoint when executing.breakpoint else
                cause_instruction_misaligned when misaligned_jump else
                "001" & executing.store & not misaligned_data;
  trap.value <= x"00000000" when take_interrupt or executing.environment_call else
                instruction when illegal and not executing.fetch_fault else
                std_ulogic_vector(address) when
                  executing.fetch_fault or executing.breakpoint else
                std_ulogic_vector(target(31 downto 1)) & (target(0) and not misaligned_jump);

end architecture;
