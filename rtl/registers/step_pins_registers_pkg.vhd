-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `step_pins`. Generated from rtl/motion/step_pins.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_pins_registers_pkg is

  constant step_pins_address : unsigned(31 downto 0) := x"F0008000";

  -- Who drives the pins. Changed only where the chip permits software stepping (status.permitted), while the step generator is idle and no step pin would change; refused otherwise.
  constant step_pins_control_address : unsigned(31 downto 0) := x"F0008000";
  type step_pins_control_t is record
    software : std_ulogic;
  end record;

  -- Step pins, bit n for axis n. All change in the same clock.
  constant step_pins_step_address : unsigned(31 downto 0) := x"F0008004";
  type step_pins_step_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;

  -- Direction pins, bit n for axis n.
  constant step_pins_direction_address : unsigned(31 downto 0) := x"F0008008";
  type step_pins_direction_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;

  -- Emergency stop: works without software.
  constant step_pins_stop_address : unsigned(31 downto 0) := x"F000800C";
  type step_pins_stop_t is record
    stopped : std_ulogic;
  end record;

  -- Whether software may drive the pins.
  constant step_pins_status_address : unsigned(31 downto 0) := x"F0008010";
  type step_pins_status_t is record
    permitted : std_ulogic;
    refused : std_ulogic;
  end record;

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
