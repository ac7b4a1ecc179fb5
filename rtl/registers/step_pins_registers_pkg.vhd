-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `step_pins`. Generated from rtl/motion/step_pins.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_pins_registers_pkg is

  constant step_pins_address : unsigned(31 downto 0) := x"F0008000";

  -- Who drives the pins. Changed only where the chip permits software stepping (status.permitted), while the step generator is idle and no step pin would change; refused otherwise.
  constant step_pins_control_address : unsigned(31 downto 0) := x"F0008000";
  constant step_pins_control_software_bit : natural := 0;
  type step_pins_control_t is record
    software : std_ulogic;
  end record;
  function to_word(value : step_pins_control_t) return std_ulogic_vector;
  function to_step_pins_control(word : std_ulogic_vector(31 downto 0)) return step_pins_control_t;

  -- Step pins, bit n for axis n. All change in the same clock.
  constant step_pins_step_address : unsigned(31 downto 0) := x"F0008004";
  subtype step_pins_step_pins_bits is natural range 7 downto 0;
  type step_pins_step_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;
  constant step_pins_step_after_reset : step_pins_step_t := (pins => 8x"0");
  function to_word(value : step_pins_step_t) return std_ulogic_vector;
  function to_step_pins_step(word : std_ulogic_vector(31 downto 0)) return step_pins_step_t;

  -- Direction pins, bit n for axis n.
  constant step_pins_direction_address : unsigned(31 downto 0) := x"F0008008";
  subtype step_pins_direction_pins_bits is natural range 7 downto 0;
  type step_pins_direction_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;
  constant step_pins_direction_after_reset : step_pins_direction_t := (pins => 8x"0");
  function to_word(value : step_pins_direction_t) return std_ulogic_vector;
  function to_step_pins_direction(word : std_ulogic_vector(31 downto 0)) return step_pins_direction_t;

  -- Emergency stop: works without software.
  constant step_pins_stop_address : unsigned(31 downto 0) := x"F000800C";
  constant step_pins_stop_stopped_bit : natural := 0;
  type step_pins_stop_t is record
    stopped : std_ulogic;
  end record;
  function to_word(value : step_pins_stop_t) return std_ulogic_vector;
  function to_step_pins_stop(word : std_ulogic_vector(31 downto 0)) return step_pins_stop_t;

  -- Whether software may drive the pins.
  constant step_pins_status_address : unsigned(31 downto 0) := x"F0008010";
  constant step_pins_status_permitted_bit : natural := 0;
  constant step_pins_status_refused_bit : natural := 1;
  type step_pins_status_t is record
    permitted : std_ulogic;
    refused : std_ulogic;
  end record;
  function to_word(value : step_pins_status_t) return std_ulogic_vector;
  function to_step_pins_status(word : std_ulogic_vector(31 downto 0)) return step_pins_status_t;

  type step_pins_from_software_t is record
    control : step_pins_control_t;
    control_written : std_ulogic;
    step : step_pins_step_t;
    direction : step_pins_direction_t;
    stop : step_pins_stop_t;
    stop_written : std_ulogic;
    status : step_pins_status_t;
    status_written : std_ulogic;
  end record;

  type step_pins_to_software_t is record
    control : step_pins_control_t;
    stop : step_pins_stop_t;
    status : step_pins_status_t;
  end record;

end package;

package body step_pins_registers_pkg is

  function to_word(value : step_pins_control_t) return std_ulogic_vector is
  begin
    return "0000000000000000000000000000000" & value.software;
  end function;

  function to_step_pins_control(word : std_ulogic_vector(31 downto 0)) return step_pins_control_t is
  begin
    return (
      software => word(step_pins_control_software_bit));
  end function;

  function to_word(value : step_pins_step_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & value.pins;
  end function;

  function to_step_pins_step(word : std_ulogic_vector(31 downto 0)) return step_pins_step_t is
  begin
    return (
      pins => word(step_pins_step_pins_bits));
  end function;

  function to_word(value : step_pins_direction_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000" & value.pins;
  end function;

  function to_step_pins_direction(word : std_ulogic_vector(31 downto 0)) return step_pins_direction_t is
  begin
    return (
      pins => word(step_pins_direction_pins_bits));
  end function;

  function to_word(value : step_pins_stop_t) return std_ulogic_vector is
  begin
    return "0000000000000000000000000000000" & value.stopped;
  end function;

  function to_step_pins_stop(word : std_ulogic_vector(31 downto 0)) return step_pins_stop_t is
  begin
    return (
      stopped => word(step_pins_stop_stopped_bit));
  end function;

  function to_word(value : step_pins_status_t) return std_ulogic_vector is
  begin
    return "000000000000000000000000000000" & value.refused & value.permitted;
  end function;

  function to_step_pins_status(word : std_ulogic_vector(31 downto 0)) return step_pins_status_t is
  begin
    return (
      permitted => word(step_pins_status_permitted_bit),
  refused => word(step_pins_status_refused_bit));
  end function;

end package body;
