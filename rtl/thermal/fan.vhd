-- SPDX-License-Identifier: Apache-2.0
-- Fan output: pulse-width modulation of a duty and a period that software sets.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.fan_registers_pkg.all;

entity fan is
  port (
    clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- '1' is on.
    level : out std_ulogic
  );
end entity;

architecture rtl of fan is

  signal from_software : fan_from_software_t;

  -- Clocks left of the present slot after this one.
  signal remaining_cycles : unsigned(23 downto 0) := (others => '0');
  signal advance : std_ulogic;

begin

  registers : entity work.fan_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software
    );

  advance <= '1' when remaining_cycles = 0 else '0';

  divide : process
  begin
    wait until rising_edge(clk);
    if remaining_cycles /= 0 then
      remaining_cycles <= remaining_cycles - 1;
    elsif from_software.period.slot_cycles /= 0 then
      remaining_cycles <= from_software.period.slot_cycles - 1;
    end if;
    if reset then
      remaining_cycles <= (others => '0');
    end if;
  end process;

  modulator : entity work.pulse_width
    generic map (width => 8)
    port map (
      clk => clk,
      reset => reset,
      advance => advance,
      duty => from_software.duty.slots,
      level => level
    );

end architecture;
