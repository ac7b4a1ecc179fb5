-- SPDX-License-Identifier: Apache-2.0
-- The timer with a capacitor that charges in a straight line, so that each count and each time is exact: a
-- bench of milliseconds that the mutants are tried on before `capacitor_timer_tb`.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity capacitor_timer_quick_tb is
end entity;

architecture simulation of capacitor_timer_quick_tb is

  constant threshold : natural := 600;
  constant charges : positive := 3;
  constant dither : natural := 7;
  constant discharge : natural := 20;
  constant pause : natural := 9;
  constant longest : natural := 150;

  -- What a clock through each resistor adds to the capacitor.
  type speeds_t is array (0 to resistors - 1) of natural;
  constant usual : speeds_t := (thermistor => 12, reference_low => 60, reference_high => 5);

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  -- Overflows in the first conversion.
  signal seen_cycles : cycles_t := x"FFFF80";
  signal enable, restart : std_ulogic := '0';
  signal settings : converter_settings_t := (
    references => '1', dither_cycles => to_unsigned(dither, 8), more_charges => to_unsigned(charges - 1, 8),
    discharge_cycles => to_unsigned(discharge, 24), timeout_cycles => to_unsigned(longest, 24),
    pause_cycles => to_unsigned(pause, 24), short_limit => to_unsigned(1, 32));
  signal drive_enable, drive_level : std_ulogic_vector(resistors - 1 downto 0);
  signal discharging, sense, updated, changes : std_ulogic;
  signal state : unsigned(2 downto 0);
  signal thermistor_count, reference_low_count, reference_high_count : unsigned(31 downto 0);
  signal wake_cycles : cycles_t;

  signal speeds : speeds_t := usual;
  signal level : natural := 0;
  signal stuck : std_ulogic := '0';
  signal clock_number : natural := 0;
  signal driven : std_ulogic_vector(resistors - 1 downto 0) := "000";

begin

  clk <= not clk after 5 ns;

  timer : entity work.capacitor_timer
    port map (
      clk => clk, reset => reset, seen_cycles => seen_cycles, enable => enable, settings => settings,
      restart => restart, drive_enable => drive_enable, drive_level => drive_level,
      discharging => discharging, sense => sense, updated => updated, state => state,
      thermistor_count => thermistor_count, reference_low_count => reference_low_count,
      reference_high_count => reference_high_count, changes => changes, wake_cycles => wake_cycles);

  sense <= '1' when level >= threshold or stuck = '1' else '0';

  charge : process
    variable wake_before : cycles_t := (others => '0');
    variable discharging_before, discharging_earlier : std_ulogic := '0';
    variable changes_in_turn : natural := 0;
  begin
    wait until rising_edge(clk);
    seen_cycles <= seen_cycles + 1;
    clock_number <= clock_number + 1;
    driven <= driven or drive_enable;
    for i in speeds'range loop
      if drive_enable(i) = '1' and drive_level(i) = '1' then
        level <= level + speeds(i);
      elsif drive_enable(i) = '1' then
        level <= 0;
      end if;
    end loop;
    -- A discharge ends by time alone: two clocks after the one to wake in, and this is a change.
    if discharging = '0' and discharging_before = '1' and enable = '1' and restart = '0' and reset = '0'
      and discharging_earlier = '1' and drive_enable /= "000" then
      reports_a_change : assert changes = '1' report "no change" severity error;
      wakes_in_time : assert wake_before + 3 = seen_cycles
        report to_hstring(wake_before) & " before " & to_hstring(seen_cycles) severity error;
    end if;
    -- Phases of one clock come in short rows only.
    changes_in_turn := changes_in_turn + 1 when changes = '1' else 0;
    does_not_change_all_the_time : assert changes_in_turn <= 5 or enable = '0' or reset = '1'
      report "changes all the time" severity error;
    discharging_earlier := discharging_before;
    discharging_before := discharging;
    wake_before := wake_cycles;
    drives_down_to_discharge : assert discharging = '0' or (drive_enable and drive_level) = "000"
      report "charges while discharging" severity error;
    discharges_through_all : assert discharging = '0'
      or drive_enable = (2 downto 1 => settings.references) & '1'
      report "discharges through " & to_string(drive_enable) severity error;
  end process;

  test : process

    variable before : natural;

    procedure convert (expected : natural; why : string) is
    begin
      wait until rising_edge(clk) and updated = '1' for 100 us;
      converts : assert updated = '1' report why & ": no conversion" severity failure;
      has_its_state : assert state = expected
        report why & ": state " & to_string(to_integer(state)) severity error;
      wait_for_clock(clk);
      reports_once : assert updated = '0' report "updated for two clocks" severity error;
    end procedure;

    procedure expect_counts (of_thermistor, of_low, of_high : natural; why : string) is
    begin
      counts : assert thermistor_count = of_thermistor and reference_low_count = of_low
        and reference_high_count = of_high
        report why & ": " & to_string(to_integer(thermistor_count)) & " "
          & to_string(to_integer(reference_low_count)) & " " & to_string(to_integer(reference_high_count))
        severity error;
    end procedure;

    -- Clocks until `level` is at the threshold, through a resistor that begins at `from`.
    function clocks_from (from, speed : natural) return natural is
    begin
      return (threshold - from + speed - 1) / speed;
    end function;

    -- Of all charges, each with a longer precharge through the high reference.
    function count_of (speed : natural; step : natural := dither) return natural is
      variable sum : natural := 0;
    begin
      for i in 0 to charges - 1 loop
        sum := sum + clocks_from(i * step * usual(reference_high), speed);
      end loop;
      return sum;
    end function;

    constant of_thermistor : natural := count_of(usual(thermistor));
    constant of_low : natural := count_of(usual(reference_low));
    constant of_high : natural := count_of(usual(reference_high));
    -- Each phase takes a clock more than it waits, but the precharge.
    constant whole_conversion : natural := of_thermistor + of_low + of_high
      + 3 * charges * (discharge + 1 + 1) + 3 * dither * (0 + 1 + 2) + 1 + pause + 1;

  begin
    wait_for_clock(clk);
    wait_for_clock(clk);
    reset <= '0';
    for i in 1 to 10 loop
      wait_for_clock(clk);
      is_high_impedance_at_rest : assert drive_enable = "000" and updated = '0' severity error;
    end loop;
    enable <= '1';
    convert(temperature_converter_status_state_ok, "first");
    expect_counts(of_thermistor, of_low, of_high, "first");
    before := clock_number;
    convert(temperature_converter_status_state_ok, "second");
    expect_counts(of_thermistor, of_low, of_high, "second");
    takes_its_time : assert clock_number - before = whole_conversion
      report to_string(clock_number - before) & " clocks instead of " & to_string(whole_conversion)
      severity error;

    -- Below the limit it is shorted, at it not.
    settings.short_limit <= to_unsigned(of_thermistor, 32);
    convert(temperature_converter_status_state_ok, "at the short limit");
    settings.short_limit <= to_unsigned(of_thermistor + 1, 32);
    convert(temperature_converter_status_state_shorted, "below the short limit");
    expect_counts(of_thermistor, of_low, of_high, "shorted");
    settings.short_limit <= to_unsigned(1, 32);

    -- Each resistor that never charges: the clocks of its time-out are its count.
    speeds(thermistor) <= 0;
    convert(temperature_converter_status_state_open, "no thermistor");
    expect_counts(longest + 1, of_low, of_high, "no thermistor");
    speeds <= usual;
    speeds(reference_low) <= 0;
    convert(temperature_converter_status_state_time_out, "no low reference");
    expect_counts(longest + 1, 0, 0, "no low reference");
    speeds <= usual;
    speeds(reference_high) <= 0;
    convert(temperature_converter_status_state_time_out, "no high reference");
    -- Without it there is no precharge either.
    expect_counts(longest + 1, count_of(usual(reference_low), 0), 0, "no high reference");
    speeds <= usual;
    convert(temperature_converter_status_state_ok, "well again");
    expect_counts(of_thermistor, of_low, of_high, "well again");
    -- At the end of the time-out itself the charge counts.
    settings.timeout_cycles <= to_unsigned(clocks_from(0, usual(reference_high)), 24);
    convert(temperature_converter_status_state_ok, "just in time");
    settings.timeout_cycles <= to_unsigned(clocks_from(0, usual(reference_high)) - 2, 24);
    convert(temperature_converter_status_state_time_out, "just too late");
    settings.timeout_cycles <= to_unsigned(longest, 24);
    stuck <= '1';
    convert(temperature_converter_status_state_stuck, "stuck");
    expect_counts(0, 0, 0, "stuck");
    stuck <= '0';
    convert(temperature_converter_status_state_ok, "no longer stuck");
    for discharges in 1 to resistors * charges - 1 loop
      for i in 1 to discharges loop
        wait until discharging'event and discharging = '1';
      end loop;
      stuck <= '1';
      convert(temperature_converter_status_state_stuck, "stuck after " & to_string(discharges));
      stuck <= '0';
      convert(temperature_converter_status_state_ok, "well after " & to_string(discharges));
    end loop;

    -- Other times.
    settings.dither_cycles <= x"00";
    settings.pause_cycles <= to_unsigned(30, 24);
    settings.discharge_cycles <= to_unsigned(11, 24);
    convert(temperature_converter_status_state_ok, "no dither");
    before := clock_number;
    convert(temperature_converter_status_state_ok, "no dither");
    expect_counts(count_of(usual(thermistor), 0), count_of(usual(reference_low), 0),
      count_of(usual(reference_high), 0), "no dither");
    takes_other_times : assert clock_number - before = count_of(usual(thermistor), 0)
      + count_of(usual(reference_low), 0) + count_of(usual(reference_high), 0) + 3 * charges * 13 + 1 + 31
      report to_string(clock_number - before) & " clocks" severity error;
    settings.dither_cycles <= to_unsigned(dither, 8);

    -- A restart anywhere forgets all; nothing of the conversion before is in the next.
    for delay in 0 to 40 loop
      for i in 1 to 13 * delay + 1 loop
        wait_for_clock(clk);
      end loop;
      if delay mod 3 = 0 then
        restart <= '1';
      elsif delay mod 3 = 1 then
        reset <= '1';
      else
        enable <= '0';
      end if;
      wait_for_clock(clk);
      lets_go : assert drive_enable = "000" and discharging = '0' and updated = '0' severity error;
      if delay mod 3 /= 2 then
        forgets : assert state = temperature_converter_status_state_never severity error;
        expect_counts(0, 0, 0, "forgotten");
      else
        for i in 1 to 60 loop
          wait_for_clock(clk);
          rests_while_disabled : assert drive_enable = "000" and updated = '0' severity error;
        end loop;
      end if;
      restart <= '0';
      reset <= '0';
      enable <= '1';
      convert(temperature_converter_status_state_ok, "after a restart");
      expect_counts(of_thermistor, of_low, of_high, "after a restart");
    end loop;

    -- Disabled in the clock in which it would publish, it publishes nothing.
    speeds(thermistor) <= 0;
    -- Nor with a restart in it.
    wait until rising_edge(clk) and discharging = '0' and drive_enable = "001";
    for i in 1 to longest loop
      wait_for_clock(clk);
    end loop;
    restart <= '1';
    wait_for_clock(clk);
    is_not_updated_by_a_restart : assert updated = '0' and state = temperature_converter_status_state_never
      severity error;
    restart <= '0';
    speeds <= usual;
    convert(temperature_converter_status_state_ok, "after a restart at the end");
    speeds(thermistor) <= 0;
    wait until rising_edge(clk) and discharging = '0' and drive_enable = "001";
    for i in 1 to longest loop
      wait_for_clock(clk);
    end loop;
    is_at_its_end : assert discharging = '1' severity error;
    enable <= '0';
    for i in 1 to 10 loop
      wait_for_clock(clk);
      publishes_nothing : assert updated = '0' and state = temperature_converter_status_state_ok
        severity error;
    end loop;
    speeds <= usual;

    -- One resistor alone: no precharge, and the references are never driven.
    settings.references <= '0';
    wait_for_clock(clk);
    driven <= force "000";
    wait_for_clock(clk);
    driven <= release;
    enable <= '1';
    convert(temperature_converter_status_state_ok, "alone");
    expect_counts(charges * clocks_from(0, usual(thermistor)), 0, 0, "alone");
    drives_one_alone : assert driven = "001" report to_string(driven) severity error;
    speeds(thermistor) <= 0;
    convert(temperature_converter_status_state_time_out, "alone and open");
    finish;
  end process;

end architecture;
