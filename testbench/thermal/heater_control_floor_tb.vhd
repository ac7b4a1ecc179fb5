-- SPDX-License-Identifier: Apache-2.0
-- The built-in floor of the cut-off follows the shortest charge that the chip is built for, up to
-- the longest of them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.clocked_bench_pkg.all;
use work.heater_control_registers_pkg.all;
use work.thermal_pkg.all;

entity heater_control_floor_tb is
end entity;

architecture simulation of heater_control_floor_tb is

  constant clock_frequency_hz : positive := 100_000_000;
  constant charges : positive := 16;

  signal reset : std_ulogic := '1';
  signal done : std_ulogic_vector(0 to 2) := "000";
  signal readings : sensor_reading_array_t(0 to 0) := (others => sensor_reading_none);

begin

  each_build : for build in 0 to 2 generate

    type least_charges_t is array (0 to 2) of positive;
    constant least_charges : least_charges_t := (1, 4, 64);
    constant least_charge : positive := least_charges(build);
    -- Clocks of so many 2^-20 s, whole ones, for each charge.
    constant floor_count : positive := clock_frequency_hz / 64 * least_charge / 2 ** 14 * charges;

    signal master : bus_master_t := bus_master_idle;

  begin

    make_clock(master.clk, 10 ns);

    control : entity work.heater_control
      generic map (channels => 1, least_charge => least_charge)
      port map (
        clk => master.clk, always_clk => master.clk, bus_clk => master.clk,
        clock_frequency_hz => to_unsigned(clock_frequency_hz, 32), reset => reset,
        request => to_request(master.request), to_wires(response) => master.response,
        readings => readings, more_charges => to_unsigned(charges - 1, 8), limits_locked => open,
        emergency_stop => '0', veto => '0', gates => open, supply => open, interrupt => open,
        at_rest => open);

    test : process
      constant refused : natural := 2 ** heater_control_status_refused_bit;
      constant locked : natural := 2 ** heater_control_status_minimum_locked_bit;
    begin
      wait until rising_edge(master.clk) and reset = '0';
      wait_clocks(master.clk, 5);
      write(master, heater_control_minimum_count_address, floor_count - 1);
      wait_clocks(master.clk, 3);
      expect(master, heater_control_status_address, refused);
      expect(master, heater_control_minimum_count_address, x"FFFFFFFF");
      write(master, heater_control_minimum_count_address, floor_count);
      wait_clocks(master.clk, 3);
      expect(master, heater_control_minimum_count_address, floor_count);
      expect(master, heater_control_status_address, refused + locked);
      done(build) <= '1';
      wait;
    end process;

  end generate;

  run : process
  begin
    wait for 50 ns;
    reset <= '0';
    wait until done = "111" for 5 us;
    ends : assert done = "111" report to_string(done) severity failure;
    std.env.finish;
  end process;

end architecture;
