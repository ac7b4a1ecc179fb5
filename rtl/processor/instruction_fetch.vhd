-- SPDX-License-Identifier: Apache-2.0
-- Prefetch and fetch: addresses the instruction memory and aligns the instructions in what it returns.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch is
  generic (
    -- A multiple of the memory's size, or of the next power of two.
    memory_address : unsigned(31 downto 0);
    memory_size_bytes : positive
  );
  port (
    clk : in std_ulogic;
    -- No instruction is valid in the next clock.
    flush : in std_ulogic;
    -- Both kinds of jumps address the memory in their own clock, in which `advance` is high. A redirect by
    -- execute has priority; bit 0 of its target is ignored. The first one follows reset.
    redirect : in std_ulogic;
    redirect_target : in unsigned(31 downto 0);
    redirect_target_plus_2 : in unsigned(31 downto 2);
    -- The instruction at the outputs is jal, or a branch predicted taken.
    predicted_taken : in std_ulogic;
    predicted_target : in unsigned(31 downto 0);
    predicted_target_plus_2 : in unsigned(31 downto 0);
    -- Address of the next instruction: the target if predicted taken; `address` if no instruction is valid.
    predicted_next_address : in unsigned(31 downto 0);
    -- The instruction at the outputs, if any, is issued in this clock.
    advance : in std_ulogic;
    instruction_request : out instruction_request_t;
    instruction_data : in word_t;
    -- The upper half of a compressed instruction is don't care.
    valid : out std_ulogic;
    instruction : out word_t;
    is_word : out std_ulogic;
    -- Its address; without a valid instruction that of the next one.
    address : out unsigned(31 downto 0);
    -- It lies outside the memory; only its second half does.
    fault : out std_ulogic;
    crosses_memory_end : out std_ulogic
  );
end entity;

architecture rtl of instruction_fetch is

  subtype half_word_t is std_ulogic_vector(15 downto 0);
  constant memory_address_bits : positive := address_bits_of(memory_size_bytes);
  -- Offset of a word in the memory: there are no instructions elsewhere.
  subtype word_address_t is unsigned(memory_address_bits - 1 downto 2);
  constant memory_number : unsigned(31 downto memory_address_bits) :=
    memory_address(31 downto memory_address_bits);

  function is_long(half_word : half_word_t) return std_ulogic is
  begin
    return half_word(1) and half_word(0);
  end function;

  function banks_without(offset : word_address_t; enable : std_ulogic) return bank_choice_t is
  begin
    return not bank_of(memory_number & offset, memory_size_bytes) and enable;
  end function;

  signal jump, next_buffer_valid : std_ulogic;

  -- The memory returns 32 bits from any half-word address: a pair of half words. Pairs follow each other from
  -- the last jump target on. Addresses of the current pair's words; it begins in the upper half of one.
  signal upper, lower : word_address_t;
  signal is_odd, was_redirect, redirect_is_odd, predicted_is_odd : std_ulogic;
  signal pair_low, pair_high : half_word_t;
  -- Alignment buffer: the upper half word of the previous pair. While it is a compressed instruction, the
  -- current pair is held.
  signal buffer_valid, hold_pair : std_ulogic;
  signal buffered : half_word_t;
  signal next_upper, next_lower, predicted_upper, predicted_lower : word_address_t;
  signal fetch_upper, fetch_lower : word_address_t;
  signal upper_elsewhere, lower_elsewhere : bank_choice_t;
  signal beyond_end, at_last_half_word, straddles, outside : std_ulogic;

begin

  -- Critical path: memory data settles late. One multiplexer lies between it and the instruction register.
  is_odd <= redirect_is_odd when was_redirect else predicted_is_odd;
  pair_low <= instruction_data(31 downto 16) when is_odd else instruction_data(15 downto 0);
  pair_high <= instruction_data(15 downto 0) when is_odd else instruction_data(31 downto 16);

  hold_pair <= buffer_valid and not is_long(buffered);
  next_buffer_valid <= is_long(buffered) when buffer_valid else not is_long(pair_low);
  next_upper <= upper + unsigned'(0 => not hold_pair);
  next_lower <= lower + unsigned'(0 => not hold_pair);

  -- `redirect` settles late in the clock: last multiplexer.
  predicted_upper <= predicted_target(word_address_t'range) when predicted_taken else next_upper;
  predicted_lower <= predicted_target_plus_2(word_address_t'range) when predicted_taken else next_lower;
  fetch_upper <= redirect_target(word_address_t'range) when redirect else predicted_upper;
  fetch_lower <= redirect_target_plus_2(word_address_t'range) when redirect else predicted_lower;
  upper_elsewhere <= banks_without(redirect_target(word_address_t'range), advance) when redirect else
                     banks_without(predicted_upper, advance);
  lower_elsewhere <= banks_without(redirect_target_plus_2(word_address_t'range), advance) when redirect else
                     banks_without(predicted_lower, advance);
  jump <= redirect or predicted_taken;
  instruction_request <= (
    enable => advance,
    upper_address => memory_number & fetch_upper,
    lower_address => memory_number & fetch_lower,
    upper_elsewhere => upper_elsewhere,
    lower_elsewhere => lower_elsewhere);

  update : process
  begin
    wait until rising_edge(clk);
    if advance then
      upper <= fetch_upper;
      lower <= fetch_lower;
      buffered <= pair_high;
      instruction <= pair_low & buffered when buffer_valid else pair_high & pair_low;
      is_word <= is_long(buffered) when buffer_valid else is_long(pair_low);

      if redirect then
        address <= redirect_target(31 downto 1) & '0';
      else
        address <= predicted_next_address;
      end if;
      was_redirect <= redirect;
      redirect_is_odd <= redirect_target(1);
      predicted_is_odd <= predicted_target(1) when predicted_taken else is_odd;

      valid <= not jump;
      buffer_valid <= next_buffer_valid and not jump;
    end if;

    if flush then
      valid <= '0';
    end if;
  end process;

  beyond_end <= is_beyond_memory(address, memory_size_bytes);
  outside <= (address(31 downto memory_address_bits) ?/= memory_number) or beyond_end;
  at_last_half_word <= address(memory_address_bits - 1 downto 1) ?=
                       to_unsigned(memory_size_bytes / 2 - 1, memory_address_bits - 1);
  straddles <= is_word and at_last_half_word;
  fault <= outside or straddles;
  crosses_memory_end <= straddles and not outside;

end architecture;
