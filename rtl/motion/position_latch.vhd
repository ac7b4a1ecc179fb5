-- SPDX-License-Identifier: Apache-2.0
-- Keeps the position of one axis as it was in the clock of a capture.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity position_latch is
  port (
    clk : in std_ulogic;
    capture : in std_ulogic;
    position : in position_t;
    captured_position : out position_t := (others => '0')
  );
end entity;

architecture rtl of position_latch is
begin

  latch : process
  begin
    wait until rising_edge(clk);
    if capture then
      captured_position <= position;
    end if;
  end process;

end architecture;
