-- SPDX-License-Identifier: Apache-2.0
-- Each instruction takes the clocks of the table in rtl/processor/README.md, whatever precedes and follows
-- it: the clocks between two events are 1 plus the penalty of the first and that of a load-use hazard.
-- Clocks of bus accesses, divisions and sleep are not counted. That hazards are exactly those of late
-- results is proved of `operand_forwarding`.

library ieee;
use ieee.std_logic_1164.all;

use work.instruction_set_pkg.all;
use work.retired_instruction_pkg.all;

entity instruction_times is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- An instruction retires or raises an exception in this clock; or an interrupt is taken.
    observed : in retired_instruction_t;
    interrupted : in std_ulogic;
    bus_active : in std_ulogic;
    -- The instruction in execute is stalled by bus, divider or sleep.
    externally_stalled : in std_ulogic;
    -- The instruction in execute is stalled by a load-use hazard.
    hazard_stall : in std_ulogic;
    -- To the next event, unless stalled.
    clocks_to_retirement : in natural range 0 to 7
  );
end entity;

architecture proof of instruction_times is

  -- Penalties: clocks of the table, less the one of the next instruction.
  constant trap_penalty : natural := 4 - 1;
  constant reset_penalty : natural := trap_penalty + 1;
  constant redirect_penalty : natural := 3 - 1;
  constant taken_penalty : natural := 2 - 1;

  signal started : std_ulogic := '0';
  signal event, predicted_taken, taken, had_hazard, has_hazard : std_ulogic := '0';
  signal clocks_since_event : natural range 0 to 7 := 0;
  signal penalty, next_penalty : natural range 0 to 4 := 0;
  signal hazard_clocks, next_hazard_clocks : natural range 0 to 1;

  default clock is rising_edge(clk);

begin

  event <= observed.completed or observed.exception or interrupted;
  -- Backward bne, bge, bgeu.
  predicted_taken <= observed.word(31) and observed.word(12);
  taken <= '1' when is_taken(observed.word, observed.first, observed.second) else '0';

  find_penalty : process (all)
  begin
    next_penalty <= 0;
    if not observed.completed then
      next_penalty <= trap_penalty;
    else
      case kind_of(observed.word) is
        when trap_return => next_penalty <= trap_penalty;
        when jump_register | fence_instruction => next_penalty <= redirect_penalty;
        when jump => next_penalty <= taken_penalty;
        when branch =>
          if taken and predicted_taken then
            next_penalty <= taken_penalty;
          elsif taken or predicted_taken then
            next_penalty <= redirect_penalty;
          end if;
        when others => null;
      end case;
    end if;
  end process;

  has_hazard <= had_hazard or (hazard_stall and not bus_active);
  hazard_clocks <= 1 when has_hazard else 0;
  next_hazard_clocks <= 1 when hazard_stall else 0;

  track : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    if event then
      clocks_since_event <= 0 when externally_stalled = '1' else 1;
      penalty <= next_penalty;
      had_hazard <= hazard_stall;
    else
      if not externally_stalled then
        clocks_since_event <= clocks_since_event + 1;
      end if;
      had_hazard <= has_hazard;
    end if;
    if reset then
      clocks_since_event <= 1;
      penalty <= reset_penalty;
      had_hazard <= '0';
    end if;
  end process;

  instruction_time_is_right : assert always
    ((started = '1' and (observed.completed = '1' or observed.exception = '1')) ->
     ((had_hazard = '0' and clocks_since_event = penalty + 1) or
      (had_hazard = '1' and clocks_since_event = penalty + 2)));
  penalty_is_bounded : assert always (penalty <= reset_penalty);
  remaining_clocks_are_right : assert always
    ((started and not event and not bus_active) ->
     clocks_since_event + clocks_to_retirement = penalty + 1 + hazard_clocks);
  bus_access_begins_in_time : assert always
    ((started and not event and bus_active) ->
     ((had_hazard = '0' and clocks_since_event = penalty + 1) or
      (had_hazard = '1' and clocks_since_event = penalty + 2)));
  penalty_is_right : assert always
    ((started and event) -> clocks_to_retirement = next_penalty + 1 + next_hazard_clocks);

end architecture;
