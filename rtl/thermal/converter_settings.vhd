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
  signal wanted : converter_settings_t;

begin

  -- An eighth of a second, at most 100 MHz: an open sensor is found in every conversion.
  longest_charge <= clock_frequency_hz(26 downto 3);

  restart <= changed or (limits_locked and not locked_before);

  choose : process (all)
  begin
    wanted <= settings;
    if from_software.control_written then
      wanted.references <= from_software.control.references;
      wanted.dither_cycles <= from_software.control.dither_cycles;
      wanted.more_charges <= from_software.control.more_charges;
    end if;
    if from_software.discharge_written then
      wanted.discharge_cycles <= from_software.discharge.cycles;
    end if;
    if from_software.timeout_written then
      wanted.timeout_cycles <= from_software.timeout.cycles;
      if from_software.timeout.cycles > longest_charge then
        wanted.timeout_cycles <= longest_charge;
      end if;
    end if;
    if from_software.pause_written then
      wanted.pause_cycles <= from_software.pause.cycles;
    end if;
    if from_software.short_limit_written then
      wanted.short_limit <= from_software.short_limit.cycles;
    end if;
  end process;

  keep : process
  begin
    wait until rising_edge(clk);
    changed <= '0';
    locked_before <= limits_locked;
    if from_software.control_written then
      enable <= from_software.control.enable;
    end if;
    if from_software.settings_lock_written = '1' and from_software.settings_lock.refused = '1' then
      refused <= '0';
    end if;
    if wanted /= settings then
      if limits_locked then
        refused <= '1';
      else
        settings <= wanted;
        changed <= '1';
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
