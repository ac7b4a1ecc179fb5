-- SPDX-License-Identifier: Apache-2.0
-- The pins are the step generator's until software asks for them, and none rises in an emergency.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.step_pins_registers_pkg.all;

entity step_pins_tb is
end entity;

architecture simulation of step_pins_tb is

  constant axes : positive := 5;
  subtype pins_t is std_ulogic_vector(axes - 1 downto 0);

  constant control : unsigned(31 downto 0) := step_pins_address;
  constant step_register : unsigned(31 downto 0) := step_pins_address + 4;
  constant direction_register : unsigned(31 downto 0) := step_pins_address + 8;
  constant stop : unsigned(31 downto 0) := step_pins_address + 12;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal emergency_stop : std_ulogic := '0';
  signal generated_step, generated_direction : pins_t := (others => '0');
  signal step, direction : pins_t;

begin

  clk <= not clk after 5 ns;

  pins : entity work.step_pins
    generic map (axes => axes)
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => request, response => response,
      emergency_stop => emergency_stop, generated_step => generated_step,
      generated_direction => generated_direction, step => step, direction => direction);

  check : process
    variable seed_1, seed_2 : positive := 3;
    variable word : word_t;
    variable wanted, random_direction : pins_t;

    impure function random_pins return pins_t is
      variable chance : real;
    begin
      uniform(seed_1, seed_2, chance);
      return std_ulogic_vector(to_unsigned(integer(floor(chance * 32.0)), axes));
    end function;

    procedure write (address : unsigned(31 downto 0); value : natural) is
    begin
      bus_write(clk, request, response, address, value);
    end procedure;

    procedure write (address : unsigned(31 downto 0); value : pins_t) is
    begin
      write(address, to_integer(unsigned(value)));
    end procedure;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
      wait until falling_edge(clk);
    end procedure;
  begin
    wait_clocks(2);
    reset <= '0';

    -- Without being asked, software's registers reach no pin, and the generator's pins pass at once.
    wait_clocks(1);
    write(step_register, pins_t'(others => '1'));
    write(direction_register, pins_t'(others => '1'));
    for i in 1 to 200 loop
      wait until falling_edge(clk);
      generated_step <= random_pins;
      generated_direction <= random_pins;
      wait for 1 ns;
      the_generator_steps : assert step = generated_step severity error;
      the_generator_turns : assert direction = generated_direction severity error;
    end loop;

    -- Software's pins, whatever the generator does, all in one clock.
    write(step_register, 0);
    write(control, 1);
    for i in 1 to 200 loop
      generated_step <= random_pins;
      generated_direction <= random_pins;
      wanted := random_pins;
      random_direction := random_pins;
      wait until rising_edge(clk);
      write(direction_register, random_direction);
      write(step_register, wanted);
      wait_clocks(1);
      software_steps : assert step = wanted severity error;
      software_turns : assert direction = random_direction severity error;
      bus_read(clk, request, response, step_register, word);
      it_reads_what_it_wrote : assert word(axes - 1 downto 0) = wanted severity error;
    end loop;

    -- In an emergency pulses that are out end when software ends them, and none begins.
    write(step_register, 2#01101#);
    wait_clocks(3);
    emergency_stop <= '1';
    wait_clocks(20);
    a_pulse_keeps_its_width : assert step = "01101" severity error;
    wait until rising_edge(clk);
    write(step_register, 2#11001#);
    wait_clocks(3);
    only_falls : assert step = "01001" severity error;
    wait until rising_edge(clk);
    write(stop, 1);
    write(step_register, 2#11111#);
    wait_clocks(3);
    no_acknowledgement_while_it_lasts : assert step = "01001" severity error;

    -- It is remembered until it is acknowledged.
    emergency_stop <= '0';
    wait_clocks(5);
    still_stopped : assert step = "01001" severity error;
    wait until rising_edge(clk);
    bus_read(clk, request, response, stop, word);
    tells : assert word = x"00000001" severity error;
    write(stop, 0);
    wait_clocks(3);
    zero_acknowledges_nothing : assert step = "01001" severity error;
    wait until rising_edge(clk);
    write(step_register, 0);
    write(stop, 1);
    write(step_register, 2#10110#);
    wait_clocks(3);
    steps_again : assert step = "10110" severity error;
    wait until rising_edge(clk);
    bus_read(clk, request, response, stop, word);
    tells_that_it_is_over : assert word = x"00000000" severity error;

    -- The generator is not stopped here: it has a stop latch of its own.
    write(control, 0);
    emergency_stop <= '1';
    generated_step <= "10101";
    wait_clocks(2);
    generator_passes : assert step = "10101" severity error;
    report "step_pins_tb passed";
    std.env.finish;
  end process;

end architecture;
