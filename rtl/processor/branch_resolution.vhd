-- SPDX-License-Identifier: Apache-2.0
-- Redirects of fetch by execute: jalr, fence.i and mispredicted branches in their own clock; traps, returns
-- and resets in the clock after the flush.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity branch_resolution is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- `redirect_always` in the clock after a flush.
    condition : in redirect_condition_t;
    -- Of the operands.
    comparison : in comparison_t;
    -- Target of mispredicted branches and of fence.i; the reset address after a reset. Zero in the clock
    -- after any other flush.
    alternate_address : in unsigned(31 downto 0);
    -- jalr: low in the clock after a flush; base, immediate and their sum.
    jump_register : in std_ulogic;
    base : in unsigned(31 downto 0);
    offset : in unsigned(31 downto 0);
    sum : in unsigned(31 downto 0);
    -- Trap, return or resume, which takes priority over a redirect. Its target is given in the next clock,
    -- none after a reset. Handlers are word-aligned, return addresses half-word-aligned.
    flush : in std_ulogic;
    to_handler : in std_ulogic;
    to_return : in std_ulogic;
    handler_address : in unsigned(31 downto 0);
    return_address : in unsigned(31 downto 0);
    -- Redirect fetch to `target`, of which bit 0 is ignored;
    -- `target_plus_2` selects the next pair's other word.
    redirect : out std_ulogic;
    target : out unsigned(31 downto 0);
    target_plus_2 : out unsigned(31 downto 2);
    -- The pipeline was flushed in the previous clock.
    flushed : out std_ulogic
  );
end entity;

architecture rtl of branch_resolution is

  signal condition_met, inverted : std_ulogic;
  signal trap_address, trap_address_plus_2, jump_address, jump_address_plus_2 : unsigned(31 downto 0);
  signal return_address_plus_2 : unsigned(31 downto 0);
  signal offset_plus_2, sum_plus_2, alternate_address_plus_2 : unsigned(31 downto 0);

begin

  -- Critical path: the comparison is the last to settle. One gate follows it, then, with everything that
  -- inverts the condition, the target multiplexer.
  condition_met <= (condition.if_below and comparison.below) or (condition.if_above and comparison.above);
  -- Different signs invert an order (blt, bge), not an inequality (beq, bne).
  inverted <= condition.inverted xor
              (condition.if_below and not condition.if_above and comparison.signs_differ);
  redirect <= condition_met xor inverted;

  -- Wired OR of two sources, one of which is zero: faster than a third multiplexer input.
  return_address_plus_2 <= return_address + 2;
  trap_address <= handler_address when to_handler else
               (return_address and (31 downto 0 => to_return));
  trap_address_plus_2 <= handler_address when to_handler else
                      (return_address_plus_2 and (31 downto 0 => to_return));

  -- `base` is the last to settle.
  offset_plus_2 <= offset + 2;
  sum_plus_2 <= base + offset_plus_2;
  alternate_address_plus_2 <= alternate_address + 2;
  jump_address <= sum when jump_register else alternate_address;
  jump_address_plus_2 <= sum_plus_2 when jump_register else alternate_address_plus_2;
  target <= trap_address or jump_address;
  target_plus_2 <= trap_address_plus_2(31 downto 2) or jump_address_plus_2(31 downto 2);

  register_flush : process
  begin
    wait until rising_edge(clk);
    flushed <= flush or reset;
  end process;

end architecture;
