-- SPDX-License-Identifier: Apache-2.0
-- Says when a block is at rest: the next edge of its clock would change nothing, and may be left out.

library ieee;
use ieee.std_logic_1164.all;

-- Nothing has to be at rest on a board. A model saves the evaluation of a block that is, so what is reported
-- here must be certain: at rest stays what has had `settling_clocks` edges without any reason to work, so
-- that whatever a reason has set off has come to its end.
entity rest_watch is
  generic (
    -- Edges after the last reason: more than the registers that one lies behind the other in the block.
    settling_clocks : positive := 4
  );
  port (
    -- The clock whose edges may be left out while `at_rest` is high.
    clk : in std_ulogic;
    -- The clock of the block's registers.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    -- Software's access to the block begins or goes on.
    strobe : in std_ulogic;
    -- The block has work that lasts: looked at in the edges that are not left out.
    working : in std_ulogic;
    -- The very next edge counts. All of it must come from registers, and for one that counts while `clk`
    -- rests a clock early, if what acts upon it sees it only through a register.
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
