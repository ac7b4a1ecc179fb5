-- SPDX-License-Identifier: Apache-2.0
-- What travels between the stages of the processor's pipeline, and what it tells to the outside.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package processor_pkg is

  subtype word_t is std_ulogic_vector(31 downto 0);
  subtype register_index_t is std_ulogic_vector(4 downto 0);

  -- What the decoder reads from an instruction word. It looks at nothing else.
  type decoded_t is record
    -- Not an instruction of this processor. CSR addresses are judged by the CSRs themselves.
    illegal : std_ulogic;
    reads_first : std_ulogic;
    reads_second : std_ulogic;
    -- Writes a register other than x0.
    writes : std_ulogic;
    -- The result comes one clock after execution: who reads it next waits one clock.
    late : std_ulogic;
    -- First operand of the arithmetic unit: register rs1 if none of both.
    first_is_address : std_ulogic;
    first_is_zero : std_ulogic;
    -- Second operand: register rs2 or this.
    second_is_constant : std_ulogic;
    constant_operand : word_t;
    -- The target or data address is offset plus rs1, or plus the instruction's own address.
    relative : std_ulogic;
    offset : word_t;
    -- Operation of the arithmetic unit in funct3's coding; `alternate`: subtract, arithmetic shift.
    operation : std_ulogic_vector(2 downto 0);
    alternate : std_ulogic;
    compare_unsigned : std_ulogic;
    -- At most one of these; none is an operation of the arithmetic unit, or nothing at all.
    load : std_ulogic;
    store : std_ulogic;
    branch : std_ulogic;
    jump : std_ulogic;
    multiply : std_ulogic;
    divide : std_ulogic;
    csr : std_ulogic;
    environment_call : std_ulogic;
    breakpoint : std_ulogic;
    trap_return : std_ulogic;
    wait_for_interrupt : std_ulogic;
  end record;

  -- The instruction in the execute stage. Its words (address, operands) are signals of their own
  -- beside this record: together GHDL makes them one register of 213 bits, which Verilator moves in
  -- pieces, and the simulation is an eighth slower. The same holds for `writing_t`.
  type executing_t is record
    valid : std_ulogic;
    -- Fetched from outside the memory.
    fetch_fault : std_ulogic;
    -- A fetch fault or an illegal instruction: nothing of it may happen.
    refused : std_ulogic;
    operation : std_ulogic_vector(2 downto 0);
    alternate : std_ulogic;
    compare_unsigned : std_ulogic;
    writes : std_ulogic;
    late : std_ulogic;
    load : std_ulogic;
    store : std_ulogic;
    branch : std_ulogic;
    jump : std_ulogic;
    multiply : std_ulogic;
    divide : std_ulogic;
    csr : std_ulogic;
    environment_call : std_ulogic;
    breakpoint : std_ulogic;
    trap_return : std_ulogic;
    wait_for_interrupt : std_ulogic;
  end record;

  -- The completed instruction whose result is written to its register.
  type writing_t is record
    valid : std_ulogic;
    trapped : std_ulogic;
    interrupted : std_ulogic;
    writes : std_ulogic;
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

  type csr_response_t is record
    data : word_t;
    -- The CSR exists and may be accessed so.
    legal : std_ulogic;
  end record;

  -- A trap that is taken in this clock.
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
