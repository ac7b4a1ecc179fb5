-- SPDX-License-Identifier: Apache-2.0
-- Divides two words, signed or not, one bit of the quotient a clock: always 34 clocks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity divider is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Held, with the operands, until `done`; if it falls before, the division is given up.
    request : in std_ulogic;
    -- In the coding of funct3: bit 0 unsigned, bit 1 remainder instead of quotient.
    operation : in std_ulogic_vector(1 downto 0);
    first : in word_t;
    second : in word_t;
    -- For one clock, the 34th of the request: the result is there.
    done : out std_ulogic;
    result : out word_t
  );
end entity;

architecture rtl of divider is

  type state_t is (idle, dividing, finished);
  signal state : state_t;
  signal bits_left : unsigned(4 downto 0);

  -- Absolute values. The quotient enters `quotient` from the right, the dividend leaves to the
  -- left.
  signal quotient, remainder, divisor : unsigned(31 downto 0);
  signal negate_quotient, negate_remainder : std_ulogic;

  signal shifted, difference : unsigned(32 downto 0);
  signal first_negative, second_negative : std_ulogic;

begin

  first_negative <= first(31) and not operation(0);
  second_negative <= second(31) and not operation(0);

  shifted <= remainder & quotient(31);
  difference <= shifted - ('0' & divisor);

  divide : process
  begin
    wait until rising_edge(clk);
    case state is
      when idle =>
        if request then
          state <= dividing;
          bits_left <= (others => '1');
          quotient <= unsigned(first);
          if first_negative then
            quotient <= 0 - unsigned(first);
          end if;
          divisor <= unsigned(second);
          if second_negative then
            divisor <= 0 - unsigned(second);
          end if;
          remainder <= (others => '0');
          -- Division by zero gives a quotient of all ones as it comes, whatever the signs.
          negate_quotient <= (first_negative xor second_negative) and (or second);
          negate_remainder <= first_negative;
        end if;

      when dividing =>
        quotient <= quotient(30 downto 0) & not difference(32);
        remainder <= difference(31 downto 0);
        if difference(32) then
          remainder <= shifted(31 downto 0);
        end if;
        bits_left <= bits_left - 1;
        if bits_left = 0 then
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

  give_sign : process (all)
    variable magnitude : unsigned(31 downto 0);
    variable negate : std_ulogic;
  begin
    if operation(1) then
      magnitude := remainder;
      negate := negate_remainder;
    else
      magnitude := quotient;
      negate := negate_quotient;
    end if;
    result <= std_ulogic_vector(magnitude);
    if negate then
      result <= std_ulogic_vector(0 - magnitude);
    end if;
  end process;

end architecture;
