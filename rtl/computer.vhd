-- SPDX-License-Identifier: Apache-2.0
-- The computer: processor, memory and, optionally, the debug port.

library ieee;
use ieee.std_logic_1164.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity computer is
  generic (
    memory_size_bytes : positive;
    -- A debugger can halt the processor and reach the memory and the bus over JTAG.
    has_debug : boolean;
    -- The processor implements extension Zbb.
    has_zbb : boolean := false;
    -- As of the memory.
    memory_shows_clear : boolean := false
  );
  port (
    -- `clk` may be gated while `at_rest` is high, `always_clk` never.
    clk : in std_ulogic;
    always_clk : in std_ulogic;
    -- Synchronous: from outside the chip, for the debugger's own part; and with what the debugger requests.
    external_reset : in std_ulogic;
    reset : in std_ulogic;
    -- The debugger resets the chip.
    chip_reset : out std_ulogic;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    timer_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    -- JTAG, asynchronous.
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic;
    -- The processor waits in wfi; an instruction has retired.
    sleeping : out std_ulogic;
    retired : out std_ulogic;
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of computer is

  signal instruction_request : instruction_request_t;
  signal instruction_data : std_ulogic_vector(31 downto 0);
  signal processor_memory_request, memory_request : memory_request_t;
  signal memory_data : std_ulogic_vector(31 downto 0);
  signal processor_bus_request : bus_request_t;
  signal processor_bus_response : bus_response_t;
  signal debug_request : debug_request_t := debug_request_idle;
  signal debug_response : debug_response_t;

begin

  cpu : entity work.processor
    generic map (
      memory_size_bytes => memory_size_bytes,
      has_zbb => has_zbb
    )
    port map (
      clk => clk,
      always_clk => always_clk,
      reset => reset,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      memory_request => processor_memory_request,
      memory_data => memory_data,
      bus_request => processor_bus_request,
      bus_response => processor_bus_response,
      timer_interrupt => timer_interrupt,
      external_interrupt => '0',
      interrupts => interrupts,
      sleeping => sleeping,
      at_rest => at_rest,
      retired => retired,
      retirement => open,
      debug_request => debug_request,
      debug_response => debug_response
    );

  with_debug : if has_debug generate
    signal own_reset : std_ulogic := '1';
  begin

    -- The debugger's own part goes on while the chip is in the reset that it requests.
    register_own_reset : process
    begin
      wait until rising_edge(clk);
      own_reset <= external_reset;
    end process;

    debugging : entity work.debug_port
      generic map (
        memory_size_bytes => memory_size_bytes
      )
      port map (
        clk => clk,
        reset => own_reset,
        tck => tck,
        tms => tms,
        tdi => tdi,
        tdo => tdo,
        chip_reset => chip_reset,
        processor_reset => reset,
        debug_request => debug_request,
        debug_response => debug_response,
        processor_memory_request => processor_memory_request,
        memory_request => memory_request,
        memory_data => memory_data,
        processor_bus_request => processor_bus_request,
        processor_bus_response => processor_bus_response,
        bus_request => bus_request,
        bus_response => bus_response
      );

  else generate

    memory_request <= processor_memory_request;
    bus_request <= processor_bus_request;
    processor_bus_response <= bus_response;
    debug_request <= debug_request_idle;
    chip_reset <= '0';
    tdo <= '0';

  end generate;

  ram : entity work.memory
    generic map (
      size_bytes => memory_size_bytes,
      shows_clear => memory_shows_clear
    )
    port map (
      clk => clk,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      data_request => memory_request,
      data => memory_data
    );

end architecture;
