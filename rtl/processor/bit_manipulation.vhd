-- SPDX-License-Identifier: Apache-2.0
-- Zbb instructions with a late result: bit counts, byte order, sign and zero extension, minimum and maximum.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity bit_manipulation is
  port (
    clk : in std_ulogic;
    -- Samples the operands.
    enable : in std_ulogic;
    -- One that bit_manipulation_decoder assigns to this unit.
    instruction : in word_t;
    first : in word_t;
    second : in word_t;
    -- `first` is less than `second`, signed or unsigned as the instruction says.
    less : in std_ulogic;
    -- From the clock after `enable` until the next `enable`.
    result : out word_t
  );
end entity;

architecture rtl of bit_manipulation is

  -- Instruction bits that distinguish the operations.
  alias inverts : std_ulogic is instruction(30);
  alias compares : std_ulogic is instruction(25);
  alias extends : std_ulogic is instruction(22);
  alias counts_ones : std_ulogic is instruction(21);
  alias from_below : std_ulogic is instruction(20);
  alias of_bytes : std_ulogic is instruction(14);
  alias wants_maximum : std_ulogic is instruction(13);
  alias of_registers : std_ulogic is instruction(5);
  signal is_comparison, is_zero_extension, is_sign_extension, is_count : std_ulogic;
  signal is_reverse, is_combination : std_ulogic;

  signal turned, swapped, prepared : word_t;
  signal combined, sign_extension : word_t;
  signal sign : std_ulogic;

  -- The result is `kept`, with the parts selected by `replaces` (upper half, byte 1, byte 0) taken from
  -- `replacement`. A bit count is inserted into zeros.
  signal kept, replacement, chosen : word_t;
  signal replaces : std_ulogic_vector(2 downto 0);
  signal gives_zeros, gives_ones : std_ulogic;

  -- Counting is pipelined over two clocks: first the leading zero nibbles and the ones of each byte.
  signal nonzero : std_ulogic_vector(7 downto 0);
  signal zero_nibbles : unsigned(2 downto 0);
  signal is_zero : std_ulogic;
  type byte_counts_t is array (0 to 3) of unsigned(3 downto 0);
  signal byte_counts : byte_counts_t;
  signal ones, zeros, number : unsigned(5 downto 0);

  function reversed(word : word_t) return word_t is
    variable turned_word : word_t;
  begin
    for index in word'range loop
      turned_word(index) := word(31 - index);
    end loop;
    return turned_word;
  end function;

  function count_ones(nibble : std_ulogic_vector(3 downto 0)) return unsigned is
    variable two_or_more : std_ulogic;
  begin
    two_or_more := (nibble(0) and nibble(1)) or (nibble(2) and nibble(3)) or
                   ((nibble(0) or nibble(1)) and (nibble(2) or nibble(3)));
    return (and nibble) & (two_or_more and not (and nibble)) & (xor nibble);
  end function;

  -- Zeros above the highest one.
  function leading_zeros(bits : std_ulogic_vector(7 downto 0)) return unsigned is
    variable four : std_ulogic_vector(3 downto 0);
    variable two : std_ulogic_vector(1 downto 0);
    variable count : unsigned(2 downto 0);
  begin
    count(2) := nor bits(7 downto 4);
    four := bits(3 downto 0) when count(2) else bits(7 downto 4);
    count(1) := nor four(3 downto 2);
    two := four(1 downto 0) when count(1) else four(3 downto 2);
    count(0) := not two(1);
    return count;
  end function;

  -- Leading zeros of the highest nonzero nibble of `word`, which follows `nibbles` zero ones.
  function zeros_in_nibble(word : word_t; nibbles : unsigned(2 downto 0)) return unsigned is
    variable half : std_ulogic_vector(15 downto 0);
    variable byte : std_ulogic_vector(7 downto 0);
    variable nibble : std_ulogic_vector(3 downto 0);
  begin
    half := word(15 downto 0) when nibbles(2) else word(31 downto 16);
    byte := half(7 downto 0) when nibbles(1) else half(15 downto 8);
    nibble := byte(3 downto 0) when nibbles(0) else byte(7 downto 4);
    return (nor nibble(3 downto 2)) & (not nibble(3) and (nibble(2) or not nibble(1)));
  end function;

begin

  is_comparison <= of_registers and compares;
  is_zero_extension <= of_registers and not compares;
  is_sign_extension <= not of_registers and not of_bytes and extends;
  is_count <= not of_registers and not of_bytes and not extends;
  is_reverse <= not of_registers and of_bytes and inverts;
  is_combination <= not of_registers and of_bytes and not inverts;

  -- ctz is clz of the reversed word.
  turned <= reversed(first);
  swapped <= first(7 downto 0) & first(15 downto 8) & first(23 downto 16) & first(31 downto 24);
  prepared <= turned when is_count and from_below else swapped when is_reverse else first;

  find_nibbles : for index in nonzero'range generate
    nonzero(index) <= or prepared(4 * index + 3 downto 4 * index);
  end generate;

  sign <= first(15) when from_below else first(7);
  sign_extension <= (others => sign and is_sign_extension);
  combine_bytes : for index in 0 to 3 generate
    combined(8 * index + 7 downto 8 * index) <=
      (others => is_combination and (or first(8 * index + 7 downto 8 * index)));
  end generate;

  take : process
  begin
    wait until rising_edge(clk);
    if enable then
      kept <= prepared;
      replacement <= second when is_comparison else combined or sign_extension;
      replaces(2) <= (not less xor wants_maximum) when is_comparison else not is_reverse;
      replaces(1) <= (not less xor wants_maximum) when is_comparison else
                     is_count or is_combination or (is_sign_extension and not from_below);
      replaces(0) <= (not less xor wants_maximum) when is_comparison else is_count or is_combination;
      gives_zeros <= is_count and not counts_ones;
      gives_ones <= is_count and counts_ones;
      zero_nibbles <= leading_zeros(nonzero);
      is_zero <= nor nonzero;
      for index in byte_counts'range loop
        byte_counts(index) <= ('0' & count_ones(first(8 * index + 3 downto 8 * index))) +
                              count_ones(first(8 * index + 7 downto 8 * index + 4));
      end loop;
    end if;
  end process;

  ones <= (resize(byte_counts(0), 6) + byte_counts(1)) + (resize(byte_counts(2), 6) + byte_counts(3));
  zeros <= 6x"20" when is_zero else '0' & zero_nibbles & zeros_in_nibble(kept, zero_nibbles);
  number <= (zeros and (5 downto 0 => gives_zeros)) or (ones and (5 downto 0 => gives_ones));

  chosen(31 downto 16) <= replacement(31 downto 16) when replaces(2) else kept(31 downto 16);
  chosen(15 downto 8) <= replacement(15 downto 8) when replaces(1) else kept(15 downto 8);
  chosen(7 downto 0) <= replacement(7 downto 0) when replaces(0) else kept(7 downto 0);
  result <= chosen(31 downto 6) & (chosen(5 downto 0) or std_ulogic_vector(number));

end architecture;
