-- SPDX-License-Identifier: Apache-2.0
-- Stand-in for the multiplier in proofs of the processor: the same latency, with values that a solver can
-- handle.

library ieee;
use ieee.std_logic_1164.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity multiplier is
  port (
    clk : in std_ulogic;
    enable : in std_ulogic;
    operation : in std_ulogic_vector(1 downto 0);
    first : in word_t;
    second : in word_t;
    result : out word_t
  );
end entity;

architecture rtl of multiplier is
begin

  multiply : process
  begin
    wait until rising_edge(clk);
    if enable then
      result <= stand_in('0' & operation, first, second);
    end if;
  end process;

end architecture;
