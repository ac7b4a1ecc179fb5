-- SPDX-License-Identifier: Apache-2.0
-- Jumps that only execute can decide (jalr, fence.i, branches that go another way than was thought), and a
-- clock after traps and returns from them where they go.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity late_jump is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- In any case where it is redirecting.
    turn : in late_turn_t;
    -- Of its operands.
    comparison : in comparison_t;
    -- Where a branch goes that did not go there, and fence.i; behind a reset the start. Zero where a
    -- redirection goes elsewhere.
    other : in unsigned(31 downto 0);
    -- jalr: it is one, and nothing is redirected; base, constant and their sum.
    jump_register : in std_ulogic;
    base : in unsigned(31 downto 0);
    offset : in unsigned(31 downto 0);
    sum : in unsigned(31 downto 0);
    -- A trap or a return from one, which wins over a jump; where it goes, in the next clock, nowhere behind a
    -- reset. Handlers begin with a word, other places may be in the middle of one.
    redirect : in std_ulogic;
    to_handler : in std_ulogic;
    to_return : in std_ulogic;
    handler_address : in unsigned(31 downto 0);
    return_address : in unsigned(31 downto 0);
    -- Jump, to this address (of which bit 0 is ignored), with the word of this plus 2.
    jump : out std_ulogic;
    target : out unsigned(31 downto 0);
    target_plus_2 : out unsigned(31 downto 2);
    -- It was not decided before this clock where to go on.
    redirecting : out std_ulogic
  );
end entity;

architecture rtl of late_jump is

  signal is_so, inverted : std_ulogic;
  signal elsewhere, elsewhere_plus_2, jump_address, jump_address_plus_2 : unsigned(31 downto 0);
  signal return_address_plus_2 : unsigned(31 downto 0);
  signal offset_plus_2, sum_plus_2, other_plus_2 : unsigned(31 downto 0);

begin

  -- What is below and above comes last: one gate lies behind it, and then, with all that inverts it, the
  -- choice of an address.
  is_so <= (turn.if_below and comparison.below) or (turn.if_above and comparison.above);
  -- An order, but no inequality, is turned around by signs.
  inverted <= turn.inverted xor (turn.if_below and not turn.if_above and comparison.signs_differ);
  jump <= is_so xor inverted;

  -- One of the two parts of each target is zero: three choices would come later.
  return_address_plus_2 <= return_address + 2;
  elsewhere <= handler_address when to_handler else
               (return_address and (31 downto 0 => to_return));
  elsewhere_plus_2 <= handler_address when to_handler else
                      (return_address_plus_2 and (31 downto 0 => to_return));

  -- The base comes last.
  offset_plus_2 <= offset + 2;
  sum_plus_2 <= base + offset_plus_2;
  other_plus_2 <= other + 2;
  jump_address <= sum when jump_register else other;
  jump_address_plus_2 <= sum_plus_2 when jump_register else other_plus_2;
  target <= elsewhere or jump_address;
  target_plus_2 <= elsewhere_plus_2(31 downto 2) or jump_address_plus_2(31 downto 2);

  note_redirection : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect or reset;
  end process;

end architecture;
