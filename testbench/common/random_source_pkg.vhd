-- SPDX-License-Identifier: Apache-2.0
-- Random numbers for benches, the same in each run.

library ieee;
use ieee.math_real.all;

package random_source_pkg is

  type random_source_t is protected
    procedure seed(first, second : positive);
    -- Each equally likely.
    impure function between(least, most : natural) return natural;
  end protected;

end package;

package body random_source_pkg is

  type random_source_t is protected body
    variable seed_1 : positive := 1;
    variable seed_2 : positive := 1;

    procedure seed(first, second : positive) is
    begin
      seed_1 := first;
      seed_2 := second;
    end procedure;

    impure function between(least, most : natural) return natural is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      return least + integer(floor(value * real(most - least + 1)));
    end function;
  end protected body;

end package body;
