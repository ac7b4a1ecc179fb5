-- SPDX-License-Identifier: Apache-2.0
-- Machine mode, a part of execute: CSRs, traps and returns, entry to debug mode.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity machine_mode is
  generic (
    -- First address after the memory.
    memory_end : unsigned(31 downto 0) := x"80010000"
  );
  port (
    clk : in std_ulogic;
    -- The same clock without gating.
    always_clk : in std_ulogic;
    reset : in std_ulogic;
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    debug_request : in debug_request_t;
    -- The instruction in execute; it can be executed, has no operands yet, starts in this clock.
    executing : in executing_t;
    control : in control_t;
    legal : in std_ulogic;
    executing_instruction : in word_t;
    executing_address : in unsigned(31 downto 0);
    first_operand : in word_t;
    executable : in std_ulogic;
    stalled : in std_ulogic;
    start : in std_ulogic;
    -- An interrupt is taken, or the debugger halts; where the program goes on if execute is empty.
    take_interrupt : in std_ulogic;
    take_halt : in std_ulogic;
    fetched_address : in unsigned(31 downto 0);
    -- Of loads and stores.
    data_address : in unsigned(31 downto 0);
    data_misaligned : in std_ulogic;
    bus_active : in std_ulogic;
    bus_error : in std_ulogic;
    bus_store : in std_ulogic;
    -- An instruction retires; not one that the debugger injected.
    retire : in std_ulogic;
    counted : out std_ulogic;
    csr_request : out csr_request_t;
    csr_data : out word_t;
    -- For wfi: requested at all, by an interrupt that is enabled in mie. To be taken, with which cause.
    interrupt_requested : out std_ulogic;
    wake_request : out std_ulogic;
    interrupt_pending : out std_ulogic;
    interrupt_cause : out std_ulogic_vector(4 downto 0);
    -- Trap of the instruction in execute; the same without debug mode; the latter in the next clock.
    trap : out trap_t;
    machine_trap : out trap_t;
    taken : out trap_t;
    return_from_trap : out std_ulogic;
    enter_debug : out std_ulogic;
    -- All stages before are flushed; in the next clock fetch is redirected to a handler, or away from it.
    flush : out std_ulogic;
    entering_handler : out std_ulogic;
    returning : out std_ulogic;
    resuming : out std_ulogic;
    trap_target : out unsigned(31 downto 0);
    return_address : out unsigned(31 downto 0);
    return_target : out unsigned(31 downto 0)
  );
end entity;

architecture rtl of machine_mode is

  signal csr_operand : word_t;
  signal csr_legal : std_ulogic;
  signal taken_trap : trap_t;

begin

  csr_operand <= 27x"0" & executing_instruction(19 downto 15) when control.funct3(2) else first_operand;
  -- CSR numbers with both upper bits set are read-only.
  csr_legal <= control.csr_exists and not (control.csr_written and (and executing_instruction(31 downto 30)));
  csr_request <= (
    enable => executable and not stalled and control.csr and control.csr_exists,
    cancelled => take_interrupt,
    address => executing_instruction(31 downto 20),
    operation => control.funct3(1 downto 0),
    operand => csr_operand,
    writes => control.csr_written);
  return_from_trap <= start and control.trap_return;
  -- Injected instructions do not count in minstret.
  counted <= retire and not debug_request.halted;
  control_status_registers : entity work.control_status_registers
    port map (
      clk => clk,
      always_clk => always_clk,
      reset => reset,
      request => csr_request,
      read_data => csr_data,
      trap => taken_trap,
      trap_return => return_from_trap,
      retire => counted,
      timer_interrupt => timer_interrupt,
      external_interrupt => external_interrupt,
      interrupts => interrupts,
      interrupt_requested => interrupt_requested,
      wake_request => wake_request,
      interrupt_pending => interrupt_pending,
      interrupt_cause => interrupt_cause,
      trap_target => trap_target,
      return_address => return_address);

  trap_control : entity work.trap_control
    generic map (memory_end => memory_end)
    port map (
      executing => executing,
      control => control,
      legal => legal,
      ready => not stalled,
      address => executing_address,
      instruction => executing_instruction,
      take_interrupt => take_interrupt,
      interrupt_cause => interrupt_cause,
      next_address => fetched_address,
      csr_legal => csr_legal,
      data_address => data_address,
      data_misaligned => data_misaligned,
      bus_error => bus_error,
      bus_store => bus_store,
      trap => trap);

  -- No trap is taken on entry to debug mode and within it:
  -- an exception of an injected instruction is only reported.
  enter_debug <= take_halt or
                 (trap.enable and not take_interrupt and not bus_active and
                  debug_request.halt_at_breakpoint and
                  executing.valid and control.breakpoint and not executing.fetch_fault);
  machine_trap <= (
    enable => trap.enable and not enter_debug and not debug_request.halted,
    interrupt => trap.interrupt,
    cause => trap.cause,
    address => trap.address,
    value => trap.value);

  flush <= trap.enable or return_from_trap or debug_request.resume;
  -- In the clock after the flush.
  return_target <= debug_request.resume_address when resuming else return_address;

  -- Late signal: `trap.enable` has minimal fan-out. The CSRs are updated in the next clock, in which
  -- execute is empty.
  take_trap : process
  begin
    wait until rising_edge(clk);
    taken_trap.enable <= machine_trap.enable;
    taken_trap.interrupt <= machine_trap.interrupt;
    taken_trap.cause <= machine_trap.cause;
    if not bus_active then
      taken_trap.address <= machine_trap.address;
      taken_trap.value <= machine_trap.value;
    end if;
    entering_handler <= trap.enable;
    returning <= return_from_trap;
    resuming <= debug_request.resume;
    if reset then
      taken_trap.enable <= '0';
      entering_handler <= '0';
      returning <= '0';
      resuming <= '0';
    end if;
  end process;

  taken <= taken_trap;

end architecture;
