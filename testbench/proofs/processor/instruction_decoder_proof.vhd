-- SPDX-License-Identifier: Apache-2.0
-- Every instruction of 16 or 32 bits is read as what the instruction set says it is; and with what is read
-- of it the arithmetic unit gives its result, for all operands.

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
    -- 1: the decoder of a processor with Zbb, whose own words are left to bit_manipulation_proof.
    with_zbb : natural range 0 to 1 := 0
  );
  port (
    clk : in std_ulogic;
    instruction : in value_t;
    -- What the registers hold that it reads.
    first_content : in value_t;
    second_content : in value_t
  );
end entity;

architecture proof of instruction_decoder_proof is

  signal decoded : decoded_t;
  signal immediate : value_t;
  signal is_long, is_of_zbb, legal : std_ulogic;
  -- Of the specification.
  signal word : value_t;
  signal kind : kind_t;
  signal is_first, is_second, destination, written : std_ulogic_vector(4 downto 0);
  signal meant, has_constant : boolean;
  signal expected_constant : value_t;
  -- What reaches the arithmetic unit, and what it gives.
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
      first => is_first,
      second => is_second);

  is_long <= and instruction(1 downto 0);
  is_of_zbb <= '1' when with_zbb = 1 and is_bit_manipulation(instruction) else '0';
  legal <= (or decoded.legal) and not is_of_zbb;
  destination <= decoded.destination when decoded.writes else "00000";

  word <= instruction when is_long = '1' else expanded(instruction(15 downto 0));
  kind <= kind_of(word);
  meant <= kind /= illegal;
  written <= destination_of(word);

  choose_constant : process (all)
  begin
    has_constant <= true;
    expected_constant <= x"00000000";
    case kind is
      when load | jump_register => expected_constant <= std_ulogic_vector(constant_i(word));
      when store => expected_constant <= std_ulogic_vector(constant_s(word));
      -- Those of jumps and auipc are in jump_proof.
      when others => has_constant <= false;
    end case;
  end process;

  -- A register that is not read may give anything.
  first <= x"00000000" when is_first = "00000" else first_content;
  second_register <= x"00000000" when is_second = "00000" else second_content;
  second <= immediate when decoded.second_is_constant else second_register;
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
  operand <= specified_second when word(5) = '1' else std_ulogic_vector(constant_i(word));

  what_is_no_instruction_is_illegal : assert always ((legal = '1') = meant);
  loads_are_loads : assert always (legal -> (decoded.load = '1') = (kind = load));
  stores_are_stores : assert always (legal -> (decoded.store = '1') = (kind = store));
  branches_are_branches : assert always (legal -> (decoded.branch = '1') = (kind = branch));
  jumps_are_jumps : assert always
    (legal -> (decoded.jump = '1') = (kind = jump));
  fence_i_fetches_again : assert always
    (legal -> (decoded.refetch = '1') = (kind = fence_instruction));
  jumps_to_registers_are_such : assert always
    (legal -> (decoded.jump_register = '1') = (kind = jump_register));
  sums_with_the_address_are_such : assert always
    (legal -> (decoded.address_result = '1') = (kind = add_upper));
  multiplications_are_such : assert always
    (legal -> (decoded.multiply = '1') = (kind = multiplication));
  divisions_are_divisions : assert always (legal -> (decoded.divide = '1') = (kind = division));
  csr_instructions_are_such : assert always (legal -> (decoded.csr = '1') = (kind = csr));
  csrs_set_or_cleared_by_nothing_are_not_written : assert always
    (kind = csr ->
     (decoded.csr_written = '0') = (word(13) = '1' and word(19 downto 15) = "00000"));
  the_csrs_that_exist_are_known : assert always
    (kind = csr -> (decoded.csr_exists = '1') = csr_exists(word(31 downto 20)));
  calls_are_calls : assert always
    (legal -> (decoded.environment_call = '1') = (kind = environment_call));
  breakpoints_are_breakpoints : assert always (legal -> (decoded.breakpoint = '1') = (kind = breakpoint));
  returns_are_returns : assert always (legal -> (decoded.trap_return = '1') = (kind = trap_return));
  waits_are_waits : assert always
    (legal -> (decoded.wait_for_interrupt = '1') = (kind = wait_for_interrupt));
  the_kind_within_its_class_is_told : assert always
    ((kind = load or kind = store or kind = branch or kind = multiplication or kind = division or
      kind = csr) -> decoded.funct3 = word(14 downto 12));

  -- What is short and reads x0 may be read as what gives its second operand as it is.
  the_first_register_is_found : assert always
    ((reads_first(word) and meant) ->
     (is_first = word(19 downto 15) or
      (kind = operation and word(19 downto 15) = "00000" and decoded.reads_first = '0')));
  the_second_register_is_found : assert always
    ((reads_second(word) and meant) -> is_second = word(24 downto 20));
  who_reads_the_first_waits_for_it : assert always
    ((reads_first(word) and meant and word(19 downto 15) /= "00000") -> decoded.reads_first);
  who_reads_the_second_waits_for_it : assert always
    ((reads_second(word) and meant and word(24 downto 20) /= "00000") -> decoded.reads_second);
  the_destination_is_found : assert always (legal -> destination = written);
  late_results_are_late : assert always
    ((legal and decoded.writes) ->
     (decoded.late = '1') = (kind = load or kind = multiplication or kind = csr));
  constants_are_right : assert always (has_constant -> immediate = expected_constant);

  upper_constants_pass : assert always
    (kind = load_upper -> result = std_ulogic_vector(constant_u(word)));
  sums_come_out : assert always
    ((kind = operation and word(14 downto 12) = "000") -> result = sum(word, specified_first, operand));
  shifts_come_out : assert always
    ((kind = operation and word(13 downto 12) = "01") -> result = shift(word, specified_first, operand));
  comparisons_come_out : assert always
    ((kind = operation and word(14 downto 13) = "01") ->
     result = comparison(word, specified_first, operand));
  logic_comes_out : assert always
    ((kind = operation and word(14) = '1' and word(13 downto 12) /= "01") ->
     result = logic(word, specified_first, operand));
  branches_are_decided : assert always
    (kind = branch -> (taken = '1') = is_taken(word, specified_first, specified_second));

end architecture;
