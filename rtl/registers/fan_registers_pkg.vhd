-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `fan`. Generated from rtl/thermal/fan.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package fan_registers_pkg is

  constant fan_address : unsigned(31 downto 0) := x"F0007000";

  -- How much of the time the fan is on. Taken over at the start of a period.
  constant fan_duty_address : unsigned(31 downto 0) := x"F0007000";
  type fan_duty_t is record
    slots : unsigned(7 downto 0);
  end record;

  -- How long a period is.
  constant fan_period_address : unsigned(31 downto 0) := x"F0007004";
  type fan_period_t is record
    slot_cycles : unsigned(23 downto 0);
  end record;

  type fan_from_software_t is record
    duty : fan_duty_t;
    period : fan_period_t;
  end record;

end package;
