-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `end_stops`. Generated from rtl/motion/end_stops.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package end_stops_registers_pkg is

  constant end_stops_address : unsigned(31 downto 0) := x"F0004000";

  -- Levels of the eight inputs at each stage, bit n for input n.
  constant end_stops_status_address : unsigned(31 downto 0) := x"F0004000";
  type end_stops_status_t is record
    raw : std_ulogic_vector(7 downto 0);
    filtered : std_ulogic_vector(7 downto 0);
    triggered : std_ulogic_vector(7 downto 0);
  end record;

  -- How long a level must be stable.
  constant end_stops_filter_address : unsigned(31 downto 0) := x"F0004004";
  type end_stops_filter_t is record
    cycles : unsigned(15 downto 0);
  end record;

  -- Which level means triggered.
  constant end_stops_polarity_address : unsigned(31 downto 0) := x"F0004008";
  type end_stops_polarity_t is record
    active_low : std_ulogic_vector(7 downto 0);
  end record;

  -- Which inputs have a switch.
  constant end_stops_enable_address : unsigned(31 downto 0) := x"F000400C";
  type end_stops_enable_t is record
    inputs : std_ulogic_vector(7 downto 0);
  end record;

  type end_stops_from_software_t is record
    filter : end_stops_filter_t;
    polarity : end_stops_polarity_t;
    enable : end_stops_enable_t;
  end record;

  type end_stops_to_software_t is record
    status : end_stops_status_t;
  end record;

end package;
