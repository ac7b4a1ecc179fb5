-- SPDX-License-Identifier: Apache-2.0
-- Reports when a block is at rest: the next edge of its clock would change nothing, so the clock
-- may be gated.

library ieee;
use ieee.std_logic_1164.all;

-- On a board no clock has to be gated. A model does not evaluate a block at rest, so the report
-- must be exact: a block is at rest after `settling_clocks` edges without a reason to work, so that
-- all activity which a reason started has ended.
entity rest_watch is
  generic (
    -- Edges after the last reason: more than the longest chain of registers in the block.
    settling_clocks : positive := 4
  );
  port (
    -- The clock that may be gated while `at_rest` is high.
    clk : in std_ulogic;
    -- The clock of the block's registers.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    -- An access of software to the block begins or is in progress.
    strobe : in std_ulogic;
    -- The block has work of several clocks; sampled at the edges that are not gated.
    working : in std_ulogic;
    -- The very next edge is needed. It must come from registers only. From a register that
    -- counts while `clk` is gated it must come a clock early if it is used only through a
    -- further register.
    alarm : in std_ulogic;
    at_rest : out std_ulogic
  );
end entity;

architecture rtl of rest_watch is

  -- An access changes what the block sees up to two clocks after its last strobe.
  signal earlier_strobes : std_ulogic_vector(1 downto 0) := (others => '0');
  signal accessed : std_ulogic := '0';
  signal quiet : std_ulogic_vector(settling_clocks - 1 downto 0) := (others => '0');

begin

  has_at_least_two_settling_clocks : assert settling_clocks >= 2 severity failure;

  watch_accesses : process
  begin
    wait until rising_edge(bus_clk);
    earlier_strobes <= earlier_strobes(0) & strobe;
    accessed <= strobe or (or earlier_strobes);
  end process;

  watch_reasons : process
  begin
    wait until rising_edge(clk);
    quiet <= quiet(quiet'high - 1 downto 0) & '1';
    if reset or working or alarm or accessed then
      quiet <= (others => '0');
    end if;
  end process;

  at_rest <= quiet(quiet'high) and not (reset or alarm or accessed);

end architecture;
