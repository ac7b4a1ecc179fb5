-- SPDX-License-Identifier: Apache-2.0
-- Holds what must not change in motion: guard times, edge mode, rate floor. Refuses writes in motion.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity motion_settings is
  generic (
    axes : positive range 1 to axis_limit := 5
  );
  port (
    -- May be gated while no access is made.
    clk : in std_ulogic;
    reset : in std_ulogic;
    from_software : in step_generator_from_software_t;

    -- Nothing moves or is queued, and all pulses and guard times have ended.
    idle : in std_ulogic;
    -- The step pins: while one is high its edge mode stays, as a change would add or lose an edge.
    step : in std_ulogic_vector(axes - 1 downto 0);

    guards : out guard_array_t(axes - 1 downto 0) := (others => guard_after_reset);
    both_edges : out std_ulogic_vector(axes - 1 downto 0) := (others => '0');
    -- Never 0: every segment comes to its end.
    rate_floor : out unsigned(30 downto 0) := rate_floor_after_reset;

    -- In the clock of the write.
    refused : out std_ulogic
  );
end entity;

architecture rtl of motion_settings is

  signal floor_is_legal : std_ulogic;
  signal floor_refused : std_ulogic;
  signal guards_refused : std_ulogic_vector(axes - 1 downto 0);

begin

  refused <= floor_refused or (or guards_refused);

  floor_is_legal <= idle when from_software.rate_floor.rate /= 0 else '0';
  floor_refused <= from_software.rate_floor_written and not floor_is_legal;

  keep_floor : process
  begin
    wait until rising_edge(clk);
    if from_software.rate_floor_written and floor_is_legal then
      rate_floor <= from_software.rate_floor.rate;
    end if;
    if reset then
      rate_floor <= rate_floor_after_reset;
    end if;
  end process;

  each_axis : for axis in 0 to axes - 1 generate
    signal guard : guard_t := guard_after_reset;
    -- Outside the record: a bit that is used in every clock simulates faster on its own.
    signal falling_too : std_ulogic := '0';
    signal edges_may_change : std_ulogic;
  begin
    guards(axis) <= guard;
    both_edges(axis) <= falling_too;

    edges_may_change <= '1' when step(axis) = '0' or
      from_software.pulse_guard(axis).both_edges = falling_too else '0';
    guards_refused(axis) <=
      (from_software.pulse_guard_written(axis) and not (idle and edges_may_change)) or
      (from_software.direction_guard_written(axis) and not idle);

    keep_guard : process
    begin
      wait until rising_edge(clk);
      if from_software.pulse_guard_written(axis) and idle and edges_may_change then
        guard.high <= from_software.pulse_guard(axis).high;
        guard.low <= from_software.pulse_guard(axis).low;
        falling_too <= from_software.pulse_guard(axis).both_edges;
      end if;
      if from_software.direction_guard_written(axis) and idle then
        guard.direction_setup <= from_software.direction_guard(axis).setup;
        guard.direction_hold <= from_software.direction_guard(axis).hold;
      end if;
      if reset then
        guard <= guard_after_reset;
        falling_too <= '0';
      end if;
    end process;
  end generate;

end architecture;
