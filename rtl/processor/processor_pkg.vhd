-- SPDX-License-Identifier: Apache-2.0
-- Types of the processor's pipeline registers and interfaces.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package processor_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);
  subtype register_index_t is std_ulogic_vector(4 downto 0);

  -- Control signals of a decoded instruction. The words of a stage (immediate, address, instruction) are
  -- separate signals: in the record, GHDL would make all one register of more than 64 bits, which Verilator
  -- copies in pieces, and simulation would be an eighth slower. The same holds for `writing_t`.
  type control_t is record
    -- Legal if any bit is set; the OR is left to execute, as it would settle late in decode. The legality of
    -- CSR accesses is checked separately.
    legal : std_ulogic_vector(3 downto 0);
    destination : register_index_t;
    reads_first : std_ulogic;
    reads_second : std_ulogic;
    -- Writes `destination`, which is not x0. Within the decoders: the destination is x1.
    writes : std_ulogic;
    writes_link : std_ulogic;
    -- The result is available in write-back only: load-use hazard of one clock.
    late : std_ulogic;
    -- Second operand of the ALU: the immediate instead of a register.
    second_is_immediate : std_ulogic;
    -- ALU operation, see `alu`.
    operation : std_ulogic_vector(2 downto 0);
    shift : std_ulogic;
    subtract : std_ulogic;
    arithmetic_shift : std_ulogic;
    rotate : std_ulogic;
    compare_unsigned : std_ulogic;
    -- Which load, store, branch, multiplication, division or CSR instruction.
    funct3 : std_ulogic_vector(2 downto 0);
    -- At most one of these is set. None: an ALU operation, or a no-operation.
    load : std_ulogic;
    store : std_ulogic;
    branch : std_ulogic;
    -- jal; jalr; fence.i, a jump to the next instruction.
    jump : std_ulogic;
    jump_register : std_ulogic;
    refetch : std_ulogic;
    -- auipc.
    address_result : std_ulogic;
    multiply : std_ulogic;
    divide : std_ulogic;
    -- Zbb: executed by bit_manipulation.
    manipulate : std_ulogic;
    csr : std_ulogic;
    -- The CSR is implemented; it is written (not by csrrs, csrrc with x0 or a zero immediate).
    csr_exists : std_ulogic;
    csr_written : std_ulogic;
    environment_call : std_ulogic;
    breakpoint : std_ulogic;
    trap_return : std_ulogic;
    wait_for_interrupt : std_ulogic;
  end record;

  -- An instruction that fetch gives to decode.
  type fetched_t is record
    valid : std_ulogic;
    -- 32 bits, not compressed.
    is_word : std_ulogic;
    -- Fetched from outside the memory; only its second half is outside.
    fault : std_ulogic;
    crosses_memory_end : std_ulogic;
    instruction : word_t;
    address : unsigned(31 downto 0);
  end record;

  -- Where fetch goes on by the static prediction of decode.
  type prediction_t is record
    taken : std_ulogic;
    -- Of a taken branch or jump.
    target : unsigned(31 downto 0);
    target_plus_2 : unsigned(31 downto 0);
    -- Of the next instruction.
    next_address : unsigned(31 downto 0);
  end record;

  -- Where execute redirects fetch to; bit 0 of the target is ignored.
  type redirect_t is record
    enable : std_ulogic;
    target : unsigned(31 downto 0);
    target_plus_2 : unsigned(31 downto 2);
  end record;

  -- State of the execute stage besides the control signals.
  type executing_t is record
    valid : std_ulogic;
    -- Valid, legal, and without fetch fault.
    executable : std_ulogic;
    -- Fetched from outside the memory; only its second half is outside.
    fetch_fault : std_ulogic;
    crosses_memory_end : std_ulogic;
  end record;

  -- Comparison of the operands.
  type comparison_t is record
    -- The first is less, greater, as unsigned numbers.
    below : std_ulogic;
    above : std_ulogic;
    -- A signed comparison of operands whose signs differ: the lower one is the greater.
    signs_differ : std_ulogic;
  end record;

  -- When the instruction in execute redirects fetch: jalr, fence.i, and branches whose prediction was
  -- wrong. It takes effect when the pipeline advances.
  type redirect_condition_t is record
    -- If its first operand is below the second; above it.
    if_below : std_ulogic;
    if_above : std_ulogic;
    -- Inverts the condition; alone, it redirects unconditionally.
    inverted : std_ulogic;
  end record;

  constant redirect_never : redirect_condition_t := (others => '0');
  constant redirect_always : redirect_condition_t := (inverted => '1', others => '0');

  -- One-hot selects of the load alignment, registered because the loaded word settles late. The result is
  -- zero without any of them.
  type load_lanes_t is record
    -- The byte for bits 7 to 0; byte 1 or 3 for bits 15 to 8.
    low : std_ulogic_vector(3 downto 0);
    second : std_ulogic_vector(1 downto 0);
    -- The byte whose sign fills bits 15 to 8, bits 31 to 16.
    second_sign : std_ulogic_vector(3 downto 0);
    upper_sign : std_ulogic_vector(3 downto 0);
    -- The upper half word, unchanged.
    upper : std_ulogic;
  end record;

  -- For a load with this funct3 at this byte offset; none if it is not a load.
  function lanes_of(is_load : std_ulogic; funct3 : std_ulogic_vector(2 downto 0);
                    byte_index : std_ulogic_vector(1 downto 0)) return load_lanes_t;

  -- The instruction in write-back.
  type writing_t is record
    valid : std_ulogic;
    trapped : std_ulogic;
    interrupted : std_ulogic;
    writes : std_ulogic;
    -- Waits for the bus, and writes its register unless this answers with an error.
    write_pending : std_ulogic;
    destination : register_index_t;
    -- Selects the source of the result.
    multiply : std_ulogic;
    manipulate : std_ulogic;
    load : std_ulogic;
    from_memory : load_lanes_t;
    from_bus : load_lanes_t;
  end record;

  -- A write to the register file.
  type register_write_t is record
    enable : std_ulogic;
    destination : register_index_t;
    data : word_t;
  end record;

  -- A CSR instruction in the execute stage.
  type csr_request_t is record
    -- The instruction executes in this clock; cancelled by an interrupt.
    enable : std_ulogic;
    cancelled : std_ulogic;
    address : std_ulogic_vector(11 downto 0);
    -- funct3(1 downto 0): "01" write, "10" set bits, "11" clear bits.
    operation : std_ulogic_vector(1 downto 0);
    operand : word_t;
    -- Low for csrrs and csrrc with x0 or a zero immediate.
    writes : std_ulogic;
  end record;

  -- A trap that is taken.
  type trap_t is record
    enable : std_ulogic;
    interrupt : std_ulogic;
    cause : std_ulogic_vector(4 downto 0);
    -- For mepc and mtval.
    address : unsigned(31 downto 0);
    value : word_t;
  end record;

  -- A retired instruction, or a trap, for tests.
  type retirement_t is record
    valid : std_ulogic;
    -- The instruction at `address` did not retire: it raised an exception, or was interrupted.
    trap : std_ulogic;
    interrupt : std_ulogic;
    address : unsigned(31 downto 0);
    instruction : word_t;
    -- Destination register, 0 for none, and the value written.
    destination : register_index_t;
    value : word_t;
  end record;

  -- From the debug module (rtl/debug). Left open, it is idle and optimised away.
  type debug_request_t is record
    -- Debug mode: only injected instructions are executed.
    halted : std_ulogic;
    -- Enter debug mode before the next instruction.
    halt : std_ulogic;
    -- ebreak enters debug mode instead of raising an exception.
    halt_at_breakpoint : std_ulogic;
    -- Single step: no interrupt is taken, and wfi is a no-operation.
    step : std_ulogic;
    -- In debug mode: issue `instruction`, in a clock in which execute is empty.
    inject : std_ulogic;
    instruction : word_t;
    -- In debug mode: leave it at the end of this clock, and resume at the address.
    resume : std_ulogic;
    resume_address : unsigned(31 downto 0);
  end record;

  constant debug_request_idle : debug_request_t := (
    halted => '0', halt => '0', halt_at_breakpoint => '0', step => '0', inject => '0',
    instruction => (others => '0'), resume => '0', resume_address => (others => '0'));

  type debug_response_t is record
    -- Debug mode begins in the next clock, on request or by ebreak.
    -- The instruction at `address` has not been executed.
    enter : std_ulogic;
    at_breakpoint : std_ulogic;
    address : unsigned(31 downto 0);
    -- The pipeline advances at the end of this clock: the instruction at `next_address` is issued,
    -- or a bubble.
    advance : std_ulogic;
    issue : std_ulogic;
    next_address : unsigned(31 downto 0);
    -- An instruction retires or raises an exception in this clock.
    finish : std_ulogic;
    -- The memory's data port may be needed in this clock. Settles early.
    uses_data_port : std_ulogic;
    -- In the clock after: an instruction retired, or trapped; its result, even if the destination is x0.
    completed : std_ulogic;
    trapped : std_ulogic;
    value : word_t;
  end record;

  -- Exception codes of mcause.
  constant cause_instruction_misaligned : register_index_t := 5x"0";
  constant cause_instruction_access : register_index_t := 5x"1";
  constant cause_illegal_instruction : register_index_t := 5x"2";
  constant cause_breakpoint : register_index_t := 5x"3";
  constant cause_load_misaligned : register_index_t := 5x"4";
  constant cause_load_access : register_index_t := 5x"5";
  constant cause_store_misaligned : register_index_t := 5x"6";
  constant cause_store_access : register_index_t := 5x"7";
  constant cause_environment_call : register_index_t := 5x"b";

end package;

package body processor_pkg is

  function lanes_of(is_load : std_ulogic; funct3 : std_ulogic_vector(2 downto 0);
                    byte_index : std_ulogic_vector(1 downto 0)) return load_lanes_t is
    variable is_byte, is_half, has_sign : std_ulogic;
    variable of_index, of_half : std_ulogic_vector(3 downto 0);
    variable lanes : load_lanes_t;
  begin
    is_byte := is_load and not funct3(1) and not funct3(0);
    is_half := is_load and funct3(0);
    has_sign := not funct3(2);
    of_index := (byte_index(1) and byte_index(0)) & (byte_index(1) and not byte_index(0)) &
                (not byte_index(1) and byte_index(0)) & (byte_index(1) nor byte_index(0));
    of_half := (3 => byte_index(1), 1 => not byte_index(1), others => '0');
    lanes.upper := is_load and funct3(1);
    -- Aligned words and half words have their lowest byte at the byte offset, as bytes have.
    lanes.low := of_index and (3 downto 0 => is_load);
    lanes.second := (1 => (is_half and byte_index(1)), 0 => ((is_half and not byte_index(1)) or lanes.upper));
    lanes.second_sign := of_index and (3 downto 0 => is_byte and has_sign);
    lanes.upper_sign := lanes.second_sign or (of_half and (3 downto 0 => is_half and has_sign));
    return lanes;
  end function;

end package body;
