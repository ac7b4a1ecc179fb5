-- SPDX-License-Identifier: Apache-2.0
-- A converter does the same whether it gets the clock edges at rest or not, under random settings,
-- sensors, locks and resets; it rests while only time passes; its sense pins are synchronised.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_master_pkg.all;
use work.bus_pkg.all;
use work.clocked_bench_pkg.all;
use work.random_source_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity temperature_converter_rest_tb is
end entity;

architecture simulation of temperature_converter_rest_tb is

  constant frequency : unsigned(31 downto 0) := to_unsigned(100_000_000, 32);

  type converter_outputs_t is record
    drive_enable, drive_level : std_ulogic_vector(2 * resistors - 1 downto 0);
    discharging : std_ulogic_vector(1 downto 0);
    readings : sensor_reading_array_t(0 to 1);
    more_charges : unsigned(7 downto 0);
  end record;

  signal master : bus_master_t := bus_master_idle;
  signal request : bus_request_t;
  signal response, rested_response : bus_response_t;
  signal reset : std_ulogic := '1';
  signal limits_locked : std_ulogic := '0';
  signal sense, stuck_high, stuck_low : std_ulogic_vector(1 downto 0) := "00";
  signal outputs, rested : converter_outputs_t;
  signal pins : std_ulogic_vector(2 downto 0);
  signal resting_clk, resting_bus_clk, at_rest : std_ulogic;
  signal clocks_left_out : natural;

  type ohms_t is array (0 to 1) of real;
  signal ohms : ohms_t := (1_000.0, 5_000.0);

  alias clk is master.clk;

begin

  request <= to_request(master.request);
  master.response <= to_wires(response);
  pins <= limits_locked & sense;

  clocks : entity work.resting_clocks
    generic map (period => 10 ns)
    port map (
      reset => reset, strobe => request.strobe, at_rest => at_rest, pins => pins,
      clk => clk, resting_clk => resting_clk, resting_bus_clk => resting_bus_clk,
      clocks_left_out => clocks_left_out);

  converter : entity work.temperature_converter
    port map (
      clk => clk, always_clk => clk, bus_clk => clk, clock_frequency_hz => frequency,
      reset => reset, request => request, response => response,
      drive_enable => outputs.drive_enable, drive_level => outputs.drive_level,
      discharging => outputs.discharging, sense => sense, readings => outputs.readings,
      more_charges => outputs.more_charges, limits_locked => limits_locked, at_rest => open);

  resting_converter : entity work.temperature_converter
    port map (
      clk => resting_clk, always_clk => clk, bus_clk => resting_bus_clk,
      clock_frequency_hz => frequency, reset => reset, request => request,
      response => rested_response, drive_enable => rested.drive_enable,
      drive_level => rested.drive_level, discharging => rested.discharging, sense => sense,
      readings => rested.readings, more_charges => rested.more_charges,
      limits_locked => limits_locked, at_rest => at_rest);

  sensors : for channel in 0 to 1 generate
    circuit : entity work.sensor_circuit
      generic map (clocks_per_ohm => 0.0272)
      port map (
        clk => clk,
        drive_enable => outputs.drive_enable(resistors * channel + 2 downto resistors * channel),
        drive_level => outputs.drive_level(resistors * channel + 2 downto resistors * channel),
        thermistor_ohms => ohms(channel), stuck_high => stuck_high(channel),
        stuck_low => stuck_low(channel), sense => sense(channel));
  end generate;

  compare : process
  begin
    wait until falling_edge(clk);
    assert rested = outputs report "a rest has changed pins or readings" severity failure;
    assert rested_response = response
      report "a rest has changed an answer: " & to_hstring(rested_response.data) & ", not " &
      to_hstring(response.data) severity failure;
  end process;

  test : process

    variable random : random_source_t;
    variable word : word_t;

    procedure start_over is
    begin
      reset <= '1';
      wait_clocks(clk, random.between(1, 4));
      reset <= '0';
      wait_clocks(clk, 1);
    end procedure;

    procedure write_control (charges : positive; dither_cycles : natural; enable, references : std_ulogic) is
    begin
      write(master, temperature_converter_control_address, to_word(temperature_converter_control_t'(
        enable => enable, references => references, dither_cycles => to_unsigned(dither_cycles, 8),
        more_charges => to_unsigned(charges - 1, 8))));
    end procedure;

    -- In the shortest phases one begins before the other's activity has ended.
    impure function some_cycles return natural is
    begin
      case random.between(0, 3) is
        when 0 => return random.between(0, 3);
        when 1 => return random.between(0, 12);
        when 2 => return random.between(10, 80);
        when others => return random.between(50, 400);
      end case;
    end function;

    -- '1' once in `share` calls, on average.
    impure function seldom (share : positive) return std_ulogic is
    begin
      if random.between(1, share) = 1 then
        return '1';
      end if;
      return '0';
    end function;

    procedure change_settings is
    begin
      write(master, temperature_converter_discharge_address, some_cycles);
      write(master, temperature_converter_timeout_address, some_cycles);
      write(master, temperature_converter_pause_address, some_cycles);
      write(master, temperature_converter_short_limit_address, some_cycles);
      write_control(
        charges => random.between(1, 6), dither_cycles => random.between(0, 3),
        enable => not seldom(8),
        references => seldom(2));
    end procedure;

    procedure change_sensor (channel : natural) is
    begin
      ohms(channel) <= real(random.between(0, 20_000)) - 2_000.0;
      stuck_high(channel) <= seldom(8);
      stuck_low(channel) <= seldom(8);
    end procedure;

    -- Control to the last register of the last channel.
    procedure read_anything is
    begin
      read(master, temperature_converter_control_address + 4 * random.between(0, 25), word);
    end procedure;

    procedure do_anything is
    begin
      case random.between(0, 15) is
        when 0 => start_over;
        when 1 | 2 => limits_locked <= not limits_locked;
        when 3 | 4 | 5 => change_settings;
        when 6 | 7 => change_sensor(0);
        when 8 | 9 => change_sensor(1);
        when 10 =>
          write(master, temperature_converter_settings_lock_address,
            2 ** temperature_converter_settings_lock_refused_bit);
        when 11 | 12 =>
          read(master, temperature_converter_age_address + 4 * random.between(0, 1), word);
        when others => read_anything;
      end case;
    end procedure;

    -- Only ticks, and the ends of the phases of both channels, take some clocks of 20 ticks each.
    procedure expect_rest (what : string) is
      variable before : natural;
    begin
      before := clocks_left_out;
      wait_clocks(clk, 20 * tick_cycles);
      rests : assert clocks_left_out - before > 19 * tick_cycles
        report what & ": " & to_string(clocks_left_out - before) & " clocks left out" severity failure;
    end procedure;

  begin
    random.seed(20, 7);
    start_over;
    for round in 1 to 1_500 loop
      do_anything;
      case random.between(0, 3) is
        when 0 => null;
        when 1 => wait_clocks(clk, random.between(1, 20));
        when others => wait_clocks(clk, random.between(20, 250));
      end case;
    end loop;

    limits_locked <= '0';
    stuck_high <= "00";
    stuck_low <= "00";
    ohms <= (1_000.0, 5_000.0);
    start_over;
    expect_rest("disabled");
    write(master, temperature_converter_discharge_address, 200);
    write(master, temperature_converter_timeout_address, 200_000);
    write(master, temperature_converter_pause_address, 200_000);
    write_control(charges => 1, dither_cycles => 0, enable => '1', references => '0');
    wait until rising_edge(clk) and outputs.readings(1).updated = '1';
    expect_rest("in a pause");
    write_control(charges => 1, dither_cycles => 0, enable => '0', references => '0');
    expect_rest("disabled again");
    stuck_low <= "11";
    write_control(charges => 1, dither_cycles => 0, enable => '1', references => '0');
    wait_clocks(clk, 300);
    assert outputs.drive_level = "001001" severity failure;
    expect_rest("in a charge");

    -- A sense pin goes through two flip-flops before anything depends on it.
    stuck_high <= "01";
    for i in 1 to 2 loop
      wait_clocks(clk, 1);
      is_synchronised_first : assert outputs.drive_level = "001001"
        report to_string(i) & " clocks after the pin" severity failure;
    end loop;
    wait_clocks(clk, 1);
    ends_the_charge : assert outputs.drive_level = "001000" severity failure;
    std.env.finish;
  end process;

end architecture;
