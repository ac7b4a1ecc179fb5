-- SPDX-License-Identifier: Apache-2.0
-- Each instruction takes the clocks that the table of rtl/processor/README.md says, whatever comes before and
-- behind it: what is told follows what was told before after as many clocks as that leaves behind it. Not
-- counted are those in which an access is on the bus, the divider has not ended, or wfi sleeps. That only who
-- reads the late result before it waits is proved of `operand_reader`.

library ieee;
use ieee.std_logic_1164.all;

use work.instruction_set_pkg.all;
use work.retired_instruction_pkg.all;

entity instruction_times is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Completed or refused in this clock; or an interrupt was taken.
    seen : in retired_instruction_t;
    interrupted : in std_ulogic;
    bus_active : in std_ulogic;
    -- It is not the pipeline that holds up what is executed.
    is_held_up : in std_ulogic;
    -- What is executed waits for the late result before it.
    is_waiting : in std_ulogic;
    -- Until something is told, if nothing holds it up.
    clocks_left : in natural range 0 to 7
  );
end entity;

architecture proof of instruction_times is

  -- Clocks of the table, less the one in which the next instruction could be completed.
  constant behind_traps_and_returns : natural := 4 - 1;
  constant behind_reset : natural := behind_traps_and_returns + 1;
  constant behind_late_jumps : natural := 3 - 1;
  constant behind_early_jumps : natural := 2 - 1;

  signal started : std_ulogic := '0';
  signal told, is_early, is_so, has_waited, waits : std_ulogic := '0';
  signal quiet_for : natural range 0 to 7 := 0;
  signal behind, behind_this : natural range 0 to 4 := 0;
  signal more, more_behind_this : natural range 0 to 1;

  default clock is rising_edge(clk);

begin

  told <= seen.completed or seen.refused or interrupted;
  -- bne, bge, bgeu backwards.
  is_early <= seen.word(31) and seen.word(12);
  is_so <= '1' when is_taken(seen.word, seen.first, seen.second) else '0';

  tell_what_is_behind : process (all)
  begin
    behind_this <= 0;
    if not seen.completed then
      behind_this <= behind_traps_and_returns;
    else
      case kind_of(seen.word) is
        when trap_return => behind_this <= behind_traps_and_returns;
        when jump_register | fence_instruction => behind_this <= behind_late_jumps;
        when jump => behind_this <= behind_early_jumps;
        when branch =>
          if is_so and is_early then
            behind_this <= behind_early_jumps;
          elsif is_so or is_early then
            behind_this <= behind_late_jumps;
          end if;
        when others => null;
      end case;
    end if;
  end process;

  waits <= has_waited or (is_waiting and not bus_active);
  more <= 1 when waits else 0;
  more_behind_this <= 1 when is_waiting else 0;

  follow : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    if told then
      quiet_for <= 0 when is_held_up = '1' else 1;
      behind <= behind_this;
      has_waited <= is_waiting;
    else
      if not is_held_up then
        quiet_for <= quiet_for + 1;
      end if;
      has_waited <= waits;
    end if;
    if reset then
      quiet_for <= 1;
      behind <= behind_reset;
      has_waited <= '0';
    end if;
  end process;

  each_takes_its_time : assert always
    ((started = '1' and (seen.completed = '1' or seen.refused = '1')) ->
     ((has_waited = '0' and quiet_for = behind + 1) or (has_waited = '1' and quiet_for = behind + 2)));
  no_more_is_behind_anything : assert always (behind <= behind_reset);
  it_comes_exactly_in_its_time : assert always
    ((started and not told and not bus_active) -> quiet_for + clocks_left = behind + 1 + more);
  an_access_began_in_its_time : assert always
    ((started and not told and bus_active) ->
     ((has_waited = '0' and quiet_for = behind + 1) or (has_waited = '1' and quiet_for = behind + 2)));
  what_is_told_leaves_its_clocks_behind : assert always
    ((started and told) -> clocks_left = behind_this + 1 + more_behind_this);

end architecture;
