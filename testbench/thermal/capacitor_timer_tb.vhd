-- SPDX-License-Identifier: Apache-2.0
-- Three charge times give the thermistor's resistance, finer than a clock; each way to fail has its name.

library ieee;
use ieee.math_real.all;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity capacitor_timer_tb is
end entity;

architecture simulation of capacitor_timer_tb is

  constant charges : positive := 8;
  -- 68 nF at 4 MHz.
  constant clocks_per_ohm : real := 68.0e-9 * 4.0e6;
  constant ohms_per_count : real := 1.0 / (clocks_per_ohm * log(2.0) * real(charges));

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  -- Begins shortly before it overflows.
  signal seen_cycles : unsigned(23 downto 0) := x"FFFF00";
  signal enable : std_ulogic := '0';
  signal references : std_ulogic := '1';
  signal dither_cycles : unsigned(7 downto 0) := to_unsigned(2, 8);
  signal discharge_cycles : unsigned(23 downto 0) := to_unsigned(1_500, 24);
  signal timeout_cycles : unsigned(23 downto 0) := to_unsigned(60_000, 24);
  signal short_limit : unsigned(31 downto 0) := to_unsigned(8 * 12, 32);
  signal drive_enable, drive_level : std_ulogic_vector(resistors - 1 downto 0);
  signal discharging, sense, updated : std_ulogic;
  signal state : unsigned(2 downto 0);
  signal thermistor_count, reference_low_count, reference_high_count : unsigned(31 downto 0);

  signal restart : std_ulogic := '0';

  signal thermistor_ohms : real := 1_000.0;
  signal stuck_high, stuck_low : std_ulogic := '0';
  -- Pins that were ever driven since it was cleared.
  signal ever_driven : std_ulogic_vector(resistors - 1 downto 0) := (others => '0');
  signal forget : std_ulogic := '0';

begin

  clk <= not clk after 5 ns;

  count_cycles : process
  begin
    wait until rising_edge(clk);
    seen_cycles <= seen_cycles + 1;
  end process;

  timer : entity work.capacitor_timer
    port map (
      clk => clk, reset => reset, seen_cycles => seen_cycles, enable => enable,
      settings => (
        references => references, more_charges => to_unsigned(charges - 1, 8), dither_cycles => dither_cycles,
        discharge_cycles => discharge_cycles, timeout_cycles => timeout_cycles,
        pause_cycles => to_unsigned(10, 24), short_limit => short_limit),
      restart => restart,
      drive_enable => drive_enable, drive_level => drive_level, discharging => discharging,
      sense => sense, updated => updated, state => state, thermistor_count => thermistor_count,
      reference_low_count => reference_low_count, reference_high_count => reference_high_count);

  circuit : entity work.sensor_circuit
    generic map (clocks_per_ohm => clocks_per_ohm)
    port map (
      clk => clk, drive_enable => drive_enable, drive_level => drive_level,
      thermistor_ohms => thermistor_ohms, stuck_high => stuck_high, stuck_low => stuck_low,
      sense => sense);

  watch_pins : process
  begin
    wait until rising_edge(clk);
    if forget then
      ever_driven <= (others => '0');
    else
      ever_driven <= ever_driven or drive_enable;
    end if;
    pulls_down_only_while_discharging : assert
      discharging = '0' or (drive_enable and drive_level) = "000"
      report "charges while discharging" severity error;
  end process;

  check : process

    procedure convert is
    begin
      wait until rising_edge(clk) and updated = '1' for 100 ms;
      converts : assert updated = '1' report "no conversion" severity failure;
      wait until rising_edge(clk);
      reports_once : assert updated = '0' report "updated for two clocks" severity error;
    end procedure;

    -- Once more, if a conversion has begun before what it is to see.
    procedure convert_again is
    begin
      convert;
      convert;
    end procedure;

    impure function measured_ohms return real is
      constant above_low : real := real(to_integer(thermistor_count)) - real(to_integer(reference_low_count));
      constant span : real := real(to_integer(reference_high_count)) - real(to_integer(reference_low_count));
    begin
      return 470.0 + 9_530.0 * above_low / span;
    end function;

    procedure expect (expected : natural; why : string) is
    begin
      convert;
      has_its_state : assert state = expected
        report why & ": state " & to_string(to_integer(state)) severity error;
    end procedure;

    procedure measures (ohms, tolerance : real) is
    begin
      thermistor_ohms <= ohms;
      expect(temperature_converter_status_state_ok, "a thermistor");
      is_right : assert abs (measured_ohms - ohms) < tolerance
        report to_string(ohms) & " ohms measured as " & to_string(measured_ohms) severity error;
    end procedure;

    variable worst_dithered, worst_plain : real := 0.0;
  begin
    for i in 1 to 3 loop
      wait until rising_edge(clk);
    end loop;
    reset <= '0';
    wait for 1 us;
    is_high_impedance_at_rest : assert drive_enable = "000" report "drives without need" severity error;
    enable <= '1';

    -- 300 to 10 degrees of a 100 kOhm NTC; at most 0.5 %, and a few counts of the references.
    measures(144.0, 2.0);
    measures(645.0, 3.0);
    measures(2_000.0, 10.0);
    measures(20_000.0, 100.0);
    measures(100_000.0, 1_000.0);

    -- Steps of a third of a clock per charge at about 200 degrees.
    for step in 0 to 11 loop
      thermistor_ohms <= 640.0 + real(step) * 1.9;
      dither_cycles <= to_unsigned(2, 8);
      convert;
      worst_dithered := maximum(worst_dithered, abs (measured_ohms - thermistor_ohms));
      dither_cycles <= to_unsigned(0, 8);
      convert;
      worst_plain := maximum(worst_plain, abs (measured_ohms - thermistor_ohms));
    end loop;
    dither_finds_parts_of_a_clock : assert worst_dithered < 0.3 * ohms_per_count * real(charges)
      report "dithered error " & to_string(worst_dithered) & " ohms" severity error;
    dither_pays : assert worst_dithered < 0.6 * worst_plain
      report to_string(worst_dithered) & " against " & to_string(worst_plain) severity error;
    dither_cycles <= to_unsigned(2, 8);

    thermistor_ohms <= -1.0;
    expect(temperature_converter_status_state_open, "a broken wire");
    thermistor_ohms <= 1.0;
    expect(temperature_converter_status_state_shorted, "a short");
    thermistor_ohms <= 1_000.0;
    stuck_high <= '1';
    expect(temperature_converter_status_state_stuck, "a pin at 1");
    stuck_high <= '0';
    stuck_low <= '1';
    expect(temperature_converter_status_state_time_out, "a pin at 0");
    stuck_low <= '0';
    expect(temperature_converter_status_state_ok, "all well again");

    -- New settings begin a new conversion, and the one before them does not count.
    restart <= '1';
    wait until rising_edge(clk);
    restart <= '0';
    wait until rising_edge(clk);
    forgets_at_a_restart : assert state = 0 and thermistor_count = 0 and drive_enable = "000"
      report "a restart leaves something" severity error;
    measures(1_000.0, 10.0);

    -- One resistor alone: it has to empty the capacitor too.
    references <= '0';
    discharge_cycles <= to_unsigned(20_000, 24);
    convert_again;
    forget <= '1';
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    forget <= '0';
    convert_again;
    works_without_references : assert state = temperature_converter_status_state_ok
      and abs (real(to_integer(thermistor_count)) * ohms_per_count - 1_000.0) < 20.0
      report "counts " & to_string(to_integer(thermistor_count)) severity error;
    leaves_absent_references_alone : assert ever_driven = "001"
      report to_string(ever_driven) severity error;
    has_no_reference_counts : assert reference_low_count = 0 and reference_high_count = 0
      report "counts of absent references" severity error;
    thermistor_ohms <= -1.0;
    expect(temperature_converter_status_state_time_out, "a broken wire, alone");

    enable <= '0';
    wait for 1 us;
    lets_go_when_disabled : assert drive_enable = "000" report "drives while disabled" severity error;
    enable <= '1';
    reset <= '1';
    wait for 1 us;
    forgets_at_reset : assert state = 0 and thermistor_count = 0 and drive_enable = "000"
      report "reset leaves something" severity error;
    std.env.finish;
  end process;

end architecture;
