-- SPDX-License-Identifier: Apache-2.0
-- The processor: RV32IMC with machine mode, a six-stage in-order pipeline with constant instruction times.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor is
  generic (
    -- First address of the memory, and reset vector: a multiple of the power of two that the memory fits in.
    reset_address : unsigned(31 downto 0) := x"80000000";
    -- Data accesses outside the memory go to the bus, instruction
    -- fetches raise an exception.
    memory_size_bytes : positive := 65536;
    -- Extension Zbb: bit manipulation.
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    -- The same clock without gating. `clk` may be gated while `at_rest` is high.
    always_clk : in std_ulogic;
    reset : in std_ulogic;
    -- Instruction port of the memory.
    instruction_request : out instruction_request_t;
    instruction_data : in std_ulogic_vector(31 downto 0);
    -- Data port of the memory.
    memory_request : out memory_request_t;
    memory_data : in std_ulogic_vector(31 downto 0);
    -- Data accesses outside the memory.
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    -- Levels, synchronous to the clock: mip.MTIP, mip.MEIP, and mip(16 + index).
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    -- Waiting in wfi.
    sleeping : out std_ulogic;
    -- The next edge of `clk` changes nothing: asleep, pipeline empty, no wake-up.
    at_rest : out std_ulogic;
    -- An instruction has retired.
    retired : out std_ulogic;
    -- Trace for tests; optimised away if left open.
    retirement : out retirement_t;
    -- Halt, resume, single step; optimised away if left open.
    debug_request : in debug_request_t := debug_request_idle;
    debug_response : out debug_response_t
  );
end entity;

architecture rtl of processor is

  -- Fetch and decode.
  signal fetched : fetched_t;
  signal prediction : prediction_t;
  signal flush, flushed : std_ulogic;
  signal decoded : control_t;
  signal decoded_immediate : word_t;
  signal first_index, second_index : register_index_t;
  signal advance, issue, issue_executable : std_ulogic;

  -- Execute.
  signal executing : executing_t;
  signal redirect_condition : redirect_condition_t;
  signal legal : std_ulogic;
  signal control : control_t;
  signal executing_instruction, executing_immediate : word_t;
  signal executing_address, alternate_address, data_address : unsigned(31 downto 0);
  signal executable, stalled, start, complete, take_interrupt : std_ulogic;
  signal interruptible, take_halt, enter_debug : std_ulogic;
  signal first_operand, second_operand : word_t;
  signal hazard, forward_late_result : std_ulogic;
  signal forwarded_late, forwarded_early, result : word_t;
  signal result_is_address : std_ulogic;
  signal divider_done : std_ulogic;
  signal redirect : redirect_t;
  signal data_misaligned, data_in_memory : std_ulogic;
  signal bus_active, bus_done, bus_error : std_ulogic;
  signal asleep, interrupt_requested : std_ulogic;
  -- Asleep in each of the previous clocks: when all are set, the stages after execute are empty.
  signal asleep_before : std_ulogic_vector(3 downto 0) := (others => '0');
  signal csr_request : csr_request_t;
  signal csr_data : word_t;
  -- Trap of the instruction in execute; the same without debug mode; the latter in the next clock.
  signal trap, machine_trap, taken_trap : trap_t;
  signal trapped : std_ulogic;
  signal return_from_trap, entering_handler, returning, resuming : std_ulogic;
  signal wake_request, interrupt_pending : std_ulogic;
  signal retire, counted : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap_target, return_address, return_target : unsigned(31 downto 0);

  -- Write-back.
  signal writing : writing_t;
  signal writing_instruction, product, manipulated : word_t;
  signal written_value, written_late, written_product, written_early : word_t;
  signal register_write : register_write_t;

begin

  memory_lies_at_a_multiple_of_its_size : assert
    to_integer(reset_address(address_bits_of(memory_size_bytes) - 1 downto 0)) = 0 severity failure;

  instruction_fetch : entity work.instruction_fetch
    generic map (memory_address => reset_address, memory_size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      flush => flush or reset,
      redirect => redirect.enable,
      redirect_target => redirect.target,
      redirect_target_plus_2 => redirect.target_plus_2,
      predicted_taken => prediction.taken,
      predicted_target => prediction.target,
      predicted_target_plus_2 => prediction.target_plus_2,
      predicted_next_address => prediction.next_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => fetched.valid,
      instruction => fetched.instruction,
      is_word => fetched.is_word,
      address => fetched.address,
      fault => fetched.fault,
      crosses_memory_end => fetched.crosses_memory_end);

  decode : entity work.decode_stage
    generic map (reset_address => reset_address, has_zbb => has_zbb)
    port map (
      clk => clk, reset => reset, advance => advance, fetched => fetched,
      debug_request => debug_request, redirect => redirect.enable, trap_enable => trap.enable,
      return_from_trap => return_from_trap, bus_error => bus_error, take_interrupt => take_interrupt,
      flush => flush, forwarded_late => forwarded_late, forwarded_early => forwarded_early,
      forward_late_result => forward_late_result, writing => writing, written_late => written_late,
      written_product => written_product, written_early => written_early,
      register_write => register_write, prediction => prediction, issue => issue,
      issue_executable => issue_executable, decoded => decoded, decoded_immediate => decoded_immediate,
      first_index => first_index, second_index => second_index, issued => executing,
      issued_condition => redirect_condition, issued_control => control, legal => legal,
      result_is_address => result_is_address, executing_instruction => executing_instruction,
      executing_immediate => executing_immediate, executing_address => executing_address,
      alternate_address => alternate_address, first_operand => first_operand,
      second_operand => second_operand, hazard => hazard);

  -- Stalls and flushes. All side effects and traps happen in execute; only bus accesses complete in the next
  -- stage, and stall the pipeline meanwhile.

  -- An instruction with a fetch fault, or an illegal one, has no side effect.
  executable <= executing.executable;
  -- `stalled`: no operands yet. Divisions and wfi have theirs, and hold back `advance` only.
  forward_late_result <= executable and hazard and not bus_active;
  stalled <= bus_active or (executable and hazard);
  -- Debug mode is entered as an interrupt is taken, but also before wfi.
  interruptible <= (executing.valid or not flushed) and not bus_active;
  take_halt <= debug_request.halt and interruptible;
  take_interrupt <= take_halt or
                    (interrupt_pending and interruptible and
                     not (executing.valid and control.wait_for_interrupt) and
                     not debug_request.halted and not debug_request.step);
  start <= executable and not stalled and not take_interrupt;
  -- Stall of the whole pipeline. An interrupted instruction is flushed from execute even
  -- while `advance` is low.
  advance <= not (bus_active or
                  (executable and
                   (hazard or (control.divide and not divider_done) or
                    (control.wait_for_interrupt and not wake_request and not debug_request.step))));
  complete <= executing.valid and advance and not trap.enable;

  execute : entity work.execute_stage
    generic map (
      reset_address => reset_address, memory_size_bytes => memory_size_bytes, has_zbb => has_zbb)
    port map (
      clk => clk, reset => reset, start => start, redirect_condition => redirect_condition,
      control => control, result_is_address => result_is_address,
      executing_instruction => executing_instruction, executing_immediate => executing_immediate,
      alternate_address => alternate_address, first_operand => first_operand,
      second_operand => second_operand, flush => flush, entering_handler => entering_handler,
      leaving_handler => resuming or returning, trap_target => trap_target,
      return_target => return_target, redirect => redirect, flushed => flushed,
      memory_request => memory_request, bus_request => bus_request, bus_response => bus_response,
      data_address => data_address, data_misaligned => data_misaligned,
      data_in_memory => data_in_memory, bus_active => bus_active, bus_done => bus_done,
      bus_error => bus_error, divider_done => divider_done, csr_data => csr_data,
      forwarded_late => forwarded_late, forwarded_early => forwarded_early, result => result,
      product => product,
      manipulated => manipulated);

  machine_mode : entity work.machine_mode
    generic map (memory_end => reset_address + memory_size_bytes)
    port map (
      clk => clk, always_clk => always_clk, reset => reset, timer_interrupt => timer_interrupt,
      external_interrupt => external_interrupt, interrupts => interrupts,
      debug_request => debug_request, executing => executing, control => control, legal => legal,
      executing_instruction => executing_instruction, executing_address => executing_address,
      first_operand => first_operand, executable => executable, stalled => stalled, start => start,
      take_interrupt => take_interrupt, take_halt => take_halt, fetched_address => fetched.address,
      data_address => data_address, data_misaligned => data_misaligned, bus_active => bus_active,
      bus_error => bus_error, bus_store => bus_request.write, retire => retire, counted => counted,
      csr_request => csr_request, csr_data => csr_data, interrupt_requested => interrupt_requested,
      wake_request => wake_request, interrupt_pending => interrupt_pending,
      interrupt_cause => interrupt_cause, trap => trap, machine_trap => machine_trap,
      taken => taken_trap, return_from_trap => return_from_trap, enter_debug => enter_debug,
      flush => flush, entering_handler => entering_handler, returning => returning,
      resuming => resuming, trap_target => trap_target, return_address => return_address,
      return_target => return_target);

  debug_response <= (
    enter => enter_debug,
    at_breakpoint => not take_halt,
    address => trap.address,
    advance => advance,
    issue => issue,
    next_address => fetched.address,
    finish => complete or machine_trap.enable,
    uses_data_port => executing.valid and (control.load or control.store),
    completed => writing.valid,
    trapped => writing.trapped,
    value => written_value);

  trapped <= trap.enable and not enter_debug;
  write_back : entity work.write_back
    port map (
      clk => clk,
      reset => reset,
      complete => complete,
      control => control,
      instruction => executing_instruction,
      result => result,
      trapped => trapped,
      interrupted => trap.interrupt,
      to_memory => data_in_memory,
      byte_index => std_ulogic_vector(data_address(1 downto 0)),
      bus_active => bus_active,
      bus_done => bus_done,
      product => product,
      manipulated => manipulated,
      memory_data => memory_data,
      retire => retire,
      writing => writing,
      writing_instruction => writing_instruction,
      value => written_value,
      value_late => written_late,
      value_product => written_product,
      value_early => written_early);

  register_write_stage : entity work.register_write
    port map (
      clk => clk,
      writing => writing,
      memory_data => memory_data,
      value_product => written_product,
      value_early => written_early,
      write => register_write);

  asleep <= executable and not bus_active and control.wait_for_interrupt and not wake_request;
  sleeping <= asleep;
  at_rest <= asleep and (and asleep_before) and not interrupt_requested;

  watch_sleep : process
  begin
    wait until rising_edge(clk);
    asleep_before <= asleep_before(2 downto 0) & '1' when asleep = '1' else (others => '0');
    if reset then
      asleep_before <= (others => '0');
    end if;
  end process;

  retired <= writing.valid;
  retirement <= (
    valid => writing.valid,
    trap => writing.trapped,
    interrupt => writing.interrupted,
    address => taken_trap.address,
    instruction => writing_instruction,
    destination => writing.destination and (4 downto 0 => writing.writes),
    value => written_value);

end architecture;
