-- SPDX-License-Identifier: Apache-2.0
-- Asks the memory for the next instruction, and shows the one that it has brought.

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
    redirect_address : in unsigned(31 downto 0);
    -- At most one of both, each with its target, of which bit 0 is ignored, and the target plus 2.
    jump : in std_ulogic;
    target : in unsigned(31 downto 0);
    target_plus_2 : in unsigned(31 downto 0);
    jump_register : in std_ulogic;
    register_target : in unsigned(31 downto 0);
    register_target_plus_2 : in unsigned(31 downto 0);
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

  signal redirecting : std_ulogic;
  signal redirect_target, redirect_target_plus_2 : unsigned(31 downto 0);
  signal enable, is_word, in_upper_half, outside, straddles : std_ulogic;
  signal next_word, word_after : unsigned(31 downto 2);
  signal upper_of_following, lower_of_following : unsigned(31 downto 2);
  signal upper_address, lower_address : unsigned(31 downto 2);
  signal next_in_upper_half : std_ulogic;

begin

  in_upper_half <= address(1);
  instruction <= instruction_data(15 downto 0) & instruction_data(31 downto 16) when
                   in_upper_half else
                 instruction_data;
  is_word <= instruction(1) and instruction(0);

  -- The upper half words come from the word in which the instruction begins. The lower half words
  -- come from the same, or from the next where it begins in the upper half.
  next_word <= address(31 downto 2) + 1;
  word_after <= address(31 downto 2) + 2;
  upper_of_following <= next_word when is_word or in_upper_half else address(31 downto 2);
  lower_of_following <= word_after when is_word and in_upper_half else next_word;

  -- What comes from execute comes late in the clock: it passes this one selection.
  redirect_target_plus_2 <= redirect_target + 2;
  upper_address <= target(31 downto 2) when jump else
                   register_target(31 downto 2) when jump_register else
                   redirect_target(31 downto 2) when redirecting else
                   upper_of_following;
  lower_address <= target_plus_2(31 downto 2) when jump else
                   register_target_plus_2(31 downto 2) when jump_register else
                   redirect_target_plus_2(31 downto 2) when redirecting else
                   lower_of_following;
  next_in_upper_half <= target(1) when jump else
                        register_target(1) when jump_register else
                        redirect_target(1) when redirecting else
                        in_upper_half xor not is_word;
  enable <= redirecting or jump or jump_register or advance;
  instruction_request <= (
    enable => enable, upper_address => upper_address, lower_address => lower_address);

  follow : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect;
    if redirect then
      redirect_target <= redirect_address;
    end if;
    if enable then
      address <= upper_address & next_in_upper_half & '0';
    end if;

    if reset then
      redirecting <= '1';
      redirect_target <= reset_address;
    end if;
  end process;

  valid <= not redirecting;
  outside <= address(31 downto memory_address_bits) ?/=
             reset_address(31 downto memory_address_bits);
  straddles <= is_word and (and address(memory_address_bits - 1 downto 1));
  fault <= outside or straddles;
  leaves_memory <= straddles and not outside;

end architecture;
