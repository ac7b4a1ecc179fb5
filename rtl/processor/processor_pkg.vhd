-- SPDX-License-Identifier: Apache-2.0
-- What travels between the stages of the processor's pipeline, and what it tells to the outside.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package processor_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);
  subtype register_index_t is std_ulogic_vector(4 downto 0);

  -- What the decoder reads from an instruction, beside its constant. The words of a stage (constant,
  -- address, instruction) are signals of their own beside its record: together GHDL makes them one
  -- register of more than 64 bits, which Verilator moves in pieces, and the simulation is an eighth
  -- slower. The same holds for `writing_t`.
  type decoded_t is record
    -- An instruction of this processor where one of these is set: their sum would come late in the
    -- clock. Whether a CSR may be accessed is judged beside it.
    legal : std_ulogic_vector(3 downto 0);
    destination : register_index_t;
    reads_first : std_ulogic;
    reads_second : std_ulogic;
    -- Writes `destination` unless this is x0; x1 in its place.
    writes : std_ulogic;
    writes_link : std_ulogic;
    -- The result comes one clock after execution: who reads it next waits one clock.
    late : std_ulogic;
    -- Second operand of the arithmetic unit: the constant instead of a register.
    second_is_constant : std_ulogic;
    -- Operation of the arithmetic unit in its coding.
    operation : std_ulogic_vector(2 downto 0);
    shift : std_ulogic;
    subtract : std_ulogic;
    arithmetic_shift : std_ulogic;
    rotate : std_ulogic;
    compare_unsigned : std_ulogic;
    -- Which load, store, branch, multiplication, division or CSR instruction.
    funct3 : std_ulogic_vector(2 downto 0);
    -- At most one of these; none is an operation of the arithmetic unit, or nothing at all.
    load : std_ulogic;
    store : std_ulogic;
    branch : std_ulogic;
    -- To its own address plus the constant, to a register plus the constant; to the next instruction, which
    -- is fetched again.
    jump : std_ulogic;
    jump_register : std_ulogic;
    refetch : std_ulogic;
    -- auipc: its own address plus the constant is the result.
    address_result : std_ulogic;
    multiply : std_ulogic;
    divide : std_ulogic;
    -- Zbb: what is left to bit_manipulation.
    manipulate : std_ulogic;
    csr : std_ulogic;
    -- There is a CSR of this address; it is written, unless it is set or cleared by nothing.
    csr_exists : std_ulogic;
    csr_written : std_ulogic;
    environment_call : std_ulogic;
    breakpoint : std_ulogic;
    trap_return : std_ulogic;
    wait_for_interrupt : std_ulogic;
  end record;

  -- Of the instruction in the execute stage, beside what was decoded.
  type executing_t is record
    valid : std_ulogic;
    -- It is fetched from within the memory and legal.
    able : std_ulogic;
    -- Fetched from outside the memory; begun in its last two bytes.
    fetch_fault : std_ulogic;
    leaves_memory : std_ulogic;
  end record;

  -- How two operands compare.
  type comparison_t is record
    -- The first is less, is greater, without regard to signs.
    below : std_ulogic;
    above : std_ulogic;
    -- It has to regard them, and they differ: what is below is the greater then.
    signs_differ : std_ulogic;
  end record;

  -- What has the processor go another way than it went while the instruction in the execute stage was
  -- decoded. Nothing comes of it before the pipeline advances.
  type late_turn_t is record
    -- Where its first operand is below the second; above it.
    if_below : std_ulogic;
    if_above : std_ulogic;
    -- Where it would not turn, and only there. So it may turn with any operands.
    inverted : std_ulogic;
  end record;

  constant no_turn : late_turn_t := (others => '0');
  constant any_turn : late_turn_t := (inverted => '1', others => '0');

  -- Which bits of a loaded word a load takes, one signal for each choice: they wait where the word is
  -- the last to come. Without any of them the result is zero.
  type load_lanes_t is record
    -- The byte that becomes bits 7 to 0; byte 1 or 3 as bits 15 to 8.
    low : std_ulogic_vector(3 downto 0);
    second : std_ulogic_vector(1 downto 0);
    -- The byte whose sign becomes bits 15 to 8, bits 31 to 16.
    second_sign : std_ulogic_vector(3 downto 0);
    upper_sign : std_ulogic_vector(3 downto 0);
    -- The upper half word as it is.
    upper : std_ulogic;
  end record;

  -- Of a load with this funct3 from this byte of a word, if it is one.
  function lanes_of(is_load : std_ulogic; funct3 : std_ulogic_vector(2 downto 0);
                    byte_index : std_ulogic_vector(1 downto 0)) return load_lanes_t;

  -- The completed instruction whose result is written to its register.
  type writing_t is record
    valid : std_ulogic;
    trapped : std_ulogic;
    interrupted : std_ulogic;
    writes : std_ulogic;
    -- It will write, if the bus does not refuse its access.
    wanted : std_ulogic;
    destination : register_index_t;
    -- The result, or the data that came over the bus.
    multiply : std_ulogic;
    manipulate : std_ulogic;
    load : std_ulogic;
    from_memory : load_lanes_t;
    from_bus : load_lanes_t;
  end record;

  -- A CSR instruction in the execute stage.
  type csr_request_t is record
    -- The instruction is executed in this clock; but it is not if an interrupt takes its place.
    enable : std_ulogic;
    in_vain : std_ulogic;
    address : std_ulogic_vector(11 downto 0);
    -- funct3(1 downto 0): "01" write, "10" set bits, "11" clear bits.
    operation : std_ulogic_vector(1 downto 0);
    operand : word_t;
    -- Set and clear of no register or of zero do not write at all.
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

  -- One completed instruction, or one that was refused with a trap.
  type retirement_t is record
    valid : std_ulogic;
    -- The instruction at `address` was not completed: an exception, or an interrupt before it.
    trap : std_ulogic;
    interrupt : std_ulogic;
    address : unsigned(31 downto 0);
    instruction : word_t;
    -- The register that it wrote, 0 for none, and the value.
    destination : register_index_t;
    value : word_t;
  end record;

  -- From what debugs the processor (rtl/debug). Idle, as it is where the port is left open, it costs
  -- nothing.
  type debug_request_t is record
    -- The processor is in debug mode: it executes what is injected, and nothing else.
    halted : std_ulogic;
    -- Enter debug mode before the next instruction that is not executed yet.
    halt : std_ulogic;
    -- ebreak enters debug mode instead of a trap.
    halt_at_breakpoint : std_ulogic;
    -- While one instruction is stepped: no interrupt is taken, and wfi does not wait.
    step : std_ulogic;
    -- In debug mode: pass `instruction` to the execute stage, in a clock in which that is empty.
    inject : std_ulogic;
    instruction : word_t;
    -- In debug mode: leave it with this clock, and go on at the address.
    resume : std_ulogic;
    resume_address : unsigned(31 downto 0);
  end record;

  constant debug_request_idle : debug_request_t := (
    halted => '0', halt => '0', halt_at_breakpoint => '0', step => '0', inject => '0',
    instruction => (others => '0'), resume => '0', resume_address => (others => '0'));

  type debug_response_t is record
    -- Debug mode begins with the next clock, for an ebreak or because it was asked for. The instruction
    -- at `address` was not executed.
    enter : std_ulogic;
    at_breakpoint : std_ulogic;
    address : unsigned(31 downto 0);
    -- At the end of this clock the execute stage takes something new: the instruction at `next_address`
    -- where it `follows`, or nothing.
    advance : std_ulogic;
    follows : std_ulogic;
    next_address : unsigned(31 downto 0);
    -- An instruction is completed, or refused with a trap, in this clock.
    finish : std_ulogic;
    -- The memory's data port may be needed in this clock; told early.
    uses_data_port : std_ulogic;
    -- A clock after its completion: an instruction was completed, or trapped; what it wrote, or would
    -- have written were its destination not x0.
    completed : std_ulogic;
    trapped : std_ulogic;
    value : word_t;
  end record;

  -- Exceptions, in the coding of mcause.
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
    -- What lies at its size has the lowest byte that its address tells, as a byte has.
    lanes.low := of_index and (3 downto 0 => is_load);
    lanes.second := (1 => (is_half and byte_index(1)), 0 => ((is_half and not byte_index(1)) or lanes.upper));
    lanes.second_sign := of_index and (3 downto 0 => is_byte and has_sign);
    lanes.upper_sign := lanes.second_sign or (of_half and (3 downto 0 => is_half and has_sign));
    return lanes;
  end function;

end package body;
