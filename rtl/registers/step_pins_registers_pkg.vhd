-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `step_pins`. Generated from rtl/motion/step_pins.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package step_pins_registers_pkg is

  constant step_pins_address : unsigned(31 downto 0) := x"F0008000";

  -- Who drives the pins. To be changed only while nothing moves.
  type step_pins_control_t is record
    software : std_ulogic;
  end record;

  -- Step pins, bit n for axis n. All change in the same clock.
  type step_pins_step_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;

  -- Direction pins, bit n for axis n.
  type step_pins_direction_t is record
    pins : std_ulogic_vector(7 downto 0);
  end record;

  -- Emergency stop: works without software.
  type step_pins_stop_t is record
    stopped : std_ulogic;
  end record;

  type step_pins_from_software_t is record
    control : step_pins_control_t;
    step : step_pins_step_t;
    direction : step_pins_direction_t;
    stop : step_pins_stop_t;
    stop_written : std_ulogic;
  end record;

  type step_pins_to_software_t is record
    stop : step_pins_stop_t;
  end record;

end package;
