-- SPDX-License-Identifier: Apache-2.0
-- Temperature converter: one capacitor timer per sensor channel behind one set of registers. The channels
-- convert side by side, so that a cold or broken sensor never delays the readings of another.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity temperature_converter is
  generic (
    -- Sensor channels.
    channels : positive range 1 to 4 := 2
  );
  port (
    -- May be gated while `at_rest` is high,
    -- but for those after a change of `sense` or `limits_locked`.
    clk : in std_ulogic;
    -- The same clock, never gated.
    always_clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    -- Of `clk`; constant.
    clock_frequency_hz : in unsigned(31 downto 0);
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- Three pins per channel, channel n at bits 3 n + 2 to 3 n: high reference, low reference, thermistor.
    -- A pin is high-impedance where not enabled.
    drive_enable : out std_ulogic_vector(resistors * channels - 1 downto 0);
    drive_level : out std_ulogic_vector(resistors * channels - 1 downto 0);
    -- Per channel: the capacitor is being discharged, a sense pin that can drive may pull it low.
    discharging : out std_ulogic_vector(channels - 1 downto 0);
    -- Per channel: the capacitor is above the threshold of its pin. Asynchronous.
    sense : in std_ulogic_vector(channels - 1 downto 0);
    -- To the heater control, with the scale of the counts: charges of a conversion, less one.
    readings : out sensor_reading_array_t(0 to channels - 1);
    more_charges : out unsigned(7 downto 0);
    -- From the heater control: limits are set, so that their scale must stay.
    limits_locked : in std_ulogic;
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of temperature_converter is

  signal from_software : temperature_converter_from_software_t;
  signal to_software : temperature_converter_to_software_t;

  signal enable, restart, refused : std_ulogic;
  signal settings : converter_settings_t;

  signal sense_synchronized : std_ulogic_vector(channels - 1 downto 0);

  signal now_cycles : cycles_t := (others => '0');
  -- Equal to the time in every clock that follows an edge of `clk`, otherwise an earlier value.
  signal seen_cycles : cycles_t := (others => '0');

  signal tick : std_ulogic := '0';
  signal tick_ends : std_ulogic;
  signal tick_phase : natural range 0 to tick_cycles - 1 := 0;

  signal settling, alarm : std_ulogic;
  signal waking, moving : std_ulogic_vector(channels - 1 downto 0);

begin

  count_cycles : process
  begin
    wait until rising_edge(always_clk);
    now_cycles <= now_cycles + 1;
    if reset then
      now_cycles <= (others => '0');
    end if;
  end process;

  see_cycles : process
  begin
    wait until rising_edge(clk);
    seen_cycles <= now_cycles + 1;
    if reset then
      seen_cycles <= (others => '0');
    end if;
  end process;

  alarm <= tick_ends or settling or (or waking);

  watch_rest : entity work.rest_watch
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset,
      strobe => request.strobe,
      working => or moving,
      alarm => alarm,
      at_rest => at_rest);

  tick_ends <= '1' when tick_phase = tick_cycles - 1 else '0';

  make_tick : process
  begin
    wait until rising_edge(clk);
    tick <= tick_ends;
  end process;

  count_tick_phase : process
  begin
    wait until rising_edge(always_clk);
    if tick_ends then
      tick_phase <= 0;
    else
      tick_phase <= tick_phase + 1;
    end if;
    if reset then
      tick_phase <= 0;
    end if;
  end process;

  sense_pins : entity work.synchronizer
    generic map (width => channels)
    port map (
      clk => clk,
      asynchronous => sense,
      synchronous => sense_synchronized,
      settling => settling);

  each_channel : for channel in 0 to to_software.status'high generate
    present : if channel < channels generate
      constant first_pin : natural := resistors * channel;
      signal updated : std_ulogic;
      signal state : unsigned(2 downto 0);
      signal conversions : unsigned(7 downto 0) := (others => '0');
      signal age : tick_count_t := (others => '1');
      signal changes : std_ulogic;
      signal wake_cycles : cycles_t;
    begin

      waking(channel) <= '1' when now_cycles = wake_cycles else '0';
      moving(channel) <= changes or updated or restart;

      timer : entity work.capacitor_timer
        port map (
          clk => clk,
          reset => reset,
          seen_cycles => seen_cycles,
          changes => changes,
          wake_cycles => wake_cycles,
          enable => enable,
          settings => settings,
          restart => restart,
          drive_enable => drive_enable(first_pin + resistors - 1 downto first_pin),
          drive_level => drive_level(first_pin + resistors - 1 downto first_pin),
          discharging => discharging(channel),
          sense => sense_synchronized(channel),
          updated => updated,
          state => state,
          thermistor_count => to_software.thermistor(channel).cycles,
          reference_low_count => to_software.reference_low(channel).cycles,
          reference_high_count => to_software.reference_high(channel).cycles);

      count_age : process
      begin
        wait until rising_edge(clk);
        if updated then
          age <= (others => '0');
          conversions <= conversions + 1;
        elsif tick = '1' and age /= (age'range => '1') then
          age <= age + 1;
        end if;
        if reset or restart then
          age <= (others => '1');
        end if;
        if reset then
          conversions <= (others => '0');
        end if;
      end process;

      to_software.status(channel).state <= state;
      to_software.status(channel).conversions <= conversions;
      to_software.age(channel).ticks <= age;

      readings(channel).updated <= updated or restart;
      readings(channel).valid <= '1' when state = temperature_converter_status_state_ok
        and restart = '0' else '0';
      readings(channel).count <= to_software.thermistor(channel).cycles;
    end generate;

    absent : if channel >= channels generate
      to_software.status(channel) <= (state => (others => '0'), conversions => (others => '0'));
      to_software.age(channel).ticks <= (others => '1');
      to_software.thermistor(channel).cycles <= (others => '0');
      to_software.reference_low(channel).cycles <= (others => '0');
      to_software.reference_high(channel).cycles <= (others => '0');
    end generate;
  end generate;

  set_up : entity work.converter_settings
    port map (
      clk => clk,
      reset => reset,
      clock_frequency_hz => clock_frequency_hz,
      limits_locked => limits_locked,
      from_software => from_software,
      enable => enable,
      settings => settings,
      restart => restart,
      refused => refused);

  more_charges <= settings.more_charges;

  to_software.control <= (
    enable => enable,
    references => settings.references,
    dither_cycles => settings.dither_cycles,
    more_charges => settings.more_charges);
  to_software.discharge.cycles <= settings.discharge_cycles;
  to_software.timeout.cycles <= settings.timeout_cycles;
  to_software.pause.cycles <= settings.pause_cycles;
  to_software.short_limit.cycles <= settings.short_limit;
  to_software.settings_lock <= (locked => limits_locked, refused => refused);

  registers : entity work.temperature_converter_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software);

end architecture;
