-- SPDX-License-Identifier: Apache-2.0
-- Restoring divider, signed or unsigned, two quotient bits a clock: always 18 clocks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity divider is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Held, with the operands, until `done`; the division is aborted if it falls before.
    request : in std_ulogic;
    -- As funct3: bit 0 unsigned, bit 1 remainder instead of quotient.
    operation : in std_ulogic_vector(1 downto 0);
    first : in word_t;
    second : in word_t;
    -- High in the 18th clock of the request, with the result.
    done : out std_ulogic;
    result : out word_t
  );
end entity;

architecture rtl of divider is

  type state_t is (idle, dividing, finished);
  signal state : state_t;
  signal pairs_left : unsigned(3 downto 0);

  -- Absolute values. `quotient` shifts the dividend out to the left and the quotient in from the right.
  signal quotient, remainder : unsigned(31 downto 0);
  -- Adding these subtracts the divisor's absolute value: a negative divisor unchanged, any other inverted,
  -- with a carry in.
  signal addend : unsigned(31 downto 0);
  signal carry_in : std_ulogic;
  signal negate_quotient, negate_remainder : std_ulogic;

  -- The first of the two bits, then the second. Bit 32 of a difference is the borrow: the divisor is greater.
  signal first_shifted, first_difference, second_shifted, second_difference : unsigned(32 downto 0);
  signal first_remainder, second_remainder : unsigned(31 downto 0);

  signal first_negative, second_negative : std_ulogic;
  -- One negation unit for both the dividend and the result.
  signal to_sign, given_sign : unsigned(31 downto 0);
  signal negate : std_ulogic;

  function without_divisor(value : unsigned(32 downto 0); to_add : unsigned(31 downto 0);
                           carry : std_ulogic) return unsigned is
    variable sum : unsigned(33 downto 0);
  begin
    -- An extra lowest bit is the carry in.
    sum := (value & '1') + ('1' & to_add & carry);
    return sum(33 downto 1);
  end function;

begin

  first_negative <= first(31) and not operation(0);
  second_negative <= second(31) and not operation(0);

  first_shifted <= remainder & quotient(31);
  first_difference <= without_divisor(first_shifted, addend, carry_in);
  first_remainder <= first_shifted(31 downto 0) when first_difference(32) else
                     first_difference(31 downto 0);
  second_shifted <= first_remainder & quotient(30);
  second_difference <= without_divisor(second_shifted, addend, carry_in);
  second_remainder <= second_shifted(31 downto 0) when second_difference(32) else
                      second_difference(31 downto 0);

  choose_to_sign : process (all)
  begin
    if state = idle then
      to_sign <= unsigned(first);
      negate <= first_negative;
    elsif operation(1) then
      to_sign <= remainder;
      negate <= negate_remainder;
    else
      to_sign <= quotient;
      negate <= negate_quotient;
    end if;
  end process;
  given_sign <= (to_sign xor (31 downto 0 => negate)) + ("" & negate);

  divide : process
  begin
    wait until rising_edge(clk);
    case state is
      when idle =>
        if request then
          state <= dividing;
          pairs_left <= (others => '1');
          quotient <= given_sign;
          remainder <= (others => '0');
          addend <= unsigned(second xor (31 downto 0 => not second_negative));
          carry_in <= not second_negative;
          -- Division by zero: the quotient is all ones and must not be negated.
          negate_quotient <= (first_negative xor second_negative) and (or second);
          negate_remainder <= first_negative;
        end if;

      when dividing =>
        quotient <= quotient(29 downto 0) & not first_difference(32) & not second_difference(32);
        remainder <= second_remainder;
        pairs_left <= pairs_left - 1;
        if pairs_left = 0 then
          state <= finished;
        end if;

      when finished =>
        state <= idle;
    end case;

    if reset or not request then
      state <= idle;
    end if;
  end process;

  done <= '1' when state = finished else '0';
  result <= std_ulogic_vector(given_sign);

end architecture;
