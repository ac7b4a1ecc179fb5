-- SPDX-License-Identifier: Apache-2.0
-- Every instruction of 16 or 32 bits is decoded as specified, and with its control signals the ALU computes
-- its result, for all operands.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bit_manipulation_pkg.all;
use work.instruction_set_pkg.all;
use work.machine_mode_pkg.all;
use work.processor_pkg.all;
use work.short_instructions_pkg.all;

entity instruction_decoder_proof is
  generic (
    -- 1: decoder with Zbb, whose instructions are left to bit_manipulation_proof.
    with_zbb : natural range 0 to 1 := 0
  );
  port (
    clk : in std_ulogic;
    instruction : in value_t;
    -- Contents of its source registers.
    first_content : in value_t;
    second_content : in value_t
  );
end entity;

architecture proof of instruction_decoder_proof is

  signal decoded : control_t;
  signal immediate : value_t;
  signal is_long, is_of_zbb, legal : std_ulogic;
  -- Specified.
  signal word : value_t;
  signal kind : kind_t;
  signal first_index, second_index, destination, written : std_ulogic_vector(4 downto 0);
  signal meant, has_immediate : boolean;
  signal expected_immediate : value_t;
  -- Operands and result of the ALU.
  signal first, second, second_register, result : value_t;
  signal equal, less, taken : std_ulogic;
  signal compared : comparison_t;
  signal specified_first, specified_second, operand : value_t;

  default clock is rising_edge(clk);

begin

  instruction_decoder : entity work.instruction_decoder
    generic map (has_zbb => with_zbb = 1)
    port map (
      instruction => instruction,
      is_word => is_long,
      decoded => decoded,
      immediate => immediate,
      first => first_index,
      second => second_index);

  is_long <= and instruction(1 downto 0);
  is_of_zbb <= '1' when with_zbb = 1 and is_bit_manipulation(instruction) else '0';
  legal <= (or decoded.legal) and not is_of_zbb;
  destination <= decoded.destination when decoded.writes else "00000";

  word <= instruction when is_long = '1' else expanded(instruction(15 downto 0));
  kind <= kind_of(word);
  meant <= kind /= illegal;
  written <= destination_of(word);

  choose_immediate : process (all)
  begin
    has_immediate <= true;
    expected_immediate <= x"00000000";
    case kind is
      when load | jump_register => expected_immediate <= std_ulogic_vector(immediate_i(word));
      when store => expected_immediate <= std_ulogic_vector(immediate_s(word));
      -- Those of jumps, branches and auipc are in jump_proof.
      when others => has_immediate <= false;
    end case;
  end process;

  -- A register that is not read may have any content.
  first <= x"00000000" when first_index = "00000" else first_content;
  second_register <= x"00000000" when second_index = "00000" else second_content;
  second <= immediate when decoded.second_is_immediate else second_register;
  arithmetic : entity work.alu
    generic map (has_zbb => with_zbb = 1)
    port map (
      first => first,
      second => second,
      operation => decoded.operation,
      shift => decoded.shift,
      subtract => decoded.subtract,
      arithmetic_shift => decoded.arithmetic_shift,
      rotate => decoded.rotate,
      compare_unsigned => decoded.compare_unsigned,
      result => result,
      less => less,
      comparison => compared);
  equal <= compared.below nor compared.above;
  taken <= less xor decoded.funct3(0) when decoded.funct3(2) else equal xor decoded.funct3(0);

  specified_first <= x"00000000" when word(19 downto 15) = "00000" else first_content;
  specified_second <= x"00000000" when word(24 downto 20) = "00000" else second_content;
  operand <= specified_second when word(5) = '1' else std_ulogic_vector(immediate_i(word));

  legal_exactly_where_specified : assert always ((legal = '1') = meant);
  loads_are_decoded : assert always (legal -> (decoded.load = '1') = (kind = load));
  stores_are_decoded : assert always (legal -> (decoded.store = '1') = (kind = store));
  branches_are_decoded : assert always (legal -> (decoded.branch = '1') = (kind = branch));
  jal_is_decoded : assert always
    (legal -> (decoded.jump = '1') = (kind = jump));
  fence_i_is_decoded : assert always
    (legal -> (decoded.refetch = '1') = (kind = fence_instruction));
  jalr_is_decoded : assert always
    (legal -> (decoded.jump_register = '1') = (kind = jump_register));
  auipc_is_decoded : assert always
    (legal -> (decoded.address_result = '1') = (kind = add_upper));
  multiplications_are_decoded : assert always
    (legal -> (decoded.multiply = '1') = (kind = multiplication));
  divisions_are_decoded : assert always (legal -> (decoded.divide = '1') = (kind = division));
  csr_instructions_are_decoded : assert always (legal -> (decoded.csr = '1') = (kind = csr));
  csr_written_is_right : assert always
    (kind = csr ->
     (decoded.csr_written = '0') = (word(13) = '1' and word(19 downto 15) = "00000"));
  csr_exists_is_right : assert always
    (kind = csr -> (decoded.csr_exists = '1') = csr_exists(word(31 downto 20)));
  ecall_is_decoded : assert always
    (legal -> (decoded.environment_call = '1') = (kind = environment_call));
  ebreak_is_decoded : assert always (legal -> (decoded.breakpoint = '1') = (kind = breakpoint));
  mret_is_decoded : assert always (legal -> (decoded.trap_return = '1') = (kind = trap_return));
  wfi_is_decoded : assert always
    (legal -> (decoded.wait_for_interrupt = '1') = (kind = wait_for_interrupt));
  funct3_is_right : assert always
    ((kind = load or kind = store or kind = branch or kind = multiplication or kind = division or
      kind = csr) -> decoded.funct3 = word(14 downto 12));

  -- A compressed instruction that reads x0 may be decoded to pass its second operand.
  first_index_is_right : assert always
    ((reads_first(word) and meant) ->
     (first_index = word(19 downto 15) or
      (kind = operation and word(19 downto 15) = "00000" and decoded.reads_first = '0')));
  second_index_is_right : assert always
    ((reads_second(word) and meant) -> second_index = word(24 downto 20));
  reads_first_is_right : assert always
    ((reads_first(word) and meant and word(19 downto 15) /= "00000") -> decoded.reads_first);
  reads_second_is_right : assert always
    ((reads_second(word) and meant and word(24 downto 20) /= "00000") -> decoded.reads_second);
  destination_index_is_right : assert always (legal -> destination = written);
  late_results_are_late : assert always
    ((legal and decoded.writes) ->
     (decoded.late = '1') = (kind = load or kind = multiplication or kind = csr));
  immediates_are_right : assert always (has_immediate -> immediate = expected_immediate);

  lui_result_is_right : assert always
    (kind = load_upper -> result = std_ulogic_vector(immediate_u(word)));
  decoded_sums_are_right : assert always
    ((kind = operation and word(14 downto 12) = "000") -> result = sum(word, specified_first, operand));
  decoded_shifts_are_right : assert always
    ((kind = operation and word(13 downto 12) = "01") -> result = shift(word, specified_first, operand));
  decoded_comparisons_are_right : assert always
    ((kind = operation and word(14 downto 13) = "01") ->
     result = comparison(word, specified_first, operand));
  decoded_logic_is_right : assert always
    ((kind = operation and word(14) = '1' and word(13 downto 12) /= "01") ->
     result = logic(word, specified_first, operand));
  branch_conditions_are_right : assert always
    (kind = branch -> (taken = '1') = is_taken(word, specified_first, specified_second));

end architecture;
