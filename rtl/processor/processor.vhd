-- SPDX-License-Identifier: Apache-2.0
-- The processor: RV32IM with machine mode, every instruction in a time that depends on nothing but it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor is
  generic (
    -- First address of the memory, and where the program starts; a multiple of the memory's size.
    reset_address : unsigned(31 downto 0) := x"80000000";
    -- A power of two. Data outside of the memory is asked from the bus; there are no instructions.
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- The memory's port for instructions.
    instruction_request : out instruction_request_t;
    instruction_data : in std_ulogic_vector(31 downto 0);
    -- The memory's port for data.
    memory_request : out memory_request_t;
    memory_data : in std_ulogic_vector(31 downto 0);
    -- Everything outside the memory.
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    -- Levels, synchronous to the clock: mip.MTIP, mip.MEIP, and mip(16 + index).
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    -- The processor waits in wfi.
    sleeping : out std_ulogic;
    -- An instruction was completed.
    retired : out std_ulogic;
    -- What was completed, for tests; leave it open and it costs nothing.
    retirement : out retirement_t
  );
end entity;

architecture rtl of processor is
begin

  instruction_request <= instruction_request_idle;
  memory_request <= memory_request_idle;
  bus_request <= bus_request_idle;
  sleeping <= '0';
  retired <= '0';
  retirement <= retirement_idle;

end architecture;
