-- SPDX-License-Identifier: Apache-2.0
-- Asks the memory for instructions, and shows the next one of what it has brought.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;
use work.processor_pkg.all;

entity instruction_fetch is
  generic (
    reset_address : unsigned(31 downto 0);
    -- The memory holds 2 to this power bytes.
    memory_address_bits : positive
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- A trap or a return from one. It takes one clock more than a jump, which goes to the memory in
    -- the clock in which it is executed; a redirection wins over a jump in the same clock.
    redirect : in std_ulogic;
    -- In the next clock; its address and, where this is not a whole word's, this plus 2.
    redirect_address : in unsigned(31 downto 0);
    redirect_address_plus_2 : in unsigned(31 downto 0);
    -- Comes with `advance`. Its address, of which bit 0 is ignored, and this plus 2.
    jump : in std_ulogic;
    jump_address : in unsigned(31 downto 0);
    jump_address_plus_2 : in unsigned(31 downto 0);
    -- The instruction shown is taken in this clock.
    advance : in std_ulogic;
    instruction_request : out instruction_request_t;
    instruction_data : in word_t;
    -- The instruction shown and its address; above a short one there is what follows it.
    valid : out std_ulogic;
    address : out unsigned(31 downto 0);
    instruction : out word_t;
    -- It comes from outside the memory; only its second half does.
    fault : out std_ulogic;
    leaves_memory : out std_ulogic
  );
end entity;

architecture rtl of instruction_fetch is

  signal redirecting, resetting : std_ulogic;
  signal redirect_target, redirect_target_plus_2 : unsigned(31 downto 0);
  signal enable, is_word, outside, straddles : std_ulogic;

  -- The memory is asked for pairs of half words, each 4 bytes behind the one before, from where the last
  -- jump went. How long the instruction shown is comes too late in the clock to tell the memory where
  -- to read on; it only decides which half words begin the next. `kept` is the pair before the one that
  -- the memory shows.
  type place_t is (memory_first, kept_second, kept_first);
  signal place : place_t;
  signal pair, kept : word_t;
  signal kept_half : std_ulogic_vector(15 downto 0);
  signal first_is_kept, first_is_upper, second_is_kept, second_is_upper : std_ulogic;
  -- Where the pair begins that the memory shows; the next words.
  signal pair_address : unsigned(31 downto 1);
  signal word_after, second_word_after : unsigned(31 downto 2);
  signal other_upper, other_lower : unsigned(31 downto 2);
  signal upper_address, lower_address : unsigned(31 downto 2);
  signal other_in_upper_half : std_ulogic;

begin

  pair <= instruction_data(15 downto 0) & instruction_data(31 downto 16) when pair_address(1) else
          instruction_data;
  -- What the memory brings comes late in the clock: one choice, made early, is all between it and the
  -- instruction.
  kept_half <= kept(31 downto 16) when place = kept_second else kept(15 downto 0);
  first_is_kept <= '0' when place = memory_first else '1';
  first_is_upper <= pair_address(1);
  second_is_kept <= '1' when place = kept_first else '0';
  second_is_upper <= pair_address(1) when place = kept_second else not pair_address(1);
  instruction(15 downto 0) <= kept_half when first_is_kept else
                              instruction_data(31 downto 16) when first_is_upper else
                              instruction_data(15 downto 0);
  instruction(31 downto 16) <= kept(31 downto 16) when second_is_kept else
                               instruction_data(31 downto 16) when second_is_upper else
                               instruction_data(15 downto 0);
  is_word <= and instruction(1 downto 0);

  -- While a whole pair is kept, the one that the memory shows is read again, so as not to lose it. Of a
  -- pair that begins in the upper half of a word, the lower half words come from the word after.
  word_after <= pair_address(31 downto 2) + 1;
  second_word_after <= pair_address(31 downto 2) + 2;
  other_upper <= redirect_target(31 downto 2) when redirecting else
                 pair_address(31 downto 2) when place = kept_first else
                 word_after;
  other_lower <= redirect_target_plus_2(31 downto 2) when redirecting else
                 pair_address(31 downto 2) when place = kept_first and pair_address(1) = '0' else
                 word_after when place = kept_first or pair_address(1) = '0' else
                 second_word_after;
  other_in_upper_half <= redirect_target(1) when redirecting else pair_address(1);

  -- A jump comes late in the clock.
  upper_address <= jump_address(31 downto 2) when jump else other_upper;
  lower_address <= jump_address_plus_2(31 downto 2) when jump else other_lower;
  enable <= redirecting or advance;
  instruction_request <= (
    enable => enable,
    upper_address => upper_address,
    lower_address => lower_address);

  redirect_target <= reset_address when resetting else redirect_address;
  redirect_target_plus_2 <= reset_address when resetting else redirect_address_plus_2;

  follow : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect or reset;
    resetting <= reset;
    if enable then
      pair_address <= jump_address(31 downto 1) when jump else other_upper & other_in_upper_half;
      if place /= kept_first then
        kept <= pair;
      end if;

      if redirecting or jump then
        address <= other_upper & other_in_upper_half & '0';
        if jump then
          address <= jump_address(31 downto 1) & '0';
        end if;
        place <= memory_first;
      elsif is_word then
        address <= address + 4;
        if place = kept_first then
          place <= memory_first;
        end if;
      else
        address <= address + 2;
        place <= kept_first when place = kept_second else kept_second;
      end if;
    end if;
  end process;

  valid <= not redirecting;
  outside <= address(31 downto memory_address_bits) ?/=
             reset_address(31 downto memory_address_bits);
  straddles <= is_word and (and address(memory_address_bits - 1 downto 1));
  fault <= outside or straddles;
  leaves_memory <= straddles and not outside;

end architecture;
