-- SPDX-License-Identifier: Apache-2.0
-- Hart control: halt, resume, single step; dcsr, dpc and the triggers of hardware breakpoints.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.processor_pkg.all;

entity hart_control is
  generic (
    -- Instruction addresses at which the hardware halts.
    triggers : positive range 1 to 4 := 2
  );
  port (
    clk : in std_ulogic;
    -- The processor's.
    reset : in std_ulogic;
    -- Levels: halt as soon as possible; halt before the first instruction after a reset.
    halt_request : in std_ulogic;
    halt_at_reset : in std_ulogic;
    -- For one clock, while `halted`: resume.
    resume : in std_ulogic;
    halted : out std_ulogic;
    -- dcsr, dpc, tselect, tdata1, tdata2, tinfo, for debuggers only: programs find no trigger.
    csr_request : in debug_csr_request_t;
    csr_response : out debug_csr_response_t;
    -- An instruction for the halted processor.
    inject : in std_ulogic;
    instruction : in word_t;
    debug_request : out debug_request_t;
    debug_response : in debug_response_t
  );
end entity;

architecture rtl of hart_control is

  -- dcsr.cause, table 4.2 of RISC-V External Debug Support 0.13.2.
  subtype cause_t is std_ulogic_vector(2 downto 0);
  constant cause_breakpoint : cause_t := "001";
  constant cause_trigger : cause_t := "010";
  constant cause_request : cause_t := "011";
  constant cause_step : cause_t := "100";
  constant cause_reset : cause_t := "101";

  type addresses_t is array (0 to triggers - 1) of unsigned(31 downto 0);

  signal halts_at_breakpoint, steps : std_ulogic := '0';
  signal cause : cause_t := "000";
  signal return_address : unsigned(31 downto 1);

  signal selected : unsigned(1 downto 0) := "00";
  -- Per trigger: set by a debugger (dmode), in machine mode, at execution.
  signal reserved, in_machine_mode, at_execution : std_ulogic_vector(0 to triggers - 1);
  signal addresses : addresses_t;

  signal next_matches, triggered, step_done, reset_halt : std_ulogic := '0';
  signal trigger_word, trigger_address, status : word_t;

begin

  debug_request <= (
    halted => halted,
    halt => not halted and (halt_request or reset_halt or step_done or triggered),
    halt_at_breakpoint => halts_at_breakpoint,
    step => steps and not halted,
    inject => inject,
    instruction => instruction,
    resume => resume,
    resume_address => return_address & '0');

  compare_addresses : process (all)
  begin
    next_matches <= '0';
    for index in 0 to triggers - 1 loop
      if reserved(index) and in_machine_mode(index) and at_execution(index) and
        (debug_response.next_address ?= addresses(index)) then
        next_matches <= '1';
      end if;
    end loop;
  end process;

  halt : process
  begin
    wait until rising_edge(clk);
    -- The instruction in execute matches a trigger: halt before it.
    if debug_response.advance then
      triggered <= debug_response.issue and next_matches and not halted;
    end if;
    if debug_response.finish and steps and not halted then
      step_done <= '1';
    end if;

    if debug_response.enter and not halted then
      halted <= '1';
      step_done <= '0';
      reset_halt <= '0';
      cause <= cause_trigger when triggered else
               cause_breakpoint when debug_response.at_breakpoint else
               cause_reset when reset_halt else
               cause_request when halt_request else
               cause_step;
    elsif resume then
      halted <= '0';
    end if;

    if reset then
      halted <= '0';
      triggered <= '0';
      step_done <= '0';
      reset_halt <= halt_at_reset;
      cause <= "000";
    end if;
  end process;

  keep_registers : process
  begin
    wait until rising_edge(clk);
    if debug_response.enter and not halted then
      return_address <= debug_response.address(31 downto 1);
    end if;
    if csr_request.write then
      case csr_request.address is
        when x"7b0" =>
          halts_at_breakpoint <= csr_request.data(15);
          steps <= csr_request.data(2);
        when x"7b1" =>
          return_address <= unsigned(csr_request.data(31 downto 1));
        when x"7a0" =>
          if unsigned(csr_request.data) < triggers then
            selected <= unsigned(csr_request.data(1 downto 0));
          end if;
        when x"7a1" =>
          for index in 0 to triggers - 1 loop
            if selected = index then
              reserved(index) <= csr_request.data(27);
              in_machine_mode(index) <= csr_request.data(6);
              at_execution(index) <= csr_request.data(2);
            end if;
          end loop;
        when x"7a2" =>
          for index in 0 to triggers - 1 loop
            if selected = index then
              addresses(index) <= unsigned(csr_request.data);
            end if;
          end loop;
        when others => null;
      end case;
    end if;

    if reset then
      halts_at_breakpoint <= '0';
      steps <= '0';
      selected <= "00";
      reserved <= (others => '0');
      in_machine_mode <= (others => '0');
      at_execution <= (others => '0');
    end if;
  end process;

  -- Version 0.13, machine mode.
  status <= x"4000" & halts_at_breakpoint & "000000" & cause & "000" & steps & "11";

  select_trigger : process (all)
  begin
    trigger_word <= (others => '0');
    trigger_address <= (others => '0');
    for index in 0 to triggers - 1 loop
      if selected = index then
        -- Address match (type 2) that enters debug mode (action 1).
        trigger_word <= (29 => '1', 27 => reserved(index), 12 => '1', 6 => in_machine_mode(index),
                         2 => at_execution(index), others => '0');
        trigger_address <= std_ulogic_vector(addresses(index));
      end if;
    end loop;
  end process;

  answer : process (all)
  begin
    csr_response <= (exists => '1', data => (others => '0'));
    case csr_request.address is
      when x"7b0" => csr_response.data <= status;
      when x"7b1" => csr_response.data <= std_ulogic_vector(return_address) & '0';
      when x"7a0" => csr_response.data(1 downto 0) <= std_ulogic_vector(selected);
      when x"7a1" => csr_response.data <= trigger_word;
      when x"7a2" => csr_response.data <= trigger_address;
      when x"7a4" => csr_response.data(2) <= '1';
      when others => csr_response.exists <= '0';
    end case;
  end process;

end architecture;
