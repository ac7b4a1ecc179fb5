-- SPDX-License-Identifier: Apache-2.0
-- Reports to software what this chip is: constants given by the entity that composes the chip.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.identity_registers_pkg.all;

entity identity is
  generic (
    memory_size_bytes : positive := 65_536;
    axes : positive := 5;
    queue_depth : positive := 16;
    sensors : natural := 2;
    heaters : natural := 2
  );
  port (
    -- May be gated while no access is made.
    clk : in std_ulogic;
    -- Of `clk`: a constant on a board, chosen for each run in co-simulation.
    clock_frequency_hz : in unsigned(31 downto 0);
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t
  );
end entity;

architecture rtl of identity is

  -- The design's version, as in the changelog.
  constant version_major : natural := 0;
  constant version_minor : natural := 1;
  constant version_patch : natural := 0;

  signal to_software : identity_to_software_t;

begin

  to_software <= (
    magic => (word => to_unsigned(identity_magic_word_stepfabric, 32)),
    version => (
      major => to_unsigned(version_major, 16),
      minor => to_unsigned(version_minor, 8),
      patch => to_unsigned(version_patch, 8)
    ),
    clock => (frequency_hz => clock_frequency_hz),
    memory => (size_bytes => to_unsigned(memory_size_bytes, 32)),
    motion => (axes => to_unsigned(axes, 8), queue_depth => to_unsigned(queue_depth, 16)),
    thermal => (sensors => to_unsigned(sensors, 8), heaters => to_unsigned(heaters, 8))
  );

  registers : entity work.identity_registers
    port map (
      clk => clk,
      reset => reset,
      request => request,
      response => response,
      to_software => to_software
    );

end architecture;
