-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `fan`. Generated from rtl/thermal/fan.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package fan_registers_pkg is

  constant fan_address : unsigned(31 downto 0) := x"F0007000";

  -- How much of the time the fan is on. Taken over at the start of a period.
  constant fan_duty_address : unsigned(31 downto 0) := x"F0007000";
  subtype fan_duty_slots_bits is natural range 7 downto 0;
  type fan_duty_t is record
    slots : unsigned(7 downto 0);
  end record;
  constant fan_duty_after_reset : fan_duty_t := (slots => 8x"0");
  function to_word(value : fan_duty_t) return std_ulogic_vector;
  function to_fan_duty(word : std_ulogic_vector(31 downto 0)) return fan_duty_t;

  -- How long a period is.
  constant fan_period_address : unsigned(31 downto 0) := x"F0007004";
  subtype fan_period_slot_cycles_bits is natural range 23 downto 0;
  type fan_period_t is record
    slot_cycles : unsigned(23 downto 0);
  end record;
  constant fan_period_after_reset : fan_period_t := (slot_cycles => 24x"1");
  function to_word(value : fan_period_t) return std_ulogic_vector;
  function to_fan_period(word : std_ulogic_vector(31 downto 0)) return fan_period_t;

  type fan_from_software_t is record
    duty : fan_duty_t;
    period : fan_period_t;
  end record;

end package;

package body fan_registers_pkg is

  function to_word(value : fan_duty_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & std_ulogic_vector(value.slots);
  end function;

  function to_fan_duty(word : std_ulogic_vector(31 downto 0)) return fan_duty_t is
  begin
    return (
      slots => unsigned(word(fan_duty_slots_bits)));
  end function;

  function to_word(value : fan_period_t) return std_ulogic_vector is
  begin
    return "00000000" & std_ulogic_vector(value.slot_cycles);
  end function;

  function to_fan_period(word : std_ulogic_vector(31 downto 0)) return fan_period_t is
  begin
    return (
      slot_cycles => unsigned(word(fan_period_slot_cycles_bits)));
  end function;

end package body;
