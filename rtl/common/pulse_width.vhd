-- SPDX-License-Identifier: Apache-2.0
-- Pulse-width modulator: on for the first part of every period, without a glitch when that part changes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pulse_width is
  generic (
    -- Bits of the duty: a period has 2**width - 1 slots.
    width : positive := 8
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- '1' in the last clock of every slot.
    advance : in std_ulogic;
    -- Slots of a period in which the output is on: 0 is never, all ones is always. Sampled when a
    -- period begins.
    duty : in unsigned(width - 1 downto 0);
    level : out std_ulogic := '0'
  );
end entity;

architecture rtl of pulse_width is

  constant last_slot : unsigned(width - 1 downto 0) := (width - 1 downto 1 => '1') & '0';

  signal slot : unsigned(width - 1 downto 0) := last_slot;
  signal slots_on : unsigned(width - 1 downto 0) := (others => '0');

begin

  modulate : process
  begin
    wait until rising_edge(clk);
    if advance then
      if slot = last_slot then
        slot <= (others => '0');
        slots_on <= duty;
        level <= '1' when duty /= 0 else '0';
      else
        slot <= slot + 1;
        level <= '1' when slot + 1 < slots_on else '0';
      end if;
    end if;
    if reset then
      slot <= last_slot;
      slots_on <= (others => '0');
      level <= '0';
    end if;
  end process;

end architecture;
