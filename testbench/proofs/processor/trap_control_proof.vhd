-- SPDX-License-Identifier: Apache-2.0
-- A trap is taken where and only where there is a reason, with the cause, address and value that the
-- specification gives to the first of the reasons.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity trap_control_proof is
  port (
    clk : in std_ulogic;
    executing : in executing_t;
    kind : in decoded_t;
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
  -- mcause, mepc and mtval as they must become.
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
      kind => kind,
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
      value <= x"80010000" when executing.leaves_memory = '1' else std_ulogic_vector(address);
    elsif legal = '0' or (kind.csr = '1' and csr_legal = '0') then
      cause <= 2;
      value <= instruction;
    elsif kind.breakpoint then
      cause <= 3;
      value <= std_ulogic_vector(address);
    elsif kind.environment_call then
      cause <= 11;
    elsif kind.load = '1' and data_misaligned = '1' then
      cause <= 4;
      value <= std_ulogic_vector(data_address);
    elsif kind.store = '1' and data_misaligned = '1' then
      cause <= 6;
      value <= std_ulogic_vector(data_address);
    else
      traps <= '0';
    end if;
  end process;

  what_leaves_the_memory_cannot_be_fetched : assume always
    (executing.leaves_memory -> executing.fetch_fault);
  an_instruction_is_of_one_kind : assume always
    ((kind.csr = '1' and kind.breakpoint = '0' and kind.environment_call = '0' and kind.load = '0' and
      kind.store = '0') or
     (kind.csr = '0' and kind.breakpoint = '1' and kind.environment_call = '0' and kind.load = '0' and
      kind.store = '0') or
     (kind.csr = '0' and kind.breakpoint = '0' and kind.environment_call = '1' and kind.load = '0' and
      kind.store = '0') or
     (kind.csr = '0' and kind.breakpoint = '0' and kind.environment_call = '0' and
      (kind.load = '0' or kind.store = '0')));
  nothing_is_ready_while_the_bus_is_at_work : assume always (bus_error -> (not ready and not take_interrupt));

  a_trap_is_taken_where_there_is_a_reason : assert always (trap.enable = traps);
  interrupts_are_told_from_exceptions : assert always (trap.enable -> trap.interrupt = interrupts);
  the_cause_is_that_of_the_first_reason : assert always
    (trap.enable -> to_integer(unsigned(trap.cause)) = cause);
  the_trap_is_that_of_its_instruction : assert always
    ((trap.enable and not bus_error) -> trap.address = exception_address);
  the_value_is_that_of_the_cause : assert always ((trap.enable and not bus_error) -> trap.value = value);
  an_access_is_told_with_what_it_needs_if_the_bus_refuses_it : assert always
    ((executing.valid and ready and not trap.enable and (kind.load or kind.store)) ->
     (trap.address = address and trap.value = std_ulogic_vector(data_address)));

end architecture;
