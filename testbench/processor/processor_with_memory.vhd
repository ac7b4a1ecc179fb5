-- SPDX-License-Identifier: Apache-2.0
-- The processor and its memory, with all other ports left to the test: top entity of the Verilated tests.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor_with_memory is
  generic (
    memory_size_bytes : positive := 65536;
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    timer_interrupt : in std_ulogic;
    external_interrupt : in std_ulogic;
    interrupts : in std_ulogic_vector(15 downto 0);
    sleeping : out std_ulogic;
    retired : out std_ulogic;
    retirement : out retirement_t
  );
end entity;

architecture rtl of processor_with_memory is

  signal instruction_request : instruction_request_t;
  signal instruction_word, data_word : std_ulogic_vector(31 downto 0);
  signal data_request : memory_request_t;

begin

  processor : entity work.processor
    generic map (memory_size_bytes => memory_size_bytes, has_zbb => has_zbb)
    port map (
      clk => clk,
      always_clk => clk,
      reset => reset,
      instruction_request => instruction_request,
      instruction_data => instruction_word,
      memory_request => data_request,
      memory_data => data_word,
      bus_request => bus_request,
      bus_response => bus_response,
      timer_interrupt => timer_interrupt,
      external_interrupt => external_interrupt,
      interrupts => interrupts,
      sleeping => sleeping,
      retired => retired,
      retirement => retirement);

  memory : entity work.memory
    generic map (size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      instruction_request => instruction_request,
      instruction_data => instruction_word,
      data_request => data_request,
      data => data_word);

end architecture;
