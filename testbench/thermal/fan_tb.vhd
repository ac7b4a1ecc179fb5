-- SPDX-License-Identifier: Apache-2.0
-- The fan is on for exactly its duty, at the period that was set; off and full are constant levels.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.fan_registers_pkg.all;

entity fan_tb is
end entity;

architecture simulation of fan_tb is

  constant slots : positive := 255;
  constant duty : unsigned(31 downto 0) := fan_duty_address;
  constant period : unsigned(31 downto 0) := fan_period_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal level : std_ulogic;

  signal clocks_on : natural := 0;
  signal switched_on : natural := 0;

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  fan : entity work.fan
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, level => level);

  watch : process
    variable before : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    if level then
      clocks_on <= clocks_on + 1;
    end if;
    if level and not before then
      switched_on <= switched_on + 1;
    end if;
    before := level;
  end process;

  check : process
    variable word : word_t;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
    end procedure;

    procedure is_on_for_its_duty (on_slots, slot_cycles : natural) is
      constant slot_clocks : positive := maximum(1, slot_cycles);
      variable clocks_on_before : natural;
      variable switched_on_before : natural;
      variable expected_switching : natural := 3;
    begin
      write(master, period, slot_cycles);
      write(master, duty, on_slots);
      -- Until the period under way has ended, whatever its slots were.
      wait_clocks(2 * slots * slot_clocks + 100);
      clocks_on_before := clocks_on;
      switched_on_before := switched_on;
      wait_clocks(3 * slots * slot_clocks);
      has_its_duty : assert clocks_on - clocks_on_before = 3 * on_slots * slot_clocks
        report "on for " & to_string(clocks_on - clocks_on_before) & " clocks at duty "
          & to_string(on_slots) & ", slots of " & to_string(slot_cycles) severity error;
      if on_slots = 0 or on_slots = slots then
        expected_switching := 0;
      end if;
      switches_once_a_period : assert switched_on - switched_on_before = expected_switching
        report "switched on " & to_string(switched_on - switched_on_before) & " times at duty "
          & to_string(on_slots) severity error;
    end procedure;
  begin
    wait_clocks(2);
    reset <= '0';
    wait_clocks(1000);
    is_off_after_reset : assert clocks_on = 0 report "on after reset" severity error;

    for on_slots in 0 to slots loop
      if on_slots mod 17 < 2 then
        is_on_for_its_duty(on_slots, 1);
        is_on_for_its_duty(on_slots, 7);
      end if;
    end loop;
    is_on_for_its_duty(100, 0);
    is_on_for_its_duty(1, 300);

    read(master, duty, word);
    duty_reads_back : assert unsigned(word) = 1 report to_hstring(word) severity error;
    is_on_for_its_duty(slots, 1);
    reset <= '1';
    wait_clocks(2);
    goes_off_at_reset : assert level = '0' report "on in reset" severity error;
    reset <= '0';

    -- A reset ends the slot under way, however long it is.
    write(master, period, 2 ** (fan_period_slot_cycles_bits'high + 1) - 1);
    wait_clocks(2 * slots);
    reset <= '1';
    wait_clocks(1);
    reset <= '0';
    write(master, period, 1);
    write(master, duty, slots);
    wait_clocks(2 * slots + 100);
    runs_soon_after_a_reset : assert level = '1' report "still off" severity error;
    std.env.finish;
  end process;

end architecture;
