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
    compare_unsigned : std_ulogic;
    -- Which load, store, branch, multiplication, division or CSR instruction.
    funct3 : std_ulogic_vector(2 downto 0);
    -- At most one of these; none is an operation of the arithmetic unit, or nothing at all.
    load : std_ulogic;
    store : std_ulogic;
    branch : std_ulogic;
    -- To its own address plus the constant, to a register plus the constant.
    jump : std_ulogic;
    jump_register : std_ulogic;
    -- auipc: its own address plus the constant is the result.
    address_result : std_ulogic;
    multiply : std_ulogic;
    divide : std_ulogic;
    csr : std_ulogic;
    -- There is a CSR of this address.
    csr_exists : std_ulogic;
    environment_call : std_ulogic;
    breakpoint : std_ulogic;
    trap_return : std_ulogic;
    wait_for_interrupt : std_ulogic;
  end record;

  -- Where a register's number stands: which number it is comes late in the clock, so whatever depends
  -- on it is found for each place and chosen at the end.
  type register_choice_t is record
    -- "00" short, "01" long, "10" implied, "11" of a word.
    place : std_ulogic_vector(1 downto 0);
    short : register_index_t;
    long : register_index_t;
    implied : register_index_t;
    of_word : register_index_t;
  end record;

  function chosen(choice : register_choice_t) return register_index_t;
  -- `index` is the register chosen.
  function is_chosen(choice : register_choice_t; index : register_index_t) return std_ulogic;

  -- Of the instruction in the execute stage, beside what was decoded.
  type executing_t is record
    valid : std_ulogic;
    -- Fetched from outside the memory; begun in its last two bytes.
    fetch_fault : std_ulogic;
    leaves_memory : std_ulogic;
  end record;

  -- The completed instruction whose result is written to its register.
  type writing_t is record
    valid : std_ulogic;
    trapped : std_ulogic;
    interrupted : std_ulogic;
    writes : std_ulogic;
    -- It will write, if the bus does not refuse its access.
    wanted : std_ulogic;
    -- The result is not in `writing_result` yet.
    late : std_ulogic;
    destination : register_index_t;
    -- The result, or the data that came over the bus.
    multiply : std_ulogic;
    load : std_ulogic;
    from_memory : std_ulogic;
    -- Of a load: funct3 and the place in the word.
    size : std_ulogic_vector(2 downto 0);
    byte_index : std_ulogic_vector(1 downto 0);
  end record;

  -- A CSR instruction in the execute stage.
  type csr_request_t is record
    -- The instruction is executed in this clock.
    enable : std_ulogic;
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

  -- From what debugs the processor (rtl/debug). Idle, as it is where the port is left open, it costs nothing.
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

  function chosen(choice : register_choice_t) return register_index_t is
  begin
    -- One of four: written so, no tool makes of the constants among them a late reset of a register.
    return (choice.of_word and (4 downto 0 => choice.place(1) and choice.place(0))) or
           (choice.implied and (4 downto 0 => choice.place(1) and not choice.place(0))) or
           (choice.long and (4 downto 0 => not choice.place(1) and choice.place(0))) or
           (choice.short and (4 downto 0 => choice.place(1) nor choice.place(0)));
  end function;

  function is_chosen(choice : register_choice_t; index : register_index_t) return std_ulogic is
  begin
    if choice.place(1) and choice.place(0) then
      return choice.of_word ?= index;
    elsif choice.place(1) then
      return choice.implied ?= index;
    elsif choice.place(0) then
      return choice.long ?= index;
    end if;
    return choice.short ?= index;
  end function;

end package body;
