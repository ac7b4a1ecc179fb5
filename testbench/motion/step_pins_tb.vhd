-- SPDX-License-Identifier: Apache-2.0
-- The pins are the step generator's until software requests them, and none rises in an emergency.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.random_source_pkg.all;
use work.step_pins_registers_pkg.all;

entity step_pins_tb is
end entity;

architecture simulation of step_pins_tb is

  constant axes : positive := 5;
  subtype pins_t is std_ulogic_vector(axes - 1 downto 0);

  constant software : natural := 2 ** step_pins_control_software_bit;
  constant stopped : natural := 2 ** step_pins_stop_stopped_bit;
  constant permitted : natural := 2 ** step_pins_status_permitted_bit;
  constant refused : natural := 2 ** step_pins_status_refused_bit;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal emergency_stop, software_stepping : std_ulogic := '0';
  signal generator_idle : std_ulogic := '1';
  signal generated_step, generated_direction : pins_t := (others => '0');
  signal step, direction : pins_t;
  signal at_rest : std_ulogic;
  -- The generator has the pins, or they change hands: its edges are not looked at.
  signal software_steps_now : boolean := false;

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  pins : entity work.step_pins
    generic map (axes => axes)
    port map (
      clk => clk, bus_clk => clk, reset => reset, request => to_request(master.request),
      to_wires(response) => master.response, software_stepping => software_stepping,
      emergency_stop => emergency_stop, generated_step => generated_step,
      generated_direction => generated_direction, generator_idle => generator_idle, step => step,
      direction => direction, at_rest => at_rest);

  watch_emergency : process
    variable stopped_before : std_ulogic := '0';
    variable step_before : pins_t := (others => '0');
  begin
    wait until rising_edge(clk);
    no_step_rises_from_the_next_clock_on : assert not software_steps_now or stopped_before = '0'
      or (step and not step_before) = (step'range => '0')
      report to_string(step) & " after " & to_string(step_before) severity error;
    stopped_before := emergency_stop;
    step_before := step;
  end process;

  check : process
    variable random : random_source_t;
    variable word : word_t;
    variable wanted, random_direction : pins_t;

    impure function random_pins return pins_t is
    begin
      return std_ulogic_vector(to_unsigned(random.between(0, 2 ** axes - 1), axes));
    end function;

    procedure write_pins (address : unsigned(31 downto 0); levels : pins_t) is
    begin
      write(master, address, to_integer(unsigned(levels)));
    end procedure;

    procedure expect (address : unsigned(31 downto 0); value : natural; claim : string) is
    begin
      read(master, address, word);
      assert unsigned(word) = value report claim & ": " & to_hstring(word) severity error;
    end procedure;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
      wait until falling_edge(clk);
    end procedure;
  begin
    random.seed(3, 3);
    wait_clocks(2);
    reset <= '0';
    -- A stray store does not take the pins from the generator: software needs the strap for that.
    wait until rising_edge(clk);
    write(master, step_pins_control_address, software);
    expect(step_pins_control_address, 0, "a stray store selects nothing");
    write_pins(step_pins_step_address, pins_t'(others => '1'));
    generated_step <= "01010";
    wait_clocks(2);
    a_stray_store_takes_no_pin : assert step = "01010" severity error;
    wait until rising_edge(clk);
    expect(step_pins_status_address, refused, "the refusal is reported");
    write(master, step_pins_status_address, refused);
    write(master, step_pins_control_address, 0);
    expect(step_pins_status_address, 0, "a store without effect is not refused");

    -- Without being asked, software's registers reach no pin, and the generator's pins pass at once.
    wait_clocks(1);
    write_pins(step_pins_step_address, pins_t'(others => '1'));
    write_pins(step_pins_direction_address, pins_t'(others => '1'));
    for i in 1 to 200 loop
      wait until falling_edge(clk);
      generated_step <= random_pins;
      generated_direction <= random_pins;
      wait for 1 ns;
      the_generator_steps : assert step = generated_step severity error;
      the_generator_turns : assert direction = generated_direction severity error;
    end loop;

    -- With the strap they change hands only where nothing moves and no pin would change.
    software_stepping <= '1';
    generated_step <= "00100";
    write(master, step_pins_step_address, 0);
    write(master, step_pins_control_address, software);
    expect(step_pins_control_address, 0, "no edge is lost");
    generated_step <= (others => '0');
    generator_idle <= '0';
    write(master, step_pins_control_address, software);
    expect(step_pins_control_address, 0, "nothing changes in motion");
    expect(step_pins_status_address, permitted + refused, "the refusals are reported");
    write(master, step_pins_status_address, 0);
    expect(step_pins_status_address, permitted + refused, "zero forgets nothing");
    write(master, step_pins_status_address, refused);
    -- Nor where a pin would rise by it, of software's more than of the generator's.
    generator_idle <= '1';
    write(master, step_pins_step_address, 2#00110#);
    generated_step <= "00100";
    write(master, step_pins_control_address, software);
    expect(step_pins_control_address, 0, "no edge is made");
    generated_step <= (others => '0');
    write(master, step_pins_step_address, 0);
    wait_clocks(1);
    wait until rising_edge(clk);
    write(master, step_pins_status_address, refused);
    generator_idle <= '1';
    write(master, step_pins_control_address, software);
    expect(step_pins_status_address, permitted, "it may change at rest");
    expect(step_pins_control_address, software, "software has them");

    -- Software's pins, whatever the generator does, all in one clock.
    for i in 1 to 200 loop
      generated_step <= random_pins;
      generated_direction <= random_pins;
      wanted := random_pins;
      random_direction := random_pins;
      wait until rising_edge(clk);
      write_pins(step_pins_direction_address, random_direction);
      write_pins(step_pins_step_address, wanted);
      wait_clocks(1);
      software_steps : assert step = wanted severity error;
      software_turns : assert direction = random_direction severity error;
      read(master, step_pins_step_address, word);
      it_reads_what_it_wrote : assert word(axes - 1 downto 0) = wanted severity error;
    end loop;

    -- In an emergency pulses that are out end when software ends them, and none begins.
    write(master, step_pins_step_address, 2#01101#);
    wait_clocks(3);
    emergency_stop <= '1';
    wait_clocks(20);
    a_pulse_keeps_its_width : assert step = "01101" severity error;
    wait until rising_edge(clk);
    write(master, step_pins_step_address, 2#11001#);
    wait_clocks(3);
    only_falls : assert step = "01001" severity error;
    wait until rising_edge(clk);
    write(master, step_pins_stop_address, stopped);
    write(master, step_pins_step_address, 2#11111#);
    wait_clocks(3);
    no_acknowledgement_while_it_lasts : assert step = "01001" severity error;

    -- It is remembered until it is acknowledged.
    emergency_stop <= '0';
    wait_clocks(5);
    still_stopped : assert step = "01001" severity error;
    wait until rising_edge(clk);
    expect(step_pins_stop_address, stopped, "reports");
    write(master, step_pins_stop_address, 0);
    wait_clocks(3);
    zero_acknowledges_nothing : assert step = "01001" severity error;
    wait until rising_edge(clk);
    write(master, step_pins_step_address, 0);
    write(master, step_pins_stop_address, stopped);
    write(master, step_pins_step_address, 2#10110#);
    wait_clocks(3);
    steps_again : assert step = "10110" severity error;
    wait until rising_edge(clk);
    expect(step_pins_stop_address, 0, "reports that it is over");

    -- The generator is not stopped here: it has a stop latch of its own.
    write(master, step_pins_step_address, 0);
    generated_step <= (others => '0');
    wait_clocks(3);
    wait until rising_edge(clk);
    write(master, step_pins_control_address, 0);
    emergency_stop <= '1';
    generated_step <= "10101";
    wait_clocks(2);
    generator_passes : assert step = "10101" severity error;
    emergency_stop <= '0';
    generated_step <= (others => '0');
    wait until rising_edge(clk);
    write(master, step_pins_stop_address, stopped);

    -- An emergency in any clock of a write that raises pins.
    write(master, step_pins_control_address, software);
    for delay in 0 to 6 loop
      write(master, step_pins_step_address, 0);
      write(master, step_pins_stop_address, stopped);
      wait_clocks(4);
      software_steps_now <= true;
      wait_clocks(1);
      emergency_stop <= '1' after delay * 10 ns;
      wait until rising_edge(clk);
      write(master, step_pins_step_address, 2#11111#);
      wait_clocks(8);
      emergency_stop <= '0';
      software_steps_now <= false;
      wait until rising_edge(clk);
    end loop;
    write(master, step_pins_step_address, 0);
    write(master, step_pins_stop_address, stopped);
    wait_clocks(4);

    -- Without the strap the pins are the generator's, whatever was chosen with it.
    wait until rising_edge(clk);
    write(master, step_pins_step_address, 2#01100#);
    write(master, step_pins_direction_address, 2#00011#);
    wait_clocks(4);
    is_software_s : assert step = "01100" and direction = "00011" severity error;
    software_stepping <= '0';
    generated_step <= "10000";
    generated_direction <= "01000";
    wait_clocks(1);
    is_the_generator_s : assert step = "10000" and direction = "01000" severity error;
    software_stepping <= '1';
    wait_clocks(1);
    is_software_s_again : assert step = "01100" and direction = "00011" severity error;

    -- It rests but for the first clock of an emergency.
    wait_clocks(40);
    rests : assert at_rest = '1' severity error;
    emergency_stop <= '1';
    wait for 1 ns;
    is_awake_for_an_emergency : assert at_rest = '0' severity error;
    wait_clocks(40);
    rests_while_it_lasts : assert at_rest = '1' severity error;
    emergency_stop <= '0';
    wait_clocks(40);
    rests_when_it_is_over : assert at_rest = '1' severity error;

    -- A reset gives the pins back, forgets the stop, a refusal, and what software drove.
    wait until rising_edge(clk);
    write(master, step_pins_control_address, 0);
    expect(step_pins_status_address, permitted + refused, "is refused with pins high");
    wait until falling_edge(clk);
    reset <= '1';
    wait_clocks(1);
    reset <= '0';
    is_the_generator_s_after_reset : assert step = "10000" and direction = "01000" severity error;
    wait until rising_edge(clk);
    expect(step_pins_control_address, 0, "control is reset");
    expect(step_pins_status_address, permitted, "no refusal is left");
    expect(step_pins_stop_address, 0, "no stop is left");
    generated_step <= (others => '0');
    write(master, step_pins_control_address, software);
    wait_clocks(1);
    no_pin_is_left : assert step = "00000" and direction = "00000" severity error;
    -- Also in the clocks of the reset itself, as soon as it is seen.
    wait until rising_edge(clk);
    write(master, step_pins_step_address, 2#11111#);
    write(master, step_pins_direction_address, 2#11111#);
    wait_clocks(4);
    reset <= '1';
    wait until rising_edge(clk);
    wait for 1 ns;
    reset <= '0';
    generated_step <= "00000";
    is_low_after_a_reset : assert step = "00000" severity error;
    wait_clocks(4);
    std.env.finish;
  end process;

end architecture;
