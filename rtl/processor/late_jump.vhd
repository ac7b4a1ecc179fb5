-- SPDX-License-Identifier: Apache-2.0
-- Jumps that only execute can decide (jalr, fence.i, branches that go another way than was thought), and a
-- clock after traps and returns from them where they go.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity late_jump is
  generic (
    reset_address : unsigned(31 downto 0)
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- With `always` where it is redirecting.
    turn : in late_turn_t;
    -- Of its operands.
    equal : in std_ulogic;
    less : in std_ulogic;
    -- Where a branch goes that did not go there, and fence.i.
    other : in unsigned(31 downto 0);
    -- jalr: it is one; base, constant and their sum.
    jump_register : in std_ulogic;
    base : in unsigned(31 downto 0);
    offset : in unsigned(31 downto 0);
    sum : in unsigned(31 downto 0);
    -- A trap or a return from one, which wins over a jump; where it goes, in the next clock. Handlers begin
    -- with a word, other places may be in the middle of one.
    redirect : in std_ulogic;
    to_handler : in std_ulogic;
    handler_address : in unsigned(31 downto 0);
    return_address : in unsigned(31 downto 0);
    -- Jump, to this address (of which bit 0 is ignored), with this plus 2.
    jump : out std_ulogic;
    target : out unsigned(31 downto 0);
    target_plus_2 : out unsigned(31 downto 0);
    -- It was not decided before this clock where to go on.
    redirecting : out std_ulogic
  );
end entity;

architecture rtl of late_jump is

  signal resetting, compared, ordered : std_ulogic;
  signal redirect_target, redirect_target_plus_2 : unsigned(31 downto 0);
  signal offset_plus_2, sum_plus_2, other_plus_2 : unsigned(31 downto 0);

begin

  -- `less` is the last to come.
  compared <= turn.always or (turn.if_equal and equal) or (turn.if_not_equal and not equal);
  ordered <= turn.if_less when less else turn.if_not_less;
  jump <= compared or ordered;

  redirect_target <= reset_address when resetting else
                     handler_address when to_handler else
                     return_address;
  redirect_target_plus_2 <= reset_address when resetting else
                            handler_address when to_handler else
                            return_address + 2;

  -- The base comes last.
  offset_plus_2 <= offset + 2;
  sum_plus_2 <= base + offset_plus_2;
  other_plus_2 <= other + 2;
  target <= redirect_target when redirecting else
            sum when jump_register else
            other;
  target_plus_2 <= redirect_target_plus_2 when redirecting else
                   sum_plus_2 when jump_register else
                   other_plus_2;

  note_redirection : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect or reset;
    resetting <= reset;
  end process;

end architecture;
