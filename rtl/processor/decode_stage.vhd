-- SPDX-License-Identifier: Apache-2.0
-- Decode: control signals, static prediction, operands with forwarding; issues the instruction to execute.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity decode_stage is
  generic (
    reset_address : unsigned(31 downto 0) := x"80000000";
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- The pipeline advances: the instruction in decode moves to execute.
    advance : in std_ulogic;
    fetched : in fetched_t;
    debug_request : in debug_request_t;
    -- From execute: what discards the instruction in decode; what flushes the one in execute.
    redirect : in std_ulogic;
    trap_enable : in std_ulogic;
    return_from_trap : in std_ulogic;
    bus_error : in std_ulogic;
    take_interrupt : in std_ulogic;
    flush : in std_ulogic;
    -- Results to forward: of execute, unless it is late, of write-back and of register write.
    forwarded_late : in word_t;
    forwarded_early : in word_t;
    forward_late_result : in std_ulogic;
    writing : in writing_t;
    written_late : in word_t;
    written_product : in word_t;
    written_early : in word_t;
    register_write : in register_write_t;
    prediction : out prediction_t;
    -- The instruction in decode: it is issued, and executable; control signals, immediate, source registers.
    issue : out std_ulogic;
    issue_executable : out std_ulogic;
    decoded : out control_t;
    decoded_immediate : out word_t;
    first_index : out register_index_t;
    second_index : out register_index_t;
    -- The instruction in execute.
    issued : out executing_t;
    issued_condition : out redirect_condition_t;
    issued_control : out control_t;
    legal : out std_ulogic;
    result_is_address : out std_ulogic;
    executing_instruction : out word_t;
    executing_immediate : out word_t;
    executing_address : out unsigned(31 downto 0);
    alternate_address : out unsigned(31 downto 0);
    -- Its operands, unless they are still to come (load-use hazard).
    first_operand : out word_t;
    second_operand : out word_t;
    hazard : out std_ulogic
  );
end entity;

architecture rtl of decode_stage is

  signal executing : executing_t;
  signal redirect_condition : redirect_condition_t;
  signal control : control_t;
  signal decode_valid, decode_fault, decode_is_word : std_ulogic;
  signal decode_instruction : word_t;
  signal decoded_alternate_address : unsigned(31 downto 0);
  signal decoded_condition : redirect_condition_t;

begin

  -- In debug mode injected instructions replace fetched ones.
  decode_valid <= debug_request.inject when debug_request.halted else fetched.valid;
  decode_fault <= fetched.fault and not debug_request.halted;
  decode_instruction <= debug_request.instruction when debug_request.halted else
                           fetched.instruction;
  decode_is_word <= fetched.is_word or debug_request.halted;

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
      valid => fetched.valid and not debug_request.halted,
      address => fetched.address,
      instruction => decode_instruction,
      is_word => decode_is_word,
      decoded => decoded,
      taken => prediction.taken,
      target => prediction.target,
      target_plus_2 => prediction.target_plus_2,
      next_address => prediction.next_address,
      alternate_address => decoded_alternate_address,
      condition => decoded_condition);

  -- The instruction in decode is issued unless execute redirects or traps.
  issue <= decode_valid and not (redirect or trap_enable or return_from_trap);
  issue_executable <= issue and not decode_fault and (or decoded.legal);

  issue_to_execute : process
  begin
    wait until rising_edge(clk);
    if advance then
      executing <= (
        valid => issue,
        executable => issue_executable,
        fetch_fault => decode_fault,
        crosses_memory_end => fetched.crosses_memory_end);
      redirect_condition <= (
        if_below => issue_executable and decoded_condition.if_below,
        if_above => issue_executable and decoded_condition.if_above,
        inverted => issue_executable and decoded_condition.inverted);
      control <= decoded;
      legal <= or decoded.legal;
      result_is_address <= decoded.address_result or decoded.jump or decoded.jump_register;
      executing_immediate <= decoded_immediate;
      executing_address <= fetched.address;
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
    -- The clock after a flush redirects to the trap vector or return address,
    -- after reset to the reset vector.
    if reset or flush then
      redirect_condition <= redirect_always;
      control.jump_register <= '0';
      alternate_address <= (others => '0');
    end if;
    if reset then
      alternate_address <= reset_address;
    end if;
  end process;

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
      execute_result_late => forwarded_late,
      execute_result_early => forwarded_early,
      write => writing.writes,
      destination => writing.destination,
      write_data_late => written_late,
      write_data_product => written_product,
      write_data_early => written_early,
      register_write => register_write,
      forward_late_result => forward_late_result,
      hazard => hazard,
      first => first_operand,
      second => second_operand);

  issued <= executing;
  issued_condition <= redirect_condition;
  issued_control <= control;

end architecture;
