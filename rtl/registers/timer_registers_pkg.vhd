-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package timer_registers_pkg is

  constant timer_address : unsigned(31 downto 0) := x"F0002000";

  -- Low word: Clocks since reset. Reading the low word holds the high word of the same instant.
  constant timer_time_low_address : unsigned(31 downto 0) := x"F0002000";
  subtype timer_time_low_cycles_bits is natural range 31 downto 0;
  type timer_time_low_t is record
    cycles : unsigned(31 downto 0);
  end record;
  function to_word(value : timer_time_low_t) return std_ulogic_vector;
  function to_timer_time_low(word : std_ulogic_vector(31 downto 0)) return timer_time_low_t;

  -- High word: Clocks since reset. Reading the low word holds the high word of the same instant.
  constant timer_time_high_address : unsigned(31 downto 0) := x"F0002004";
  subtype timer_time_high_cycles_bits is natural range 31 downto 0;
  type timer_time_high_t is record
    cycles : unsigned(31 downto 0);
  end record;
  function to_word(value : timer_time_high_t) return std_ulogic_vector;
  function to_timer_time_high(word : std_ulogic_vector(31 downto 0)) return timer_time_high_t;

  -- Low word: The deadline. It takes effect with the write of the high word; from then on the interrupt is on, until a later one is set.
  constant timer_compare_low_address : unsigned(31 downto 0) := x"F0002008";
  subtype timer_compare_low_cycles_bits is natural range 31 downto 0;
  type timer_compare_low_t is record
    cycles : unsigned(31 downto 0);
  end record;
  constant timer_compare_low_after_reset : timer_compare_low_t := (cycles => 32x"FFFFFFFF");
  function to_word(value : timer_compare_low_t) return std_ulogic_vector;
  function to_timer_compare_low(word : std_ulogic_vector(31 downto 0)) return timer_compare_low_t;

  -- High word: The deadline. It takes effect with the write of the high word; from then on the interrupt is on, until a later one is set.
  constant timer_compare_high_address : unsigned(31 downto 0) := x"F000200C";
  subtype timer_compare_high_cycles_bits is natural range 31 downto 0;
  type timer_compare_high_t is record
    cycles : unsigned(31 downto 0);
  end record;
  function to_word(value : timer_compare_high_t) return std_ulogic_vector;
  function to_timer_compare_high(word : std_ulogic_vector(31 downto 0)) return timer_compare_high_t;

  type timer_from_software_t is record
    time_low_read : std_ulogic;
    compare_low : timer_compare_low_t;
    compare_high : timer_compare_high_t;
    compare_high_written : std_ulogic;
  end record;

  type timer_to_software_t is record
    time_low : timer_time_low_t;
    time_high : timer_time_high_t;
    compare_high : timer_compare_high_t;
  end record;

end package;

package body timer_registers_pkg is

  function to_word(value : timer_time_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_timer_time_low(word : std_ulogic_vector(31 downto 0)) return timer_time_low_t is
  begin
    return (
      cycles => unsigned(word(timer_time_low_cycles_bits)));
  end function;

  function to_word(value : timer_time_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_timer_time_high(word : std_ulogic_vector(31 downto 0)) return timer_time_high_t is
  begin
    return (
      cycles => unsigned(word(timer_time_high_cycles_bits)));
  end function;

  function to_word(value : timer_compare_low_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_timer_compare_low(word : std_ulogic_vector(31 downto 0)) return timer_compare_low_t is
  begin
    return (
      cycles => unsigned(word(timer_compare_low_cycles_bits)));
  end function;

  function to_word(value : timer_compare_high_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.cycles);
  end function;

  function to_timer_compare_high(word : std_ulogic_vector(31 downto 0)) return timer_compare_high_t is
  begin
    return (
      cycles => unsigned(word(timer_compare_high_cycles_bits)));
  end function;

end package body;
