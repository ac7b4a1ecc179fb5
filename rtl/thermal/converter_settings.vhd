-- SPDX-License-Identifier: Apache-2.0
-- How the temperature converter measures: the scale of the heaters' limits, and locked together with them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.temperature_converter_registers_pkg.all;
use work.thermal_pkg.all;

entity converter_settings is
  port (
    clk : in std_ulogic;
    -- Of no effect on the settings while they are locked,
    -- so that a reset of the converter alone unlocks nothing.
    reset : in std_ulogic;
    -- Of `clk`; constant.
    clock_frequency_hz : in unsigned(31 downto 0);
    -- From the heater control: a limit of some channel is set, in this scale.
    limits_locked : in std_ulogic;
    from_software : in temperature_converter_from_software_t;
    enable : out std_ulogic := '0';
    settings : out converter_settings_t := converter_settings_none;
    -- Conversions so far are void: the settings have changed, or have just been locked.
    restart : out std_ulogic;
    -- A write would have changed what is locked; remembered until software forgets it.
    refused : out std_ulogic := '0'
  );
end entity;

architecture rtl of converter_settings is

  signal changed : std_ulogic := '0';
  signal locked_before : std_ulogic := '0';
  signal longest_charge : cycles_t;
  signal timeout_is_too_long : std_ulogic;
  signal timeout : cycles_t;
  -- What is written is not what the setting is.
  signal control_differs, discharge_differs, timeout_differs, pause_differs, short_limit_differs : std_ulogic;
  signal differs : std_ulogic;

begin

  -- An eighth of a second, at most 100 MHz: an open sensor is found in every conversion.
  longest_charge <= clock_frequency_hz(26 downto 3);
  timeout_is_too_long <= from_software.timeout.cycles ?> longest_charge;
  timeout <= longest_charge when timeout_is_too_long = '1' else from_software.timeout.cycles;

  restart <= changed or (limits_locked and not locked_before);

  control_differs <= (from_software.control.references ?/= settings.references)
    or (from_software.control.dither_cycles ?/= settings.dither_cycles)
    or (from_software.control.more_charges ?/= settings.more_charges);
  discharge_differs <= from_software.discharge.cycles ?/= settings.discharge_cycles;
  -- Both possible time-outs are compared before it is known which one counts.
  timeout_differs <= longest_charge ?/= settings.timeout_cycles when timeout_is_too_long = '1'
    else from_software.timeout.cycles ?/= settings.timeout_cycles;
  pause_differs <= from_software.pause.cycles ?/= settings.pause_cycles;
  short_limit_differs <= from_software.short_limit.cycles ?/= settings.short_limit;

  differs <= (from_software.control_written and control_differs)
    or (from_software.discharge_written and discharge_differs)
    or (from_software.timeout_written and timeout_differs)
    or (from_software.pause_written and pause_differs)
    or (from_software.short_limit_written and short_limit_differs);

  keep : process
  begin
    wait until rising_edge(clk);
    changed <= differs and not limits_locked;
    locked_before <= limits_locked;
    if from_software.control_written then
      enable <= from_software.control.enable;
    end if;
    if from_software.settings_lock_written = '1' and from_software.settings_lock.refused = '1' then
      refused <= '0';
    end if;
    if differs and limits_locked then
      refused <= '1';
    end if;
    if not limits_locked then
      if from_software.control_written then
        settings.references <= from_software.control.references;
        settings.dither_cycles <= from_software.control.dither_cycles;
        settings.more_charges <= from_software.control.more_charges;
      end if;
      if from_software.discharge_written then
        settings.discharge_cycles <= from_software.discharge.cycles;
      end if;
      if from_software.timeout_written then
        settings.timeout_cycles <= timeout;
      end if;
      if from_software.pause_written then
        settings.pause_cycles <= from_software.pause.cycles;
      end if;
      if from_software.short_limit_written then
        settings.short_limit <= from_software.short_limit.cycles;
      end if;
    end if;
    if reset then
      enable <= '0';
      refused <= '0';
      if not limits_locked then
        settings <= converter_settings_none;
        changed <= '1';
      end if;
    end if;
  end process;

end architecture;
