-- SPDX-License-Identifier: Apache-2.0
-- The processor: RV32IMC with machine mode, a five-stage in-order pipeline with constant instruction times.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor is
  generic (
    -- First address of the memory and reset vector; a multiple of the memory's size.
    reset_address : unsigned(31 downto 0) := x"80000000";
    -- A power of two, or three quarters of one. Data accesses outside the memory go to the bus, instruction
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

  constant memory_address_bits : positive := integer(ceil(log2(real(memory_size_bytes))));
  constant memory_lacks_quarter : boolean := memory_size_bytes /= 2 ** memory_address_bits;

  -- Fetch and decode.
  signal fetched_valid, fetch_fault, crosses_memory_end, flushed : std_ulogic;
  signal decode_valid, decode_fault, fetched_is_word, decode_is_word : std_ulogic;
  signal decode_instruction, fetched_instruction : word_t;
  signal fetched_address : unsigned(31 downto 0);
  signal flush : std_ulogic;
  signal decoded : control_t;
  signal decoded_immediate : word_t;
  signal first_index, second_index : register_index_t;
  signal predicted_taken : std_ulogic;
  signal predicted_next_address, predicted_target, predicted_target_plus_2 : unsigned(31 downto 0);
  signal decoded_alternate_address : unsigned(31 downto 0);
  signal decoded_condition : redirect_condition_t;
  signal advance, issue, issue_executable : std_ulogic;

  -- Execute.
  signal executing : executing_t;
  signal redirect_condition : redirect_condition_t;
  signal legal : std_ulogic;
  signal control : control_t;
  signal executing_instruction, executing_immediate : word_t;
  signal executing_address, alternate_address, offset, sum : unsigned(31 downto 0);
  signal executable, stalled, start, complete, take_interrupt : std_ulogic;
  signal interruptible, take_halt, enter_debug : std_ulogic;
  signal first_operand, second_operand : word_t;
  signal hazard, forward_late_result : std_ulogic;
  signal alu_result, divider_result, early_result, forwarded_result, late_result, execute_result : word_t;
  signal result_is_address : std_ulogic;
  signal less, divider_done : std_ulogic;
  signal comparison : comparison_t;
  signal redirect : std_ulogic;
  signal redirect_target : unsigned(31 downto 0);
  signal redirect_target_plus_2 : unsigned(31 downto 2);
  signal data_enable, data_misaligned, data_in_memory : std_ulogic;
  signal bus_active, bus_done, bus_error : std_ulogic;
  signal csr_operand : word_t;
  signal asleep, interrupt_requested : std_ulogic;
  -- Asleep in each of the previous clocks: when all are set, the stages behind execute are empty.
  signal asleep_before : std_ulogic_vector(3 downto 0) := (others => '0');
  signal csr_request : csr_request_t;
  signal csr_data : word_t;
  signal csr_legal : std_ulogic;
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
  signal manipulated : word_t := (others => '0');
  signal writing_instruction, product, written_value, written_late, written_early : word_t;

begin

  memory_lies_at_a_multiple_of_its_size : assert
    (memory_size_bytes = 2 ** memory_address_bits or
     memory_size_bytes = 3 * 2 ** (memory_address_bits - 2)) and
    to_integer(reset_address(memory_address_bits - 1 downto 0)) = 0 severity failure;

  instruction_fetch : entity work.instruction_fetch
    generic map (memory_address => reset_address, memory_address_bits => memory_address_bits,
      memory_lacks_quarter => memory_lacks_quarter)
    port map (
      clk => clk,
      flush => flush or reset,
      redirect => redirect,
      redirect_target => redirect_target,
      redirect_target_plus_2 => redirect_target_plus_2,
      predicted_taken => predicted_taken,
      predicted_target => predicted_target,
      predicted_target_plus_2 => predicted_target_plus_2,
      predicted_next_address => predicted_next_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => fetched_valid,
      instruction => fetched_instruction,
      is_word => fetched_is_word,
      address => fetched_address,
      fault => fetch_fault,
      crosses_memory_end => crosses_memory_end);

  -- In debug mode injected instructions replace fetched ones.
  decode_valid <= debug_request.inject when debug_request.halted else fetched_valid;
  decode_fault <= fetch_fault and not debug_request.halted;
  decode_instruction <= debug_request.instruction when debug_request.halted else
                           fetched_instruction;
  decode_is_word <= fetched_is_word or debug_request.halted;

  instruction_decoder : entity work.instruction_decoder
    generic map (has_zbb => has_zbb)
    port map (
      instruction => decode_instruction,
      is_word => decode_is_word,
      decoded => decoded,
      immediate => decoded_immediate,
      first => first_index,
      second => second_index);

  branch_predictor : entity work.branch_predictor
    port map (
      valid => fetched_valid and not debug_request.halted,
      address => fetched_address,
      instruction => decode_instruction,
      is_word => decode_is_word,
      decoded => decoded,
      taken => predicted_taken,
      target => predicted_target,
      target_plus_2 => predicted_target_plus_2,
      next_address => predicted_next_address,
      alternate_address => decoded_alternate_address,
      condition => decoded_condition);

  -- The instruction in decode is issued unless execute redirects or traps.
  issue <= decode_valid and not (redirect or trap.enable or return_from_trap);
  issue_executable <= issue and not decode_fault and (or decoded.legal);

  issue_to_execute : process
  begin
    wait until rising_edge(clk);
    if advance then
      executing <= (
        valid => issue,
        executable => issue_executable,
        fetch_fault => decode_fault,
        crosses_memory_end => crosses_memory_end);
      redirect_condition <= (
        if_below => issue_executable and decoded_condition.if_below,
        if_above => issue_executable and decoded_condition.if_above,
        inverted => issue_executable and decoded_condition.inverted);
      control <= decoded;
      legal <= or decoded.legal;
      result_is_address <= decoded.address_result or decoded.jump or decoded.jump_register;
      executing_immediate <= decoded_immediate;
      executing_address <= fetched_address;
      alternate_address <= decoded_alternate_address;
      executing_instruction <= decode_instruction;
      -- Clear what follows a compressed instruction.
      if not decode_is_word then
        executing_instruction(31 downto 16) <= (others => '0');
      end if;
    end if;

    if reset or bus_error or take_interrupt then
      executing.valid <= '0';
      executing.executable <= '0';
      redirect_condition <= redirect_never;
    end if;
    -- The clock after a flush redirects to the trap vector or return address, after reset to the reset
    -- vector.
    if reset or flush then
      redirect_condition <= redirect_always;
      control.jump_register <= '0';
      alternate_address <= (others => '0');
    end if;
    if reset then
      alternate_address <= reset_address;
    end if;
  end process;

  -- Execute: all side effects and traps happen in this stage. Only bus accesses complete in the next one, and
  -- stall the pipeline meanwhile.
  operand_forwarding : entity work.operand_forwarding
    port map (
      clk => clk,
      advance => advance,
      executable => issue_executable,
      first_index => first_index,
      second_index => second_index,
      reads_first => decoded.reads_first,
      reads_second => decoded.reads_second,
      second_is_immediate => decoded.second_is_immediate,
      immediate => decoded_immediate,
      execute_writes => executing.valid and control.writes,
      execute_destination => control.destination,
      execute_late => control.late,
      execute_result => forwarded_result,
      write => writing.writes,
      destination => writing.destination,
      write_data => written_value,
      write_data_late => written_late,
      write_data_early => written_early,
      forward_late_result => forward_late_result,
      hazard => hazard,
      first => first_operand,
      second => second_operand);

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
  -- Stall of the whole pipeline. An interrupted instruction is flushed from execute even while `advance` is
  -- low.
  advance <= not (bus_active or
                  (executable and
                   (hazard or (control.divide and not divider_done) or
                    (control.wait_for_interrupt and not wake_request and not debug_request.step))));
  complete <= executing.valid and advance and not trap.enable;

  arithmetic : entity work.alu
    generic map (has_zbb => has_zbb)
    port map (
      first => first_operand,
      second => second_operand,
      operation => control.operation,
      shift => control.shift,
      subtract => control.subtract,
      arithmetic_shift => control.arithmetic_shift,
      rotate => control.rotate,
      compare_unsigned => control.compare_unsigned,
      result => alu_result,
      less => less,
      comparison => comparison);

  offset <= unsigned(executing_immediate);
  sum <= unsigned(first_operand) + offset;
  branch_resolution : entity work.branch_resolution
    port map (
      clk => clk,
      reset => reset,
      condition => redirect_condition,
      comparison => comparison,
      alternate_address => alternate_address,
      jump_register => control.jump_register,
      base => unsigned(first_operand),
      offset => offset,
      sum => sum,
      flush => flush,
      to_handler => entering_handler,
      to_return => resuming or returning,
      handler_address => trap_target,
      return_address => return_target,
      redirect => redirect,
      target => redirect_target,
      target_plus_2 => redirect_target_plus_2,
      flushed => flushed);

  multiplication : entity work.multiplier
    port map (
      clk => clk,
      enable => control.multiply,
      operation => control.funct3(1 downto 0),
      first => first_operand,
      second => second_operand,
      result => product);

  division : entity work.divider
    port map (
      clk => clk,
      reset => reset,
      request => start and control.divide,
      operation => control.funct3(1 downto 0),
      first => first_operand,
      second => second_operand,
      done => divider_done,
      result => divider_result);

  with_zbb : if has_zbb generate
    bits : entity work.bit_manipulation
      port map (
        clk => clk,
        enable => control.manipulate,
        instruction => executing_instruction,
        first => first_operand,
        second => second_operand,
        less => less,
        result => manipulated);
  end generate;

  data_enable <= start and (control.load or control.store);
  data_access : entity work.data_access
    generic map (memory_address => reset_address, memory_address_bits => memory_address_bits,
      memory_lacks_quarter => memory_lacks_quarter)
    port map (
      clk => clk,
      reset => reset,
      enable => data_enable,
      store => control.store,
      base => unsigned(first_operand),
      offset => offset,
      address => sum,
      size => control.funct3(1 downto 0),
      store_data => second_operand,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => data_misaligned,
      to_memory => data_in_memory,
      bus_active => bus_active,
      done => bus_done,
      error => bus_error);

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
    generic map (memory_end => reset_address + memory_size_bytes)
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
      data_address => sum,
      data_misaligned => data_misaligned,
      bus_error => bus_error,
      bus_store => bus_request.write,
      trap => trap);

  -- No trap is taken on entry to debug mode and within it: an exception of an injected instruction is only
  -- reported.
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

  debug_response <= (
    enter => enter_debug,
    at_breakpoint => not take_halt,
    address => trap.address,
    advance => advance,
    issue => issue,
    next_address => fetched_address,
    finish => complete or machine_trap.enable,
    uses_data_port => executing.valid and (control.load or control.store),
    completed => writing.valid,
    trapped => writing.trapped,
    value => written_value);

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

  -- Result forwarded to the next instruction; the ALU's settles last. Late results are forwarded from
  -- write-back.
  early_result <= divider_result when control.divide else std_ulogic_vector(alternate_address);
  forwarded_result <= early_result when control.divide or result_is_address else alu_result;
  late_result <= bus_response.data when bus_active else csr_data;
  execute_result <= late_result when bus_active or control.csr else forwarded_result;

  trapped <= trap.enable and not enter_debug;
  write_back : entity work.write_back
    port map (
      clk => clk,
      reset => reset,
      complete => complete,
      control => control,
      instruction => executing_instruction,
      result => execute_result,
      trapped => trapped,
      interrupted => trap.interrupt,
      to_memory => data_in_memory,
      byte_index => std_ulogic_vector(sum(1 downto 0)),
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
      value_early => written_early);

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
