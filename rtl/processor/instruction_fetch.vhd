-- SPDX-License-Identifier: Apache-2.0
-- Asks the memory for instructions, and shows the next one of what it has brought.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch is
  generic (
    -- A multiple of the memory's size.
    memory_address : unsigned(31 downto 0);
    -- The memory holds 2 to this power bytes.
    memory_address_bits : positive;
    -- But for the last quarter of them.
    memory_lacks_quarter : boolean := false
  );
  port (
    clk : in std_ulogic;
    -- Nothing is shown in the next clock.
    cancel : in std_ulogic;
    -- Jumps go to the memory in their own clock, which is one with `advance`. First that of execute; its
    -- address, of which bit 0 is ignored, and the word of this plus 2. The first comes behind a reset.
    late_jump : in std_ulogic;
    late_address : in unsigned(31 downto 0);
    late_address_plus_2 : in unsigned(31 downto 2);
    -- That of the instruction shown, if there is none in execute.
    early_jump : in std_ulogic;
    early_address : in unsigned(31 downto 0);
    early_address_plus_2 : in unsigned(31 downto 0);
    -- Where it goes on behind the instruction shown: with `early_jump` where this goes. The address
    -- shown where no instruction is.
    following_address : in unsigned(31 downto 0);
    -- The instruction shown is taken in this clock, or there is none to take.
    advance : in std_ulogic;
    instruction_request : out instruction_request_t;
    instruction_data : in word_t;
    -- An instruction is shown; above a short one there is what follows it.
    valid : out std_ulogic;
    instruction : out word_t;
    is_word : out std_ulogic;
    -- Its address; with no instruction shown that of the next to be shown.
    address : out unsigned(31 downto 0);
    -- It comes from outside the memory; only its second half does.
    fault : out std_ulogic;
    leaves_memory : out std_ulogic
  );
end entity;

architecture rtl of instruction_fetch is

  subtype half_word_t is std_ulogic_vector(15 downto 0);
  -- Of a word in the memory: there is nothing to fetch elsewhere.
  subtype word_place_t is unsigned(memory_address_bits - 1 downto 2);
  constant memory_number : unsigned(31 downto memory_address_bits) :=
    memory_address(31 downto memory_address_bits);

  function is_long(half_word : half_word_t) return std_ulogic is
  begin
    return half_word(1) and half_word(0);
  end function;

  signal jumps, keeps_next : std_ulogic;

  -- The memory shows pairs of half words, each 4 bytes behind the one before, from where the last jump
  -- went: this one's words and half.
  signal upper, lower : word_place_t;
  signal is_odd, was_late_jump, late_is_odd, early_is_odd : std_ulogic;
  signal pair_low, pair_high : half_word_t;
  -- Of the pair before it, one half word may be kept. Where this is a short instruction, the pair rests.
  signal keeps, rests : std_ulogic;
  signal kept : half_word_t;
  signal next_upper, next_lower, early_upper, early_lower : word_place_t;
  signal upper_place, lower_place : word_place_t;
  signal in_lacking_quarter, at_last_half_word, straddles, outside : std_ulogic;

begin

  -- What the memory brings comes late in the clock: one choice is all between it and the instruction.
  is_odd <= late_is_odd when was_late_jump else early_is_odd;
  pair_low <= instruction_data(31 downto 16) when is_odd else instruction_data(15 downto 0);
  pair_high <= instruction_data(15 downto 0) when is_odd else instruction_data(31 downto 16);

  rests <= keeps and not is_long(kept);
  keeps_next <= is_long(kept) when keeps else not is_long(pair_low);
  next_upper <= upper + unsigned'(0 => not rests);
  next_lower <= lower + unsigned'(0 => not rests);

  -- A late jump comes late in the clock.
  early_upper <= early_address(word_place_t'range) when early_jump else next_upper;
  early_lower <= early_address_plus_2(word_place_t'range) when early_jump else next_lower;
  upper_place <= late_address(word_place_t'range) when late_jump else early_upper;
  lower_place <= late_address_plus_2(word_place_t'range) when late_jump else early_lower;
  jumps <= late_jump or early_jump;
  instruction_request <= (
    enable => advance,
    upper_address => memory_number & upper_place,
    lower_address => memory_number & lower_place);

  follow : process
  begin
    wait until rising_edge(clk);
    if advance then
      upper <= upper_place;
      lower <= lower_place;
      kept <= pair_high;
      instruction <= pair_low & kept when keeps else pair_high & pair_low;
      is_word <= is_long(kept) when keeps else is_long(pair_low);

      if late_jump then
        address <= late_address(31 downto 1) & '0';
      else
        address <= following_address;
      end if;
      was_late_jump <= late_jump;
      late_is_odd <= late_address(1);
      early_is_odd <= early_address(1) when early_jump else is_odd;

      valid <= not jumps;
      keeps <= keeps_next and not jumps;
    end if;

    if cancel then
      valid <= '0';
    end if;
  end process;

  in_lacking_quarter <= address(memory_address_bits - 1) and address(memory_address_bits - 2)
    when memory_lacks_quarter else '0';
  outside <= (address(31 downto memory_address_bits) ?/= memory_number) or in_lacking_quarter;
  at_last_half_word <=
    (and address(memory_address_bits - 3 downto 1)) and address(memory_address_bits - 1) and
    not address(memory_address_bits - 2) when memory_lacks_quarter else
    and address(memory_address_bits - 1 downto 1);
  straddles <= is_word and at_last_half_word;
  fault <= outside or straddles;
  leaves_memory <= straddles and not outside;

end architecture;
