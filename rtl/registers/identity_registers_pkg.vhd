-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `identity`. Generated from rtl/bus/identity.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package identity_registers_pkg is

  constant identity_address : unsigned(31 downto 0) := x"F0000000";

  -- Says that this is the design that the rest of the map belongs to.
  constant identity_magic_address : unsigned(31 downto 0) := x"F0000000";
  type identity_magic_t is record
    word : unsigned(31 downto 0);
  end record;
  constant identity_magic_word_stepfabric : natural := 1397113154;

  -- Version of the design. The same major number means that old firmware still runs.
  constant identity_version_address : unsigned(31 downto 0) := x"F0000004";
  type identity_version_t is record
    major : unsigned(15 downto 0);
    minor : unsigned(7 downto 0);
    patch : unsigned(7 downto 0);
  end record;

  -- The one clock of the chip.
  constant identity_clock_address : unsigned(31 downto 0) := x"F0000008";
  type identity_clock_t is record
    frequency_hz : unsigned(31 downto 0);
  end record;

  -- Memory at 0x80000000.
  constant identity_memory_address : unsigned(31 downto 0) := x"F000000C";
  type identity_memory_t is record
    size_bytes : unsigned(31 downto 0);
  end record;

  -- Sizes of the step generator.
  constant identity_motion_address : unsigned(31 downto 0) := x"F0000010";
  type identity_motion_t is record
    axes : unsigned(7 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;

  -- Sizes of the thermal part.
  constant identity_thermal_address : unsigned(31 downto 0) := x"F0000014";
  type identity_thermal_t is record
    sensors : unsigned(7 downto 0);
    heaters : unsigned(7 downto 0);
  end record;

  type identity_to_software_t is record
    magic : identity_magic_t;
    version : identity_version_t;
    clock : identity_clock_t;
    memory : identity_memory_t;
    motion : identity_motion_t;
    thermal : identity_thermal_t;
  end record;

end package;
