-- SPDX-License-Identifier: Apache-2.0
-- Specification of machine mode for the proofs: interrupt priorities and implemented CSRs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

package machine_mode_pkg is

  -- The CSRs as they are read; for those without a reset value, whether they have been written.
  type machine_state_t is record
    mie : value_t;
    mtvec : value_t;
    mscratch : value_t;
    mepc : value_t;
    mcause : value_t;
    mtval : value_t;
    -- mstatus.MIE, MPIE; mcountinhibit.CY, IR.
    enable : std_ulogic;
    previous_enable : std_ulogic;
    stops_cycle : std_ulogic;
    stops_instructions : std_ulogic;
    scratch_known : std_ulogic;
    trap_known : std_ulogic;
    mtval_known : std_ulogic;
  end record;

  -- The highest-priority interrupt of a set: external, timer, 16, 17, .. 31; 0 if empty.
  function first_of(set : value_t) return natural;

  -- Whether the CSR is implemented.
  function csr_exists(number : std_ulogic_vector(11 downto 0)) return boolean;

end package;

package body machine_mode_pkg is

  function first_of(set : value_t) return natural is
  begin
    if set(11) = '1' then
      return 11;
    elsif set(7) = '1' then
      return 7;
    end if;
    for index in 16 to 31 loop
      if set(index) = '1' then
        return index;
      end if;
    end loop;
    return 0;
  end function;

  function csr_exists(number : std_ulogic_vector(11 downto 0)) return boolean is
    variable index : natural range 0 to 31;
  begin
    index := to_integer(unsigned(number(4 downto 0)));
    case number is
      when x"300" | x"301" | x"304" | x"305" | x"310" | x"320" | x"340" | x"341" | x"342" | x"343" |
           x"344" | x"7a0" | x"7a1" | x"7a2" | x"7a3" | x"b00" | x"b02" | x"b80" | x"b82" | x"c00" |
           x"c02" | x"c80" | x"c82" | x"f11" | x"f12" | x"f13" | x"f14" | x"f15" =>
        return true;
      when others =>
        case number(11 downto 5) is
          when x"b" & "000" | x"b" & "100" | x"3" & "001" => return index >= 3;
          when others => return false;
        end case;
    end case;
  end function;

end package body;
