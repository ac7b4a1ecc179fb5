-- SPDX-License-Identifier: Apache-2.0
-- The processor: RV32IM with machine mode, each instruction in a time that depends only on itself.

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
    retirement : out retirement_t
  );
end entity;

architecture rtl of processor is

  constant memory_address_bits : positive := integer(ceil(log2(real(memory_size_bytes))));

  -- Fetch.
  signal fetched_valid, fetch_fault, jump : std_ulogic;
  signal fetched_address : unsigned(31 downto 0);
  signal redirect : std_ulogic;
  signal redirect_address : unsigned(31 downto 0);

  -- Decode.
  signal decoded : decoded_t;
  alias first_index : register_index_t is instruction_data(19 downto 15);
  alias second_index : register_index_t is instruction_data(24 downto 20);
  signal first_stored, second_stored, first_value, second_value : word_t;
  signal result_missing, advance, follow : std_ulogic;

  -- Execute.
  signal executing : executing_t;
  signal executing_instruction, executing_first, executing_second : word_t;
  signal executing_address, executing_base, executing_offset : unsigned(31 downto 0);
  alias destination : register_index_t is executing_instruction(11 downto 7);
  alias funct3 : std_ulogic_vector(2 downto 0) is executing_instruction(14 downto 12);
  signal start, stall, complete, take_interrupt : std_ulogic;
  signal alu_result, divider_result : word_t;
  signal equal, less, condition, divider_done : std_ulogic;
  signal target : unsigned(31 downto 0);
  signal data_enable, data_misaligned, data_in_memory, data_done, data_error : std_ulogic;
  signal bus_active : std_ulogic;
  signal csr_operand : word_t;
  signal asleep, interrupt_requested : std_ulogic;
  -- Clocks asleep so far; the stages behind are empty when all are set.
  signal asleep_before : std_ulogic_vector(3 downto 0) := (others => '0');
  signal csr_request : csr_request_t;
  signal csr_response : csr_response_t;
  signal trap : trap_t;
  signal return_from_trap, awake, interrupt_pending : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap_target, return_address : unsigned(31 downto 0);

  -- Write back.
  signal writing : writing_t;
  signal writing_instruction, writing_result : word_t;
  signal writing_address : unsigned(31 downto 0);
  signal product, loaded_word, loaded, written_value : word_t;

begin

  memory_lies_at_a_multiple_of_its_size : assert
    memory_size_bytes = 2 ** memory_address_bits and
    to_integer(reset_address(memory_address_bits - 1 downto 0)) = 0 severity failure;

  -- Fetch: the memory's port for instructions holds what is decoded.
  instruction_fetch : entity work.instruction_fetch
    generic map (reset_address => reset_address, memory_address_bits => memory_address_bits)
    port map (
      clk => clk,
      reset => reset,
      redirect => redirect,
      redirect_address => redirect_address,
      jump => jump,
      jump_address => target,
      advance => advance,
      instruction_request => instruction_request,
      valid => fetched_valid,
      address => fetched_address,
      fault => fetch_fault);

  -- Decode: the registers are read, or what is about to be written to them.
  instruction_decoder : entity work.instruction_decoder
    port map (instruction => instruction_data, decoded => decoded);

  register_file : entity work.register_file
    port map (
      clk => clk,
      first_index => first_index,
      first => first_stored,
      second_index => second_index,
      second => second_stored,
      write => writing.writes,
      write_index => writing.destination,
      write_data => written_value);

  first_value <= alu_result when executing.writes and (first_index ?= destination) else
                 written_value when writing.writes and (first_index ?= writing.destination) else
                 first_stored;
  second_value <= alu_result when executing.writes and (second_index ?= destination) else
                  written_value when writing.writes and (second_index ?= writing.destination) else
                  second_stored;

  result_missing <= executing.writes and executing.late and
                    ((decoded.reads_first and (first_index ?= destination)) or
                     (decoded.reads_second and (second_index ?= destination)));
  advance <= not stall and not result_missing;
  -- What is decoded comes after what is executed.
  follow <= fetched_valid and not (jump or trap.enable or return_from_trap);

  pass_to_execute : process
  begin
    wait until rising_edge(clk);
    if not stall then
      executing.valid <= follow and not result_missing;
      executing.writes <= decoded.writes and follow and not result_missing;
    end if;
    if advance then
      executing_address <= fetched_address;
      executing_instruction <= instruction_data;
      executing.fetch_fault <= fetch_fault;
      executing.refused <= fetch_fault or decoded.illegal;
      executing_first <= std_ulogic_vector(fetched_address) when decoded.first_is_address else
                         x"00000000" when decoded.first_is_zero else
                         first_value;
      executing_second <= decoded.constant_operand when decoded.second_is_constant else
                          second_value;
      executing_base <= fetched_address when decoded.relative else unsigned(first_value);
      executing_offset <= unsigned(decoded.offset);
      executing.operation <= decoded.operation;
      executing.alternate <= decoded.alternate;
      executing.compare_unsigned <= decoded.compare_unsigned;
      executing.late <= decoded.late;
      executing.load <= decoded.load;
      executing.store <= decoded.store;
      executing.branch <= decoded.branch;
      executing.jump <= decoded.jump;
      executing.multiply <= decoded.multiply;
      executing.divide <= decoded.divide;
      executing.csr <= decoded.csr;
      executing.environment_call <= decoded.environment_call;
      executing.breakpoint <= decoded.breakpoint;
      executing.trap_return <= decoded.trap_return;
      executing.wait_for_interrupt <= decoded.wait_for_interrupt;
    end if;

    if reset then
      executing.valid <= '0';
      executing.writes <= '0';
    end if;
  end process;

  -- Execute: everything that an instruction does, it does here, or it traps.
  take_interrupt <= interrupt_pending and (executing.valid or fetched_valid) and not bus_active and
                    not (executing.valid and executing.wait_for_interrupt);
  start <= executing.valid and not executing.refused and not take_interrupt;
  stall <= start and ((executing.divide and not divider_done) or
                      ((executing.load or executing.store) and not data_done) or
                      (executing.wait_for_interrupt and not awake));
  complete <= executing.valid and not stall and not trap.enable;

  arithmetic : entity work.alu
    port map (
      first => executing_first,
      second => executing_second,
      operation => executing.operation,
      alternate => executing.alternate,
      compare_unsigned => executing.compare_unsigned,
      result => alu_result,
      equal => equal,
      less => less);

  target <= executing_base + executing_offset;
  condition <= less xor funct3(0) when funct3(2) else equal xor funct3(0);
  jump <= executing.valid and not executing.refused and
          (executing.jump or (executing.branch and condition));

  multiplication : entity work.multiplier
    port map (
      clk => clk,
      enable => executing.multiply,
      operation => funct3(1 downto 0),
      first => executing_first,
      second => executing_second,
      result => product);

  division : entity work.divider
    port map (
      clk => clk,
      reset => reset,
      request => start and executing.divide,
      operation => funct3(1 downto 0),
      first => executing_first,
      second => executing_second,
      done => divider_done,
      result => divider_result);

  data_enable <= start and (executing.load or executing.store);
  data_access : entity work.data_access
    generic map (memory_address => reset_address, memory_address_bits => memory_address_bits)
    port map (
      clk => clk,
      reset => reset,
      enable => data_enable,
      store => executing.store,
      address => target,
      size => funct3(1 downto 0),
      store_data => executing_second,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => data_misaligned,
      to_memory => data_in_memory,
      bus_active => bus_active,
      done => data_done,
      error => data_error);

  csr_operand <= 27x"0" & executing_instruction(19 downto 15) when funct3(2) else executing_first;
  csr_request <= (
    enable => start and executing.csr,
    address => executing_instruction(31 downto 20),
    operation => funct3(1 downto 0),
    operand => csr_operand,
    writes => not funct3(1) or (or executing_instruction(19 downto 15)));
  return_from_trap <= start and executing.trap_return;
  control_status_registers : entity work.control_status_registers
    port map (
      clk => clk,
      always_clk => always_clk,
      reset => reset,
      request => csr_request,
      response => csr_response,
      trap => trap,
      trap_return => return_from_trap,
      retire => complete,
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
    port map (
      executing => executing,
      address => executing_address,
      instruction => executing_instruction,
      take_interrupt => take_interrupt,
      interrupt_cause => interrupt_cause,
      next_address => fetched_address,
      csr_legal => csr_response.legal,
      jump => jump,
      target => target,
      data_misaligned => data_misaligned,
      data_error => data_error,
      trap => trap);

  redirect <= trap.enable or return_from_trap;
  redirect_address <= trap_target when trap.enable else return_address;

  pass_to_write_back : process
  begin
    wait until rising_edge(clk);
    writing.valid <= complete;
    writing.trapped <= trap.enable;
    writing.interrupted <= trap.interrupt;
    writing.writes <= complete and executing.writes;
    writing_address <= trap.address;
    writing_instruction <= executing_instruction;
    if complete then
      writing.destination <= destination;
      writing_result <= divider_result when executing.divide else
                        csr_response.data when executing.csr else
                        bus_response.data when executing.load else
                        alu_result;
      writing.multiply <= executing.multiply;
      writing.load <= executing.load;
      writing.from_memory <= data_in_memory;
      writing.size <= funct3;
      writing.byte_index <= std_ulogic_vector(target(1 downto 0));
    end if;

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

  written_value <= product when writing.multiply else
                   loaded when writing.load else
                   writing_result;

  asleep <= executing.valid and executing.wait_for_interrupt and not awake;
  sleeping <= asleep;
  at_rest <= asleep and (and asleep_before) and not interrupt_requested;

  watch_sleep : process
  begin
    wait until rising_edge(always_clk);
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
    address => writing_address,
    instruction => writing_instruction,
    destination => writing.destination and (4 downto 0 => writing.writes),
    value => written_value);

end architecture;
