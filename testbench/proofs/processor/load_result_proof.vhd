-- SPDX-License-Identifier: Apache-2.0
-- Loads extract and extend what the instruction set specifies, for all words and byte offsets.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.data_width_pkg.all;
use work.instruction_set_pkg.all;
use work.processor_pkg.all;

entity load_result_proof is
  port (
    clk : in std_ulogic;
    memory : in value_t;
    size : in std_ulogic_vector(2 downto 0);
    byte_index : in std_ulogic_vector(1 downto 0)
  );
end entity;

architecture proof of load_result_proof is

  signal word : value_t;
  signal address : unsigned(31 downto 0);
  signal result, nothing : value_t;

  default clock is rising_edge(clk);

begin

  word <= 17x"0" & size & "00000" & "0000011";
  address <= 30x"0" & unsigned(byte_index);

  load_result : entity work.load_result
    port map (loaded => memory, lanes => lanes_of('1', size, byte_index), result => result);

  no_load : entity work.load_result
    port map (loaded => memory, lanes => lanes_of('0', size, byte_index), result => nothing);

  it_is_a_load : assume always (kind_of(word) = load);
  it_is_aligned : assume always (not is_misaligned(word, address));

  bytes_are_extended : assert always
    (size(1 downto 0) = "00" -> result = loaded(word, memory, address));
  half_words_are_extended : assert always
    (size(1 downto 0) = "01" -> result = loaded(word, memory, address));
  words_are_unchanged : assert always
    (size(1 downto 0) = "10" -> result = loaded(word, memory, address));
  no_load_gives_zero : assert always (nothing = x"00000000");

end architecture;
