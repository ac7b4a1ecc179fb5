-- SPDX-License-Identifier: Apache-2.0
-- Machine mode reads and writes CSRs, takes exceptions and interrupts, returns, and enters debug mode.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.clocked_bench_pkg.all;
use work.instruction_words_pkg.all;
use work.processor_pkg.all;

entity machine_mode_tb is
end entity;

architecture simulation of machine_mode_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal timer_interrupt : std_ulogic := '0';
  signal debug_request : debug_request_t := debug_request_idle;
  signal instruction : word_t := nop;
  signal control : control_t;
  signal executing : executing_t := (others => '0');
  signal legal : std_ulogic := '1';
  signal executing_address : unsigned(31 downto 0) := x"80000100";
  signal first_operand : word_t := (others => '0');
  signal take_interrupt, take_halt : std_ulogic := '0';
  signal counted, retire : std_ulogic := '0';
  signal csr_request : csr_request_t;
  signal csr_data : word_t;
  signal interrupt_requested, wake_request, interrupt_pending : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap, machine_trap, taken_trap : trap_t;
  signal return_from_trap, enter_debug, flush, entering_handler, returning, resuming : std_ulogic;
  signal trap_target, return_address, return_target : unsigned(31 downto 0);

begin

  clk <= not clk after 10 ns;

  issue : entity work.issued_instruction
    port map (
      clk => clk, instruction => instruction, control => control,
      immediate => open);

  machine : entity work.machine_mode
    port map (
      clk => clk, always_clk => clk, reset => reset, timer_interrupt => timer_interrupt,
      external_interrupt => '0', interrupts => x"0000", debug_request => debug_request,
      executing => executing, control => control, legal => legal, executing_instruction => instruction,
      executing_address => executing_address, first_operand => first_operand,
      executable => executing.executable, stalled => '0',
      start => executing.executable and not take_interrupt, take_interrupt => take_interrupt,
      take_halt => take_halt, fetched_address => x"80000200", data_address => x"00000000",
      data_misaligned => '0', bus_active => '0', bus_error => '0', bus_store => '0', retire => retire,
      counted => counted, csr_request => csr_request, csr_data => csr_data,
      interrupt_requested => interrupt_requested, wake_request => wake_request,
      interrupt_pending => interrupt_pending, interrupt_cause => interrupt_cause, trap => trap,
      machine_trap => machine_trap, taken => taken_trap, return_from_trap => return_from_trap,
      enter_debug => enter_debug, flush => flush, entering_handler => entering_handler,
      returning => returning, resuming => resuming, trap_target => trap_target,
      return_address => return_address, return_target => return_target);

  test : process

    -- To be ended by `finish`.
    procedure execute(word : word_t; operand : word_t := x"00000000") is
    begin
      instruction <= word;
      wait_for_clock(clk);
      first_operand <= operand;
      executing.valid <= '1';
      executing.executable <= '1';
      wait for 1 ns;
    end procedure;

    procedure finish is
    begin
      wait_for_clock(clk);
      executing.valid <= '0';
      executing.executable <= '0';
      wait for 1 ns;
    end procedure;

  begin
    wait_clocks(clk, 2);
    reset <= '0';
    execute(csrw_mtvec, x"80000041");
    is_no_trap : assert trap.enable = '0' and flush = '0' severity failure;
    finish;
    execute(csrw_mscratch, x"c0ffee00");
    finish;
    wait_clocks(clk, 3);
    execute(csrr_mscratch);
    reads_what_was_written : assert csr_data = x"c0ffee00" severity failure;
    finish;

    -- Read-only.
    execute(csrw_mhartid);
    is_illegal : assert trap.enable = '1' and trap.cause = cause_illegal_instruction and
      trap.value = csrw_mhartid severity failure;
    finish;
    wait_clocks(clk, 3);

    -- An exception, and back.
    execute(ecall);
    traps : assert trap.enable = '1' and machine_trap.enable = '1' and flush = '1' and
      trap.cause = cause_environment_call and trap.address = x"80000100" severity failure;
    finish;
    enters_the_handler : assert entering_handler = '1' and taken_trap.enable = '1' and
      trap_target = x"80000040" severity failure;
    wait_clocks(clk, 3);
    execute(mret);
    leaves : assert return_from_trap = '1' and flush = '1' severity failure;
    finish;
    returns : assert returning = '1' and return_target = x"80000100" severity failure;
    wait_clocks(clk, 3);

    -- An interrupt: enabled in mie it wakes, enabled in mstatus too it is taken.
    execute(csrw_mie, x"00000080");
    finish;
    timer_interrupt <= '1';
    wait_clocks(clk, 3);
    wakes_only : assert interrupt_requested = '1' and wake_request = '1' and interrupt_pending = '0'
      severity failure;
    execute(csrwi_mstatus_8);
    finish;
    wait_clocks(clk, 3);
    is_pending : assert interrupt_pending = '1' and interrupt_cause = "00111" severity failure;
    take_interrupt <= '1';
    wait for 1 ns;
    is_taken_before_the_next : assert trap.enable = '1' and trap.interrupt = '1' and
      trap.address = x"80000200" severity failure;
    wait_for_clock(clk);
    take_interrupt <= '0';
    timer_interrupt <= '0';
    wait for 1 ns;
    enters_its_vector : assert entering_handler = '1' and trap_target = x"8000005c" severity failure;
    wait_clocks(clk, 3);

    -- Debug mode: by ebreak where it is requested, with no trap; and back.
    debug_request.halt_at_breakpoint <= '1';
    execute(ebreak);
    halts : assert enter_debug = '1' and machine_trap.enable = '0' and flush = '1' severity failure;
    finish;
    debug_request.halted <= '1';
    execute(ecall);
    no_trap_in_debug_mode : assert trap.enable = '1' and machine_trap.enable = '0' severity failure;
    finish;
    retire <= '1';
    wait for 1 ns;
    injected_instructions_do_not_count : assert counted = '0' severity failure;
    debug_request.resume <= '1';
    debug_request.resume_address <= x"80000300";
    wait for 1 ns;
    flushes_to_resume : assert flush = '1' severity failure;
    wait_for_clock(clk);
    debug_request.halted <= '0';
    debug_request.resume <= '0';
    wait for 1 ns;
    goes_on : assert resuming = '1' and return_target = x"80000300" and counted = '1' severity failure;
    debug_request.halt_at_breakpoint <= '0';
    execute(ebreak);
    is_an_exception : assert enter_debug = '0' and machine_trap.enable = '1' severity failure;
    finish;
    take_halt <= '1';
    take_interrupt <= '1';
    wait for 1 ns;
    halts_on_request : assert enter_debug = '1' and machine_trap.enable = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
