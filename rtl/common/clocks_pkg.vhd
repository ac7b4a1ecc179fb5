-- SPDX-License-Identifier: Apache-2.0
-- The chip's clock for each of its parts, and what goes with each.

library ieee;
use ieee.std_logic_1164.all;

package clocks_pkg is

  -- One clock. Each part that is often at rest has it for itself, so that it can be gated: a model leaves the
  -- edges out that change nothing. On a board all are the same.
  type clocks_t is record
    -- Never gated: what counts or integrates in every clock.
    free_running : std_ulogic;
    -- Processor, memory, and what they wake up by.
    processor : std_ulogic;
    -- The registers on the bus, but for the timer's.
    registers : std_ulogic;
    -- Step generator and step pins.
    axes : std_ulogic;
    -- Serial line, end stops, sensors and heaters.
    peripherals : std_ulogic;
  end record;

  -- Each gated clock is at rest: its next edge changes nothing, but for the one after an input has changed.
  type clocks_at_rest_t is record
    processor : std_ulogic;
    registers : std_ulogic;
    axes : std_ulogic;
    peripherals : std_ulogic;
  end record;

  -- A synchronous reset for each clock, so that nothing behind the registers of a clock at rest is driven by
  -- another. The registers have the processor's.
  type resets_t is record
    free_running : std_ulogic;
    processor : std_ulogic;
    axes : std_ulogic;
    peripherals : std_ulogic;
  end record;

end package;
