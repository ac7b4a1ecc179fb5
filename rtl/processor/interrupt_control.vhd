-- SPDX-License-Identifier: Apache-2.0
-- Interrupt priority: the pending and enabled interrupt to be taken first.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity interrupt_control is
  port (
    clk : in std_ulogic;
    -- mip, and the next value of mie.
    requested : in word_t;
    enabled : in word_t;
    -- An enabled interrupt was requested in the previous clock.
    pending : out std_ulogic;
    -- The highest-priority one: external, timer, 16, 17, .. 31.
    cause : out std_ulogic_vector(4 downto 0)
  );
end entity;

architecture rtl of interrupt_control is

  signal active : word_t;

begin

  register_requests : process
  begin
    wait until rising_edge(clk);
    active <= requested and enabled;
    pending <= or (requested and enabled);
  end process;

  -- Not timing-critical.
  prioritize : process (all)
  begin
    cause <= 5d"31";
    for index in 30 downto 16 loop
      if active(index) then
        cause <= std_ulogic_vector(to_unsigned(index, 5));
      end if;
    end loop;
    if active(7) then
      cause <= 5d"7";
    end if;
    if active(11) then
      cause <= 5d"11";
    end if;
  end process;

end architecture;
