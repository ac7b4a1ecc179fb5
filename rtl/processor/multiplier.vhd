-- SPDX-License-Identifier: Apache-2.0
-- Multiplier, signed and unsigned, pipelined: partial products in one clock, their sum in the next.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity multiplier is
  port (
    clk : in std_ulogic;
    -- Samples the operands.
    enable : in std_ulogic;
    -- As funct3: "00" lower word; upper word of "01" signed by signed,
    -- "10" signed by unsigned, "11" unsigned by unsigned.
    operation : in std_ulogic_vector(1 downto 0);
    first : in word_t;
    second : in word_t;
    -- From the clock after `enable` until the next `enable`.
    result : out word_t
  );
end entity;

architecture rtl of multiplier is

  -- Half words as 17-bit signed numbers: the width of an FPGA's multiplier (18 x 18).
  signal first_high, first_low, second_high, second_low : signed(16 downto 0);
  signal high_high, high_low, low_high, low_low : signed(33 downto 0);
  signal upper_wanted : std_ulogic;

  -- The partial products, each in its place, and the two numbers that have the same sum.
  signal outer, upper_middle, lower_middle, partial, carries : unsigned(63 downto 0);
  signal product : unsigned(63 downto 0);

begin

  first_low <= signed('0' & first(15 downto 0));
  second_low <= signed('0' & second(15 downto 0));
  first_high <= signed((first(31) and (operation(0) nand operation(1))) & first(31 downto 16));
  second_high <= signed((second(31) and not operation(1)) & second(31 downto 16));

  multiply_parts : process
  begin
    wait until rising_edge(clk);
    if enable then
      low_low <= first_low * second_low;
      high_low <= first_high * second_low;
      low_high <= first_low * second_high;
      high_high <= first_high * second_high;
      upper_wanted <= operation(0) or operation(1);
    end if;
  end process;

  -- The multipliers of an FPGA are slow: nothing is added up in their clock. Three numbers become two without
  -- a carry, so that one carry chain is enough.
  outer <= unsigned(high_high(31 downto 0) & low_low(31 downto 0));
  upper_middle <= unsigned(resize(high_low, 48)) & x"0000";
  lower_middle <= unsigned(resize(low_high, 48)) & x"0000";
  partial <= outer xor upper_middle xor lower_middle;
  carries <= (outer and upper_middle) or (outer and lower_middle) or (upper_middle and lower_middle);
  product <= partial + (carries(62 downto 0) & '0');
  result <= std_ulogic_vector(product(63 downto 32)) when upper_wanted else
            std_ulogic_vector(product(31 downto 0));

end architecture;
