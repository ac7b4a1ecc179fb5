-- SPDX-License-Identifier: Apache-2.0
-- The supply of all heaters: closed by its key where no cause lasts, opened by every cause; unasked heat;
-- slots; rest.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_supply_tb is
end entity;

architecture simulation of heater_control_supply_tb is

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : heater_inputs_t := (others => '0');
  signal outputs : heater_outputs_t;
  signal sensors_work : boolean := true;
  signal present_count : natural := 5_000;
  signal gate_0_edges, clocks_at_rest : natural;

  alias clk is master.clk;

begin

  rig : entity work.heater_control_rig
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      sensors_work => sensors_work, present_count => present_count,
      gate_0_edges => gate_0_edges, clocks_at_rest => clocks_at_rest);

  check : process

    -- All limits are locked, and the channel may heat.
    constant cleared : natural := 2 ** heater_control_status_permitted_bit
      + 2 ** heater_control_status_minimum_locked_bit + 2 ** heater_control_status_maximum_locked_bit
      + 2 ** heater_control_status_hot_locked_bit + 2 ** heater_control_status_settle_locked_bit;

    variable word : word_t;
    variable edges_before : natural;

    -- Causes as in opener_bits.
    procedure expect_opened (causes : std_ulogic_vector(3 downto 0)) is
    begin
      wait_clocks(clk, 3);
      supply_is_open : assert outputs.supply = '0' report "the supply is closed" severity error;
      read(master, heater_control_supply_address, word);
      supply_says_why : assert word(opener_bits) = causes and word(heater_control_supply_closed_bit) = '0'
        report to_hstring(word) & " instead of " & to_string(causes) severity error;
      wait_clocks(clk, 2);
      supply_interrupts : assert outputs.interrupt = '1' report "no interrupt" severity error;
      write(master, heater_control_duty_address, 0);
      clear_trips(master);
      wait_clocks(clk, 3 * tick_cycles);
      feed_watchdog(master);
      wait_clocks(clk, 3);
      stays_open : assert outputs.supply = '0' report "closed by itself" severity error;
      -- Of the trip, if there was one, nothing is left: it is the supply that interrupts.
      expect(master, heater_control_status_address, cleared);
      expect(master, heater_control_status_address, cleared, 1);
      interrupts_until_closed : assert outputs.interrupt = '1' report "no interrupt" severity error;
      switch_supply(master, heater_control_supply_key_close);
      closes_again : assert outputs.supply = '1' report "does not close" severity error;
      wait_clocks(clk, 2);
      closed_it_does_not_interrupt : assert outputs.interrupt = '0' report "interrupt" severity error;
    end procedure;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 10);
    write(master, heater_control_watchdog_address, patience);
    write(master, heater_control_slot_address, 1);
    write(master, heater_control_minimum_count_address, 1_000);
    write(master, heater_control_maximum_count_address, 9_000);
    write(master, heater_control_hot_count_address, 6_000);
    write(master, heater_control_settle_address, settling);
    write(master, heater_control_minimum_count_address, 1_000, 1);
    write(master, heater_control_maximum_count_address, 9_000, 1);
    write(master, heater_control_hot_count_address, 6_000, 1);
    write(master, heater_control_settle_address, settling, 1);
    feed_watchdog(master);
    wait_clocks(clk, conversion);
    clear_trips(master);

    -- The supply: closed by its key, at duty 0, without a cause; opened by its key and by every cause.
    is_open_at_first : assert outputs.supply = '0' report "closed" severity error;
    wait_clocks(clk, 2 * tick_cycles);
    feed_watchdog(master);
    wait_clocks(clk, 3);
    switch_supply(master, heater_control_supply_key_close + 1);
    wants_its_key : assert outputs.supply = '0' report "closed" severity error;
    switch_supply(master, heater_control_supply_key_close - 1);
    wants_no_lower_key : assert outputs.supply = '0' report "closed" severity error;
    switch_supply(master, 0);
    wants_a_key : assert outputs.supply = '0' report "closed" severity error;
    write(master, heater_control_duty_address, 1, 1);
    switch_supply(master, heater_control_supply_key_close);
    wants_no_duty : assert outputs.supply = '0' report "closed" severity error;
    read(master, heater_control_supply_address, word);
    says_that_it_stays_open : assert unsigned(word) = 2 ** heater_control_supply_refused_bit
      report to_hstring(word) severity error;
    write(master, heater_control_duty_address, 0, 1);
    clear_trips(master);
    switch_supply(master, heater_control_supply_key_close);
    closes : assert outputs.supply = '1' report "open" severity error;
    read(master, heater_control_supply_address, word);
    says_that_it_is_closed : assert unsigned(word) = 2 ** heater_control_supply_closed_bit
      report to_hstring(word) severity error;
    -- The key of another register is none.
    write(master, heater_control_clear_address,
      to_word(heater_control_clear_t'(channels => "0000",
        key => to_unsigned(heater_control_supply_key_open, 16))));
    wait_clocks(clk, 3);
    only_its_own_register_opens : assert outputs.supply = '1' report "open" severity error;
    switch_supply(master, heater_control_supply_key_open);
    opens_when_asked : assert outputs.supply = '0' report "closed" severity error;
    wait_clocks(clk, 3);
    that_is_no_alarm : assert outputs.interrupt = '0' report "interrupt" severity error;
    switch_supply(master, heater_control_supply_key_close);
    inputs.veto <= '1';
    wait_clocks(clk, 6);
    switch_supply(master, heater_control_supply_key_close);
    a_cause_that_lasts_keeps_it_open : assert outputs.supply = '0' report "closed" severity error;
    inputs.veto <= '0';
    wait_clocks(clk, 3);
    expect_opened("1000");
    inputs.emergency_stop <= '1';
    wait_clocks(clk, 6);
    inputs.emergency_stop <= '0';
    wait_clocks(clk, 3);
    expect_opened("0100");
    wait_clocks(clk, (patience + 1) * tick_cycles);
    expect_opened("0010");
    present_count <= 999;
    wait_clocks(clk, conversion);
    present_count <= 5_000;
    wait_clocks(clk, conversion);
    expect_opened("0001");

    -- A transistor that conducts by itself: an eighth hotter with the gate long closed.
    for i in 1 to settling loop
      wait_clocks(clk, 2 * tick_cycles);
      feed_watchdog(master);
    end loop;
    present_count <= 5_500;
    wait_clocks(clk, 2 * conversion);
    feed_watchdog(master);
    present_count <= 4_813;
    wait_clocks(clk, 2 * conversion);
    feed_watchdog(master);
    tolerates_a_little : assert outputs.supply = '1' report "open" severity error;
    present_count <= 4_812;
    wait_clocks(clk, 2 * conversion);
    expect_trip(master, outputs.interrupt, heater_control_status_heats_unasked_trip_bit);
    present_count <= 5_000;
    expect_opened("0001");

    -- Half duty in slots of 100 clocks: an edge every slot.
    wait_clocks(clk, 2 * tick_cycles);
    write(master, heater_control_slot_address, 100);
    heat(master, outputs.gates);
    write(master, heater_control_duty_address, 32_768);
    wait_clocks(clk, 400);
    edges_before := gate_0_edges;
    wait_clocks(clk, 4_000);
    keeps_levels_for_a_slot : assert abs (gate_0_edges - edges_before - 40) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;

    -- A slot of 0 clocks is one of 1: an edge every clock.
    write(master, heater_control_slot_address, 0);
    feed_watchdog(master);
    wait_clocks(clk, 200);
    edges_before := gate_0_edges;
    wait_clocks(clk, 1_000);
    a_slot_of_0_is_a_clock : assert abs (gate_0_edges - edges_before - 1_000) <= 2
      report to_string(gate_0_edges - edges_before) & " edges" severity error;
    write(master, heater_control_duty_address, 0);
    write(master, heater_control_slot_address, 100);
    wait_clocks(clk, 200);
    edges_before := clocks_at_rest;
    wait_clocks(clk, 2_000);
    rests_most_of_the_time : assert clocks_at_rest - edges_before > 1_500
      report to_string(clocks_at_rest - edges_before) & " clocks at rest" severity error;

    std.env.finish;
  end process;

end architecture;
