-- SPDX-License-Identifier: Apache-2.0
-- Stand-in for the divider in proofs of the processor: done in the third clock of a request, with values
-- that a solver can handle.

library ieee;
use ieee.std_logic_1164.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity divider is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in std_ulogic;
    operation : in std_ulogic_vector(1 downto 0);
    first : in word_t;
    second : in word_t;
    done : out std_ulogic;
    result : out word_t
  );
end entity;

architecture rtl of divider is

  signal clocks : natural range 0 to 2 := 0;

  default clock is rising_edge(clk);

begin

  divide : process
  begin
    wait until rising_edge(clk);
    if clocks = 0 then
      result <= stand_in('1' & operation, first, second);
    end if;
    if clocks = 2 or request = '0' or reset = '1' then
      clocks <= 0;
    else
      clocks <= clocks + 1;
    end if;
  end process;

  done <= '1' when clocks = 2 else '0';

  stand_in_divider_terminates : assert always (clocks <= 2);
  stand_in_divider_is_right : assert always
    (clocks > 0 -> result = stand_in('1' & operation, first, second));

end architecture;
