-- SPDX-License-Identifier: Apache-2.0
-- Registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package timer_registers_pkg is

  constant timer_address : unsigned(31 downto 0) := x"F0002000";

  -- Clocks since reset, low half. Reading it holds the high half of the same instant.
  type timer_time_low_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- High half of the time at which `time_low` was last read.
  type timer_time_high_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- Low half of the deadline. It takes effect together with the next write of `compare_high`.
  type timer_compare_low_t is record
    cycles : unsigned(31 downto 0);
  end record;

  -- High half of the deadline. The interrupt is on from the deadline until a later one is set.
  type timer_compare_high_t is record
    cycles : unsigned(31 downto 0);
  end record;

  type timer_from_software_t is record
    time_low_read : std_ulogic;
    compare_low : timer_compare_low_t;
    compare_high : timer_compare_high_t;
    compare_high_written : std_ulogic;
  end record;

  type timer_to_software_t is record
    time_low : timer_time_low_t;
    time_high : timer_time_high_t;
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.timer_registers_pkg.all;

entity timer_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out timer_from_software_t;
    to_software : in timer_to_software_t
  );
end entity;

architecture rtl of timer_registers is

  signal answered : std_ulogic := '0';
  signal compare_low_stored : std_ulogic_vector(31 downto 0) := x"FFFFFFFF";
  signal compare_high_stored : std_ulogic_vector(31 downto 0) := x"FFFFFFFF";

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
      from_software.time_low_read <= '0';
      from_software.compare_high_written <= '0';
    elsif request.strobe then
      word := (others => '0');
      known := false;
      answered <= '1';
      case to_integer(request.address(11 downto 2)) is
        when 0 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.time_low.cycles);
            from_software.time_low_read <= '1';
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(31 downto 0) := std_ulogic_vector(to_software.time_high.cycles);
          end if;
        when 2 =>
          if not request.write then
            known := true;
            word(31 downto 0) := compare_low_stored(31 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            compare_low_stored(31 downto 0) <= request.data(31 downto 0);
          end if;
        when 3 =>
          if not request.write then
            known := true;
            word(31 downto 0) := compare_high_stored(31 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            compare_high_stored(31 downto 0) <= request.data(31 downto 0);
            from_software.compare_high_written <= '1';
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
      from_software.time_low_read <= '0';
      from_software.compare_high_written <= '0';
      compare_low_stored <= x"FFFFFFFF";
      compare_high_stored <= x"FFFFFFFF";
    end if;
  end process;

  from_software.compare_low.cycles <= unsigned(compare_low_stored(31 downto 0));

  from_software.compare_high.cycles <= unsigned(compare_high_stored(31 downto 0));

end architecture;
