-- SPDX-License-Identifier: Apache-2.0
-- Registers of `identity`. Generated from rtl/bus/identity.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package identity_registers_pkg is

  constant identity_address : unsigned(31 downto 0) := x"F0000000";

  -- Tells that this is the design that the rest of the map belongs to.
  type identity_magic_t is record
    word : unsigned(31 downto 0);
  end record;
  constant identity_magic_word_stepfabric : natural := 1397113154;

  -- Version of the design. The same major number means that old firmware still runs.
  type identity_version_t is record
    major : unsigned(15 downto 0);
    minor : unsigned(7 downto 0);
    patch : unsigned(7 downto 0);
  end record;

  -- The one clock of the chip.
  type identity_clock_t is record
    frequency_hz : unsigned(31 downto 0);
  end record;

  -- Memory at 0x80000000.
  type identity_memory_t is record
    size_bytes : unsigned(31 downto 0);
  end record;

  -- Sizes of the step generator.
  type identity_motion_t is record
    axes : unsigned(7 downto 0);
    queue_depth : unsigned(15 downto 0);
  end record;

  -- Sizes of the thermal part.
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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.identity_registers_pkg.all;

entity identity_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    to_software : in identity_to_software_t
  );
end entity;

architecture rtl of identity_registers is

  signal answered : std_ulogic := '0';

begin

  -- Answers in the clock after the strobe: whole words only, errors for everything not described.
  answer : process
    variable word : std_ulogic_vector(31 downto 0);
    variable known : boolean;
  begin
    wait until rising_edge(clk);
    if answered then
      response <= bus_response_idle;
      answered <= '0';
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.magic.word);
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(31 downto 16) := std_ulogic_vector(to_software.version.major);
            word(15 downto 8) := std_ulogic_vector(to_software.version.minor);
            word(7 downto 0) := std_ulogic_vector(to_software.version.patch);
          end if;
        when 2 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.clock.frequency_hz);
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.memory.size_bytes);
          end if;
        when 4 =>
          if not request.write then
            known := true;
            word(7 downto 0) := std_ulogic_vector(to_software.motion.axes);
            word(31 downto 16) := std_ulogic_vector(to_software.motion.queue_depth);
          end if;
        when 5 =>
          if not request.write then
            known := true;
            word(7 downto 0) := std_ulogic_vector(to_software.thermal.sensors);
            word(15 downto 8) := std_ulogic_vector(to_software.thermal.heaters);
          end if;
        when others =>
          null;
      end case;
      if known then
        response.acknowledge <= '1';
        response.data <= word;
      else
        response.error <= '1';
      end if;
    end if;
    if reset then
      response <= bus_response_idle;
      answered <= '0';
    end if;
  end process;

end architecture;
