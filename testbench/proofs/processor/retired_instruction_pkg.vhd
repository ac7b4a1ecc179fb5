-- SPDX-License-Identifier: Apache-2.0
-- What is seen of an instruction that the processor has completed or refused, and what each instruction
-- should do, as the specification says it: what it reads and writes, stores and asks for, where it goes on,
-- whether it traps.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.instruction_names_pkg.all;
use work.instruction_set_pkg.all;
use work.machine_mode_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

package retired_instruction_pkg is

  type retired_instruction_t is record
    -- One of these.
    completed : std_ulogic;
    refused : std_ulogic;
    -- As the memory gave it, and as 32 bits.
    told : value_t;
    word : value_t;
    address : unsigned(31 downto 0);
    -- The address behind it, and that of what is executed next.
    link : unsigned(31 downto 0);
    next_address : unsigned(31 downto 0);
    -- It was executed with what registers of these numbers hold; zero instead where it did not look at them.
    looks_at_first : std_ulogic;
    looks_at_second : std_ulogic;
    first_index : register_index_t;
    second_index : register_index_t;
    first : value_t;
    second : value_t;
    -- What it wrote, number 0 where nothing.
    destination : register_index_t;
    value : value_t;
    -- What was asked of the memory when it was executed, and what came.
    memory : memory_request_t;
    memory_data : value_t;
    -- The last request on the bus, if it was answered in the clock before.
    bus_answered : std_ulogic;
    bus_failed : std_ulogic;
    bus_asked : bus_request_t;
    bus_data : value_t;
    -- What was asked of the CSRs when it was executed, and what they gave; that they were told of a return
    -- from a trap.
    csr_asked : std_ulogic;
    csr_request : csr_request_t;
    csr_value : value_t;
    returned : std_ulogic;
    -- What they hold now: where a trap and a return from it go.
    trap_target : unsigned(31 downto 0);
    return_address : unsigned(31 downto 0);
    -- What they are told of an exception.
    cause : register_index_t;
    trap_value : value_t;
  end record;

  -- It was executed with its registers and no others.
  function reads_its_registers(seen : retired_instruction_t) return boolean;
  -- Nothing was stored, nothing asked of the bus or the CSRs.
  function is_quiet(seen : retired_instruction_t) return boolean;
  -- Refused with this exception.
  function traps(seen : retired_instruction_t; cause : register_index_t; value : value_t) return boolean;
  -- It did what an instruction of this name does, or was refused for a reason that it has.
  function is_right(name : name_t; seen : retired_instruction_t) return boolean;

end package;

package body retired_instruction_pkg is

  function reads_its_registers(seen : retired_instruction_t) return boolean is
    variable first_is_right, second_is_right : boolean;
  begin
    first_is_right := seen.first_index = seen.word(19 downto 15) when seen.looks_at_first = '1' else
                      seen.word(19 downto 15) = "00000";
    second_is_right := seen.second_index = seen.word(24 downto 20) when seen.looks_at_second = '1' else
                       seen.word(24 downto 20) = "00000";
    return (first_is_right or not reads_first(seen.word)) and
           (second_is_right or not reads_second(seen.word));
  end function;

  function stores_nothing(seen : retired_instruction_t) return boolean is
  begin
    return seen.memory.enable = '0' or seen.memory.write_bytes = "0000";
  end function;

  function is_quiet(seen : retired_instruction_t) return boolean is
  begin
    return stores_nothing(seen) and seen.bus_answered = '0' and seen.csr_asked = '0' and seen.returned = '0';
  end function;

  function writes(seen : retired_instruction_t; value : value_t) return boolean is
  begin
    return seen.completed = '1' and reads_its_registers(seen) and
           seen.destination = seen.word(11 downto 7) and
           (seen.destination = "00000" or seen.value = value);
  end function;

  -- An operation: it writes this and goes on behind itself.
  function gives(seen : retired_instruction_t; value : value_t) return boolean is
  begin
    return writes(seen, value) and is_quiet(seen) and seen.next_address = seen.link;
  end function;

  function jumps(seen : retired_instruction_t; target : unsigned(31 downto 0)) return boolean is
  begin
    return writes(seen, std_ulogic_vector(seen.link)) and is_quiet(seen) and
           seen.next_address = (target and x"fffffffe");
  end function;

  -- It goes there and does nothing else.
  function goes(seen : retired_instruction_t; target : unsigned(31 downto 0)) return boolean is
  begin
    return seen.completed = '1' and reads_its_registers(seen) and seen.destination = "00000" and
           is_quiet(seen) and seen.next_address = target;
  end function;

  function branches(seen : retired_instruction_t) return boolean is
  begin
    if is_taken(seen.word, seen.first, seen.second) then
      return goes(seen, seen.address + constant_b(seen.word));
    end if;
    return goes(seen, seen.link);
  end function;

  function traps(seen : retired_instruction_t; cause : register_index_t; value : value_t) return boolean is
  begin
    return seen.refused = '1' and seen.destination = "00000" and stores_nothing(seen) and
           seen.returned = '0' and seen.cause = cause and seen.trap_value = value and
           seen.next_address = seen.trap_target;
  end function;

  function is_in_memory(address : unsigned(31 downto 0)) return boolean is
  begin
    return address(31 downto 16) = x"8000";
  end function;

  -- The bus was asked for this access.
  function asks_bus(seen : retired_instruction_t; write : std_ulogic; address : unsigned(31 downto 0))
    return boolean is
  begin
    return seen.bus_answered = '1' and stores_nothing(seen) and seen.csr_asked = '0' and
           seen.returned = '0' and seen.bus_asked.write = write and seen.bus_asked.address = address and
           seen.bus_asked.select_bytes = lanes(seen.word, address);
  end function;

  function loads(seen : retired_instruction_t) return boolean is
    variable address : unsigned(31 downto 0);
  begin
    address := unsigned(seen.first) + constant_i(seen.word);
    if is_misaligned(seen.word, address) then
      return traps(seen, cause_load_misaligned, std_ulogic_vector(address)) and is_quiet(seen);
    elsif is_in_memory(address) then
      return gives(seen, loaded(seen.word, seen.memory_data, address)) and
             seen.memory.enable = '1' and seen.memory.address = address(31 downto 2);
    elsif seen.bus_failed then
      return asks_bus(seen, '0', address) and
             traps(seen, cause_load_access, std_ulogic_vector(address));
    end if;
    return asks_bus(seen, '0', address) and writes(seen, loaded(seen.word, seen.bus_data, address)) and
           seen.next_address = seen.link;
  end function;

  function stores(seen : retired_instruction_t) return boolean is
    variable address : unsigned(31 downto 0);
    variable goes_on, is_data : boolean;
  begin
    address := unsigned(seen.first) + constant_s(seen.word);
    goes_on := seen.completed = '1' and reads_its_registers(seen) and seen.destination = "00000" and
               seen.next_address = seen.link;
    if is_misaligned(seen.word, address) then
      return traps(seen, cause_store_misaligned, std_ulogic_vector(address)) and is_quiet(seen);
    elsif is_in_memory(address) then
      is_data := stored(seen.word, seen.memory.data, seen.second, address) = seen.memory.data;
      return goes_on and is_data and seen.memory.enable = '1' and
             seen.memory.write_bytes = lanes(seen.word, address) and
             seen.memory.address = address(31 downto 2) and
             seen.bus_answered = '0' and seen.csr_asked = '0' and seen.returned = '0';
    end if;
    is_data := stored(seen.word, seen.bus_asked.data, seen.second, address) = seen.bus_asked.data;
    if seen.bus_failed then
      return asks_bus(seen, '1', address) and is_data and
             traps(seen, cause_store_access, std_ulogic_vector(address));
    end if;
    return asks_bus(seen, '1', address) and is_data and goes_on;
  end function;

  -- What becomes of the register is told by the proof of the CSRs.
  function accesses_csr(seen : retired_instruction_t) return boolean is
    variable changes : boolean;
    variable operand : value_t;
  begin
    changes := seen.word(13 downto 12) = "01" or seen.word(19 downto 15) /= "00000";
    operand := 27x"0" & seen.word(19 downto 15) when seen.word(14) = '1' else seen.first;
    if not csr_exists(seen.word(31 downto 20)) or (changes and seen.word(31 downto 30) = "11") then
      return traps(seen, cause_illegal_instruction, seen.told) and seen.bus_answered = '0';
    end if;
    return writes(seen, seen.csr_value) and stores_nothing(seen) and seen.bus_answered = '0' and
           seen.returned = '0' and seen.next_address = seen.link and
           seen.csr_asked = '1' and seen.csr_request.address = seen.word(31 downto 20) and
           seen.csr_request.operation = seen.word(13 downto 12) and
           (seen.csr_request.writes = '1') = changes and
           (seen.csr_request.operand = operand or not changes);
  end function;

  function is_right(name : name_t; seen : retired_instruction_t) return boolean is
    variable first, second, constant_operand, product : value_t;
  begin
    first := seen.first;
    second := seen.second;
    constant_operand := std_ulogic_vector(constant_i(seen.word));
    product := stand_in(seen.word(14 downto 12), first, second);
    case name is
      when rv_lui => return gives(seen, std_ulogic_vector(constant_u(seen.word)));
      when rv_auipc => return gives(seen, std_ulogic_vector(seen.address + constant_u(seen.word)));
      when rv_jal => return jumps(seen, seen.address + constant_j(seen.word));
      when rv_jalr => return jumps(seen, unsigned(first) + constant_i(seen.word));
      when rv_beq | rv_bne | rv_blt | rv_bge | rv_bltu | rv_bgeu => return branches(seen);
      when rv_lb | rv_lh | rv_lw | rv_lbu | rv_lhu => return loads(seen);
      when rv_sb | rv_sh | rv_sw => return stores(seen);
      when rv_addi => return gives(seen, sum(seen.word, first, constant_operand));
      when rv_slti | rv_sltiu => return gives(seen, comparison(seen.word, first, constant_operand));
      when rv_xori | rv_ori | rv_andi => return gives(seen, logic(seen.word, first, constant_operand));
      when rv_slli | rv_srli | rv_srai => return gives(seen, shift(seen.word, first, constant_operand));
      when rv_add | rv_sub => return gives(seen, sum(seen.word, first, second));
      when rv_slt | rv_sltu => return gives(seen, comparison(seen.word, first, second));
      when rv_xor | rv_or | rv_and => return gives(seen, logic(seen.word, first, second));
      when rv_sll | rv_srl | rv_sra => return gives(seen, shift(seen.word, first, second));
      when rv_mul | rv_mulh | rv_mulhsu | rv_mulhu => return gives(seen, product);
      when rv_div | rv_divu | rv_rem | rv_remu => return gives(seen, product);
      when rv_fence | rv_fence_i | rv_wfi => return goes(seen, seen.link);
      when rv_ecall =>
        return traps(seen, cause_environment_call, x"00000000") and is_quiet(seen);
      when rv_ebreak =>
        return traps(seen, cause_breakpoint, std_ulogic_vector(seen.address)) and is_quiet(seen);
      when rv_mret =>
        return seen.completed = '1' and seen.destination = "00000" and seen.returned = '1' and
               stores_nothing(seen) and seen.bus_answered = '0' and seen.csr_asked = '0' and
               seen.next_address = seen.return_address;
      when rv_csrrw | rv_csrrs | rv_csrrc | rv_csrrwi | rv_csrrsi | rv_csrrci => return accesses_csr(seen);
      when no_instruction =>
        return traps(seen, cause_illegal_instruction, seen.told) and is_quiet(seen);
    end case;
  end function;

end package body;
