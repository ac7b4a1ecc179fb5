-- SPDX-License-Identifier: Apache-2.0
-- Settings change only when idle, the kind of edges only of a pin that is low, the floor never to 0.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.bus_master_pkg.all;
use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity motion_settings_tb is
end entity;

architecture simulation of motion_settings_tb is

  constant axes : positive := 2;
  constant rate_floor_register : unsigned(31 downto 0) := step_generator_rate_floor_address;
  constant pulse_guard : unsigned(31 downto 0) := step_generator_pulse_guard_address;
  constant direction_guard : unsigned(31 downto 0) := step_generator_direction_guard_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal from_software : step_generator_from_software_t;
  signal to_software : step_generator_to_software_t;
  signal idle : std_ulogic := '1';
  signal step : std_ulogic_vector(axes - 1 downto 0) := "00";
  signal guards : guard_array_t(axes - 1 downto 0);
  signal both_edges : std_ulogic_vector(axes - 1 downto 0);
  signal rate_floor : unsigned(30 downto 0);
  signal refused : std_ulogic;
  signal refusals : natural := 0;

  alias clk is master.clk;

begin

  make_clock(master.clk, 20 ns);

  registers : entity work.step_generator_registers
    port map (
      clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, from_software => from_software,
      to_software => to_software);

  settings : entity work.motion_settings
    generic map (axes => axes)
    port map (
      clk => clk, reset => reset, from_software => from_software, idle => idle, step => step,
      guards => guards, both_edges => both_edges, rate_floor => rate_floor, refused => refused);

  count : process
  begin
    wait until rising_edge(clk);
    if refused then
      refusals <= refusals + 1;
    end if;
  end process;

  test : process
    function pulse(high, low : natural; edges : std_ulogic := '0') return word_t is
    begin
      return to_word(step_generator_pulse_guard_t'(
        high => to_unsigned(high, 12), low => to_unsigned(low, 12), both_edges => edges));
    end function;

    function turn(setup, hold : natural) return word_t is
    begin
      return to_word(step_generator_direction_guard_t'(
        setup => to_unsigned(setup, 12), hold => to_unsigned(hold, 12)));
    end function;

    procedure write(address : unsigned(31 downto 0); data : word_t; refusal : boolean) is
      variable before : natural;
    begin
      before := refusals;
      write(master, address, data);
      wait until rising_edge(clk);
      wait until rising_edge(clk);
      assert (refusals /= before) = refusal
        report to_hstring(address) & " is " & to_hstring(data) severity failure;
    end procedure;
  begin
    wait until rising_edge(clk);
    reset <= '0';
    wait until rising_edge(clk);
    assert guards(1) = guard_after_reset and rate_floor = rate_floor_after_reset severity failure;

    write(pulse_guard + 4, pulse(2, 3, edges => '1'), false);
    write(direction_guard, turn(4, 5), false);
    write(rate_floor_register, word_t(to_unsigned(7, 32)), false);
    assert guards(1).high = 2 and guards(1).low = 3 and both_edges = "10" severity failure;
    assert guards(0).direction_setup = 4 and guards(0).direction_hold = 5 severity failure;
    assert guards(0).high = 50 and rate_floor = 7 severity failure;

    idle <= '0';
    write(pulse_guard + 4, pulse(3, 3), true);
    write(direction_guard, turn(6, 6), true);
    write(rate_floor_register, word_t(to_unsigned(8, 32)), true);
    assert guards(1).high = 2 and both_edges = "10" and guards(0).direction_setup = 4 and
      rate_floor = 7 severity failure;
    -- Of axes that this build does not have nothing is asked.
    write(pulse_guard + 8, pulse(3, 3), false);

    idle <= '1';
    write(rate_floor_register, word_t(to_unsigned(0, 32)), true);
    assert rate_floor = 7 severity failure;
    step <= "10";
    write(pulse_guard + 4, pulse(3, 3), true);
    write(pulse_guard + 4, pulse(4, 4, edges => '1'), false);
    write(pulse_guard, pulse(4, 4, edges => '1'), false);
    assert guards(1).high = 4 and both_edges = "11" severity failure;
    step <= "00";
    write(pulse_guard + 4, pulse(5, 5), false);
    assert guards(1).high = 5 and both_edges = "01" severity failure;
    -- Nor from one edge to both.
    step <= "11";
    write(pulse_guard + 4, pulse(6, 6, edges => '1'), true);
    assert guards(1).high = 5 and both_edges = "01" severity failure;
    step <= "00";

    reset <= '1';
    wait until rising_edge(clk);
    wait for 1 ns;
    for axis in guards'range loop
      assert guards(axis) = guard_after_reset severity failure;
    end loop;
    assert both_edges = "00" and rate_floor = rate_floor_after_reset severity failure;
    finish;
  end process;

end architecture;
