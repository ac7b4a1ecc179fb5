-- SPDX-License-Identifier: Apache-2.0
-- Control and status registers of machine mode, with their updates by traps and mret.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity control_status_registers is
  port (
    clk : in std_ulogic;
    -- The same clock without gating.
    always_clk : in std_ulogic;
    reset : in std_ulogic;
    -- A CSR instruction; read data in the same clock.
    request : in csr_request_t;
    read_data : out word_t;
    -- The trap taken in the previous clock. No instruction is in execute for two clocks from then on.
    trap : in trap_t;
    -- mret executes in this clock.
    trap_return : in std_ulogic;
    -- An instruction retires in this clock.
    retire : in std_ulogic;
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    -- An interrupt enabled in mie is pending, combinational.
    interrupt_requested : out std_ulogic;
    -- The same in the previous clock: wakes wfi regardless of mstatus.MIE.
    wake_request : out std_ulogic;
    -- ... and mstatus.MIE is set: take the interrupt.
    interrupt_pending : out std_ulogic;
    interrupt_cause : out std_ulogic_vector(4 downto 0);
    -- From mtvec; an interrupt's cause is that of the clock before.
    trap_target : out unsigned(31 downto 0);
    -- mepc.
    return_address : out unsigned(31 downto 0)
  );
end entity;

architecture rtl of control_status_registers is

  constant misa : word_t := x"40001104";  -- RV32, I, M and C.
  constant writable_interrupts : word_t := x"ffff0880";

  signal interrupt_enable, previous_interrupt_enable : std_ulogic;
  signal enabled_interrupts, next_enabled_interrupts, requested_interrupts : word_t;
  signal trap_base, interrupt_vector : unsigned(31 downto 2);
  signal trap_vectored : std_ulogic;
  signal scratch, last_trap_value : word_t;
  signal exception_address : unsigned(31 downto 1);
  signal last_trap_cause : std_ulogic_vector(4 downto 0);
  signal last_trap_was_interrupt : std_ulogic;
  signal cycle_stopped, instructions_stopped : std_ulogic;
  signal cycle, next_cycle, instructions : unsigned(63 downto 0);

  signal write_data, status : word_t;
  signal counter_half : unsigned(31 downto 0);
  signal trap_state, setup : word_t;
  signal is_counter, is_trap_state, is_setup : std_ulogic;
  signal write, writes_counter : std_ulogic;
  signal cycle_event, instruction_event : std_ulogic;

  -- New value of a CSR that holds `old`.
  function written(old, operand : word_t; operation : std_ulogic_vector(1 downto 0)) return word_t is
  begin
    if operation = "10" then
      return old or operand;
    elsif operation = "11" then
      return old and not operand;
    end if;
    return operand;
  end function;

begin

  status <= (12 => '1', 11 => '1', 7 => previous_interrupt_enable, 3 => interrupt_enable,
             others => '0');
  requested_interrupts <= (11 => external_interrupt, 7 => timer_interrupt,
                           31 => interrupts(15), 30 => interrupts(14), 29 => interrupts(13),
                           28 => interrupts(12), 27 => interrupts(11), 26 => interrupts(10),
                           25 => interrupts(9), 24 => interrupts(8), 23 => interrupts(7),
                           22 => interrupts(6), 21 => interrupts(5), 20 => interrupts(4),
                           19 => interrupts(3), 18 => interrupts(2), 17 => interrupts(1),
                           16 => interrupts(0), others => '0');

  -- Read multiplexer, selected by as few address bits as distinguish the implemented CSRs. Other addresses
  -- are illegal instructions and don't care.
  is_counter <= request.address(11) and (request.address(10) nand request.address(9)) and
                not (or request.address(4 downto 2)) and not request.address(0);
  counter_half <= cycle(63 downto 32) when request.address(7) and not request.address(1) else
                  instructions(63 downto 32) when request.address(7) else
                  cycle(31 downto 0) when not request.address(1) else
                  instructions(31 downto 0);
  -- 34x: mscratch, mepc, mcause, mtval, mip.
  is_trap_state <= request.address(9) and request.address(6);
  trap_state <= requested_interrupts when request.address(2) else
                last_trap_value when request.address(1) and request.address(0) else
                (31 => last_trap_was_interrupt, 4 => last_trap_cause(4), 3 => last_trap_cause(3),
                 2 => last_trap_cause(2), 1 => last_trap_cause(1), 0 => last_trap_cause(0),
                 others => '0') when request.address(1) else
                std_ulogic_vector(exception_address) & '0' when request.address(0) else
                scratch;
  -- 30x: mstatus, misa, mie, mtvec; 320: mcountinhibit; 310 (mstatush) and the rest of 32x are zero.
  is_setup <= not request.address(11) and not request.address(10) and not request.address(6) and
              not request.address(4);
  setup <= (2 => instructions_stopped and not (or request.address(4 downto 0)),
            0 => cycle_stopped and not (or request.address(4 downto 0)), others => '0') when
             request.address(5) else
           std_ulogic_vector(trap_base) & '0' & trap_vectored when
             request.address(2) and request.address(0) else
           enabled_interrupts when request.address(2) else
           misa when request.address(0) else
           status;
  read_data <= std_ulogic_vector(counter_half) when is_counter else
               trap_state when is_trap_state else
               setup when is_setup else
               x"00000000";

  write <= request.enable and request.writes and not request.cancelled;
  write_data <= written(read_data, request.operand, request.operation);
  writes_counter <= write and (request.address(11 downto 8) ?= x"b");

  -- A write of mie takes effect at once, so interrupts are masked with its next value. Critical path:
  -- computed without the read multiplexer, and without `cancelled`, since no interrupt is taken in the
  -- clock after one.
  next_enabled_interrupts <= written(enabled_interrupts, request.operand, request.operation) and
                          writable_interrupts when
                          request.enable and request.writes and (request.address ?= x"304") else
                        enabled_interrupts;

  update : process
  begin
    wait until rising_edge(clk);
    if not request.cancelled then
      enabled_interrupts <= next_enabled_interrupts;
    end if;
    if write then
      case request.address is
        when x"300" =>
          interrupt_enable <= write_data(3);
          previous_interrupt_enable <= write_data(7);
        when x"305" =>
          trap_base <= unsigned(write_data(31 downto 2));
          trap_vectored <= write_data(0);
        when x"320" =>
          cycle_stopped <= write_data(0);
          instructions_stopped <= write_data(2);
        when x"340" => scratch <= write_data;
        when x"341" => exception_address <= unsigned(write_data(31 downto 1));
        when x"342" =>
          last_trap_was_interrupt <= write_data(31);
          last_trap_cause <= write_data(4 downto 0);
        when x"343" => last_trap_value <= write_data;
        when others => null;
      end case;
    end if;

    if trap.enable then
      previous_interrupt_enable <= interrupt_enable;
      interrupt_enable <= '0';
      exception_address <= trap.address(31 downto 1);
      last_trap_was_interrupt <= trap.interrupt;
      last_trap_cause <= trap.cause;
      last_trap_value <= trap.value;
    elsif trap_return then
      interrupt_enable <= previous_interrupt_enable;
      previous_interrupt_enable <= '1';
    end if;

    if reset then
      interrupt_enable <= '0';
      previous_interrupt_enable <= '0';
      enabled_interrupts <= (others => '0');
      trap_base <= (others => '0');
      trap_vectored <= '0';
      last_trap_was_interrupt <= '0';
      last_trap_cause <= (others => '0');
      cycle_stopped <= '0';
      instructions_stopped <= '0';
    end if;
  end process;

  -- Critical path: the vector addresses the memory in the clock after an interrupt is taken. It is added in
  -- the clock before, in which `interrupt_cause` becomes `trap.cause` and no instruction writes mtvec.
  add_vector : process
  begin
    wait until rising_edge(clk);
    interrupt_vector <= trap_base + (unsigned(interrupt_cause) and (4 downto 0 => trap_vectored));
  end process;
  trap_target(31 downto 2) <= interrupt_vector when trap.interrupt else trap_base;
  trap_target(1 downto 0) <= "00";
  return_address <= exception_address & '0';

  cycle_event <= not cycle_stopped;
  -- Counts also while the clock of the processor is gated.
  cycle_counter : entity work.event_counter
    port map (
      clk => always_clk,
      reset => reset,
      increment => cycle_event,
      write_low => writes_counter and (request.address(7 downto 0) ?= x"00"),
      write_high => writes_counter and (request.address(7 downto 0) ?= x"80"),
      write_data => write_data,
      count => open,
      next_count => next_cycle);

  -- The value that instructions read: equal to the counter in every clock that follows an edge of `clk`.
  -- Reading the counter itself would make a simulation evaluate the whole read path in every clock.
  sample_cycle : process
  begin
    wait until rising_edge(clk);
    cycle <= next_cycle;
    if reset then
      cycle <= (others => '0');
    end if;
  end process;

  -- `retire` settles late: it is counted a clock later. `count` of the counter includes the pending event.
  delay_instruction_event : process
  begin
    wait until rising_edge(clk);
    instruction_event <= retire and not instructions_stopped and
                         not (writes_counter and (request.address(6 downto 0) ?= "0000010"));
    if reset then
      instruction_event <= '0';
    end if;
  end process;

  instruction_counter : entity work.event_counter
    port map (
      clk => clk,
      reset => reset,
      increment => instruction_event,
      write_low => writes_counter and (request.address(7 downto 0) ?= x"02"),
      write_high => writes_counter and (request.address(7 downto 0) ?= x"82"),
      write_data => write_data,
      count => instructions,
      next_count => open);

  interrupt_control : entity work.interrupt_control
    port map (
      clk => clk,
      requested => requested_interrupts,
      enabled => next_enabled_interrupts,
      pending => wake_request,
      cause => interrupt_cause);
  interrupt_pending <= wake_request and interrupt_enable;
  interrupt_requested <= or (requested_interrupts and enabled_interrupts);

end architecture;
