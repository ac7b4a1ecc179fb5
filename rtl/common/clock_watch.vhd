-- SPDX-License-Identifier: Apache-2.0
-- Opens the heaters' supply when the chip's clock stops, as seen by an independent oscillator.

library ieee;
use ieee.std_logic_1164.all;

-- Without its clock the chip keeps every output, also a heater that is on. For boards with a second clock.
entity clock_watch is
  generic (
    -- Clocks of `clk` between two beats, by which it shows that it runs.
    beat_clocks : positive := 256;
    -- Clocks of `watch_clk` without a beat after which `clk` is lost: several beats, at the largest
    -- ratio of the two.
    patience_clocks : positive range 4 to 4095 := 64
  );
  port (
    clk : in std_ulogic;
    -- Independent of `clk`.
    watch_clk : in std_ulogic;
    -- Of `clk`: the chip wants the supply closed.
    wanted : in std_ulogic;
    -- To the relay. Opens at once when it is not requested; after a loss it stays open until the
    -- request has ended once.
    closed : out std_ulogic;
    -- Of `watch_clk`: it is held open.
    veto : out std_ulogic
  );
end entity;

architecture rtl of clock_watch is

  signal phase : natural range 0 to beat_clocks - 1 := 0;
  signal beat : std_ulogic := '0';
  signal beat_synchronized, wanted_synchronized, last_beat : std_ulogic := '0';
  signal silent_clocks : natural range 0 to patience_clocks := 0;
  signal lost : std_ulogic := '1';

begin

  show_that_it_runs : process
  begin
    wait until rising_edge(clk);
    if phase = beat_clocks - 1 then
      phase <= 0;
      beat <= not beat;
    else
      phase <= phase + 1;
    end if;
  end process;

  cross : entity work.synchronizer
    generic map (width => 2)
    port map (
      clk => watch_clk,
      asynchronous => (0 => beat, 1 => wanted),
      synchronous(0) => beat_synchronized,
      synchronous(1) => wanted_synchronized,
      settling => open);

  watch : process
  begin
    wait until rising_edge(watch_clk);
    last_beat <= beat_synchronized;
    if beat_synchronized /= last_beat then
      silent_clocks <= 0;
    elsif silent_clocks /= patience_clocks then
      silent_clocks <= silent_clocks + 1;
    end if;
    if silent_clocks = patience_clocks then
      lost <= '1';
    elsif not wanted_synchronized then
      lost <= '0';
    end if;
  end process;

  closed <= wanted and not lost;
  veto <= lost;

end architecture;
