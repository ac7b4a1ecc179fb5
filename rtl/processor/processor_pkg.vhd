-- SPDX-License-Identifier: Apache-2.0
-- What travels between the stages of the processor's pipeline, and what it tells to the outside.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package processor_pkg is

  -- One completed instruction, or one that was refused with a trap.
  type retirement_t is record
    valid : std_ulogic;
    -- The instruction at `address` was not completed: an exception, or an interrupt before it.
    trap : std_ulogic;
    address : unsigned(31 downto 0);
    instruction : std_ulogic_vector(31 downto 0);
    -- The register that it wrote, 0 for none, and the value.
    destination : unsigned(4 downto 0);
    value : std_ulogic_vector(31 downto 0);
  end record;

  constant retirement_idle : retirement_t := (
    valid => '0', trap => '0', address => (others => '0'), instruction => (others => '0'),
    destination => (others => '0'), value => (others => '0'));

end package;
