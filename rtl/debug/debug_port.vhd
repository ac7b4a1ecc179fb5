-- SPDX-License-Identifier: Apache-2.0
-- The debug logic: from the JTAG pins to the processor, its memory and its bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.debug_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

-- It lies between the processor and its memory and bus. Without a debugger it is transparent.
entity debug_port is
  generic (
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    -- Of everything.
    reset : in std_ulogic;
    -- JTAG; see debug_transport.
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic;
    -- The debugger wants the chip reset, and the processor is.
    chip_reset : out std_ulogic;
    processor_reset : in std_ulogic;
    debug_request : out debug_request_t;
    debug_response : in debug_response_t;
    -- From the processor, and what reaches the memory; the memory's data goes to both.
    processor_memory_request : in memory_request_t;
    memory_request : out memory_request_t;
    memory_data : in word_t;
    -- The same of the bus.
    processor_bus_request : in bus_request_t;
    processor_bus_response : out bus_response_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t
  );
end entity;

architecture rtl of debug_port is

  signal register_request : dmi_request_t;
  signal register_data : word_t;
  signal halted, halt_wanted, halts_at_reset, resuming, injecting : std_ulogic;
  signal injected : word_t;
  signal csr_access : debug_csr_request_t;
  signal csr_answer : debug_csr_response_t;
  signal own_memory_request : memory_request_t;
  signal own_bus_request : bus_request_t;
  signal own_bus_response : bus_response_t;
  signal processor_uses_memory, owns_bus : std_ulogic := '0';

begin

  jtag : entity work.debug_transport
    port map (
      clk => clk,
      reset => reset,
      tck => tck,
      tms => tms,
      tdi => tdi,
      tdo => tdo,
      dmi_request => register_request,
      dmi_data => register_data
    );

  processor_uses_memory <= debug_response.uses_data_port;

  registers : entity work.debug_module
    generic map (
      memory_size_bytes => memory_size_bytes
    )
    port map (
      clk => clk,
      reset => reset,
      dmi_request => register_request,
      dmi_data => register_data,
      chip_reset => chip_reset,
      processor_reset => processor_reset,
      halted => halted,
      halt_request => halt_wanted,
      halt_at_reset => halts_at_reset,
      resume => resuming,
      csr_request => csr_access,
      csr_response => csr_answer,
      inject => injecting,
      instruction => injected,
      debug_response => debug_response,
      port_free => not processor_uses_memory,
      memory_request => own_memory_request,
      memory_data => memory_data,
      bus_request => own_bus_request,
      bus_response => own_bus_response
    );

  hart : entity work.hart_control
    port map (
      clk => clk,
      reset => processor_reset,
      halt_request => halt_wanted,
      halt_at_reset => halts_at_reset,
      resume => resuming,
      halted => halted,
      csr_request => csr_access,
      csr_response => csr_answer,
      inject => injecting,
      instruction => injected,
      debug_request => debug_request,
      debug_response => debug_response
    );

  -- Critical path: arbitrated by a signal that settles early, not by the processor's `enable`.
  memory_request <= processor_memory_request when processor_uses_memory else own_memory_request;

  -- Granted while the processor does not use the bus, and released a clock after the access, so that the
  -- strobe is low for a clock between any two accesses.
  own_bus : process
  begin
    wait until rising_edge(clk);
    if owns_bus then
      owns_bus <= own_bus_request.strobe;
    else
      owns_bus <= own_bus_request.strobe and not processor_bus_request.strobe;
    end if;

    if reset or processor_reset then
      owns_bus <= '0';
    end if;
  end process;

  bus_request.strobe <= own_bus_request.strobe when owns_bus else processor_bus_request.strobe;
  bus_request.write <= own_bus_request.write when owns_bus else processor_bus_request.write;
  bus_request.address <= own_bus_request.address when owns_bus else processor_bus_request.address;
  bus_request.select_bytes <= own_bus_request.select_bytes when owns_bus else
                              processor_bus_request.select_bytes;
  bus_request.data <= own_bus_request.data when owns_bus else processor_bus_request.data;

  processor_bus_response <= (
    acknowledge => bus_response.acknowledge and not owns_bus,
    error => bus_response.error and not owns_bus,
    data => bus_response.data);
  own_bus_response <= (
    acknowledge => bus_response.acknowledge and owns_bus,
    error => bus_response.error and owns_bus,
    data => bus_response.data);

end architecture;
