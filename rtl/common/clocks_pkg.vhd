-- SPDX-License-Identifier: Apache-2.0
-- The chip's clock for each of its parts, and what goes with each.

library ieee;
use ieee.std_logic_1164.all;

package clocks_pkg is

  -- One clock. Each part that is often at rest has its own copy, so that a model can gate it. On a
  -- board all are the same net.
  type clocks_t is record
    -- Never gated: what counts or integrates in every clock.
    free_running : std_ulogic;
    -- Processor, memory, and what wakes them.
    processor : std_ulogic;
    -- The registers on the bus, except those of the timer.
    registers : std_ulogic;
    -- Step generator and step pins.
    axes : std_ulogic;
    -- Serial line, end stops, sensors and heaters.
    peripherals : std_ulogic;
  end record;

  -- For each gated clock: its next edge changes nothing, except for the edge after a change of an input.
  type clocks_at_rest_t is record
    processor : std_ulogic;
    registers : std_ulogic;
    axes : std_ulogic;
    peripherals : std_ulogic;
  end record;

  -- A synchronous reset for each clock, so that no logic of a gated clock is driven by another one.
  -- The bus registers use that of the processor.
  type resets_t is record
    free_running : std_ulogic;
    processor : std_ulogic;
    axes : std_ulogic;
    peripherals : std_ulogic;
  end record;

end package;
