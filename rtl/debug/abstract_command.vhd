-- SPDX-License-Identifier: Apache-2.0
-- Abstract commands: access registers of the halted processor by injecting instructions.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.processor_pkg.all;

-- A register is read by adding it to x0, with the result taken from write-back, and written by lui and
-- addi. A CSR is written from x8, which is restored afterwards.
entity abstract_command is
  port (
    clk : in std_ulogic;
    -- Aborts the current command.
    reset : in std_ulogic;
    halted : in std_ulogic;
    -- For one clock, while not busy: execute `command` (section 3.6.1 of the specification) with `data`.
    start : in std_ulogic;
    command : in word_t;
    data : in word_t;
    busy : out std_ulogic;
    -- For one clock: the command is done, with its error code; `result` is the value read.
    done : out std_ulogic;
    error : out command_error_t;
    has_result : out std_ulogic;
    result : out word_t;
    -- Debug registers outside the processor.
    csr_request : out debug_csr_request_t;
    csr_response : in debug_csr_response_t;
    inject : out std_ulogic;
    instruction : out word_t;
    debug_response : in debug_response_t
  );
end entity;

architecture rtl of abstract_command is

  type state_t is (
    idle, decide, read_register, write_upper, write_lower, read_csr, save_x8, set_x8_upper,
    set_x8_lower, write_csr, restore_x8_upper, restore_x8_lower, finish);

  subtype upper_t is std_ulogic_vector(19 downto 0);
  constant x8 : register_index_t := 5d"8";

  function add_to_x0(index : register_index_t) return word_t is
  begin
    return x"000" & index & "000" & "00000" & "0010011";
  end function;

  function load_upper(index : register_index_t; upper : upper_t) return word_t is
  begin
    return upper & index & "0110111";
  end function;

  -- Immediate of lui, corrected for the signed immediate of the addi that follows.
  function upper_of(value : word_t) return upper_t is
  begin
    return std_ulogic_vector(unsigned(value(31 downto 12)) + unsigned'(0 => value(11)));
  end function;

  function add_lower(index : register_index_t; value : word_t) return word_t is
  begin
    return value(11 downto 0) & index & "000" & index & "0010011";
  end function;

  alias command_type : std_ulogic_vector(7 downto 0) is command(31 downto 24);
  alias size : std_ulogic_vector(2 downto 0) is command(22 downto 20);
  alias post_increment : std_ulogic is command(19);
  alias execute_program : std_ulogic is command(18);
  alias transfer : std_ulogic is command(17);
  alias write : std_ulogic is command(16);
  alias register_number : std_ulogic_vector(15 downto 0) is command(15 downto 0);

  signal state : state_t := idle;
  signal sent, ended : std_ulogic := '0';
  signal saved_x8 : word_t;
  signal is_general, is_csr, supported, deciding : std_ulogic;

begin

  is_general <= register_number(15 downto 5) ?= "00010000000";
  is_csr <= register_number(15 downto 12) ?= "0000";
  supported <= (command_type ?= x"00") and not post_increment and not execute_program and
               (not transfer or ((size ?= "010") and (is_general or is_csr)));

  busy <= '1' when state /= idle else '0';
  deciding <= '1' when state = decide else '0';
  done <= '1' when state = finish else '0';
  csr_request <= (
    write => deciding and supported and halted and transfer and write and is_csr,
    address => register_number(11 downto 0),
    data => data);

  with state select instruction <=
    add_to_x0(register_number(4 downto 0)) when read_register,
    load_upper(register_number(4 downto 0), upper_of(data)) when write_upper,
    add_lower(register_number(4 downto 0), data) when write_lower,
    register_number(11 downto 0) & "00000" & "010" & "00000" & "1110011" when read_csr,
    add_to_x0(x8) when save_x8,
    load_upper(x8, upper_of(data)) when set_x8_upper,
    add_lower(x8, data) when set_x8_lower,
    register_number(11 downto 0) & x8 & "001" & "00000" & "1110011" when write_csr,
    load_upper(x8, upper_of(saved_x8)) when restore_x8_upper,
    add_lower(x8, saved_x8) when others;

  inject <= '1' when state /= idle and state /= decide and state /= finish and sent = '0' else '0';
  ended <= sent and (debug_response.completed or debug_response.trapped);

  follow : process
  begin
    wait until rising_edge(clk);
    if inject then
      sent <= '1';
    end if;
    if ended then
      sent <= '0';
      if debug_response.trapped then
        error <= command_error_exception;
      end if;
    end if;

    case state is
      when idle =>
        error <= command_error_none;
        has_result <= '0';
        if start then
          state <= decide;
        end if;

      when decide =>
        state <= finish;
        if not supported then
          error <= command_error_not_supported;
        elsif not halted then
          error <= command_error_not_halted;
        elsif transfer then
          has_result <= not write;
          if is_general then
            state <= write_upper when write else read_register;
          elsif csr_response.exists then
            result <= csr_response.data;
          else
            state <= save_x8 when write else read_csr;
          end if;
        end if;

      when read_register | read_csr =>
        if ended then
          result <= debug_response.value;
          has_result <= not debug_response.trapped;
          state <= finish;
        end if;

      when save_x8 =>
        if ended then
          saved_x8 <= debug_response.value;
          state <= set_x8_upper;
        end if;

      when write_upper =>
        state <= write_lower when ended else write_upper;
      when set_x8_upper =>
        state <= set_x8_lower when ended else set_x8_upper;
      when set_x8_lower =>
        state <= write_csr when ended else set_x8_lower;
      when write_csr =>
        state <= restore_x8_upper when ended else write_csr;
      when restore_x8_upper =>
        state <= restore_x8_lower when ended else restore_x8_upper;
      when write_lower | restore_x8_lower =>
        if ended then
          state <= finish;
        end if;

      when finish =>
        state <= idle;
    end case;

    if reset then
      state <= idle;
      sent <= '0';
    end if;
  end process;

end architecture;
