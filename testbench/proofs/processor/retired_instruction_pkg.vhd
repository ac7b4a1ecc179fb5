-- SPDX-License-Identifier: Apache-2.0
-- What is observed of an instruction that retires or traps, and the specification of each instruction:
-- registers read and written, memory, bus and CSR accesses, next address, traps.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.data_width_pkg.all;
use work.instruction_names_pkg.all;
use work.instruction_set_pkg.all;
use work.machine_mode_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

package retired_instruction_pkg is

  type retired_instruction_t is record
    -- One of these.
    completed : std_ulogic;
    exception : std_ulogic;
    -- As fetched, and expanded to 32 bits.
    instruction : value_t;
    word : value_t;
    address : unsigned(31 downto 0);
    -- The link address; address of the instruction executed next.
    link : unsigned(31 downto 0);
    next_address : unsigned(31 downto 0);
    -- Source registers used, their numbers and values; zero if not used.
    uses_first : std_ulogic;
    uses_second : std_ulogic;
    first_index : register_index_t;
    second_index : register_index_t;
    first : value_t;
    second : value_t;
    -- Destination, 0 for none, and result.
    destination : register_index_t;
    value : value_t;
    -- Memory request in execute, and data returned.
    memory : memory_request_t;
    memory_data : value_t;
    -- The last bus request, if it was answered in the previous clock.
    bus_answered : std_ulogic;
    bus_failed : std_ulogic;
    bus_request : bus_request_t;
    bus_data : value_t;
    -- CSR request in execute, and data read; mret was executed.
    csr_accessed : std_ulogic;
    csr_request : csr_request_t;
    csr_value : value_t;
    returned : std_ulogic;
    -- Current targets of traps and returns.
    trap_target : unsigned(31 downto 0);
    return_address : unsigned(31 downto 0);
    -- Of an exception.
    cause : register_index_t;
    trap_value : value_t;
  end record;

  -- It used its source registers and no others.
  function reads_its_registers(observed : retired_instruction_t) return boolean;
  -- No store, no bus or CSR access.
  function is_quiet(observed : retired_instruction_t) return boolean;
  -- It raised this exception.
  function traps(observed : retired_instruction_t; cause : register_index_t; value : value_t) return boolean;
  -- It did what an instruction of this name does, or raised an exception that it may raise.
  function is_right(name : name_t; observed : retired_instruction_t) return boolean;

end package;

package body retired_instruction_pkg is

  function reads_its_registers(observed : retired_instruction_t) return boolean is
    variable first_is_right, second_is_right : boolean;
  begin
    first_is_right := observed.first_index = observed.word(19 downto 15) when
                        observed.uses_first = '1' else
                      observed.word(19 downto 15) = "00000";
    second_is_right := observed.second_index = observed.word(24 downto 20) when
                         observed.uses_second = '1' else
                       observed.word(24 downto 20) = "00000";
    return (first_is_right or not reads_first(observed.word)) and
           (second_is_right or not reads_second(observed.word));
  end function;

  function stores_nothing(observed : retired_instruction_t) return boolean is
  begin
    return observed.memory.enable = '0' or observed.memory.write_bytes = "0000";
  end function;

  function is_quiet(observed : retired_instruction_t) return boolean is
  begin
    return stores_nothing(observed) and observed.bus_answered = '0' and observed.csr_accessed = '0' and
           observed.returned = '0';
  end function;

  function writes(observed : retired_instruction_t; value : value_t) return boolean is
  begin
    return observed.completed = '1' and reads_its_registers(observed) and
           observed.destination = observed.word(11 downto 7) and
           (observed.destination = "00000" or observed.value = value);
  end function;

  -- An operation: writes this result and continues after itself.
  function gives(observed : retired_instruction_t; value : value_t) return boolean is
  begin
    return writes(observed, value) and is_quiet(observed) and observed.next_address = observed.link;
  end function;

  function jumps(observed : retired_instruction_t; target : unsigned(31 downto 0)) return boolean is
  begin
    return writes(observed, std_ulogic_vector(observed.link)) and is_quiet(observed) and
           observed.next_address = (target and x"fffffffe");
  end function;

  -- Continues there, without side effect.
  function goes(observed : retired_instruction_t; target : unsigned(31 downto 0)) return boolean is
  begin
    return observed.completed = '1' and reads_its_registers(observed) and observed.destination = "00000" and
           is_quiet(observed) and observed.next_address = target;
  end function;

  function branches(observed : retired_instruction_t) return boolean is
  begin
    if is_taken(observed.word, observed.first, observed.second) then
      return goes(observed, observed.address + immediate_b(observed.word));
    end if;
    return goes(observed, observed.link);
  end function;

  function traps(observed : retired_instruction_t; cause : register_index_t; value : value_t)
    return boolean is
  begin
    return observed.exception = '1' and observed.destination = "00000" and stores_nothing(observed) and
           observed.returned = '0' and observed.cause = cause and observed.trap_value = value and
           observed.next_address = observed.trap_target;
  end function;

  function is_in_memory(address : unsigned(31 downto 0)) return boolean is
  begin
    return address(31 downto 16) = x"8000";
  end function;

  -- It made this bus access.
  function requests_bus(observed : retired_instruction_t; write : std_ulogic; address : unsigned(31 downto 0))
    return boolean is
  begin
    return observed.bus_answered = '1' and stores_nothing(observed) and observed.csr_accessed = '0' and
           observed.returned = '0' and observed.bus_request.write = write and
           observed.bus_request.address = address and
           observed.bus_request.select_bytes = lanes(observed.word, address);
  end function;

  function loads(observed : retired_instruction_t) return boolean is
    variable address : unsigned(31 downto 0);
  begin
    address := unsigned(observed.first) + immediate_i(observed.word);
    if is_misaligned(observed.word, address) then
      return traps(observed, cause_load_misaligned, std_ulogic_vector(address)) and is_quiet(observed);
    elsif is_in_memory(address) then
      return gives(observed, loaded(observed.word, observed.memory_data, address)) and
             observed.memory.enable = '1' and observed.memory.address = address(31 downto 2);
    elsif observed.bus_failed then
      return requests_bus(observed, '0', address) and
             traps(observed, cause_load_access, std_ulogic_vector(address));
    end if;
    return requests_bus(observed, '0', address) and
           writes(observed, loaded(observed.word, observed.bus_data, address)) and
           observed.next_address = observed.link;
  end function;

  function stores(observed : retired_instruction_t) return boolean is
    variable address : unsigned(31 downto 0);
    variable goes_on, is_data : boolean;
  begin
    address := unsigned(observed.first) + immediate_s(observed.word);
    goes_on := observed.completed = '1' and reads_its_registers(observed) and
               observed.destination = "00000" and observed.next_address = observed.link;
    if is_misaligned(observed.word, address) then
      return traps(observed, cause_store_misaligned, std_ulogic_vector(address)) and is_quiet(observed);
    elsif is_in_memory(address) then
      is_data := stored(observed.word, observed.memory.data, observed.second, address) = observed.memory.data;
      return goes_on and is_data and observed.memory.enable = '1' and
             observed.memory.write_bytes = lanes(observed.word, address) and
             observed.memory.address = address(31 downto 2) and
             observed.bus_answered = '0' and observed.csr_accessed = '0' and observed.returned = '0';
    end if;
    is_data := stored(observed.word, observed.bus_request.data, observed.second, address) =
               observed.bus_request.data;
    if observed.bus_failed then
      return requests_bus(observed, '1', address) and is_data and
             traps(observed, cause_store_access, std_ulogic_vector(address));
    end if;
    return requests_bus(observed, '1', address) and is_data and goes_on;
  end function;

  -- The update of the CSR is proved of control_status_registers.
  function accesses_csr(observed : retired_instruction_t) return boolean is
    variable changes : boolean;
    variable operand : value_t;
  begin
    changes := observed.word(13 downto 12) = "01" or observed.word(19 downto 15) /= "00000";
    operand := 27x"0" & observed.word(19 downto 15) when observed.word(14) = '1' else observed.first;
    if not csr_exists(observed.word(31 downto 20)) or (changes and observed.word(31 downto 30) = "11") then
      return traps(observed, cause_illegal_instruction, observed.instruction) and observed.bus_answered = '0';
    end if;
    return writes(observed, observed.csr_value) and stores_nothing(observed) and
           observed.bus_answered = '0' and observed.returned = '0' and
           observed.next_address = observed.link and
           observed.csr_accessed = '1' and observed.csr_request.address = observed.word(31 downto 20) and
           observed.csr_request.operation = observed.word(13 downto 12) and
           (observed.csr_request.writes = '1') = changes and
           (observed.csr_request.operand = operand or not changes);
  end function;

  function is_right(name : name_t; observed : retired_instruction_t) return boolean is
    variable first, second, immediate, product : value_t;
  begin
    first := observed.first;
    second := observed.second;
    immediate := std_ulogic_vector(immediate_i(observed.word));
    product := stand_in(observed.word(14 downto 12), first, second);
    case name is
      when rv_lui => return gives(observed, std_ulogic_vector(immediate_u(observed.word)));
      when rv_auipc =>
        return gives(observed, std_ulogic_vector(observed.address + immediate_u(observed.word)));
      when rv_jal => return jumps(observed, observed.address + immediate_j(observed.word));
      when rv_jalr => return jumps(observed, unsigned(first) + immediate_i(observed.word));
      when rv_beq | rv_bne | rv_blt | rv_bge | rv_bltu | rv_bgeu => return branches(observed);
      when rv_lb | rv_lh | rv_lw | rv_lbu | rv_lhu => return loads(observed);
      when rv_sb | rv_sh | rv_sw => return stores(observed);
      when rv_addi => return gives(observed, sum(observed.word, first, immediate));
      when rv_slti | rv_sltiu => return gives(observed, comparison(observed.word, first, immediate));
      when rv_xori | rv_ori | rv_andi => return gives(observed, logic(observed.word, first, immediate));
      when rv_slli | rv_srli | rv_srai => return gives(observed, shift(observed.word, first, immediate));
      when rv_add | rv_sub => return gives(observed, sum(observed.word, first, second));
      when rv_slt | rv_sltu => return gives(observed, comparison(observed.word, first, second));
      when rv_xor | rv_or | rv_and => return gives(observed, logic(observed.word, first, second));
      when rv_sll | rv_srl | rv_sra => return gives(observed, shift(observed.word, first, second));
      when rv_mul | rv_mulh | rv_mulhsu | rv_mulhu => return gives(observed, product);
      when rv_div | rv_divu | rv_rem | rv_remu => return gives(observed, product);
      when rv_fence | rv_fence_i | rv_wfi => return goes(observed, observed.link);
      when rv_ecall =>
        return traps(observed, cause_environment_call, x"00000000") and is_quiet(observed);
      when rv_ebreak =>
        return traps(observed, cause_breakpoint, std_ulogic_vector(observed.address)) and is_quiet(observed);
      when rv_mret =>
        return observed.completed = '1' and observed.destination = "00000" and observed.returned = '1' and
               stores_nothing(observed) and observed.bus_answered = '0' and observed.csr_accessed = '0' and
               observed.next_address = observed.return_address;
      when rv_csrrw | rv_csrrs | rv_csrrc | rv_csrrwi | rv_csrrsi | rv_csrrci =>
        return accesses_csr(observed);
      when no_instruction =>
        return traps(observed, cause_illegal_instruction, observed.instruction) and is_quiet(observed);
    end case;
  end function;

end package body;
