-- SPDX-License-Identifier: Apache-2.0
-- An instruction faults exactly where one of its bytes is outside the memory, whatever is fetched before it.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.memory_pkg.all;

entity instruction_fetch_proof is
  generic (
    -- All of the 2^memory_address_bits, or fewer.
    memory_address_bits : positive := 16;
    memory_size_bytes : positive := 65536
  );
  port (
    clk : in std_ulogic;
    flush : in std_ulogic;
    redirect : in std_ulogic;
    redirect_target : in unsigned(31 downto 0);
    predicted_taken : in std_ulogic;
    predicted_target : in unsigned(31 downto 0);
    predicted_next_address : in unsigned(31 downto 0);
    advance : in std_ulogic;
    instruction_data : in value_t
  );
end entity;

architecture proof of instruction_fetch_proof is

  constant memory_address : unsigned(31 downto 0) := x"80000000";

  signal instruction_request : instruction_request_t;
  signal valid, is_word, fault, crosses_memory_end : std_ulogic;
  signal instruction : value_t;
  signal address : unsigned(31 downto 0);
  signal redirect_target_plus_2, predicted_target_plus_2 : unsigned(31 downto 0);
  -- Of the specification.
  signal begins_inside, ends_inside, asks_inside : std_ulogic;

  function is_inside(place : unsigned(31 downto 0)) return std_ulogic is
  begin
    if place >= memory_address and place < memory_address + memory_size_bytes then
      return '1';
    end if;
    return '0';
  end function;

  -- Of the banks of 65536 or of 65536 + 32768 + 8192 bytes, which lie behind each other.
  function bank_by_size(word : unsigned(31 downto 2)) return bank_choice_t is
    constant offset : unsigned(31 downto 0) := (word & "00") - memory_address;
    variable found : bank_choice_t := (others => '0');
  begin
    if memory_size_bytes = 65536 or offset < 65536 then
      found(0) := '1';
    elsif offset < 65536 + 32768 then
      found(1) := '1';
    else
      found(2) := '1';
    end if;
    return found;
  end function;

  default clock is rising_edge(clk);

begin

  redirect_target_plus_2 <= redirect_target + 2;
  predicted_target_plus_2 <= predicted_target + 2;

  fetch : entity work.instruction_fetch
    generic map (
      memory_address => memory_address,
      memory_size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      flush => flush,
      redirect => redirect,
      redirect_target => redirect_target,
      redirect_target_plus_2 => redirect_target_plus_2(31 downto 2),
      predicted_taken => predicted_taken,
      predicted_target => predicted_target,
      predicted_target_plus_2 => predicted_target_plus_2,
      predicted_next_address => predicted_next_address,
      advance => advance,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      valid => valid,
      instruction => instruction,
      is_word => is_word,
      address => address,
      fault => fault,
      crosses_memory_end => crosses_memory_end);

  -- Addresses are even, so the last byte of a long instruction lies in its second half word.
  begins_inside <= is_inside(address);
  ends_inside <= is_inside(address + 2) when is_word else begins_inside;
  asks_inside <= '1' when (instruction_request.upper_address & "00") >= memory_address
    and (instruction_request.upper_address & "00") - memory_address < 2 ** memory_address_bits else '0';

  addresses_are_even : assume always (address(0) = '0');

  an_instruction_outside_memory_faults : assert always (fault = not (begins_inside and ends_inside));
  only_the_second_half_faults_at_the_end : assert always
    (crosses_memory_end = (begins_inside and not ends_inside));
  requests_are_inside_the_memory : assert always asks_inside;
  requests_are_for_the_bank_of_their_addresses : assert always
    ((instruction_request.upper_elsewhere =
        (not bank_by_size(instruction_request.upper_address) and advance)) and
     (instruction_request.lower_elsewhere =
        (not bank_by_size(instruction_request.lower_address) and advance)));

end architecture;
