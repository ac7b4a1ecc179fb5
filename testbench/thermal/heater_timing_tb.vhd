-- SPDX-License-Identifier: Apache-2.0
-- Ticks and slots come after their clocks, each announced by the alarm a clock before.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.thermal_pkg.all;

entity heater_timing_tb is
end entity;

architecture simulation of heater_timing_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal slot_cycles : unsigned(23 downto 0) := (others => '0');
  signal tick, slot_start, alarm : std_ulogic;

  -- Clocks since the last tick, the last slot; none yet.
  constant not_yet : integer := -1;
  signal since_tick, since_slot : integer := not_yet;
  signal ticks, slots : natural := 0;
  signal announced : std_ulogic := '0';
  signal slots_are_steady : boolean := false;

begin

  clk <= not clk after 10 ns;

  timing : entity work.heater_timing
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, reset => reset, slot_cycles => slot_cycles,
      tick => tick, slot_start => slot_start, alarm => alarm);

  watch : process
  begin
    wait until rising_edge(clk);
    announced <= alarm;
    is_announced : assert announced = (tick or slot_start) severity failure;
    since_tick <= since_tick + 1 when since_tick /= not_yet else not_yet;
    since_slot <= since_slot + 1 when since_slot /= not_yet else not_yet;
    if tick then
      comes_after_its_clocks : assert since_tick = not_yet or since_tick + 1 = tick_cycles severity failure;
      since_tick <= 0;
      ticks <= ticks + 1;
    end if;
    if slot_start then
      lasts_as_long_as_software_says : assert since_slot = not_yet or not slots_are_steady or
        since_slot + 1 = maximum(to_integer(slot_cycles), 1)
        report to_string(since_slot + 1) & " clocks" severity failure;
      since_slot <= 0;
      slots <= slots + 1;
    end if;
    if reset then
      since_tick <= not_yet;
      since_slot <= not_yet;
    end if;
  end process;

  test : process

    procedure clocks(number : positive) is
    begin
      for i in 1 to number loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure set_slot(cycles : natural; expected_slots : positive) is
      variable before : natural;
    begin
      slots_are_steady <= false;
      slot_cycles <= to_unsigned(cycles, 24);
      wait until rising_edge(clk) and slot_start = '1';
      clocks(4);
      wait until rising_edge(clk) and slot_start = '1';
      slots_are_steady <= true;
      before := slots;
      clocks(expected_slots * maximum(cycles, 1));
      come : assert slots - before >= expected_slots - 1 severity failure;
    end procedure;

  begin
    clocks(4);
    reset <= '0';
    set_slot(0, 20);
    set_slot(1, 20);
    set_slot(2, 20);
    set_slot(100, 5);
    set_slot(3000, 3);
    set_slot(7, 20);
    ticks_come : assert ticks >= 8 severity failure;
    finish;
  end process;

end architecture;
