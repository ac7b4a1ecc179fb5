-- SPDX-License-Identifier: Apache-2.0
-- Measures resistors by the time that a capacitor takes to charge through each of them to the threshold
-- of an input pin. One sensor channel; knows no bus.

-- One conversion is, for each resistor, a number of charges:
--
--   discharging  all pins drive 0 until the capacitor is empty
--   precharging  the high reference drives 1 for a few clocks, a few more from charge to charge (dither)
--   charging     one resistor drives 1; its clocks until `sense` reads 1 are the count
--
-- Without dither every charge would give the same count, and summing would gain no resolution. The
-- precharge sets the same initial voltages for each resistor, so all sums stay proportional to their
-- resistance (t = R C ln((V - V0) / (V - Vt))) and nothing needs to be corrected.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity capacitor_timer is
  port (
    -- May be gated while nothing but time passes, if none is from `wake_cycles` on.
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Free-running time in clocks, modulo 2^24; may stand still after edges that were gated.
    seen_cycles : in cycles_t;
    -- Convert without end; otherwise all pins are high-impedance.
    enable : in std_ulogic;
    settings : in converter_settings_t;
    -- The settings have changed: discard what has been measured and start over.
    restart : in std_ulogic;
    -- Per resistor (bit numbers in thermal_pkg): high-impedance where not enabled.
    drive_enable : out std_ulogic_vector(resistors - 1 downto 0) := (others => '0');
    drive_level : out std_ulogic_vector(resistors - 1 downto 0) := (others => '0');
    -- The capacitor is being discharged: a sense pin that can drive may help.
    discharging : out std_ulogic := '0';
    -- The capacitor's voltage is above the threshold; synchronous to clk.
    sense : in std_ulogic;
    -- For one clock when a conversion has ended and all below is new.
    updated : out std_ulogic := '0';
    -- One of temperature_converter_status_state_*.
    state : out unsigned(2 downto 0) := (others => '0');
    thermistor_count : out unsigned(31 downto 0) := (others => '0');
    reference_low_count : out unsigned(31 downto 0) := (others => '0');
    reference_high_count : out unsigned(31 downto 0) := (others => '0');
    -- A phase has just begun.
    changes : out std_ulogic := '0';
    -- Two clocks before the one in which the present phase ends by time alone.
    wake_cycles : out cycles_t := (others => '0')
  );
end entity;

architecture rtl of capacitor_timer is

  type phase_t is (off, pausing, emptying, precharging, charging, publishing);
  signal phase : phase_t := off;

  subtype pins_t is std_ulogic_vector(resistors - 1 downto 0);
  subtype resistor_t is natural range 0 to resistors - 1;

  -- The resistor of the present charges: low reference, high reference, thermistor.
  signal resistor : resistor_t := thermistor;
  signal charges_left : unsigned(7 downto 0) := (others => '0');
  -- The present phase: the clock before its first, the clocks of it before this one and with this one, and
  -- after how many it ends.
  signal cycle_before : cycles_t := (others => '0');
  signal elapsed, elapsed_with_this : cycles_t;
  signal limit : cycles_t;
  -- These clocks have passed. Known from the clock before, to keep two carry chains off what a phase ends.
  signal over : std_ulogic := '0';
  -- Phases of no clocks, known from the clock before as well: a change of the settings restarts.
  signal no_discharge, no_timeout, no_pause : std_ulogic := '0';
  signal precharge_cycles : unsigned(15 downto 0) := (others => '0');
  -- The limit of a precharge, a clock later: each is behind a phase of emptying.
  signal precharge_limit : unsigned(15 downto 0) := (others => '0');
  signal sum : unsigned(31 downto 0) := (others => '0');
  signal low_sum : unsigned(31 downto 0) := (others => '0');
  signal high_sum : unsigned(31 downto 0) := (others => '0');
  signal outcome : natural range 0 to 7 := 0;

  function only(index : resistor_t) return pins_t is
    variable pins : pins_t := (others => '0');
  begin
    for i in pins'range loop
      if i = index then
        pins(i) := '1';
      end if;
    end loop;
    return pins;
  end function;

  function first_resistor(with_references : std_ulogic) return resistor_t is
  begin
    if with_references then
      return reference_low;
    end if;
    return thermistor;
  end function;

begin

  -- Each by a carry chain of its own.
  elapsed <= seen_cycles + not cycle_before;
  elapsed_with_this <= seen_cycles - cycle_before;

  choose_limit : process (all)
  begin
    case phase is
      when emptying => limit <= settings.discharge_cycles;
      when precharging => limit <= x"00" & precharge_limit;
      when charging => limit <= settings.timeout_cycles;
      when off | pausing | publishing => limit <= settings.pause_cycles;
    end case;
  end process;

  convert : process
    variable next_sum : unsigned(31 downto 0);

    procedure begin_phase(next_phase : phase_t; without_clocks : std_ulogic) is
    begin
      phase <= next_phase;
      cycle_before <= seen_cycles;
      over <= without_clocks;
      changes <= '1';
    end procedure;

    procedure empty_the_capacitor is
    begin
      begin_phase(emptying, no_discharge);
      drive_level <= (others => '0');
      drive_enable <= only(thermistor);
      if settings.references then
        drive_enable <= (others => '1');
      end if;
      discharging <= '1';
    end procedure;

    procedure charge_through(index : resistor_t) is
    begin
      drive_enable <= only(index);
      drive_level <= only(index);
      discharging <= '0';
    end procedure;

    procedure start_resistor(index : resistor_t) is
    begin
      resistor <= index;
      charges_left <= settings.more_charges;
      precharge_cycles <= (others => '0');
      sum <= (others => '0');
      empty_the_capacitor;
    end procedure;

    procedure finish(result : natural range 0 to 7) is
    begin
      empty_the_capacitor;
      outcome <= result;
      begin_phase(publishing, no_pause);
    end procedure;

  begin
    wait until rising_edge(clk);
    updated <= '0';
    changes <= '0';
    wake_cycles <= cycle_before + limit - 1;
    -- A phase of no clocks to wait for is over when it begins.
    over <= '1' when elapsed_with_this >= limit else '0';
    precharge_limit <= precharge_cycles - 1;
    no_discharge <= settings.discharge_cycles ?= 0;
    no_timeout <= settings.timeout_cycles ?= 0;
    no_pause <= settings.pause_cycles ?= 0;

    case phase is
      when off =>
        low_sum <= (others => '0');
        high_sum <= (others => '0');
        if enable then
          start_resistor(first_resistor(settings.references));
        end if;

      when pausing =>
        if over then
          low_sum <= (others => '0');
          high_sum <= (others => '0');
          start_resistor(first_resistor(settings.references));
        end if;

      when emptying =>
        if over then
          if sense then
            finish(temperature_converter_status_state_stuck);
          elsif precharge_cycles /= 0 and settings.references = '1' then
            begin_phase(precharging, precharge_cycles ?= 1);
            charge_through(reference_high);
          else
            begin_phase(charging, no_timeout);
            charge_through(resistor);
          end if;
        end if;

      when precharging =>
        if over then
          begin_phase(charging, no_timeout);
          charge_through(resistor);
        end if;

      when charging =>
        if sense then
          -- The clocks in which `sense` read 0.
          next_sum := sum + elapsed;
          sum <= next_sum;
          precharge_cycles <= precharge_cycles + settings.dither_cycles;
          charges_left <= charges_left - 1;
          if charges_left /= 0 then
            empty_the_capacitor;
          elsif resistor = reference_low then
            low_sum <= next_sum;
            start_resistor(reference_high);
          elsif resistor = reference_high then
            high_sum <= next_sum;
            start_resistor(thermistor);
          else
            finish(temperature_converter_status_state_ok);
          end if;
        elsif over then
          sum <= sum + elapsed_with_this;
          if resistor = thermistor and settings.references = '1' then
            finish(temperature_converter_status_state_open);
          else
            finish(temperature_converter_status_state_time_out);
          end if;
        end if;

      when publishing =>
        -- Nothing is new without `updated`, which is low while disabled.
        if enable then
          updated <= '1';
          state <= to_unsigned(outcome, state'length);
          -- Not in the clock of the last charge: there the sum is late.
          if outcome = temperature_converter_status_state_ok and sum < settings.short_limit then
            state <= to_unsigned(temperature_converter_status_state_shorted, state'length);
          end if;
          thermistor_count <= sum;
          reference_low_count <= low_sum;
          reference_high_count <= high_sum;
        end if;
        begin_phase(pausing, no_pause);
    end case;

    if reset = '1' or restart = '1' or enable = '0' then
      phase <= off;
      drive_enable <= (others => '0');
      discharging <= '0';
      updated <= '0';
    end if;
    if reset or restart then
      state <= (others => '0');
      thermistor_count <= (others => '0');
      reference_low_count <= (others => '0');
      reference_high_count <= (others => '0');
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- Two pins of opposite levels would drive current through two resistors and spoil the measurement.
  -- psl pins_never_fight : assert always
  --   (not (or (drive_enable and drive_level)) or not (or (drive_enable and not drive_level)));
  -- In the clock of a restart the pins are still those of the settings before.
  -- psl absent_references_are_never_driven_in_a_charge : assert always
  --   (settings.references = '1' or restart = '1' or
  --    (drive_enable(reference_low) and drive_level(reference_low)) = '0');

end architecture;
