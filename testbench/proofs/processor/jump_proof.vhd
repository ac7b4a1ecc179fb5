-- SPDX-License-Identifier: Apache-2.0
-- Every instruction is followed by the one that the instruction set specifies, for all operands and
-- addresses: predicted by decode, or redirected by execute.

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
    flush : in std_ulogic;
    to_handler : in std_ulogic;
    handler_address : in unsigned(31 downto 0);
    return_address : in unsigned(31 downto 0)
  );
end entity;

architecture proof of jump_proof is

  signal decoded : control_t;
  signal immediate : value_t;
  signal is_long, legal : std_ulogic;
  signal first_index, second_index : std_ulogic_vector(4 downto 0);
  signal first, second, second_register : value_t;
  signal compared : comparison_t;
  signal offset, sum : unsigned(31 downto 0);
  signal predicted_taken, redirect, flushed : std_ulogic;
  signal predicted_target, predicted_target_plus_2, predicted_next_address : unsigned(31 downto 0);
  signal alternate_address, held_alternate_address : unsigned(31 downto 0);
  signal condition, decoded_condition : redirect_condition_t;
  signal redirect_target : unsigned(31 downto 0);
  signal redirect_target_plus_2 : unsigned(31 downto 2);
  signal next_address, specified_plus_2 : unsigned(31 downto 0);
  -- Specified.
  signal word : value_t;
  signal kind : kind_t;
  signal link, specified : unsigned(31 downto 0);
  signal specified_first, specified_second : value_t;
  signal started, reset_before, flush_before : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  is_long <= and instruction(1 downto 0);
  instruction_decoder : entity work.instruction_decoder
    port map (
      instruction => instruction,
      is_word => is_long,
      decoded => decoded,
      immediate => immediate,
      first => first_index,
      second => second_index);
  legal <= or decoded.legal;

  first <= x"00000000" when first_index = "00000" else first_content;
  second_register <= x"00000000" when second_index = "00000" else second_content;
  second <= immediate when decoded.second_is_immediate else second_register;
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

  branch_predictor : entity work.branch_predictor
    port map (
      valid => '1',
      address => address,
      instruction => instruction,
      is_word => is_long,
      decoded => decoded,
      taken => predicted_taken,
      target => predicted_target,
      target_plus_2 => predicted_target_plus_2,
      next_address => predicted_next_address,
      alternate_address => alternate_address,
      condition => decoded_condition);

  -- As in the pipeline register between decode and execute.
  condition <= redirect_always when flushed else decoded_condition;
  held_alternate_address <= x"80000000" when reset_before else
                            x"00000000" when flush_before else
                            alternate_address;
  offset <= unsigned(immediate);
  sum <= unsigned(first) + offset;
  branch_resolution : entity work.branch_resolution
    port map (
      clk => clk,
      reset => reset,
      condition => condition,
      comparison => compared,
      alternate_address => held_alternate_address,
      jump_register => decoded.jump_register and not flush_before,
      base => unsigned(first),
      offset => offset,
      sum => sum,
      flush => flush,
      to_handler => flush_before and not reset_before and to_handler,
      to_return => flush_before and not reset_before and not to_handler,
      handler_address => handler_address,
      return_address => return_address,
      redirect => redirect,
      target => redirect_target,
      target_plus_2 => redirect_target_plus_2,
      flushed => flushed);
  next_address <= redirect_target(31 downto 1) & '0' when redirect else predicted_next_address;

  specified_plus_2 <= redirect_target + 2;

  word <= instruction when is_long = '1' else expanded(instruction(15 downto 0));
  kind <= kind_of(word);
  link <= address + 4 when is_long = '1' else address + 2;
  specified_first <= x"00000000" when word(19 downto 15) = "00000" else first_content;
  specified_second <= x"00000000" when word(24 downto 20) = "00000" else second_content;

  specify : process (all)
  begin
    specified <= link;
    case kind is
      when jump => specified <= address + immediate_j(word);
      when jump_register =>
        specified <= unsigned(specified_first) + immediate_i(word);
        specified(0) <= '0';
      when branch =>
        if is_taken(word, specified_first, specified_second) then
          specified <= address + immediate_b(word);
        end if;
      when others => null;
    end case;
  end process;

  remember : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    reset_before <= reset;
    flush_before <= flush or reset;
  end process;

  it_starts_with_reset : assume always (not started -> reset);
  address_is_half_word_aligned : assume always (address(0) = '0');
  handler_is_word_aligned : assume always (handler_address(1 downto 0) = "00" and return_address(0) = '0');

  next_address_is_right : assert always
    ((started and legal and not flush_before) -> next_address = specified);
  jal_is_taken_in_decode : assert always
    (kind = jump -> (predicted_taken = '1' and predicted_target = specified));
  -- bne, bge, bgeu.
  backward_bne_bge_bgeu_are_predicted_taken : assert always
    (kind = branch -> (predicted_taken = '1') = (immediate_b(word)(31) = '1' and word(12) = '1'));
  only_jal_and_branches_are_predicted_taken : assert always
    ((legal and predicted_taken) -> (kind = jump or kind = branch));
  predicted_target_plus_2_is_right : assert always
    (predicted_taken -> predicted_target_plus_2 = predicted_target + 2);
  redirect_target_plus_2_is_right : assert always
    ((started and redirect and not flush_before) ->
     redirect_target_plus_2 = specified_plus_2(31 downto 2));
  reset_target_plus_2_is_right : assert always
    ((started and reset_before) -> redirect_target_plus_2 = 30x"20000000");
  return_target_plus_2_is_right : assert always
    ((started and flush_before and not reset_before and not to_handler) ->
     redirect_target_plus_2 = specified_plus_2(31 downto 2));
  reset_goes_to_reset_address : assert always ((started and reset_before) -> next_address = x"80000000");
  traps_go_to_handler : assert always
    ((started and flush_before and not reset_before and to_handler) -> next_address = handler_address);
  returns_go_to_return_address : assert always
    ((started and flush_before and not reset_before and not to_handler) -> next_address = return_address);

end architecture;
