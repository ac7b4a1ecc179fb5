-- SPDX-License-Identifier: Apache-2.0
-- Decode issues what fetch gives, with forwarded operands, unless execute discards it; predicts jumps; takes
-- the debugger's instructions in debug mode.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.clocked_bench_pkg.all;
use work.instruction_words_pkg.all;
use work.processor_pkg.all;

entity decode_stage_tb is
end entity;

architecture simulation of decode_stage_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal advance : std_ulogic := '1';
  signal fetched : fetched_t := (
    valid => '0', is_word => '1', fault => '0', crosses_memory_end => '0', instruction => addi_x1_5,
    address => x"80000100");
  signal debug_request : debug_request_t := debug_request_idle;
  signal redirect, trap_enable, return_from_trap, bus_error, take_interrupt, flush : std_ulogic := '0';
  signal forwarded_late, written_value : word_t := (others => '0');
  signal forward_late_result : std_ulogic := '0';
  signal writing : writing_t := (
    destination => "00000", from_memory => lanes_of('0', "000", "00"),
    from_bus => lanes_of('0', "000", "00"), others => '0');
  signal register_write : register_write_t := (
    enable => '0', destination => "00000", data => (others => '0'));
  signal prediction : prediction_t;
  signal issue, issue_executable : std_ulogic;
  signal decoded, control : control_t;
  signal decoded_immediate : word_t;
  signal first_index, second_index : register_index_t;
  signal executing : executing_t;
  signal redirect_condition : redirect_condition_t;
  signal legal, result_is_address, hazard : std_ulogic;
  signal executing_instruction, executing_immediate, first_operand, second_operand : word_t;
  signal executing_address, alternate_address : unsigned(31 downto 0);

begin

  clk <= not clk after 10 ns;

  stage : entity work.decode_stage
    port map (
      clk => clk, reset => reset, advance => advance, fetched => fetched,
      debug_request => debug_request, redirect => redirect, trap_enable => trap_enable,
      return_from_trap => return_from_trap, bus_error => bus_error, take_interrupt => take_interrupt,
      flush => flush, forwarded_late => forwarded_late, forwarded_early => x"00000000",
      forward_late_result => forward_late_result,
      writing => writing, written_late => written_value, written_product => x"00000000",
      written_early => x"00000000", register_write => register_write, prediction => prediction,
      issue => issue, issue_executable => issue_executable, decoded => decoded,
      decoded_immediate => decoded_immediate,
      first_index => first_index, second_index => second_index, issued => executing,
      issued_condition => redirect_condition, issued_control => control, legal => legal,
      result_is_address => result_is_address, executing_instruction => executing_instruction,
      executing_immediate => executing_immediate, executing_address => executing_address,
      alternate_address => alternate_address, first_operand => first_operand,
      second_operand => second_operand, hazard => hazard);

  test : process

    procedure fetch(instruction : word_t; is_word : std_ulogic := '1') is
    begin
      fetched.valid <= '1';
      fetched.instruction <= instruction;
      fetched.is_word <= is_word;
      wait for 1 ns;
    end procedure;

    procedure expect_discarded(signal cause : out std_ulogic; what : string) is
    begin
      cause <= '1';
      fetch(addi_x1_5);
      is_not_issued : assert issue = '0' and issue_executable = '0' report what severity failure;
      wait_for_clock(clk);
      cause <= '0';
      is_not_in_execute : assert executing.valid = '0' and executing.executable = '0'
        report what severity failure;
    end procedure;

  begin
    wait_for_clock(clk);
    starts_at_the_reset_vector : assert redirect_condition = redirect_always and
      alternate_address = x"80000000" and executing.valid = '0' severity failure;
    reset <= '0';
    wait_for_clock(clk);
    a_bubble_is_not_executed : assert executing.valid = '0' and redirect_condition = redirect_never
      severity failure;

    fetch(addi_x1_5);
    is_issued : assert issue = '1' and issue_executable = '1' severity failure;
    wait_for_clock(clk);
    is_in_execute : assert executing.valid = '1' and executing.executable = '1' and legal = '1' and
      control.destination = "00001" and control.writes = '1' and executing_immediate = x"00000005" and
      executing_instruction = addi_x1_5 and executing_address = x"80000100" severity failure;

    -- Both operands are the result in execute.
    fetch(add_x2_x1_x1);
    forwarded_late <= x"12345678";
    wait_for_clock(clk);
    forwards_from_execute : assert first_operand = x"12345678" and second_operand = x"12345678" and
      hazard = '0' severity failure;

    -- A late result is a hazard until write-back has it.
    fetch(lw_x1);
    wait_for_clock(clk);
    fetch(add_x2_x1_x1);
    wait_for_clock(clk);
    sees_the_hazard : assert hazard = '1' severity failure;
    advance <= '0';
    forward_late_result <= '1';
    writing.writes <= '1';
    writing.destination <= "00001";
    written_value <= x"0badcafe";
    wait_for_clock(clk);
    advance <= '1';
    forward_late_result <= '0';
    writing.writes <= '0';
    forwards_from_write_back : assert hazard = '0' and first_operand = x"0badcafe" and
      second_operand = x"0badcafe" severity failure;
    -- In the next clock register write has it, and an instruction that is issued then reads it.
    register_write <= (enable => '1', destination => "00001", data => x"0badcafe");
    fetch(add_x2_x1_x1);
    wait_for_clock(clk);
    forwards_from_register_write : assert first_operand = x"0badcafe" and second_operand = x"0badcafe"
      severity failure;
    register_write.enable <= '0';
    -- The register has it now.
    fetch(add_x2_x1_x1);
    wait_for_clock(clk);
    reads_the_register : assert first_operand = x"0badcafe" and second_operand = x"0badcafe" severity failure;
    fetch(addi_x1_5);
    wait_for_clock(clk);
    fetch(lw_x1);
    wait_for_clock(clk);
    fetch(c_addi_x8, '0');
    wait_for_clock(clk);
    clears_what_follows : assert executing_instruction = x"00000405" and control.destination = "01000"
      severity failure;

    fetch(jal_16);
    predicts_a_jump : assert prediction.taken = '1' and prediction.target = x"80000110" and
      prediction.next_address = x"80000110" severity failure;
    wait_for_clock(clk);
    links : assert result_is_address = '1' and alternate_address = x"80000104" severity failure;

    -- While the pipeline stalls the instruction stays in execute.
    advance <= '0';
    fetch(addi_x1_5);
    wait_for_clock(clk);
    stays : assert executing_instruction = jal_16 severity failure;
    -- An interrupt flushes it even then, as does a bus error.
    take_interrupt <= '1';
    wait_for_clock(clk);
    take_interrupt <= '0';
    an_interrupt_flushes : assert executing.valid = '0' severity failure;
    advance <= '1';
    wait_for_clock(clk);
    bus_error <= '1';
    wait_for_clock(clk);
    bus_error <= '0';
    a_bus_error_flushes : assert executing.valid = '0' severity failure;

    expect_discarded(redirect, "redirect");
    expect_discarded(trap_enable, "trap");
    expect_discarded(return_from_trap, "mret");
    flush <= '1';
    wait_for_clock(clk);
    flush <= '0';
    a_flush_redirects : assert redirect_condition = redirect_always and alternate_address = x"00000000" and
      control.jump_register = '0' severity failure;

    fetch(illegal, '0');
    wait_for_clock(clk);
    an_illegal_one_is_not_executable : assert executing.valid = '1' and executing.executable = '0' and
      legal = '0' severity failure;
    fetched.fault <= '1';
    fetched.crosses_memory_end <= '1';
    fetch(addi_x1_5);
    wait_for_clock(clk);
    nor_is_a_faulty_one : assert executing.executable = '0' and executing.fetch_fault = '1' and
      executing.crosses_memory_end = '1' severity failure;

    -- In debug mode only the debugger's instruction counts.
    debug_request.halted <= '1';
    debug_request.instruction <= add_x2_x1_x1;
    fetch(jal_16);
    nothing_is_fetched : assert issue = '0' and prediction.taken = '0' severity failure;
    debug_request.inject <= '1';
    wait_for_clock(clk);
    is_injected : assert executing.executable = '1' and executing_instruction = add_x2_x1_x1 severity failure;
    std.env.finish;
  end process;

end architecture;
