-- SPDX-License-Identifier: Apache-2.0
-- In place of the cells of boards/ulx3s: a loop that jitters until it locks, registers in pads, and an
-- oscillator of its own.

library ieee;
use ieee.std_logic_1164.all;

entity clock_50mhz is
  port (
    clk_25mhz : in std_ulogic;
    clk : out std_ulogic;
    locked : out std_ulogic
  );
end entity;

architecture model of clock_50mhz is
begin

  clock : entity work.phase_locked_loop
    generic map (device_family => "ECP5", reference_period_ps => 40_000, multiply => 2, divide => 1)
    port map (reference_clk => clk_25mhz, clk => clk, locked => locked);

end architecture;

library ieee;
use ieee.std_logic_1164.all;

entity output_register is
  port (
    clk : in std_ulogic;
    level : in std_ulogic;
    pin : out std_ulogic := '0'
  );
end entity;

architecture model of output_register is
begin

  pin <= level when rising_edge(clk);

end architecture;

library ieee;
use ieee.std_logic_1164.all;

entity output_register_high is
  port (
    clk : in std_ulogic;
    level : in std_ulogic;
    pin : out std_ulogic := '1'
  );
end entity;

architecture model of output_register_high is
begin

  pin <= level when rising_edge(clk);

end architecture;

library ieee;
use ieee.std_logic_1164.all;

entity internal_oscillator is
  port (
    clk : out std_ulogic
  );
end entity;

architecture model of internal_oscillator is

  signal level : std_ulogic := '0';

begin

  -- 2.4 MHz, from power-up on: nothing can stop it.
  level <= not level after 206.5 ns;
  clk <= level;

end architecture;
