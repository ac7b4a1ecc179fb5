-- SPDX-License-Identifier: Apache-2.0
-- Every instruction of Zbb is decoded, and its execution unit computes its result, for all operands.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bit_manipulation_pkg.all;
use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity bit_manipulation_proof is
  port (
    clk : in std_ulogic;
    instruction : in value_t;
    -- Contents of its source registers.
    first_content : in value_t;
    second_content : in value_t
  );
end entity;

architecture proof of bit_manipulation_proof is

  signal decoded : control_t;
  signal immediate : value_t;
  signal is_first, is_second : std_ulogic_vector(4 downto 0);
  signal is_word, legal, meant, takes_two : std_ulogic;
  signal first, second, second_register, result, late_result, expected, late_expected : value_t;
  signal less : std_ulogic;
  signal has_late_result : std_ulogic := '0';

  default clock is rising_edge(clk);

begin

  instruction_decoder : entity work.instruction_decoder
    generic map (has_zbb => true)
    port map (
      instruction => instruction,
      is_word => is_word,
      decoded => decoded,
      immediate => immediate,
      first => is_first,
      second => is_second);

  is_word <= and instruction(1 downto 0);
  legal <= or decoded.legal;
  meant <= '1' when is_bit_manipulation(instruction) else '0';
  takes_two <= meant and instruction(5);

  -- A register that is not read may have any content; x0 is zero.
  first <= x"00000000" when is_first = "00000" else first_content;
  second_register <= x"00000000" when is_second = "00000" else second_content;
  second <= immediate when decoded.second_is_immediate else second_register;
  arithmetic : entity work.alu
    generic map (has_zbb => true)
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
      less => less);

  bits : entity work.bit_manipulation
    port map (
      clk => clk,
      enable => decoded.manipulate,
      instruction => instruction,
      first => first,
      second => second,
      less => less,
      result => late_result);

  expected <= manipulated(instruction, first, second_register);

  follow : process
  begin
    wait until rising_edge(clk);
    has_late_result <= meant and decoded.manipulate;
    late_expected <= expected;
  end process;

  zbb_instructions_are_legal : assert always (meant -> legal);
  only_zbb_uses_bit_manipulation : assert always ((legal and not meant) -> not decoded.manipulate);
  first_index_is_right : assert always
    (meant -> (is_first = instruction(19 downto 15) and decoded.reads_first = '1'));
  second_index_is_right : assert always
    (takes_two -> (is_second = instruction(24 downto 20) and decoded.reads_second = '1'));
  destination_index_is_right : assert always
    (meant -> (decoded.destination = instruction(11 downto 7) and
               (decoded.writes = '0') = (decoded.destination = "00000")));
  no_other_control_signal : assert always
    (meant -> not (decoded.load or decoded.store or decoded.branch or decoded.jump or
                   decoded.jump_register or decoded.refetch or decoded.address_result or decoded.multiply or
                   decoded.divide or decoded.csr or decoded.environment_call or decoded.breakpoint or
                   decoded.trap_return or decoded.wait_for_interrupt));
  late_results_are_late : assert always (meant -> decoded.late = decoded.manipulate);

  alu_results_are_right : assert always
    ((meant and not decoded.manipulate) -> result = expected);
  late_results_are_right : assert always (has_late_result -> late_result = late_expected);

end architecture;
