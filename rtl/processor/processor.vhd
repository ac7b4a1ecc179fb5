-- SPDX-License-Identifier: Apache-2.0
-- The processor: RV32IMC with machine mode, each instruction in a time that depends only on itself.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor is
  generic (
    -- First address of the memory, and where the program starts; a multiple of the memory's size.
    reset_address : unsigned(31 downto 0) := x"80000000";
    -- A power of two, or three quarters of one. Data outside of the memory is asked from the bus; there are
    -- no instructions.
    memory_size_bytes : positive := 65536;
    -- Extension Zbb: bit manipulation.
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    -- The same clock for what never rests. Edges of `clk` may be left out while `at_rest` is high.
    always_clk : in std_ulogic;
    reset : in std_ulogic;
    -- The memory's port for instructions.
    instruction_request : out instruction_request_t;
    instruction_data : in std_ulogic_vector(31 downto 0);
    -- The memory's port for data.
    memory_request : out memory_request_t;
    memory_data : in std_ulogic_vector(31 downto 0);
    -- Everything outside the memory.
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    -- Levels, synchronous to the clock: mip.MTIP, mip.MEIP, and mip(16 + index).
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    -- The processor waits in wfi.
    sleeping : out std_ulogic;
    -- The next edge of `clk` changes nothing: asleep, all pipeline stages empty, no interrupt to wake it.
    at_rest : out std_ulogic;
    -- An instruction was completed.
    retired : out std_ulogic;
    -- What was completed, for tests; leave it open and it costs nothing.
    retirement : out retirement_t;
    -- Halt, resume, step; the same.
    debug_request : in debug_request_t := debug_request_idle;
    debug_response : out debug_response_t
  );
end entity;

architecture rtl of processor is

  constant memory_address_bits : positive := integer(ceil(log2(real(memory_size_bytes))));
  constant memory_lacks_quarter : boolean := memory_size_bytes /= 2 ** memory_address_bits;

  -- Fetch and decode.
  signal fetched_valid, fetch_fault, leaves_memory, redirecting : std_ulogic;
  signal presented, presented_fault, fetched_is_word, presented_is_word : std_ulogic;
  signal presented_instruction, fetched_instruction : word_t;
  signal fetched_address : unsigned(31 downto 0);
  signal redirect : std_ulogic;
  signal decoded : decoded_t;
  signal decoded_immediate : word_t;
  signal first_index, second_index : register_index_t;
  signal early_jump : std_ulogic;
  signal following_address, early_address, early_address_plus_2, decoded_other : unsigned(31 downto 0);
  signal decoded_turn : late_turn_t;
  signal advance, follow, next_able : std_ulogic;

  -- Execute.
  signal executing : executing_t;
  signal turn : late_turn_t;
  signal legal : std_ulogic;
  signal kind : decoded_t;
  signal executing_instruction, executing_immediate : word_t;
  signal executing_address, other_address, offset, sum : unsigned(31 downto 0);
  signal able, waiting, start, complete, take_interrupt : std_ulogic;
  signal interruptible, take_halt, enter_debug : std_ulogic;
  signal first_value, second_value : word_t;
  signal awaits, await_result : std_ulogic;
  signal alu_result, divider_result, early_result, next_result, late_result, executed_result : word_t;
  signal gives_address : std_ulogic;
  signal less, divider_done : std_ulogic;
  signal comparison : comparison_t;
  signal jump : std_ulogic;
  signal jump_target : unsigned(31 downto 0);
  signal jump_target_plus_2 : unsigned(31 downto 2);
  signal data_enable, data_misaligned, data_in_memory : std_ulogic;
  signal bus_active, bus_done, bus_error : std_ulogic;
  signal csr_operand : word_t;
  signal asleep, interrupt_requested : std_ulogic;
  -- Clocks asleep so far; the stages behind are empty when all are set.
  signal asleep_before : std_ulogic_vector(3 downto 0) := (others => '0');
  signal csr_request : csr_request_t;
  signal csr_data : word_t;
  signal csr_legal : std_ulogic;
  -- Of the instruction executed; that which is taken, and in the clock behind it.
  signal trap, machine_trap, taken_trap : trap_t;
  signal trapped : std_ulogic;
  signal return_from_trap, handling, returning, resuming, awake, interrupt_pending : std_ulogic;
  signal retire, counted : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap_target, return_address, return_target : unsigned(31 downto 0);

  -- Write back.
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
      cancel => redirect or reset,
      late_jump => jump,
      late_address => jump_target,
      late_address_plus_2 => jump_target_plus_2,
      early_jump => early_jump,
      early_address => early_address,
      early_address_plus_2 => early_address_plus_2,
      following_address => following_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => fetched_valid,
      instruction => fetched_instruction,
      is_word => fetched_is_word,
      address => fetched_address,
      fault => fetch_fault,
      leaves_memory => leaves_memory);

  -- In debug mode what is injected takes the place of what is fetched.
  presented <= debug_request.inject when debug_request.halted else fetched_valid;
  presented_fault <= fetch_fault and not debug_request.halted;
  presented_instruction <= debug_request.instruction when debug_request.halted else
                           fetched_instruction;
  presented_is_word <= fetched_is_word or debug_request.halted;

  instruction_decoder : entity work.instruction_decoder
    generic map (has_zbb => has_zbb)
    port map (
      instruction => presented_instruction,
      is_word => presented_is_word,
      decoded => decoded,
      immediate => decoded_immediate,
      first => first_index,
      second => second_index);

  early_jumps : entity work.early_jump
    port map (
      valid => fetched_valid and not debug_request.halted,
      address => fetched_address,
      instruction => presented_instruction,
      is_word => presented_is_word,
      decoded => decoded,
      jump => early_jump,
      target => early_address,
      target_plus_2 => early_address_plus_2,
      following => following_address,
      other => decoded_other,
      turn => decoded_turn);

  -- What is decoded comes after what is executed.
  follow <= presented and not (jump or trap.enable or return_from_trap);
  next_able <= follow and not presented_fault and (or decoded.legal);

  pass_to_execute : process
  begin
    wait until rising_edge(clk);
    if advance then
      executing <= (
        valid => follow,
        able => next_able,
        fetch_fault => presented_fault,
        leaves_memory => leaves_memory);
      turn <= (
        if_below => next_able and decoded_turn.if_below,
        if_above => next_able and decoded_turn.if_above,
        inverted => next_able and decoded_turn.inverted);
      kind <= decoded;
      legal <= or decoded.legal;
      gives_address <= decoded.address_result or decoded.jump or decoded.jump_register;
      executing_immediate <= decoded_immediate;
      executing_address <= fetched_address;
      other_address <= decoded_other;
      executing_instruction <= presented_instruction;
      -- What follows a short instruction is no part of it.
      if not presented_is_word then
        executing_instruction(31 downto 16) <= (others => '0');
      end if;
    end if;

    if reset or bus_error or take_interrupt then
      executing.valid <= '0';
      executing.able <= '0';
      turn <= no_turn;
    end if;
    -- A clock after traps and returns it goes where these lead, behind a reset to the start.
    if reset or redirect then
      turn <= any_turn;
      kind.jump_register <= '0';
      other_address <= (others => '0');
    end if;
    if reset then
      other_address <= reset_address;
    end if;
  end process;

  -- Execute: everything that an instruction does, it does here, or it traps. Only what goes over the
  -- bus ends in the next stage, and all others stand still for it.
  operand_reader : entity work.operand_reader
    port map (
      clk => clk,
      read => advance,
      is_able => next_able,
      first_index => first_index,
      second_index => second_index,
      reads_first => decoded.reads_first,
      reads_second => decoded.reads_second,
      second_is_constant => decoded.second_is_constant,
      constant_operand => decoded_immediate,
      next_writes => executing.valid and kind.writes,
      next_destination => kind.destination,
      next_is_late => kind.late,
      next_result => next_result,
      write => writing.writes,
      destination => writing.destination,
      write_data => written_value,
      write_data_late => written_late,
      write_data_early => written_early,
      await_result => await_result,
      awaits => awaits,
      first => first_value,
      second => second_value);

  -- A fetch fault or an illegal instruction is not executed: nothing of it may happen.
  able <= executing.able;
  await_result <= able and awaits and not bus_active;
  waiting <= bus_active or (able and awaits);
  -- Before which instruction debug mode begins is decided as for an interrupt, but wfi may be it.
  interruptible <= (executing.valid or not redirecting) and not bus_active;
  take_halt <= debug_request.halt and interruptible;
  take_interrupt <= take_halt or
                    (interrupt_pending and interruptible and
                     not (executing.valid and kind.wait_for_interrupt) and
                     not debug_request.halted and not debug_request.step);
  start <= able and not waiting and not take_interrupt;
  -- What an interrupt takes the place of leaves execute unfinished.
  advance <= not (bus_active or
                  (able and (awaits or (kind.divide and not divider_done) or
                             (kind.wait_for_interrupt and not awake and not debug_request.step))));
  complete <= executing.valid and advance and not trap.enable;

  arithmetic : entity work.alu
    generic map (has_zbb => has_zbb)
    port map (
      first => first_value,
      second => second_value,
      operation => kind.operation,
      shift => kind.shift,
      subtract => kind.subtract,
      arithmetic_shift => kind.arithmetic_shift,
      rotate => kind.rotate,
      compare_unsigned => kind.compare_unsigned,
      result => alu_result,
      less => less,
      comparison => comparison);

  offset <= unsigned(executing_immediate);
  sum <= unsigned(first_value) + offset;
  late_jumps : entity work.late_jump
    port map (
      clk => clk,
      reset => reset,
      turn => turn,
      comparison => comparison,
      other => other_address,
      jump_register => kind.jump_register,
      base => unsigned(first_value),
      offset => offset,
      sum => sum,
      redirect => redirect,
      to_handler => handling,
      to_return => resuming or returning,
      handler_address => trap_target,
      return_address => return_target,
      jump => jump,
      target => jump_target,
      target_plus_2 => jump_target_plus_2,
      redirecting => redirecting);

  multiplication : entity work.multiplier
    port map (
      clk => clk,
      enable => kind.multiply,
      operation => kind.funct3(1 downto 0),
      first => first_value,
      second => second_value,
      result => product);

  division : entity work.divider
    port map (
      clk => clk,
      reset => reset,
      request => start and kind.divide,
      operation => kind.funct3(1 downto 0),
      first => first_value,
      second => second_value,
      done => divider_done,
      result => divider_result);

  with_zbb : if has_zbb generate
    bits : entity work.bit_manipulation
      port map (
        clk => clk,
        enable => kind.manipulate,
        instruction => executing_instruction,
        first => first_value,
        second => second_value,
        less => less,
        result => manipulated);
  end generate;

  data_enable <= start and (kind.load or kind.store);
  data_access : entity work.data_access
    generic map (memory_address => reset_address, memory_address_bits => memory_address_bits,
      memory_lacks_quarter => memory_lacks_quarter)
    port map (
      clk => clk,
      reset => reset,
      enable => data_enable,
      store => kind.store,
      base => unsigned(first_value),
      offset => offset,
      address => sum,
      size => kind.funct3(1 downto 0),
      store_data => second_value,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => data_misaligned,
      to_memory => data_in_memory,
      bus_active => bus_active,
      done => bus_done,
      error => bus_error);

  csr_operand <= 27x"0" & executing_instruction(19 downto 15) when kind.funct3(2) else first_value;
  -- The upper two bits of an address say that it cannot be written.
  csr_legal <= kind.csr_exists and not (kind.csr_written and (and executing_instruction(31 downto 30)));
  csr_request <= (
    enable => able and not waiting and kind.csr and kind.csr_exists,
    in_vain => take_interrupt,
    address => executing_instruction(31 downto 20),
    operation => kind.funct3(1 downto 0),
    operand => csr_operand,
    writes => kind.csr_written);
  return_from_trap <= start and kind.trap_return;
  -- What is injected is no instruction of the program.
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
      awake => awake,
      interrupt_pending => interrupt_pending,
      interrupt_cause => interrupt_cause,
      trap_target => trap_target,
      return_address => return_address);

  trap_control : entity work.trap_control
    generic map (memory_end => reset_address + memory_size_bytes)
    port map (
      executing => executing,
      kind => kind,
      legal => legal,
      ready => not waiting,
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

  -- Into debug mode and within it no trap is taken: what an injected instruction does wrong is only told.
  enter_debug <= take_halt or
                 (trap.enable and not take_interrupt and not bus_active and
                  debug_request.halt_at_breakpoint and
                  executing.valid and kind.breakpoint and not executing.fetch_fault);
  machine_trap <= (
    enable => trap.enable and not enter_debug and not debug_request.halted,
    interrupt => trap.interrupt,
    cause => trap.cause,
    address => trap.address,
    value => trap.value);

  redirect <= trap.enable or return_from_trap or debug_request.resume;
  -- In the next clock.
  return_target <= debug_request.resume_address when resuming else return_address;

  debug_response <= (
    enter => enter_debug,
    at_breakpoint => not take_halt,
    address => trap.address,
    advance => advance,
    follows => follow,
    next_address => fetched_address,
    finish => complete or machine_trap.enable,
    uses_data_port => executing.valid and (kind.load or kind.store),
    completed => writing.valid,
    trapped => writing.trapped,
    value => written_value);

  -- Whether an instruction traps comes late in the clock: nothing more than must hangs on it. The CSRs
  -- learn of it a clock later, when nothing is executed.
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
    handling <= trap.enable;
    returning <= return_from_trap;
    resuming <= debug_request.resume;
    if reset then
      taken_trap.enable <= '0';
      handling <= '0';
      returning <= '0';
      resuming <= '0';
    end if;
  end process;

  -- What the next instruction may read: the arithmetic unit's result comes last in the clock. What
  -- comes late, it reads from write back.
  early_result <= divider_result when kind.divide else std_ulogic_vector(other_address);
  next_result <= early_result when kind.divide or gives_address else alu_result;
  late_result <= bus_response.data when bus_active else csr_data;
  executed_result <= late_result when bus_active or kind.csr else next_result;

  trapped <= trap.enable and not enter_debug;
  write_back : entity work.write_back
    port map (
      clk => clk,
      reset => reset,
      complete => complete,
      kind => kind,
      instruction => executing_instruction,
      result => executed_result,
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

  asleep <= able and not bus_active and kind.wait_for_interrupt and not awake;
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
