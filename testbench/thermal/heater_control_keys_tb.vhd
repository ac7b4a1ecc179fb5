-- SPDX-License-Identifier: Apache-2.0
-- A key is a key only with all of its bits, and a duty is a duty with any of its bits.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_bench_pkg.all;
use work.heater_control_registers_pkg.all;

entity heater_control_keys_tb is
end entity;

architecture simulation of heater_control_keys_tb is

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal inputs : heater_inputs_t := (others => '0');
  signal outputs : heater_outputs_t;

  alias clk is master.clk;

begin

  rig : entity work.heater_control_rig
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, inputs => inputs, outputs => outputs,
      sensors_work => true, present_count => 5_000, gate_0_edges => open, clocks_at_rest => open);

  check : process

    constant key_bits : positive := 16;

    variable word : word_t;

    function flipped (key, bit_number : natural) return natural is
      variable bits : unsigned(key_bits - 1 downto 0) := to_unsigned(key, key_bits);
    begin
      bits(bit_number) := not bits(bit_number);
      return to_integer(bits);
    end function;

    procedure expect_trip_by_feeding (what : string) is
    begin
      for channel in 0 to 1 loop
        read(master, heater_control_status_address + 4 * channel, word);
        is_a_wrong_feed : assert word(heater_control_status_watchdog_trip_bit) = '1'
          report what & " feeds" severity error;
      end loop;
      clear_trips(master);
    end procedure;

  begin
    wait_clocks(clk, 3);
    reset <= '0';
    wait_clocks(clk, 10);
    -- So short that the window of the first key is always open.
    write(master, heater_control_watchdog_address, 15);
    for channel in 0 to 1 loop
      write(master, heater_control_minimum_count_address, 1_000, channel);
      write(master, heater_control_maximum_count_address, 9_000, channel);
      write(master, heater_control_hot_count_address, 6_000, channel);
      write(master, heater_control_settle_address, settling, channel);
    end loop;
    wait_clocks(clk, conversion);

    -- Feeding.
    for bit_number in 0 to key_bits - 1 loop
      feed_watchdog(master);
      write(master, heater_control_feed_address, flipped(heater_control_feed_key_first, bit_number));
      expect_trip_by_feeding("first key, bit " & to_string(bit_number));
      write(master, heater_control_feed_address, heater_control_feed_key_first);
      write(master, heater_control_feed_address, flipped(heater_control_feed_key_second, bit_number));
      expect_trip_by_feeding("second key, bit " & to_string(bit_number));
    end loop;

    -- The supply and the trips.
    for bit_number in 0 to key_bits - 1 loop
      feed_watchdog(master);
      wait_clocks(clk, 3);
      switch_supply(master, flipped(heater_control_supply_key_close, bit_number));
      closes_only_by_its_key : assert outputs.supply = '0'
        report "closes, bit " & to_string(bit_number) severity error;
      switch_supply(master, heater_control_supply_key_close);
      closes_by_its_key : assert outputs.supply = '1' report "does not close" severity error;
      if flipped(heater_control_supply_key_open, bit_number) /= heater_control_supply_key_close then
        switch_supply(master, flipped(heater_control_supply_key_open, bit_number));
        opens_only_by_its_key : assert outputs.supply = '1'
          report "opens, bit " & to_string(bit_number) severity error;
      end if;
      write(master, heater_control_feed_address, 0);
      wait_clocks(clk, 3);
      clear_trips(master, "0011", flipped(heater_control_clear_key_clear_trips, bit_number));
      expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit);
      expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit, 1);
      clear_trips(master);
    end loop;

    -- While a bit of any duty is set, the supply is not closed, and that channel is not cleared.
    for channel in 0 to 1 loop
      for bit_number in 0 to key_bits - 1 loop
        feed_watchdog(master);
        wait_clocks(clk, 3);
        write(master, heater_control_duty_address, 2 ** bit_number, channel);
        switch_supply(master, heater_control_supply_key_close);
        closes_only_at_rest : assert outputs.supply = '0'
          report "channel " & to_string(channel) & ", bit " & to_string(bit_number) severity error;
        write(master, heater_control_feed_address, 0);
        wait_clocks(clk, 3);
        clear_trips(master);
        expect_trip(master, outputs.interrupt, heater_control_status_watchdog_trip_bit, channel);
        write(master, heater_control_duty_address, 0, channel);
        clear_trips(master);
      end loop;
    end loop;
    std.env.finish;
  end process;

end architecture;
