-- SPDX-License-Identifier: Apache-2.0
-- In place of boards/cyclone/phase_locked_loop.v: jitters until it locks, and unlocks when its input stops.

library ieee;
use ieee.std_logic_1164.all;

entity phase_locked_loop is
  generic (
    device_family : string;
    reference_period_ps : positive;
    multiply : positive;
    divide : positive
  );
  port (
    reference_clk : in std_ulogic;
    clk : out std_ulogic;
    locked : out std_ulogic
  );
end entity;

architecture model of phase_locked_loop is

  constant period : time := reference_period_ps * divide * 1 ps / multiply;
  constant lock_clocks : positive := 1_000;

  signal output, steady : std_ulogic := '0';
  signal counted : natural range 0 to lock_clocks := 0;

begin

  count : process
  begin
    wait until rising_edge(reference_clk) for 3 * period;
    if not reference_clk'event then
      counted <= 0;
    elsif counted /= lock_clocks then
      counted <= counted + 1;
    end if;
  end process;
  steady <= '1' when counted = lock_clocks else '0';

  oscillate : process
  begin
    if counted = 0 then
      wait until counted /= 0;
    end if;
    if steady then
      wait for period / 2;
    else
      wait for period / 4 + (counted mod 7) * period / 8;
    end if;
    output <= not output;
  end process;

  clk <= output;
  locked <= steady;

end architecture;
