-- SPDX-License-Identifier: Apache-2.0
-- Registers of `end_stops`. Generated from rtl/motion/end_stops.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package end_stops_registers_pkg is

  constant end_stops_address : unsigned(31 downto 0) := x"F0004000";

  -- Levels of the eight inputs at each stage, bit n for input n.
  type end_stops_status_t is record
    raw : std_ulogic_vector(7 downto 0);
    filtered : std_ulogic_vector(7 downto 0);
    triggered : std_ulogic_vector(7 downto 0);
  end record;

  -- How long a level must be stable.
  type end_stops_filter_t is record
    cycles : unsigned(15 downto 0);
  end record;

  -- Which level means triggered.
  type end_stops_polarity_t is record
    active_low : std_ulogic_vector(7 downto 0);
  end record;

  -- Which inputs have a switch.
  type end_stops_enable_t is record
    inputs : std_ulogic_vector(7 downto 0);
  end record;

  type end_stops_from_software_t is record
    filter : end_stops_filter_t;
    polarity : end_stops_polarity_t;
    enable : end_stops_enable_t;
  end record;

  type end_stops_to_software_t is record
    status : end_stops_status_t;
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.end_stops_registers_pkg.all;

entity end_stops_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out end_stops_from_software_t;
    to_software : in end_stops_to_software_t
  );
end entity;

architecture rtl of end_stops_registers is

  signal answered : std_ulogic := '0';
  signal filter_stored : std_ulogic_vector(31 downto 0) := x"00000064";
  signal polarity_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal enable_stored : std_ulogic_vector(31 downto 0) := x"00000000";

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
            word(7 downto 0) := to_software.status.raw;
            word(15 downto 8) := to_software.status.filtered;
            word(23 downto 16) := to_software.status.triggered;
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(15 downto 0) := filter_stored(15 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            filter_stored(15 downto 0) <= request.data(15 downto 0);
          end if;
        when 2 =>
          if not request.write then
            known := true;
            word(7 downto 0) := polarity_stored(7 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            polarity_stored(7 downto 0) <= request.data(7 downto 0);
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(7 downto 0) := enable_stored(7 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            enable_stored(7 downto 0) <= request.data(7 downto 0);
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
      filter_stored <= x"00000064";
      polarity_stored <= x"00000000";
      enable_stored <= x"00000000";
    end if;
  end process;

  from_software.filter.cycles <= unsigned(filter_stored(15 downto 0));

  from_software.polarity.active_low <= polarity_stored(7 downto 0);

  from_software.enable.inputs <= enable_stored(7 downto 0);

end architecture;
