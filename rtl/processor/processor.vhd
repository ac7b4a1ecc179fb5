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
    -- A power of two. Data outside of the memory is asked from the bus; there are no instructions.
    memory_size_bytes : positive := 65536
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

  -- Fetch and decode.
  signal fetched_valid, fetch_fault, leaves_memory : std_ulogic;
  signal presented, presented_fault : std_ulogic;
  signal presented_instruction : word_t;
  signal fetched_address : unsigned(31 downto 0);
  signal fetched_instruction : word_t;
  signal redirect : std_ulogic;
  signal redirect_address, redirect_address_plus_2 : unsigned(31 downto 0);
  signal decoded_of_compressed, decoded_of_word : decoded_t;
  signal first_choice, second_choice : register_choice_t;
  signal decoded_is_word : std_ulogic;
  signal decoded_immediate_of_compressed, decoded_immediate_of_word : word_t;
  signal advance, follow : std_ulogic;

  -- Execute.
  signal executing : executing_t;
  signal executing_is_word, legal : std_ulogic;
  signal legal_of_compressed, legal_of_word : std_ulogic_vector(3 downto 0);
  signal kind, kind_of_compressed, kind_of_word : decoded_t;
  signal executing_destination : register_index_t;
  signal takes_constant_of_compressed, takes_constant_of_word : std_ulogic;
  signal executing_bits, constant_operand : word_t;
  signal executing_instruction, executing_immediate : word_t;
  signal executing_immediate_of_compressed, executing_immediate_of_word : word_t;
  signal executing_address, offset, offset_plus_2 : unsigned(31 downto 0);
  signal able, waiting, start, stall, complete, take_interrupt : std_ulogic;
  signal interruptible, take_halt, enter_debug : std_ulogic;
  signal first_value, second_register, second_value, last_written : word_t;
  signal first_is_result, second_is_result, await_result : std_ulogic;
  signal alu_result, divider_result, other_result : word_t;
  signal takes_other_result : std_ulogic;
  signal equal, less, condition, divider_done : std_ulogic;
  signal jump : std_ulogic;
  signal jump_target, jump_target_plus_2 : unsigned(31 downto 0);
  signal target, target_plus_2, register_target, register_target_plus_2 : unsigned(31 downto 0);
  signal data_enable, data_misaligned, data_in_memory : std_ulogic;
  signal bus_active, bus_done, bus_error : std_ulogic;
  signal csr_operand : word_t;
  signal csr_writes : std_ulogic;
  signal asleep, interrupt_requested : std_ulogic;
  -- Clocks asleep so far; the stages behind are empty when all are set.
  signal asleep_before : std_ulogic_vector(3 downto 0) := (others => '0');
  signal csr_request : csr_request_t;
  signal csr_data : word_t;
  signal csr_legal : std_ulogic;
  -- Of the instruction executed; that which is taken, and in the clock behind it.
  signal trap, machine_trap, taken_trap : trap_t;
  signal return_from_trap, returning, resuming, awake, interrupt_pending : std_ulogic;
  signal writes, retire, take_back : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap_target, return_address, return_target : unsigned(31 downto 0);

  -- Write back.
  -- Nothing is written before the first reset, not even to x0.
  signal writing : writing_t := (
    destination => "00000", size => "000", byte_index => "00", others => '0');
  signal writing_instruction, writing_result : word_t;
  signal product, loaded_word, loaded, written_early, written_value : word_t;

begin

  memory_lies_at_a_multiple_of_its_size : assert
    memory_size_bytes = 2 ** memory_address_bits and
    to_integer(reset_address(memory_address_bits - 1 downto 0)) = 0 severity failure;

  instruction_fetch : entity work.instruction_fetch
    generic map (reset_address => reset_address, memory_address_bits => memory_address_bits)
    port map (
      clk => clk,
      reset => reset,
      redirect => redirect,
      redirect_address => redirect_address,
      redirect_address_plus_2 => redirect_address_plus_2,
      jump => jump,
      jump_address => jump_target,
      jump_address_plus_2 => jump_target_plus_2,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => fetched_valid,
      address => fetched_address,
      instruction => fetched_instruction,
      fault => fetch_fault,
      leaves_memory => leaves_memory);

  -- In debug mode what is injected takes the place of what is fetched.
  presented <= debug_request.inject when debug_request.halted else fetched_valid;
  presented_fault <= fetch_fault and not debug_request.halted;
  presented_instruction <= debug_request.instruction when debug_request.halted else
                           fetched_instruction;

  instruction_decoder : entity work.instruction_decoder
    port map (
      instruction => presented_instruction,
      decoded_of_compressed => decoded_of_compressed,
      decoded_of_word => decoded_of_word,
      immediate_of_compressed => decoded_immediate_of_compressed,
      immediate_of_word => decoded_immediate_of_word,
      first => first_choice,
      second => second_choice);

  decoded_is_word <= and presented_instruction(1 downto 0);
  advance <= not stall;
  -- What is decoded comes after what is executed.
  follow <= presented and not (jump or trap.enable or return_from_trap);

  pass_to_execute : process
  begin
    wait until rising_edge(clk);
    if advance then
      executing <= (
        valid => follow,
        fetch_fault => presented_fault,
        leaves_memory => leaves_memory);
      executing_is_word <= decoded_is_word;
      kind_of_compressed <= decoded_of_compressed;
      kind_of_word <= decoded_of_word;
      legal_of_compressed <= decoded_of_compressed.legal and not (3 downto 0 => decoded_is_word);
      legal_of_word <= decoded_of_word.legal and (3 downto 0 => decoded_is_word);
      takes_constant_of_compressed <= not decoded_is_word and decoded_of_compressed.second_is_constant;
      takes_constant_of_word <= decoded_is_word and decoded_of_word.second_is_constant;
      executing_immediate_of_compressed <= decoded_immediate_of_compressed;
      executing_immediate_of_word <= decoded_immediate_of_word;
      executing_address <= fetched_address;
      executing_bits <= presented_instruction;
    end if;

    if reset or bus_error then
      executing.valid <= '0';
    end if;
  end process;

  -- Execute: everything that an instruction does, it does here, or it traps. Only what goes over the
  -- bus ends in the next stage, and all others stand still for it.
  operand_reader : entity work.operand_reader
    port map (
      clk => clk,
      read => advance,
      first_choice => first_choice,
      second_choice => second_choice,
      next_writes => executing.valid and writes,
      next_destination => executing_destination,
      result => writing_result,
      write => writing.writes,
      destination => writing.destination,
      write_data => written_value,
      await_result => await_result,
      last_written => last_written,
      first => first_value,
      first_is_result => first_is_result,
      second => second_register,
      second_is_result => second_is_result);

  kind <= kind_of_word when executing_is_word else kind_of_compressed;
  executing_destination <= "00001" when kind.writes_link else kind.destination;
  writes <= kind.writes and (kind.writes_link or (or kind.destination));
  executing_instruction(15 downto 0) <= executing_bits(15 downto 0);
  executing_instruction(31 downto 16) <= executing_bits(31 downto 16) and
                                         (31 downto 16 => executing_is_word);
  executing_immediate <= executing_immediate_of_word when executing_is_word else
                         executing_immediate_of_compressed;
  constant_operand <=
    (executing_immediate_of_word and (31 downto 0 => takes_constant_of_word)) or
    (executing_immediate_of_compressed and (31 downto 0 => takes_constant_of_compressed));
  second_value <= constant_operand when takes_constant_of_word or takes_constant_of_compressed else
                  second_register;

  -- A fetch fault or an illegal instruction is not executed: nothing of it may happen.
  legal <= (or legal_of_compressed) or (or legal_of_word);
  able <= executing.valid and not executing.fetch_fault and legal;
  await_result <= able and writing.late and not bus_active and
                  ((kind.reads_first and first_is_result) or
                   (kind.reads_second and second_is_result));
  waiting <= bus_active or await_result;
  -- Before which instruction debug mode begins is decided as for an interrupt, but wfi may be it.
  interruptible <= (executing.valid or fetched_valid) and not bus_active;
  take_halt <= debug_request.halt and interruptible;
  take_interrupt <= take_halt or
                    (interrupt_pending and interruptible and
                     not (executing.valid and kind.wait_for_interrupt) and
                     not debug_request.halted and not debug_request.step);
  start <= able and not waiting and not take_interrupt;
  stall <= bus_active or
           (able and not take_interrupt and
            (await_result or (kind.divide and not divider_done) or
             (kind.wait_for_interrupt and not awake and not debug_request.step)));
  complete <= executing.valid and not stall and not trap.enable;

  arithmetic : entity work.alu
    port map (
      first => first_value,
      second => second_value,
      second_register => second_register,
      operation => kind.operation,
      shift => kind.shift,
      subtract => kind.subtract,
      arithmetic_shift => kind.arithmetic_shift,
      compare_unsigned => kind.compare_unsigned,
      result => alu_result,
      equal => equal,
      less => less);

  offset <= unsigned(executing_immediate);
  target <= executing_address + offset;
  -- Both are even: a carry into bit 1 adds 2.
  target_plus_2 <= ((executing_address(31 downto 1) & '1') + (offset(31 downto 1) & '1')) and
                   x"fffffffe";
  register_target <= unsigned(first_value) + offset;
  offset_plus_2 <= offset + 2;
  register_target_plus_2 <= unsigned(first_value) + offset_plus_2;
  condition <= less xor kind.funct3(0) when kind.funct3(2) else equal xor kind.funct3(0);
  jump <= able and not waiting and (kind.jump or kind.jump_register or (kind.branch and condition));
  jump_target <= register_target when kind.jump_register else target;
  jump_target_plus_2 <= register_target_plus_2 when kind.jump_register else target_plus_2;

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

  data_enable <= start and (kind.load or kind.store);
  data_access : entity work.data_access
    generic map (memory_address => reset_address, memory_address_bits => memory_address_bits)
    port map (
      clk => clk,
      reset => reset,
      enable => data_enable,
      store => kind.store,
      base => unsigned(first_value),
      offset => offset,
      address => register_target,
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

  csr_operand <= 27x"0" & executing_bits(19 downto 15) when kind.funct3(2) else first_value;
  csr_writes <= not kind.funct3(1) or (or executing_bits(19 downto 15));
  -- The upper two bits of an address say that it cannot be written.
  csr_legal <= kind.csr_exists and not (csr_writes and (and executing_bits(31 downto 30)));
  csr_request <= (
    enable => start and kind.csr and kind.csr_exists,
    address => executing_bits(31 downto 20),
    operation => kind.funct3(1 downto 0),
    operand => csr_operand,
    writes => csr_writes);
  return_from_trap <= start and kind.trap_return;
  control_status_registers : entity work.control_status_registers
    port map (
      clk => clk,
      always_clk => always_clk,
      reset => reset,
      request => csr_request,
      read_data => csr_data,
      trap => taken_trap,
      trap_return => return_from_trap,
      retire => retire,
      take_back => take_back,
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
      data_address => register_target,
      data_misaligned => data_misaligned,
      bus_active => bus_active,
      bus_error => bus_error,
      bus_store => bus_request.write,
      bus_address => bus_request.address,
      bus_instruction_address => taken_trap.address,
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
  -- In the next clock. Handlers begin with a word.
  return_target <= debug_request.resume_address when resuming else return_address;
  redirect_address <= return_target when resuming or returning else trap_target;
  redirect_address_plus_2 <= return_target + 2 when resuming or returning else trap_target;

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
  -- learn of it a clock later, when nothing is executed, and until then it counts as completed.
  take_trap : process
  begin
    wait until rising_edge(clk);
    taken_trap <= machine_trap;
    returning <= return_from_trap;
    resuming <= debug_request.resume;
    take_back <= trap.enable and not take_interrupt and not debug_request.halted;
    if reset then
      taken_trap.enable <= '0';
      take_back <= '0';
    end if;
  end process;
  retire <= executing.valid and not stall and not take_interrupt and not debug_request.halted;

  -- What the arithmetic unit gives comes last in the clock.
  other_result <= bus_response.data when bus_active else
                  last_written when await_result else
                  divider_result when kind.divide else
                  csr_data when kind.csr else
                  std_ulogic_vector(target) when kind.address_result else
                  std_ulogic_vector(fetched_address);
  takes_other_result <= bus_active or await_result or kind.divide or kind.csr or
                        kind.address_result or kind.jump or kind.jump_register;

  pass_to_write_back : process
    variable on_bus : std_ulogic;
  begin
    wait until rising_edge(clk);
    writing.trapped <= trap.enable and not enter_debug;
    writing.interrupted <= trap.interrupt;
    if bus_active then
      writing.valid <= bus_done;
      writing.writes <= bus_done and writing.wanted;
    else
      on_bus := (kind.load or kind.store) and not data_in_memory;
      writing.valid <= complete and not on_bus;
      writing.writes <= complete and writes and not on_bus;
      writing.wanted <= writes;
      writing.late <= complete and kind.late;
      writing.destination <= executing_destination;
      writing.multiply <= kind.multiply;
      writing.load <= kind.load;
      writing.from_memory <= data_in_memory;
      writing.size <= kind.funct3;
      writing.byte_index <= std_ulogic_vector(register_target(1 downto 0));
      writing_instruction <= executing_instruction;
    end if;
    writing_result <= other_result when takes_other_result else alu_result;

    if reset then
      writing.valid <= '0';
      writing.trapped <= '0';
      writing.interrupted <= '0';
      writing.writes <= '0';
    end if;
  end process;

  -- Write back.
  loaded_word <= memory_data when writing.from_memory else writing_result;
  load_result : entity work.load_result
    port map (
      loaded => loaded_word,
      size => writing.size,
      byte_index => writing.byte_index,
      result => loaded);

  -- What is loaded comes last.
  written_early <= product when writing.multiply else writing_result;
  written_value <= loaded when writing.load else written_early;

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
