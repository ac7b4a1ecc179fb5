-- SPDX-License-Identifier: Apache-2.0
-- Keeps the positions of all axes and the time of one clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity position_latch is
  generic (
    axes : positive range 1 to axis_limit := 5
  );
  port (
    clk : in std_ulogic;
    capture : in std_ulogic;
    positions : in position_array_t(axes - 1 downto 0);
    now : in time_t;
    captured_positions : out position_array_t(axes - 1 downto 0) := (others => (others => '0'));
    captured_time : out time_t := (others => '0')
  );
end entity;

architecture rtl of position_latch is
begin

  latch : process
  begin
    wait until rising_edge(clk);
    if capture then
      captured_positions <= positions;
      captured_time <= now;
    end if;
  end process;

end architecture;
