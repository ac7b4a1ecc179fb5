-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `identity`. Generated from rtl/bus/identity.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package identity_registers_pkg is

  constant identity_address : unsigned(31 downto 0) := x"F0000000";

  -- Says that this is the design that the rest of the map belongs to.
  constant identity_magic_address : unsigned(31 downto 0) := x"F0000000";
  subtype identity_magic_word_bits is natural range 31 downto 0;
  type identity_magic_t is record
    word : unsigned(31 downto 0);
  end record;
  constant identity_magic_word_stepfabric : natural := 1397113154;
  function to_word(value : identity_magic_t) return std_ulogic_vector;
  function to_identity_magic(word : std_ulogic_vector(31 downto 0)) return identity_magic_t;

  -- Version of the design. The same major number means that old firmware still runs.
  constant identity_version_address : unsigned(31 downto 0) := x"F0000004";
  subtype identity_version_major_bits is natural range 31 downto 16;
  subtype identity_version_minor_bits is natural range 15 downto 8;
  subtype identity_version_patch_bits is natural range 7 downto 0;
  type identity_version_t is record
    major : unsigned(15 downto 0);
    minor : unsigned(7 downto 0);
    patch : unsigned(7 downto 0);
  end record;
  function to_word(value : identity_version_t) return std_ulogic_vector;
  function to_identity_version(word : std_ulogic_vector(31 downto 0)) return identity_version_t;

  -- The one clock of the chip.
  constant identity_clock_address : unsigned(31 downto 0) := x"F0000008";
  subtype identity_clock_frequency_hz_bits is natural range 31 downto 0;
  type identity_clock_t is record
    frequency_hz : unsigned(31 downto 0);
  end record;
  function to_word(value : identity_clock_t) return std_ulogic_vector;
  function to_identity_clock(word : std_ulogic_vector(31 downto 0)) return identity_clock_t;

  -- Memory at 0x80000000.
  constant identity_memory_address : unsigned(31 downto 0) := x"F000000C";
  subtype identity_memory_size_bytes_bits is natural range 31 downto 0;
  type identity_memory_t is record
    size_bytes : unsigned(31 downto 0);
  end record;
  function to_word(value : identity_memory_t) return std_ulogic_vector;
  function to_identity_memory(word : std_ulogic_vector(31 downto 0)) return identity_memory_t;

  -- Sizes of the step generator.
  constant identity_motion_address : unsigned(31 downto 0) := x"F0000010";
  subtype identity_motion_axes_bits is natural range 7 downto 0;
  subtype identity_motion_queue_depth_bits is natural range 31 downto 16;
  type identity_motion_t is record
    axes : unsigned(7 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;
  function to_word(value : identity_motion_t) return std_ulogic_vector;
  function to_identity_motion(word : std_ulogic_vector(31 downto 0)) return identity_motion_t;

  -- Sizes of the thermal part.
  constant identity_thermal_address : unsigned(31 downto 0) := x"F0000014";
  subtype identity_thermal_sensors_bits is natural range 7 downto 0;
  subtype identity_thermal_heaters_bits is natural range 15 downto 8;
  type identity_thermal_t is record
    sensors : unsigned(7 downto 0);
    heaters : unsigned(7 downto 0);
  end record;
  function to_word(value : identity_thermal_t) return std_ulogic_vector;
  function to_identity_thermal(word : std_ulogic_vector(31 downto 0)) return identity_thermal_t;

  type identity_to_software_t is record
    magic : identity_magic_t;
    version : identity_version_t;
    clock : identity_clock_t;
    memory : identity_memory_t;
    motion : identity_motion_t;
    thermal : identity_thermal_t;
  end record;

end package;

package body identity_registers_pkg is

  function to_word(value : identity_magic_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.word);
  end function;

  function to_identity_magic(word : std_ulogic_vector(31 downto 0)) return identity_magic_t is
  begin
    return (
      word => unsigned(word(identity_magic_word_bits)));
  end function;

  function to_word(value : identity_version_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.major) & std_ulogic_vector(value.minor) & std_ulogic_vector(value.patch);
  end function;

  function to_identity_version(word : std_ulogic_vector(31 downto 0)) return identity_version_t is
  begin
    return (
      major => unsigned(word(identity_version_major_bits)),
  minor => unsigned(word(identity_version_minor_bits)),
  patch => unsigned(word(identity_version_patch_bits)));
  end function;

  function to_word(value : identity_clock_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.frequency_hz);
  end function;

  function to_identity_clock(word : std_ulogic_vector(31 downto 0)) return identity_clock_t is
  begin
    return (
      frequency_hz => unsigned(word(identity_clock_frequency_hz_bits)));
  end function;

  function to_word(value : identity_memory_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.size_bytes);
  end function;

  function to_identity_memory(word : std_ulogic_vector(31 downto 0)) return identity_memory_t is
  begin
    return (
      size_bytes => unsigned(word(identity_memory_size_bytes_bits)));
  end function;

  function to_word(value : identity_motion_t) return std_ulogic_vector is
  begin
    return std_ulogic_vector(value.queue_depth) & "00000000" & std_ulogic_vector(value.axes);
  end function;

  function to_identity_motion(word : std_ulogic_vector(31 downto 0)) return identity_motion_t is
  begin
    return (
      axes => unsigned(word(identity_motion_axes_bits)),
  queue_depth => unsigned(word(identity_motion_queue_depth_bits)));
  end function;

  function to_word(value : identity_thermal_t) return std_ulogic_vector is
  begin
    return "0000000000000000" & std_ulogic_vector(value.heaters) & std_ulogic_vector(value.sensors);
  end function;

  function to_identity_thermal(word : std_ulogic_vector(31 downto 0)) return identity_thermal_t is
  begin
    return (
      sensors => unsigned(word(identity_thermal_sensors_bits)),
  heaters => unsigned(word(identity_thermal_heaters_bits)));
  end function;

end package body;
