-- SPDX-License-Identifier: Apache-2.0
-- Settings change one by one, begin a new conversion, and stay while a limit is set, whatever is written.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.clocked_bench_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity converter_settings_tb is
end entity;

architecture simulation of converter_settings_tb is

  constant frequency : natural := 12_345_678;
  constant longest_charge : natural := frequency / 8;

  constant nothing_written : temperature_converter_from_software_t := (
    control => ('0', '0', x"00", x"00"), control_written => '0',
    discharge => (cycles => x"000000"), discharge_written => '0',
    timeout => (cycles => x"000000"), timeout_written => '0',
    pause => (cycles => x"000000"), pause_written => '0',
    short_limit => (cycles => x"00000000"), short_limit_written => '0',
    settings_lock => ('0', '0'), settings_lock_written => '0');

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal clock_frequency_hz : unsigned(31 downto 0) := to_unsigned(frequency, 32);
  signal limits_locked : std_ulogic := '0';
  signal from_software : temperature_converter_from_software_t := nothing_written;
  signal enable, restart, refused : std_ulogic;
  signal settings : converter_settings_t;

begin

  clk <= not clk after 10 ns;

  keep : entity work.converter_settings
    port map (
      clk => clk, reset => reset, clock_frequency_hz => clock_frequency_hz,
      limits_locked => limits_locked, from_software => from_software, enable => enable,
      settings => settings, restart => restart, refused => refused);

  test : process

    variable expected : converter_settings_t := converter_settings_none;
    variable expected_enable, expected_refused : std_ulogic := '0';

    procedure check (what : string; expected_restart : std_ulogic := '0') is
    begin
      holds_its_settings : assert settings = expected report what & ": settings" severity error;
      is_enabled : assert enable = expected_enable
        report what & ": enable is " & to_string(enable) severity error;
      says_what_it_refused : assert refused = expected_refused
        report what & ": refused is " & to_string(refused) severity error;
      begins_a_conversion : assert restart = expected_restart
        report what & ": restart is " & to_string(restart) severity error;
    end procedure;

    -- One register, as `from_software` says.
    procedure write (what : string; changes : boolean) is
      variable begins : std_ulogic := '0';
    begin
      if changes and limits_locked = '1' then
        expected_refused := '1';
      elsif changes then
        begins := '1';
      end if;
      wait_for_clock(clk);
      from_software.control_written <= '0';
      from_software.discharge_written <= '0';
      from_software.timeout_written <= '0';
      from_software.pause_written <= '0';
      from_software.short_limit_written <= '0';
      check(what, begins);
      wait_for_clock(clk);
      check(what & ", a clock later");
    end procedure;

    procedure write_control (
      on_off, references : std_ulogic; dither, charges : natural; changes : boolean := true) is
    begin
      from_software.control <= (on_off, references, to_unsigned(dither, 8), to_unsigned(charges, 8));
      from_software.control_written <= '1';
      expected_enable := on_off;
      if limits_locked = '0' then
        expected.references := references;
        expected.dither_cycles := to_unsigned(dither, 8);
        expected.more_charges := to_unsigned(charges, 8);
      end if;
      write("control", changes);
    end procedure;

    procedure write_timeout (cycles, kept : natural; changes : boolean := true) is
    begin
      from_software.timeout.cycles <= to_unsigned(cycles, 24);
      from_software.timeout_written <= '1';
      if limits_locked = '0' then
        expected.timeout_cycles := to_unsigned(kept, 24);
      end if;
      write("time-out of " & to_string(cycles), changes);
    end procedure;

    procedure write_others (discharge, pause, short : natural; changes : boolean := true) is
    begin
      from_software.discharge.cycles <= to_unsigned(discharge, 24);
      from_software.discharge_written <= '1';
      if limits_locked = '0' then
        expected.discharge_cycles := to_unsigned(discharge, 24);
      end if;
      write("discharge", changes);
      from_software.pause.cycles <= to_unsigned(pause, 24);
      from_software.pause_written <= '1';
      if limits_locked = '0' then
        expected.pause_cycles := to_unsigned(pause, 24);
      end if;
      write("pause", changes);
      from_software.short_limit.cycles <= to_unsigned(short, 32);
      from_software.short_limit_written <= '1';
      if limits_locked = '0' then
        expected.short_limit := to_unsigned(short, 32);
      end if;
      write("short limit", changes);
    end procedure;

    procedure write_lock (forget : std_ulogic; written : std_ulogic := '1') is
    begin
      from_software.settings_lock.refused <= forget;
      from_software.settings_lock_written <= written;
      wait_for_clock(clk);
      from_software.settings_lock_written <= '0';
      if forget = '1' and written = '1' then
        expected_refused := '0';
      end if;
      check("settings lock");
    end procedure;

    procedure start_again is
    begin
      reset <= '1';
      wait_for_clock(clk);
      reset <= '0';
      expected_enable := '0';
      expected_refused := '0';
      if limits_locked = '0' then
        expected := converter_settings_none;
        check("reset", '1');
      else
        check("reset while locked");
      end if;
      wait_for_clock(clk);
      check("after reset");
    end procedure;

  begin
    wait_for_clock(clk);
    start_again;
    -- A time-out is at most an eighth of a second.
    write_timeout(longest_charge - 1, longest_charge - 1);
    write_timeout(longest_charge, longest_charge);
    write_timeout(longest_charge + 1, longest_charge, changes => false);
    write_timeout(2 ** 24 - 1, longest_charge, changes => false);
    write_timeout(100_000, 100_000);
    write_timeout(2 ** 24 - 1, longest_charge);
    clock_frequency_hz <= to_unsigned(100_000_000, 32);
    write_timeout(12_500_001, 12_500_000);
    write_timeout(16#654321#, 16#654321#);

    -- Each alone; to write what is there already begins nothing.
    write_control('0', '1', 0, 0);
    write_control('0', '1', 16#A5#, 0);
    write_control('0', '1', 16#A5#, 16#3C#);
    write_control('0', '1', 16#A5#, 16#3C#, changes => false);
    write_control('1', '1', 16#A5#, 16#3C#, changes => false);
    write_control('0', '1', 16#A5#, 16#3C#, changes => false);
    write_control('1', '1', 16#A5#, 16#3C#, changes => false);
    write_others(16#123456#, 16#ABCDEF#, 16#789ABCDE#);
    write_others(16#123456#, 16#ABCDEF#, 16#789ABCDE#, changes => false);
    write_others(1, 2, 3);

    -- What is not written has no effect.
    from_software.control <= ('0', '0', x"11", x"22");
    from_software.discharge.cycles <= x"333333";
    from_software.timeout.cycles <= x"444444";
    from_software.pause.cycles <= x"555555";
    from_software.short_limit.cycles <= x"66666666";
    wait_for_clock(clk);
    check("nothing written");

    -- The lock itself begins a conversion: in its first clock.
    limits_locked <= '1';
    wait for 1 ns;
    check("limits locked", '1');
    wait_for_clock(clk);
    check("limits stay locked");
    wait_for_clock(clk);
    check("limits stay locked");
    write_control('0', '1', 16#A5#, 16#3C#, changes => false);
    write_control('1', '1', 16#A5#, 16#3C#, changes => false);
    write_control('1', '0', 16#A5#, 16#3C#);
    write_lock('0');
    write_lock('1', written => '0');
    write_lock('1');
    write_control('0', '1', 16#A4#, 16#3C#);
    write_lock('1');
    write_control('1', '1', 16#A5#, 16#3D#);
    write_lock('1');
    write_timeout(16#654320#, 0);
    write_lock('1');
    write_others(1, 2, 3, changes => false);
    write_others(4, 5, 6);
    write_lock('1');
    -- Forgotten and refused in the same clock is refused.
    from_software.settings_lock.refused <= '1';
    from_software.settings_lock_written <= '1';
    from_software.pause.cycles <= x"000009";
    from_software.pause_written <= '1';
    wait_for_clock(clk);
    from_software.settings_lock_written <= '0';
    from_software.pause_written <= '0';
    expected_refused := '1';
    check("forgotten in the clock of a refusal");
    -- A reset of the converter alone unlocks nothing.
    start_again;
    write_others(7, 8, 9);
    write_control('1', '1', 16#A5#, 16#3C#, changes => false);
    limits_locked <= '0';
    wait_for_clock(clk);
    check("unlocked");
    write_others(7, 8, 9);
    start_again;
    finish;
  end process;

end architecture;
