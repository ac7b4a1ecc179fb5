-- SPDX-License-Identifier: Apache-2.0
-- Watches a feed_override: it rests where it says so, leaps no further than it may, and what its scale owes
-- and what the base has done is counted.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

entity feed_override_watch is
  port (
    clk : in std_ulogic;
    reset, moving : in std_ulogic;
    target : in unsigned(17 downto 0);
    slope : in slope_t;
    accelerating, decelerating, braking : in std_ulogic;
    brake_slope : in slope_t;
    stalled : in std_ulogic;
    longest_leap : in leap_t;
    advance : in std_ulogic;
    leap : in leap_t;
    scale : in scale_t;
    standing, working : in std_ulogic;

    -- Base clocks done, and how many the scale has owed, both while moving; the latter in 2^-32.
    done : buffer natural := 0;
    owed : buffer unsigned(63 downto 0) := (others => '0');
    clear : in boolean
  );
end entity;

architecture simulation of feed_override_watch is

  signal permitted_leap : leap_t := to_unsigned(2, 2);

begin

  -- Without work, and with the inputs as they are for three clocks, an edge of the clock changes nothing.
  watch_work : process
    variable inputs, inputs_before : std_ulogic_vector(89 downto 0) := (others => '0');
    variable outputs, outputs_before : std_ulogic_vector(37 downto 0) := (others => '0');
    variable quiet_clocks : natural := 0;
  begin
    wait until rising_edge(clk);
    inputs := reset & moving & std_ulogic_vector(target) & std_ulogic_vector(slope) & accelerating
      & decelerating & braking & std_ulogic_vector(brake_slope) & stalled & std_ulogic_vector(longest_leap);
    outputs := advance & std_ulogic_vector(leap) & std_ulogic_vector(scale) & standing;
    nothing_changes_without_work : assert quiet_clocks < 3 or outputs = outputs_before
      report "changes without work" severity failure;
    quiet_clocks := quiet_clocks + 1 when working = '0' and inputs = inputs_before else 0;
    inputs_before := inputs;
    outputs_before := outputs;
  end process;

  count : process
  begin
    wait until rising_edge(clk);
    if clear then
      done <= 0;
      owed <= (others => '0');
    elsif moving = '1' and stalled = '0' then
      owed <= owed + scale;
      if advance then
        done <= done + 2 ** to_integer(leap);
      end if;
    end if;
    assert leap <= permitted_leap report "leap too long" severity failure;
    if not stalled then
      permitted_leap <= longest_leap;
    end if;
  end process;

end architecture;
