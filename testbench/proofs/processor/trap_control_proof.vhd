-- SPDX-License-Identifier: Apache-2.0
-- A trap is taken exactly where specified, with the cause, address and value of the highest-priority cause.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity trap_control_proof is
  port (
    clk : in std_ulogic;
    executing : in executing_t;
    control : in control_t;
    legal : in std_ulogic;
    ready : in std_ulogic;
    address : in unsigned(31 downto 0);
    instruction : in value_t;
    take_interrupt : in std_ulogic;
    interrupt_cause : in std_ulogic_vector(4 downto 0);
    next_address : in unsigned(31 downto 0);
    csr_legal : in std_ulogic;
    data_address : in unsigned(31 downto 0);
    data_misaligned : in std_ulogic;
    bus_error : in std_ulogic;
    bus_store : in std_ulogic
  );
end entity;

architecture proof of trap_control_proof is

  signal trap : trap_t;
  -- Specified mcause, mepc and mtval.
  signal traps, interrupts : std_ulogic;
  signal cause : natural range 0 to 31;
  signal exception_address : unsigned(31 downto 0);
  signal value : value_t;

  default clock is rising_edge(clk);

begin

  trap_control : entity work.trap_control
    generic map (memory_end => x"80010000")
    port map (
      executing => executing,
      control => control,
      legal => legal,
      ready => ready,
      address => address,
      instruction => instruction,
      take_interrupt => take_interrupt,
      interrupt_cause => interrupt_cause,
      next_address => next_address,
      csr_legal => csr_legal,
      data_address => data_address,
      data_misaligned => data_misaligned,
      bus_error => bus_error,
      bus_store => bus_store,
      trap => trap);

  specify : process (all)
  begin
    traps <= '1';
    interrupts <= '0';
    cause <= 0;
    exception_address <= address;
    value <= x"00000000";
    if take_interrupt then
      interrupts <= '1';
      cause <= to_integer(unsigned(interrupt_cause));
      if not executing.valid then
        exception_address <= next_address;
      end if;
    elsif bus_error then
      cause <= 7 when bus_store = '1' else 5;
    elsif not executing.valid or not ready then
      traps <= '0';
    elsif executing.fetch_fault then
      cause <= 1;
      value <= x"80010000" when executing.crosses_memory_end = '1' else std_ulogic_vector(address);
    elsif legal = '0' or (control.csr = '1' and csr_legal = '0') then
      cause <= 2;
      value <= instruction;
    elsif control.breakpoint then
      cause <= 3;
      value <= std_ulogic_vector(address);
    elsif control.environment_call then
      cause <= 11;
    elsif control.load = '1' and data_misaligned = '1' then
      cause <= 4;
      value <= std_ulogic_vector(data_address);
    elsif control.store = '1' and data_misaligned = '1' then
      cause <= 6;
      value <= std_ulogic_vector(data_address);
    else
      traps <= '0';
    end if;
  end process;

  crossing_the_memory_end_is_a_fetch_fault : assume always
    (executing.crosses_memory_end -> executing.fetch_fault);
  instruction_class_is_one_hot : assume always
    ((control.csr = '1' and control.breakpoint = '0' and control.environment_call = '0' and
      control.load = '0' and control.store = '0') or
     (control.csr = '0' and control.breakpoint = '1' and control.environment_call = '0' and
      control.load = '0' and control.store = '0') or
     (control.csr = '0' and control.breakpoint = '0' and control.environment_call = '1' and
      control.load = '0' and control.store = '0') or
     (control.csr = '0' and control.breakpoint = '0' and control.environment_call = '0' and
      (control.load = '0' or control.store = '0')));
  not_ready_during_bus_access : assume always (bus_error -> (not ready and not take_interrupt));

  trap_exactly_where_specified : assert always (trap.enable = traps);
  trap_interrupt_is_right : assert always (trap.enable -> trap.interrupt = interrupts);
  trap_cause_is_right : assert always
    (trap.enable -> to_integer(unsigned(trap.cause)) = cause);
  trap_address_is_right : assert always
    ((trap.enable and not bus_error) -> trap.address = exception_address);
  trap_value_is_right : assert always ((trap.enable and not bus_error) -> trap.value = value);
  access_sets_address_and_value_for_bus_error : assert always
    ((executing.valid and ready and not trap.enable and (control.load or control.store)) ->
     (trap.address = address and trap.value = std_ulogic_vector(data_address)));

end architecture;
