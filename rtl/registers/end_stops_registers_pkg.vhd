-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `end_stops`. Generated from rtl/motion/end_stops.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package end_stops_registers_pkg is

  constant end_stops_address : unsigned(31 downto 0) := x"F0004000";

  -- Levels of the eight inputs at each stage, bit n for input n.
  constant end_stops_status_address : unsigned(31 downto 0) := x"F0004000";
  subtype end_stops_status_raw_bits is natural range 7 downto 0;
  subtype end_stops_status_filtered_bits is natural range 15 downto 8;
  subtype end_stops_status_triggered_bits is natural range 23 downto 16;
  type end_stops_status_t is record
    raw : std_ulogic_vector(7 downto 0);
    filtered : std_ulogic_vector(7 downto 0);
    triggered : std_ulogic_vector(7 downto 0);
  end record;
  function to_word(value : end_stops_status_t) return std_ulogic_vector;
  function to_end_stops_status(word : std_ulogic_vector(31 downto 0)) return end_stops_status_t;

  -- How long a level must be stable.
  constant end_stops_filter_address : unsigned(31 downto 0) := x"F0004004";
  subtype end_stops_filter_cycles_bits is natural range 15 downto 0;
  type end_stops_filter_t is record
    cycles : unsigned(15 downto 0);
  end record;
  constant end_stops_filter_after_reset : end_stops_filter_t := (cycles => 16x"64");
  function to_word(value : end_stops_filter_t) return std_ulogic_vector;
  function to_end_stops_filter(word : std_ulogic_vector(31 downto 0)) return end_stops_filter_t;

  -- Which level means triggered.
  constant end_stops_polarity_address : unsigned(31 downto 0) := x"F0004008";
  subtype end_stops_polarity_active_low_bits is natural range 7 downto 0;
  type end_stops_polarity_t is record
    active_low : std_ulogic_vector(7 downto 0);
  end record;
  constant end_stops_polarity_after_reset : end_stops_polarity_t := (active_low => 8x"0");
  function to_word(value : end_stops_polarity_t) return std_ulogic_vector;
  function to_end_stops_polarity(word : std_ulogic_vector(31 downto 0)) return end_stops_polarity_t;

  -- Which inputs have a switch.
  constant end_stops_enable_address : unsigned(31 downto 0) := x"F000400C";
  subtype end_stops_enable_inputs_bits is natural range 7 downto 0;
  type end_stops_enable_t is record
    inputs : std_ulogic_vector(7 downto 0);
  end record;
  constant end_stops_enable_after_reset : end_stops_enable_t := (inputs => 8x"0");
  function to_word(value : end_stops_enable_t) return std_ulogic_vector;
  function to_end_stops_enable(word : std_ulogic_vector(31 downto 0)) return end_stops_enable_t;

  type end_stops_from_software_t is record
    filter : end_stops_filter_t;
    polarity : end_stops_polarity_t;
    enable : end_stops_enable_t;
  end record;

  type end_stops_to_software_t is record
    status : end_stops_status_t;
  end record;

end package;

package body end_stops_registers_pkg is

  function to_word(value : end_stops_status_t) return std_ulogic_vector is
  begin
    return "00000000" & value.triggered & value.filtered & value.raw;
  end function;

  function to_end_stops_status(word : std_ulogic_vector(31 downto 0)) return end_stops_status_t is
  begin
    return (
      raw => word(end_stops_status_raw_bits),
  filtered => word(end_stops_status_filtered_bits),
  triggered => word(end_stops_status_triggered_bits));
  end function;

  function to_word(value : end_stops_filter_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.cycles);
  end function;

  function to_end_stops_filter(word : std_ulogic_vector(31 downto 0)) return end_stops_filter_t is
  begin
    return (
      cycles => unsigned(word(end_stops_filter_cycles_bits)));
  end function;

  function to_word(value : end_stops_polarity_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & value.active_low;
  end function;

  function to_end_stops_polarity(word : std_ulogic_vector(31 downto 0)) return end_stops_polarity_t is
  begin
    return (
      active_low => word(end_stops_polarity_active_low_bits));
  end function;

  function to_word(value : end_stops_enable_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & value.inputs;
  end function;

  function to_end_stops_enable(word : std_ulogic_vector(31 downto 0)) return end_stops_enable_t is
  begin
    return (
      inputs => word(end_stops_enable_inputs_bits));
  end function;

end package body;
