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
  signal enable, is_word, in_upper_half, outside, straddles : std_ulogic;
  signal next_word, word_after : unsigned(31 downto 2);
  signal upper_behind_short, upper_behind_long : unsigned(31 downto 2);
  signal lower_behind_short, lower_behind_long : unsigned(31 downto 2);
  signal upper_address, lower_address : unsigned(31 downto 2);
  signal next_in_upper_half : std_ulogic;

begin

  in_upper_half <= address(1);
  instruction <= instruction_data(15 downto 0) & instruction_data(31 downto 16) when
                   in_upper_half else
                 instruction_data;
  is_word <= (and instruction_data(17 downto 16)) when in_upper_half else
             (and instruction_data(1 downto 0));

  -- The upper half words come from the word in which the instruction begins. The lower half words
  -- come from the same, or from the next where it begins in the upper half.
  next_word <= address(31 downto 2) + 1;
  word_after <= address(31 downto 2) + 2;
  redirect_target <= reset_address when resetting else redirect_address;
  redirect_target_plus_2 <= reset_address when resetting else redirect_address_plus_2;
  upper_behind_short <= redirect_target(31 downto 2) when redirecting else
                        next_word when in_upper_half else
                        address(31 downto 2);
  upper_behind_long <= redirect_target(31 downto 2) when redirecting else
                       next_word;
  lower_behind_short <= redirect_target_plus_2(31 downto 2) when redirecting else
                        next_word;
  lower_behind_long <= redirect_target_plus_2(31 downto 2) when redirecting else
                       word_after when in_upper_half else
                       next_word;

  -- Length and jump come late in the clock: they pass these two selections only.
  upper_address <= jump_address(31 downto 2) when jump else
                   upper_behind_long when is_word else
                   upper_behind_short;
  lower_address <= jump_address_plus_2(31 downto 2) when jump else
                   lower_behind_long when is_word else
                   lower_behind_short;
  next_in_upper_half <= jump_address(1) when jump else
                        redirect_target(1) when redirecting else
                        in_upper_half xor not is_word;
  enable <= redirecting or advance;
  instruction_request <= (
    enable => enable, upper_address => upper_address, lower_address => lower_address);

  follow : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect or reset;
    resetting <= reset;
    if enable then
      address <= upper_address & next_in_upper_half & '0';
    end if;
  end process;

  valid <= not redirecting;
  outside <= address(31 downto memory_address_bits) ?/=
             reset_address(31 downto memory_address_bits);
  straddles <= is_word and (and address(memory_address_bits - 1 downto 1));
  fault <= outside or straddles;
  leaves_memory <= straddles and not outside;

end architecture;
