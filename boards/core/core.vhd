-- SPDX-License-Identifier: Apache-2.0
-- The processor and its memory alone, behind six pins of any FPGA: to measure their size and clock rate.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity core is
  generic (
    -- A power of two.
    memory_size_bytes : positive := 65536;
    -- The processor has extension Zbb.
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    button : in std_ulogic_vector(1 downto 0);
    led : out std_ulogic_vector(2 downto 0)
  );
end entity;

architecture rtl of core is

  signal instruction_request : instruction_request_t;
  signal instruction_word, data_word : std_ulogic_vector(31 downto 0);
  signal data_request : memory_request_t;
  signal bus_request, sent : bus_request_t;
  signal bus_response : bus_response_t;
  -- What comes from outside comes out of a chain of registers: response, interrupts.
  signal inputs : std_ulogic_vector(51 downto 0);
  signal reset : std_ulogic;
  -- What goes outside is gathered to a few bits, so that none of it is optimised away.
  signal gathered : std_ulogic_vector(7 downto 0);

begin

  shift_in : process
  begin
    wait until rising_edge(clk);
    inputs <= inputs(50 downto 0) & button(0);
    reset <= button(1);
  end process;

  bus_response <= (
    acknowledge => inputs(32), error => inputs(33), data => inputs(31 downto 0));

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
      timer_interrupt => inputs(34),
      external_interrupt => inputs(35),
      interrupts => inputs(51 downto 36),
      sleeping => led(0),
      at_rest => open,
      retired => led(1),
      retirement => open);

  memory : entity work.memory
    generic map (size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      instruction_request => instruction_request,
      instruction_data => instruction_word,
      data_request => data_request,
      data => data_word);

  gather : process
  begin
    wait until rising_edge(clk);
    sent <= bus_request;
    for part in gathered'range loop
      gathered(part) <= (xor sent.address(4 * part + 3 downto 4 * part)) xor
                        (xor sent.data(4 * part + 3 downto 4 * part));
    end loop;
    led(2) <= (xor gathered) xor (xor sent.select_bytes) xor sent.write xor sent.strobe;
  end process;

end architecture;
