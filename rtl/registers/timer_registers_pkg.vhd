-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package timer_registers_pkg is

  constant timer_address : unsigned(31 downto 0) := x"F0002000";

  -- Clocks since reset, low half. Reading it holds the high half of the same instant.
  constant timer_time_low_address : unsigned(31 downto 0) := x"F0002000";
  type timer_time_low_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- High half of the time at which `time_low` was last read.
  constant timer_time_high_address : unsigned(31 downto 0) := x"F0002004";
  type timer_time_high_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- Low half of the deadline. It takes effect with the next write of `compare_high`.
  constant timer_compare_low_address : unsigned(31 downto 0) := x"F0002008";
  type timer_compare_low_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- High half of the deadline. From then on the interrupt is on, until a later one is set.
  constant timer_compare_high_address : unsigned(31 downto 0) := x"F000200C";
  type timer_compare_high_t is record
    cycles : unsigned(31 downto 0);
  end record;

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
