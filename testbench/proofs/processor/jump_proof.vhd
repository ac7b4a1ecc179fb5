-- SPDX-License-Identifier: Apache-2.0
-- Every instruction goes on where the instruction set says, for all operands and at all addresses: what
-- decode takes for the next, or what execute makes of it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.processor_pkg.all;
use work.short_instructions_pkg.all;

entity jump_proof is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    instruction : in value_t;
    address : in unsigned(31 downto 0);
    first_content : in value_t;
    second_content : in value_t;
    -- A trap, or a return from one.
    redirect : in std_ulogic;
    to_handler : in std_ulogic;
    handler_address : in unsigned(31 downto 0);
    return_address : in unsigned(31 downto 0)
  );
end entity;

architecture proof of jump_proof is

  signal decoded : decoded_t;
  signal immediate : value_t;
  signal is_long, legal : std_ulogic;
  signal is_first, is_second : std_ulogic_vector(4 downto 0);
  signal first, second, second_register : value_t;
  signal compared : comparison_t;
  signal offset, sum : unsigned(31 downto 0);
  signal early, late, redirecting : std_ulogic;
  signal early_target, early_target_plus_2, following, other, held_other : unsigned(31 downto 0);
  signal turn, decoded_turn : late_turn_t;
  signal late_target : unsigned(31 downto 0);
  signal late_target_plus_2 : unsigned(31 downto 2);
  signal next_address, pair_behind : unsigned(31 downto 0);
  -- Of the specification.
  signal word : value_t;
  signal kind : kind_t;
  signal link, specified : unsigned(31 downto 0);
  signal specified_first, specified_second : value_t;
  signal started, resets, redirects : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  is_long <= and instruction(1 downto 0);
  instruction_decoder : entity work.instruction_decoder
    port map (
      instruction => instruction,
      is_word => is_long,
      decoded => decoded,
      immediate => immediate,
      first => is_first,
      second => is_second);
  legal <= or decoded.legal;

  first <= x"00000000" when is_first = "00000" else first_content;
  second_register <= x"00000000" when is_second = "00000" else second_content;
  second <= immediate when decoded.second_is_constant else second_register;
  comparison : entity work.alu
    port map (
      first => first,
      second => second,
      operation => decoded.operation,
      shift => decoded.shift,
      subtract => decoded.subtract,
      arithmetic_shift => decoded.arithmetic_shift,
      compare_unsigned => decoded.compare_unsigned,
      result => open,
      less => open,
      comparison => compared);

  decode_jump : entity work.early_jump
    port map (
      valid => '1',
      address => address,
      instruction => instruction,
      is_word => is_long,
      decoded => decoded,
      jump => early,
      target => early_target,
      target_plus_2 => early_target_plus_2,
      following => following,
      other => other,
      turn => decoded_turn);

  -- As the pipeline holds it between the two.
  turn <= any_turn when redirecting else decoded_turn;
  held_other <= x"80000000" when resets else x"00000000" when redirects else other;
  offset <= unsigned(immediate);
  sum <= unsigned(first) + offset;
  execute_jump : entity work.late_jump
    port map (
      clk => clk,
      reset => reset,
      turn => turn,
      comparison => compared,
      other => held_other,
      jump_register => decoded.jump_register and not redirects,
      base => unsigned(first),
      offset => offset,
      sum => sum,
      redirect => redirect,
      to_handler => redirects and not resets and to_handler,
      to_return => redirects and not resets and not to_handler,
      handler_address => handler_address,
      return_address => return_address,
      jump => late,
      target => late_target,
      target_plus_2 => late_target_plus_2,
      redirecting => redirecting);
  next_address <= late_target(31 downto 1) & '0' when late else following;

  pair_behind <= late_target + 2;

  word <= instruction when is_long = '1' else expanded(instruction(15 downto 0));
  kind <= kind_of(word);
  link <= address + 4 when is_long = '1' else address + 2;
  specified_first <= x"00000000" when word(19 downto 15) = "00000" else first_content;
  specified_second <= x"00000000" when word(24 downto 20) = "00000" else second_content;

  specify : process (all)
  begin
    specified <= link;
    case kind is
      when jump => specified <= address + constant_j(word);
      when jump_register =>
        specified <= unsigned(specified_first) + constant_i(word);
        specified(0) <= '0';
      when branch =>
        if is_taken(word, specified_first, specified_second) then
          specified <= address + constant_b(word);
        end if;
      when others => null;
    end case;
  end process;

  remember : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    resets <= reset;
    redirects <= redirect or reset;
  end process;

  it_starts_with_reset : assume always (not started -> reset);
  instructions_lie_at_even_addresses : assume always (address(0) = '0');
  handlers_begin_with_a_word : assume always (handler_address(1 downto 0) = "00" and return_address(0) = '0');

  the_next_instruction_is_the_right_one : assert always
    ((started and legal and not redirects) -> next_address = specified);
  jal_is_taken_early : assert always (kind = jump -> (early = '1' and early_target = specified));
  -- bne, bge, bgeu backwards.
  branches_that_end_loops_are_taken_early : assert always
    (kind = branch -> (early = '1') = (constant_b(word)(31) = '1' and word(12) = '1'));
  nothing_else_is_taken_early : assert always
    ((legal and early) -> (kind = jump or kind = branch));
  the_pair_behind_is_asked_for : assert always
    (early -> early_target_plus_2 = early_target + 2);
  the_pair_behind_a_late_jump_is_asked_for : assert always
    ((started and late and not redirects) ->
     late_target_plus_2 = pair_behind(31 downto 2));
  the_pair_behind_the_start_is_asked_for : assert always
    ((started and resets) -> late_target_plus_2 = 30x"20000000");
  the_pair_behind_a_return_is_asked_for : assert always
    ((started and redirects and not resets and not to_handler) ->
     late_target_plus_2 = pair_behind(31 downto 2));
  reset_leads_to_the_start : assert always ((started and resets) -> next_address = x"80000000");
  traps_lead_to_their_handler : assert always
    ((started and redirects and not resets and to_handler) -> next_address = handler_address);
  returns_lead_back : assert always
    ((started and redirects and not resets and not to_handler) -> next_address = return_address);

end architecture;
