-- SPDX-License-Identifier: Apache-2.0
-- Debug module: the registers through which a debugger accesses the one hart and its memory.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.debug_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity debug_module is
  generic (
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    dmi_request : in dmi_request_t;
    -- Of the register at the request's address.
    dmi_data : out word_t;
    -- Resets the chip, except for the debug logic (ndmreset).
    chip_reset : out std_ulogic;
    -- The processor is in reset.
    processor_reset : in std_ulogic;
    halted : in std_ulogic;
    halt_request : out std_ulogic;
    halt_at_reset : out std_ulogic;
    resume : out std_ulogic;
    csr_request : out debug_csr_request_t;
    csr_response : in debug_csr_response_t;
    inject : out std_ulogic;
    instruction : out word_t;
    debug_response : in debug_response_t;
    port_free : in std_ulogic;
    memory_request : out memory_request_t;
    memory_data : in word_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t
  );
end entity;

architecture rtl of debug_module is

  signal active : std_ulogic := '0';
  signal halt_wanted, reset_wanted, halt_at_reset_wanted, resume_wanted : std_ulogic := '0';
  signal resume_acknowledged, has_been_reset : std_ulogic := '0';
  signal written : std_ulogic;
  signal module_off : std_ulogic;

  signal data0, command : word_t;
  signal repeat_with_data0, data0_touched, start : std_ulogic := '0';
  signal command_error : command_error_t := command_error_none;
  signal command_busy, command_done, command_reads : std_ulogic;
  signal done_error : command_error_t;
  signal command_result : word_t;
  signal wanted_while_busy : std_ulogic;

  signal bus_control, bus_data, status : word_t;
  signal bus_address : unsigned(31 downto 0);
  signal running, unavailable : std_ulogic;

begin

  written <= dmi_request.strobe and dmi_request.write;
  module_off <= reset or not active;
  halt_request <= halt_wanted;
  halt_at_reset <= halt_at_reset_wanted or halt_wanted;
  chip_reset <= reset_wanted;
  resume <= resume_wanted and halted and not command_busy;

  control_processor : process
  begin
    wait until rising_edge(clk);
    if resume then
      resume_wanted <= '0';
      resume_acknowledged <= '1';
    end if;
    if written and (dmi_request.address ?= dmcontrol_address) then
      active <= dmi_request.data(0);
      reset_wanted <= dmi_request.data(1);
      halt_wanted <= dmi_request.data(31);
      if dmi_request.data(30) and not dmi_request.data(31) then
        resume_wanted <= halted;
        resume_acknowledged <= not halted;
      end if;
      if dmi_request.data(28) then
        has_been_reset <= '0';
      end if;
      -- setresethaltreq, clrresethaltreq
      if dmi_request.data(3) or dmi_request.data(2) then
        halt_at_reset_wanted <= not dmi_request.data(2);
      end if;
    end if;

    if processor_reset then
      has_been_reset <= '1';
      resume_wanted <= '0';
    end if;
    if module_off then
      reset_wanted <= '0';
      halt_wanted <= '0';
      halt_at_reset_wanted <= '0';
      resume_wanted <= '0';
      resume_acknowledged <= '0';
    end if;
    if reset then
      active <= '0';
    end if;
  end process;

  -- Commands: abstractcs, command, abstractauto, data0.
  data0_touched <= dmi_request.strobe and (dmi_request.address ?= data0_address);
  wanted_while_busy <= (data0_touched or
                        (written and (dmi_request.address ?= command_address or
                                      dmi_request.address ?= abstractcs_address or
                                      dmi_request.address ?= abstractauto_address))) and
                       (command_busy or start);

  control_command : process
  begin
    wait until rising_edge(clk);
    start <= '0';
    if wanted_while_busy then
      if command_error = command_error_none then
        command_error <= command_error_busy;
      end if;
    else
      if data0_touched then
        if dmi_request.write then
          data0 <= dmi_request.data;
        end if;
        start <= repeat_with_data0 and (nor command_error);
      end if;
      if written then
        case dmi_request.address is
          when abstractcs_address =>
            command_error <= command_error and not dmi_request.data(10 downto 8);
          when command_address =>
            if command_error = command_error_none then
              command <= dmi_request.data;
              start <= '1';
            end if;
          when abstractauto_address =>
            repeat_with_data0 <= dmi_request.data(0);
          when others => null;
        end case;
      end if;
    end if;

    if command_done then
      if command_reads then
        data0 <= command_result;
      end if;
      if command_error = command_error_none then
        command_error <= done_error;
      end if;
    end if;

    if module_off then
      start <= '0';
      command_error <= command_error_none;
      repeat_with_data0 <= '0';
      data0 <= (others => '0');
      command <= (others => '0');
    end if;
  end process;

  abstract_commands : entity work.abstract_command
    port map (
      clk => clk,
      reset => module_off or processor_reset,
      halted => halted,
      start => start,
      command => command,
      data => data0,
      busy => command_busy,
      done => command_done,
      error => done_error,
      has_result => command_reads,
      result => command_result,
      csr_request => csr_request,
      csr_response => csr_response,
      inject => inject,
      instruction => instruction,
      debug_response => debug_response
    );

  bus_accesses : entity work.system_bus_access
    generic map (
      memory_size_bytes => memory_size_bytes
    )
    port map (
      clk => clk,
      reset => module_off,
      write_control => written and (dmi_request.address ?= sbcs_address),
      write_address => written and (dmi_request.address ?= sbaddress0_address),
      write_data => written and (dmi_request.address ?= sbdata0_address),
      read_data => dmi_request.strobe and not dmi_request.write and
                   (dmi_request.address ?= sbdata0_address),
      written => dmi_request.data,
      control => bus_control,
      address => bus_address,
      data => bus_data,
      port_free => port_free,
      memory_request => memory_request,
      memory_data => memory_data,
      bus_request => bus_request,
      bus_response => bus_response
    );

  -- One hart, so "any" and "all" are equal. Authenticated; halt on reset supported; version 0.13.
  unavailable <= processor_reset;
  running <= not halted and not processor_reset;
  status <= (19 | 18 => has_been_reset, 17 | 16 => resume_acknowledged, 13 | 12 => unavailable,
             11 | 10 => running, 9 | 8 => halted, 7 => '1', 5 => '1', 1 => '1', others => '0');

  read_register : process (all)
  begin
    dmi_data <= (others => '0');
    case dmi_request.address is
      when data0_address =>
        dmi_data <= data0;
      when dmcontrol_address =>
        dmi_data(31) <= halt_wanted;
        dmi_data(1) <= reset_wanted;
        dmi_data(0) <= active;
      when dmstatus_address =>
        dmi_data <= status;
      when abstractcs_address =>
        dmi_data(12) <= command_busy or start;
        dmi_data(10 downto 8) <= command_error;
        dmi_data(0) <= '1';  -- One data register.
      when abstractauto_address =>
        dmi_data(0) <= repeat_with_data0;
      when sbcs_address =>
        dmi_data <= bus_control;
      when sbaddress0_address =>
        dmi_data <= std_ulogic_vector(bus_address);
      when sbdata0_address =>
        dmi_data <= bus_data;
      when haltsum0_address =>
        dmi_data(0) <= halted;
      when others => null;
    end case;
  end process;

end architecture;
