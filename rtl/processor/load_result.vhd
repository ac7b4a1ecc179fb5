-- SPDX-License-Identifier: Apache-2.0
-- Load alignment: selects a byte, half word or word of the loaded word and extends it to 32 bits.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity load_result is
  port (
    loaded : in word_t;
    lanes : in load_lanes_t;
    -- Zero without lanes.
    result : out word_t
  );
end entity;

architecture rtl of load_result is

  subtype byte_t is std_ulogic_vector(7 downto 0);
  signal signs : std_ulogic_vector(3 downto 0);

  function gated(byte : byte_t; gate : std_ulogic) return byte_t is
  begin
    return byte and (7 downto 0 => gate);
  end function;

begin

  -- Two levels of logic: the loaded word settles late in the clock.
  signs <= loaded(31) & loaded(23) & loaded(15) & loaded(7);
  result(7 downto 0) <= (gated(loaded(31 downto 24), lanes.low(3)) or
                         gated(loaded(23 downto 16), lanes.low(2))) or
                        (gated(loaded(15 downto 8), lanes.low(1)) or
                         gated(loaded(7 downto 0), lanes.low(0)));
  result(15 downto 8) <= gated(loaded(31 downto 24), lanes.second(1)) or
                         gated(loaded(15 downto 8), lanes.second(0)) or
                         (7 downto 0 => (or (signs and lanes.second_sign)));
  result(31 downto 16) <= (loaded(31 downto 16) and (15 downto 0 => lanes.upper)) or
                          (15 downto 0 => (or (signs and lanes.upper_sign)));

end architecture;
