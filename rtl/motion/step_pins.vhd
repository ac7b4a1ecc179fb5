-- SPDX-License-Identifier: Apache-2.0
-- Lets software drive the step and direction pins instead of the step generator, to compare the two.

library ieee;
use ieee.std_logic_1164.all;

use work.bus_pkg.all;
use work.step_pins_registers_pkg.all;

entity step_pins is
  generic (
    axes : positive range 1 to 8 := 5
  );
  port (
    -- May be gated while `at_rest` is high.
    clk : in std_ulogic;
    -- The same clock for the registers; may be gated while no access is made.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;

    request : in bus_request_t;
    response : out bus_response_t;

    -- Software may take the pins: a constant '0' on a board, '1' in the co-simulation that compares the two.
    -- With '0' the pins are the step generator's at all times.
    software_stepping : in std_ulogic := '0';

    -- Synchronous to clk. From the next clock on no step pin that software drives rises.
    emergency_stop : in std_ulogic;

    -- What the step generator makes.
    generated_step : in std_ulogic_vector(axes - 1 downto 0);
    generated_direction : in std_ulogic_vector(axes - 1 downto 0);
    -- It has no segment, and every pulse is finished.
    generator_idle : in std_ulogic;

    -- The pins: the step generator's without delay, or software's in the second clock after the write.
    step : out std_ulogic_vector(axes - 1 downto 0);
    direction : out std_ulogic_vector(axes - 1 downto 0);
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of step_pins is

  signal from_software : step_pins_from_software_t;
  signal to_software : step_pins_to_software_t;

  -- Software has the pins.
  signal software : std_ulogic := '0';
  signal selects_software : std_ulogic;
  signal may_change : std_ulogic;
  signal refused : std_ulogic := '0';

  signal written_step : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal written_direction : std_ulogic_vector(axes - 1 downto 0) := (others => '0');
  signal stopped : std_ulogic := '0';
  signal stop_begins : std_ulogic;

begin

  registers : entity work.step_pins_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software
    );

  to_software.control.software <= software;
  to_software.status <= (permitted => software_stepping, refused => refused);
  to_software.stop.stopped <= stopped;
  stop_begins <= emergency_stop and not stopped;

  watch_rest : entity work.rest_watch
    port map (
      clk => clk,
      bus_clk => bus_clk,
      reset => reset,
      strobe => request.strobe,
      working => '0',
      alarm => stop_begins,
      at_rest => at_rest
    );

  selects_software <= software and software_stepping;
  step <= written_step when selects_software = '1' else generated_step;
  direction <= written_direction when selects_software = '1' else generated_direction;

  -- This adds and loses no edge.
  may_change <= software_stepping and generator_idle when written_step = generated_step else '0';

  select_pins : process
  begin
    wait until rising_edge(bus_clk);
    if from_software.status_written and from_software.status.refused then
      refused <= '0';
    end if;
    if from_software.control_written = '1' and from_software.control.software /= software then
      if may_change then
        software <= from_software.control.software;
      else
        refused <= '1';
      end if;
    end if;
    if reset then
      software <= '0';
      refused <= '0';
    end if;
  end process;

  drive : process
  begin
    wait until rising_edge(clk);
    written_direction <= from_software.direction.pins(axes - 1 downto 0);
    written_step <= from_software.step.pins(axes - 1 downto 0);
    -- A pulse that has begun keeps its width: software ends it.
    if stopped or emergency_stop then
      written_step <= from_software.step.pins(axes - 1 downto 0) and written_step;
    end if;
    if from_software.stop_written and from_software.stop.stopped then
      stopped <= '0';
    end if;
    if emergency_stop then
      stopped <= '1';
    end if;
    if reset then
      written_step <= (others => '0');
      written_direction <= (others => '0');
      stopped <= '0';
    end if;
  end process;

  each_axis : for axis in 0 to axes - 1 generate
    -- psl default clock is rising_edge(clk);
    -- psl no_step_rises_when_stopped : assert always
    --   ((stopped = '1' and written_step(axis) = '0') -> next (written_step(axis) = '0')) abort reset;
  end generate;

end architecture;
