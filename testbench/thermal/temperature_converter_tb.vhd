-- SPDX-License-Identifier: Apache-2.0
-- Software sees each channel's newest conversion and its age, and channels do not wait for each other.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity temperature_converter_tb is
end entity;

architecture simulation of temperature_converter_tb is

  constant control : unsigned(31 downto 0) := temperature_converter_control_address;
  constant discharge : unsigned(31 downto 0) := temperature_converter_discharge_address;
  constant timeout : unsigned(31 downto 0) := temperature_converter_timeout_address;
  constant pause : unsigned(31 downto 0) := temperature_converter_pause_address;
  constant status : unsigned(31 downto 0) := temperature_converter_status_address;
  constant age : unsigned(31 downto 0) := temperature_converter_age_address;
  constant thermistors : unsigned(31 downto 0) := temperature_converter_thermistor_address;
  constant settings_lock : unsigned(31 downto 0) := temperature_converter_settings_lock_address;
  constant low_references : unsigned(31 downto 0) := temperature_converter_reference_low_address;
  constant high_references : unsigned(31 downto 0) := temperature_converter_reference_high_address;

  signal master : bus_master_t := bus_master_idle;
  signal reset : std_ulogic := '1';
  signal drive_enable, drive_level : std_ulogic_vector(5 downto 0);
  signal discharging, sense : std_ulogic_vector(1 downto 0);
  signal readings : sensor_reading_array_t(0 to 1);
  signal more_charges : unsigned(7 downto 0);
  signal limits_locked : std_ulogic := '0';
  signal hotend_ohms : real := 1_000.0;
  signal bed_ohms : real := 5_000.0;
  signal bed_stuck_high, bed_stuck_low : std_ulogic := '0';

  type naturals_t is array (0 to 1) of natural;
  signal conversions : naturals_t := (0, 0);

  alias clk is master.clk;

begin

  make_clock(master.clk, 10 ns);

  converter : entity work.temperature_converter
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      clock_frequency_hz => to_unsigned(100_000_000, 32), reset => reset,
      request => to_request(master.request), to_wires(response) => master.response,
      more_charges => more_charges, limits_locked => limits_locked, drive_enable => drive_enable,
      drive_level => drive_level, discharging => discharging, sense => sense, readings => readings);

  -- A capacitor ten times smaller than on a board, to be quick.
  hotend : entity work.sensor_circuit
    generic map (clocks_per_ohm => 0.0272)
    port map (
      clk => clk, drive_enable => drive_enable(2 downto 0), drive_level => drive_level(2 downto 0),
      thermistor_ohms => hotend_ohms, sense => sense(0));
  bed : entity work.sensor_circuit
    generic map (clocks_per_ohm => 0.0272)
    port map (
      clk => clk, drive_enable => drive_enable(5 downto 3), drive_level => drive_level(5 downto 3),
      thermistor_ohms => bed_ohms, stuck_high => bed_stuck_high, stuck_low => bed_stuck_low,
      sense => sense(1));

  count_conversions : process
  begin
    wait until rising_edge(clk);
    for channel in conversions'range loop
      if readings(channel).updated = '1' and readings(channel).valid = '1' then
        conversions(channel) <= conversions(channel) + 1;
      end if;
    end loop;
  end process;

  check : process

    variable word : word_t;
    variable hotend_before, bed_before : natural;
    variable first_tick : time;

    function control_word (
      charges : positive; enable : std_ulogic := '1'; dither_cycles : natural := 1) return word_t is
    begin
      return to_word(temperature_converter_control_t'(
        enable => enable, references => '1', dither_cycles => to_unsigned(dither_cycles, 8),
        more_charges => to_unsigned(charges - 1, 8)));
    end function;

    procedure read_state (channel : natural; expected : natural) is
    begin
      read(master, status + 4 * channel, word);
      has_its_state : assert unsigned(word(temperature_converter_status_state_bits)) = expected
        report "channel " & to_string(channel) & ": state " & to_hstring(word) severity error;
    end procedure;

    function lock_word (refused : std_ulogic) return word_t is
    begin
      return to_word(temperature_converter_settings_lock_t'(locked => '1', refused => refused));
    end function;

    procedure write_control (
      charges : positive; enable : std_ulogic := '1'; dither_cycles : natural := 1) is
    begin
      write(master, control, control_word(charges, enable, dither_cycles));
    end procedure;

    -- Until a channel that does not convert gets older.
    procedure wait_for_tick is
      variable before : word_t;
    begin
      read(master, age, before);
      loop
        read(master, age, word);
        exit when word /= before;
      end loop;
    end procedure;

    procedure wait_clocks (count : natural) is
    begin
      for i in 1 to count loop
        wait until rising_edge(clk);
      end loop;
    end procedure;
  begin
    wait_clocks(3);
    reset <= '0';
    wait_clocks(10);
    read_state(0, temperature_converter_status_state_never);
    read(master, age, word);
    is_old_before_the_first : assert unsigned(word) = 2 ** tick_count_bits - 1
      report to_hstring(word) severity error;
    wait_clocks(2 * tick_cycles);
    read(master, age, word);
    stays_at_the_largest_age : assert unsigned(word) = 2 ** tick_count_bits - 1
      report to_hstring(word) severity error;
    -- A channel that is not there has never converted.
    for channel in 2 to 3 loop
      expect(master, status + 4 * channel, 0);
      expect(master, age + 4 * channel, 2 ** tick_count_bits - 1);
      expect(master, thermistors + 4 * channel, 0);
      expect(master, low_references + 4 * channel, 0);
      expect(master, high_references + 4 * channel, 0);
    end loop;

    write(master, discharge, 200);
    write(master, timeout, 5_000);
    write(master, pause, 300);
    expect(master, pause, 300);
    write(master, pause, 0);
    expect(master, pause, 0);
    for limit in 1 downto 0 loop
      write(master, temperature_converter_short_limit_address, limit * 16#12345#);
      expect(master, temperature_converter_short_limit_address, limit * 16#12345#);
    end loop;
    write_control(charges => 4);
    wait_clocks(40_000);
    for channel in 0 to 1 loop
      read_state(channel, temperature_converter_status_state_ok);
      counts_conversions : assert unsigned(word(temperature_converter_status_conversions_bits))
        = conversions(channel) mod 256
        report to_hstring(word) severity error;
      read(master, age + 4 * channel, word);
      is_fresh : assert unsigned(word) < 10 report to_hstring(word) severity error;
    end loop;

    -- About 19 clocks per charge, and 189 through 10 kOhm.
    wait until rising_edge(clk) and readings(0).updated = '1';
    read(master, thermistors, word);
    software_reads_what_the_heaters_get : assert unsigned(word) = readings(0).count
      and readings(0).valid = '1' report to_hstring(word) severity error;
    counts_the_thermistor : assert unsigned(word) > 4 * 17 and unsigned(word) < 4 * 23
      report to_string(to_integer(unsigned(word))) severity error;
    read(master, high_references, word);
    counts_the_reference : assert unsigned(word) > 4 * 180 and unsigned(word) < 4 * 195
      report to_string(to_integer(unsigned(word))) severity error;

    -- A broken sensor times out for long, and the other one does not notice.
    hotend_before := conversions(0);
    wait_clocks(100_000);
    hotend_before := conversions(0) - hotend_before;
    bed_ohms <= -1.0;
    wait_clocks(20_000);
    read_state(1, temperature_converter_status_state_open);
    is_reported_invalid : assert readings(1).valid = '0' report "valid" severity error;
    bed_stuck_low <= '1';
    wait_clocks(20_000);
    read_state(1, temperature_converter_status_state_time_out);
    a_time_out_is_invalid : assert readings(1).valid = '0' report "valid" severity error;
    bed_stuck_low <= '0';
    bed_stuck_high <= '1';
    wait_clocks(20_000);
    read_state(1, temperature_converter_status_state_stuck);
    a_stuck_pin_is_invalid : assert readings(1).valid = '0' report "valid" severity error;
    bed_stuck_high <= '0';
    wait_clocks(20_000);
    read_state(1, temperature_converter_status_state_open);
    bed_before := conversions(0);
    wait_clocks(100_000);
    goes_on_at_its_pace : assert abs (conversions(0) - bed_before - hotend_before) <= 1
      report to_string(conversions(0) - bed_before) & " against " & to_string(hotend_before)
      severity error;
    read_state(0, temperature_converter_status_state_ok);
    read_state(2, temperature_converter_status_state_never);

    -- A change of settings makes what was measured under others worth nothing.
    wait until rising_edge(clk) and readings(0).updated = '1';
    write_control(charges => 8);
    wait_clocks(3);
    is_void_at_a_change : assert readings(0).valid = '0' report "valid" severity error;
    read_state(0, temperature_converter_status_state_never);
    read(master, age, word);
    has_no_age_then : assert unsigned(word) = 2 ** tick_count_bits - 1 report to_hstring(word) severity error;
    says_its_charges : assert more_charges = 7 report to_string(to_integer(more_charges)) severity error;
    wait_clocks(40_000);
    read_state(0, temperature_converter_status_state_ok);

    -- A charge may take an eighth of a second at most.
    write(master, timeout, 16#FF_FFFF#);
    read(master, timeout, word);
    has_a_built_in_maximum : assert unsigned(word) = 12_500_000 report to_hstring(word) severity error;
    write(master, timeout, 5_000);
    wait_clocks(40_000);

    -- Locked settings stay, whatever is written, and through the converter's own reset.
    wait until rising_edge(clk) and readings(0).updated = '1';
    limits_locked <= '1';
    wait_clocks(1);
    wait for 1 ns;
    is_void_at_the_lock : assert readings(0).valid = '0' report "valid" severity error;
    wait_clocks(40_000);
    read_state(0, temperature_converter_status_state_ok);
    read(master, settings_lock, word);
    says_locked : assert word = lock_word(refused => '0') report to_hstring(word) severity error;
    write_control(charges => 8);
    read(master, settings_lock, word);
    takes_the_same_once_more : assert word = lock_word(refused => '0') report to_hstring(word) severity error;
    for index in 0 to 4 loop
      write(master, control + 4 * index,
        control_word(charges => 256, dither_cycles => 2));
      read(master, settings_lock, word);
      names_what_it_refuses : assert word = lock_word(refused => '1') report to_hstring(word) severity error;
      write(master, settings_lock, 2 ** temperature_converter_settings_lock_refused_bit);
      read(master, settings_lock, word);
      forgets_when_asked : assert word = lock_word(refused => '0') report to_hstring(word) severity error;
    end loop;
    goes_on_through_it : assert readings(0).valid = '1' report "not valid" severity error;
    reset <= '1';
    wait_clocks(3);
    reset <= '0';
    wait_clocks(3);
    for channel in 0 to 1 loop
      read_state(channel, temperature_converter_status_state_never);
      counts_from_0_again : assert unsigned(word) = 0 report to_hstring(word) severity error;
      expect(master, age + 4 * channel, 2 ** tick_count_bits - 1);
    end loop;
    read(master, control, word);
    keeps_all_but_enable : assert word = control_word(charges => 8, enable => '0')
      report to_hstring(word) severity error;
    read(master, discharge, word);
    keeps_the_discharge : assert unsigned(word) = 200 report to_hstring(word) severity error;
    read(master, timeout, word);
    keeps_the_time_out : assert unsigned(word) = 5_000 report to_hstring(word) severity error;
    write_control(charges => 8);
    read(master, control, word);
    enable_is_free : assert word = control_word(charges => 8) report to_hstring(word) severity error;
    wait_clocks(40_000);
    read_state(0, temperature_converter_status_state_ok);

    -- Age goes on in ticks when conversions stop.
    wait until rising_edge(clk) and readings(0).updated = '1';
    write_control(charges => 8, enable => '0');
    wait_clocks(50 * tick_cycles);
    read(master, age, word);
    ages_in_ticks : assert unsigned(word) = 50 report to_hstring(word) severity error;
    wait_for_tick;
    first_tick := now;
    for i in 1 to 40 loop
      wait_for_tick;
    end loop;
    -- To within the clocks of a read.
    a_tick_has_its_clocks : assert abs (now - first_tick - 40 * tick_cycles * 10 ns) < 100 ns
      report to_string(now - first_tick) severity error;
    lets_go : assert drive_enable = "000000" report "drives while disabled" severity error;
    std.env.finish;
  end process;

end architecture;
