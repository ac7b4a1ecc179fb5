-- SPDX-License-Identifier: Apache-2.0
-- The heater control's time: ticks for its time-outs, and slots of the heaters' duty.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.thermal_pkg.all;

entity heater_timing is
  port (
    -- May be gated, except for the edge after `alarm`.
    clk : in std_ulogic;
    -- The same clock, never gated: the one that counts.
    always_clk : in std_ulogic;
    -- The same clock for the registers.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    -- Clocks of a slot; 0 counts as 1.
    slot_cycles : in unsigned(23 downto 0);
    -- For one clock of `clk`.
    tick : out std_ulogic := '0';
    slot_start : out std_ulogic := '0';
    -- The next edge of `clk` makes one of both.
    alarm : out std_ulogic
  );
end entity;

architecture rtl of heater_timing is

  signal tick_phase : natural range 0 to tick_cycles - 1 := 0;
  signal tick_ends : std_ulogic;
  signal slot_phase : unsigned(23 downto 0) := (others => '0');
  -- Of a slot, registered, so that no sum is compared.
  signal last_phase : unsigned(23 downto 0) := (others => '0');
  signal slot_ends : std_ulogic;

begin

  tick_ends <= '1' when tick_phase = tick_cycles - 1 else '0';
  slot_ends <= '1' when slot_phase >= last_phase else '0';
  alarm <= tick_ends or slot_ends;

  find_last_phase : process
  begin
    wait until rising_edge(bus_clk);
    last_phase <= (others => '0');
    if slot_cycles /= 0 then
      last_phase <= slot_cycles - 1;
    end if;
  end process;

  count_phases : process
  begin
    wait until rising_edge(always_clk);
    if tick_ends then
      tick_phase <= 0;
    else
      tick_phase <= tick_phase + 1;
    end if;
    slot_phase <= slot_phase + 1;
    if slot_ends then
      slot_phase <= (others => '0');
    end if;
    if reset then
      tick_phase <= 0;
      slot_phase <= (others => '0');
    end if;
  end process;

  make_ticks : process
  begin
    wait until rising_edge(clk);
    tick <= tick_ends;
    slot_start <= slot_ends;
  end process;

end architecture;
