-- SPDX-License-Identifier: Apache-2.0
-- Register write: the pipeline register after write-back. It takes memory data before it is aligned, so that
-- the longest path out of the memory ends at a register and goes on to the register file in the next clock.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity register_write is
  port (
    clk : in std_ulogic;
    -- Write-back: its control signals; its result, which is the OR of aligned memory data, of a product and
    -- of the rest; the memory data before alignment.
    writing : in writing_t;
    memory_data : in word_t;
    value_product : in word_t;
    value_early : in word_t;
    -- The same, a clock later.
    write : out register_write_t
  );
end entity;

architecture rtl of register_write is

  -- No write before the first reset.
  signal enable : std_ulogic := '0';
  signal destination : register_index_t;
  signal lanes : load_lanes_t;
  signal loaded, rest, aligned : word_t;

begin

  hold : process
  begin
    wait until rising_edge(clk);
    enable <= writing.writes;
    destination <= writing.destination;
    lanes <= writing.from_memory;
    loaded <= memory_data;
    rest <= value_product or value_early;
  end process;

  load_result : entity work.load_result
    port map (
      loaded => loaded,
      lanes => lanes,
      result => aligned);

  write <= (enable => enable, destination => destination, data => aligned or rest);

end architecture;
