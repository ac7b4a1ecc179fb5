-- SPDX-License-Identifier: Apache-2.0
-- Specification of RV32IM for the proofs: classes, results and targets of 32-bit instructions. Independent
-- of decoder and ALU. Loads and stores: `data_width_pkg`.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package instruction_set_pkg is

  subtype value_t is std_ulogic_vector(31 downto 0);

  type kind_t is (
    illegal, load_upper, add_upper, jump, jump_register, branch, load, store, operation, multiplication,
    division, fence, fence_instruction, csr, environment_call, breakpoint, trap_return, wait_for_interrupt);

  function kind_of(word : value_t) return kind_t;

  -- Immediates of the formats I, S, B, U, J.
  function immediate_i(word : value_t) return unsigned;
  function immediate_s(word : value_t) return unsigned;
  function immediate_b(word : value_t) return unsigned;
  function immediate_u(word : value_t) return unsigned;
  function immediate_j(word : value_t) return unsigned;

  -- Whether the instruction reads rs1 and rs2.
  function reads_first(word : value_t) return boolean;
  function reads_second(word : value_t) return boolean;
  -- Its destination register, "00000" if none.
  function destination_of(word : value_t) return std_ulogic_vector;

  -- Of register-register and register-immediate operations; `second` is then the immediate.
  function sum(word, first, second : value_t) return value_t;
  function comparison(word, first, second : value_t) return value_t;
  function logic(word, first, second : value_t) return value_t;
  function shift(word, first, second : value_t) return value_t;
  function is_taken(word, first, second : value_t) return boolean;
  -- What the stand-ins multiplier.vhdl and divider.vhdl compute instead of products and quotients, which no
  -- solver could prove. Distinguishes operations and operands.
  function stand_in(funct3 : std_ulogic_vector(2 downto 0); first, second : value_t) return value_t;

end package;

package body instruction_set_pkg is

  function kind_of(word : value_t) return kind_t is
    variable opcode : std_ulogic_vector(6 downto 0);
    variable funct3 : std_ulogic_vector(2 downto 0);
    variable funct7 : std_ulogic_vector(6 downto 0);
    variable kind : kind_t;
  begin
    opcode := word(6 downto 0);
    funct3 := word(14 downto 12);
    funct7 := word(31 downto 25);
    kind := illegal;
    case opcode is
      when "0110111" => kind := load_upper;
      when "0010111" => kind := add_upper;
      when "1101111" => kind := jump;
      when "1100111" =>
        if funct3 = "000" then
          kind := jump_register;
        end if;
      when "1100011" =>
        if funct3 /= "010" and funct3 /= "011" then
          kind := branch;
        end if;
      when "0000011" =>
        if funct3 /= "011" and funct3 /= "110" and funct3 /= "111" then
          kind := load;
        end if;
      when "0100011" =>
        if funct3 = "000" or funct3 = "001" or funct3 = "010" then
          kind := store;
        end if;
      when "0010011" =>
        if funct3 = "001" then
          if funct7 = "0000000" then
            kind := operation;
          end if;
        elsif funct3 = "101" then
          if funct7 = "0000000" or funct7 = "0100000" then
            kind := operation;
          end if;
        else
          kind := operation;
        end if;
      when "0110011" =>
        if funct7 = "0000000" then
          kind := operation;
        elsif funct7 = "0100000" and (funct3 = "000" or funct3 = "101") then
          kind := operation;
        elsif funct7 = "0000001" and funct3(2) = '0' then
          kind := multiplication;
        elsif funct7 = "0000001" then
          kind := division;
        end if;
      when "0001111" =>
        if funct3 = "000" then
          kind := fence;
        elsif funct3 = "001" then
          kind := fence_instruction;
        end if;
      when "1110011" =>
        if funct3 = "000" then
          case word(31 downto 7) is
            when x"000" & "0000000000000" => kind := environment_call;
            when x"001" & "0000000000000" => kind := breakpoint;
            when x"302" & "0000000000000" => kind := trap_return;
            when x"105" & "0000000000000" => kind := wait_for_interrupt;
            when others => null;
          end case;
        elsif funct3 /= "100" then
          kind := csr;
        end if;
      when others => null;
    end case;
    return kind;
  end function;

  function extended(bits : std_ulogic_vector) return unsigned is
  begin
    return unsigned(resize(signed(bits), 32));
  end function;

  function immediate_i(word : value_t) return unsigned is
  begin
    return extended(word(31 downto 20));
  end function;

  function immediate_s(word : value_t) return unsigned is
  begin
    return extended(word(31 downto 25) & word(11 downto 7));
  end function;

  function immediate_b(word : value_t) return unsigned is
  begin
    return extended(word(31) & word(7) & word(30 downto 25) & word(11 downto 8) & '0');
  end function;

  function immediate_u(word : value_t) return unsigned is
  begin
    return unsigned(word(31 downto 12)) & x"000";
  end function;

  function immediate_j(word : value_t) return unsigned is
  begin
    return extended(word(31) & word(19 downto 12) & word(20) & word(30 downto 21) & '0');
  end function;

  function reads_first(word : value_t) return boolean is
  begin
    case kind_of(word) is
      when jump_register | branch | load | store | operation | multiplication | division => return true;
      when csr => return word(14) = '0';
      when others => return false;
    end case;
  end function;

  function reads_second(word : value_t) return boolean is
  begin
    case kind_of(word) is
      when branch | store | multiplication | division => return true;
      when operation => return word(5) = '1';
      when others => return false;
    end case;
  end function;

  function destination_of(word : value_t) return std_ulogic_vector is
  begin
    case kind_of(word) is
      when load_upper | add_upper | jump | jump_register | load | operation | multiplication |
           division | csr =>
        return word(11 downto 7);
      when others => return "00000";
    end case;
  end function;

  function sum(word, first, second : value_t) return value_t is
  begin
    if word(5) = '1' and word(30) = '1' then
      return std_ulogic_vector(unsigned(first) - unsigned(second));
    end if;
    return std_ulogic_vector(unsigned(first) + unsigned(second));
  end function;

  function comparison(word, first, second : value_t) return value_t is
    variable less : boolean;
  begin
    less := signed(first) < signed(second);
    if word(12) = '1' then
      less := unsigned(first) < unsigned(second);
    end if;
    if less then
      return x"00000001";
    end if;
    return x"00000000";
  end function;

  function logic(word, first, second : value_t) return value_t is
  begin
    case word(14 downto 12) is
      when "100" => return first xor second;
      when "110" => return first or second;
      when others => return first and second;
    end case;
  end function;

  function shift(word, first, second : value_t) return value_t is
    variable distance : natural range 0 to 31;
  begin
    distance := to_integer(unsigned(second(4 downto 0)));
    if word(14) = '0' then
      return std_ulogic_vector(shift_left(unsigned(first), distance));
    elsif word(30) = '1' then
      return std_ulogic_vector(shift_right(signed(first), distance));
    end if;
    return std_ulogic_vector(shift_right(unsigned(first), distance));
  end function;

  function is_taken(word, first, second : value_t) return boolean is
  begin
    case word(14 downto 12) is
      when "000" => return first = second;
      when "001" => return first /= second;
      when "100" => return signed(first) < signed(second);
      when "101" => return signed(first) >= signed(second);
      when "110" => return unsigned(first) < unsigned(second);
      when others => return unsigned(first) >= unsigned(second);
    end case;
  end function;

  function stand_in(funct3 : std_ulogic_vector(2 downto 0); first, second : value_t) return value_t is
  begin
    return std_ulogic_vector(unsigned(first) - unsigned(second)) xor (funct3 & x"2d8e6a1" & '1');
  end function;

end package body;
