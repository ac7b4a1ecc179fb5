-- SPDX-License-Identifier: Apache-2.0
-- Registers of `fan`. Generated from rtl/thermal/fan.toml: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package fan_registers_pkg is

  constant fan_address : unsigned(31 downto 0) := x"F0007000";

  -- How much of the time the fan is on. Taken over at the start of a period.
  type fan_duty_t is record
    slots : unsigned(7 downto 0);
  end record;

  -- How long a period is.
  type fan_period_t is record
    slot_cycles : unsigned(23 downto 0);
  end record;

  type fan_from_software_t is record
    duty : fan_duty_t;
    period : fan_period_t;
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.fan_registers_pkg.all;

entity fan_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t := bus_response_idle;
    from_software : out fan_from_software_t
  );
end entity;

architecture rtl of fan_registers is

  signal answered : std_ulogic := '0';
  signal duty_stored : std_ulogic_vector(31 downto 0) := x"00000000";
  signal period_stored : std_ulogic_vector(31 downto 0) := x"00000001";

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
            word(7 downto 0) := duty_stored(7 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            duty_stored(7 downto 0) <= request.data(7 downto 0);
          end if;
        when 1 =>
          if not request.write then
            known := true;
            word(23 downto 0) := period_stored(23 downto 0);
          end if;
          if request.write and (and request.select_bytes) then
            known := true;
            period_stored(23 downto 0) <= request.data(23 downto 0);
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
      duty_stored <= x"00000000";
      period_stored <= x"00000001";
    end if;
  end process;

  from_software.duty.slots <= unsigned(duty_stored(7 downto 0));

  from_software.period.slot_cycles <= unsigned(period_stored(23 downto 0));

end architecture;
