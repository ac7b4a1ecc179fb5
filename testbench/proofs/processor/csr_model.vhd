-- SPDX-License-Identifier: Apache-2.0
-- Reference model of the CSRs by the specification and rtl/processor/README.md, updated by each retired
-- instruction and each trap.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.machine_mode_pkg.all;

entity csr_model is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- In this clock an instruction retires, raises an exception, or is interrupted.
    completed : in std_ulogic;
    exception : in std_ulogic;
    interrupted : in std_ulogic;
    -- The instruction, expanded to 32 bits, and its address.
    word : in value_t;
    address : in unsigned(31 downto 0);
    -- Of a CSR instruction: rs1 or the immediate.
    operand : in value_t;
    -- Of the exception.
    cause : in std_ulogic_vector(4 downto 0);
    trap_value : in value_t;
    -- Interrupt requests; not settled just after they have begun.
    requests : in value_t;
    settled : in std_ulogic;
    -- Of the CSR instruction: whether it is legal, the value read, and whether that is known.
    legal : out std_ulogic;
    value : out value_t;
    known : out std_ulogic;
    -- Interrupts enabled in mie, and mstatus.MIE.
    active : out value_t;
    permitted : out std_ulogic;
    trap_target : out unsigned(31 downto 0);
    return_address : out unsigned(31 downto 0);
    return_known : out std_ulogic;
    state : out machine_state_t
  );
end entity;

architecture model of csr_model is

  signal mie, mtvec, mscratch, mepc, mcause, mtval : value_t;
  signal enable, previous_enable : std_ulogic;
  signal scratch_known, trap_known, mtval_known, cause_known : std_ulogic := '0';
  signal stops_cycle, stops_instructions : std_ulogic;
  signal instructions : unsigned(63 downto 0);
  signal exists, writes : boolean;
  signal old, changed : value_t;

begin

  read_register : process (all)
  begin
    old <= x"00000000";
    known <= '1';
    case word(31 downto 20) is
      when x"300" => old <= (12 => '1', 11 => '1', 7 => previous_enable, 3 => enable, others => '0');
      when x"301" => old <= x"40001104";
      when x"304" => old <= mie;
      when x"305" => old <= mtvec;
      when x"310" | x"7a0" | x"7a1" | x"7a2" | x"7a3" | x"f11" | x"f12" | x"f13" | x"f14" | x"f15" =>
        null;
      when x"320" => old <= (2 => stops_instructions, 0 => stops_cycle, others => '0');
      when x"340" =>
        old <= mscratch;
        known <= scratch_known;
      when x"341" =>
        old <= mepc;
        known <= trap_known;
      when x"342" =>
        old <= mcause;
        known <= cause_known;
      when x"343" =>
        old <= mtval;
        known <= mtval_known;
      when x"344" =>
        old <= requests;
        known <= settled;
      when x"b00" | x"b80" | x"c00" | x"c80" => known <= '0';
      when x"b02" | x"c02" => old <= std_ulogic_vector(instructions(31 downto 0));
      when x"b82" | x"c82" => old <= std_ulogic_vector(instructions(63 downto 32));
      when others => null;
    end case;
  end process;

  exists <= csr_exists(word(31 downto 20));
  writes <= word(13 downto 12) = "01" or word(19 downto 15) /= "00000";
  legal <= '1' when exists and not (writes and word(31 downto 30) = "11") else '0';
  value <= old;
  changed <= old or operand when word(13 downto 12) = "10" else
             old and not operand when word(13 downto 12) = "11" else
             operand;

  active <= requests and mie;
  permitted <= enable;
  trap_target <= unsigned(mtvec(31 downto 2) & "00") +
                   shift_left(to_unsigned(first_of(active), 32), 2) when
                   interrupted = '1' and mtvec(0) = '1' else
                 unsigned(mtvec(31 downto 2) & "00");
  return_address <= unsigned(mepc);
  return_known <= trap_known;
  state <= (
    mie => mie,
    mtvec => mtvec,
    mscratch => mscratch,
    mepc => mepc,
    mcause => mcause,
    mtval => mtval,
    enable => enable,
    previous_enable => previous_enable,
    stops_cycle => stops_cycle,
    stops_instructions => stops_instructions,
    scratch_known => scratch_known,
    trap_known => trap_known,
    mtval_known => mtval_known);

  follow : process
    variable is_written : boolean;
  begin
    wait until rising_edge(clk);
    is_written := completed = '1' and kind_of(word) = csr and writes;
    if completed = '1' and stops_instructions = '0' then
      instructions <= instructions + 1;
    end if;
    if is_written then
      case word(31 downto 20) is
        when x"300" =>
          enable <= changed(3);
          previous_enable <= changed(7);
        when x"304" => mie <= changed and x"ffff0880";
        when x"305" => mtvec <= changed and x"fffffffd";
        when x"320" =>
          stops_cycle <= changed(0);
          stops_instructions <= changed(2);
        when x"340" =>
          mscratch <= changed;
          scratch_known <= scratch_known or not word(13);
        when x"341" =>
          mepc <= changed(31 downto 1) & '0';
          trap_known <= trap_known or not word(13);
        when x"342" =>
          mcause <= changed and x"8000001f";
        when x"343" =>
          mtval <= changed;
          mtval_known <= mtval_known or not word(13);
        when x"b02" => instructions <= instructions(63 downto 32) & unsigned(changed);
        when x"b82" => instructions <= unsigned(changed) & instructions(31 downto 0);
        when others => null;
      end case;
    end if;
    if completed = '1' and kind_of(word) = trap_return then
      enable <= previous_enable;
      previous_enable <= '1';
    end if;
    if exception or interrupted then
      enable <= '0';
      previous_enable <= enable;
      mepc <= std_ulogic_vector(address);
      mcause <= "000" & x"000000" & cause;
      mtval <= trap_value;
      trap_known <= '1';
      mtval_known <= '1';
      if interrupted then
        mcause <= std_ulogic_vector(to_unsigned(first_of(active), 32));
        mcause(31) <= '1';
        mtval <= x"00000000";
      end if;
    end if;

    if reset then
      enable <= '0';
      previous_enable <= '0';
      mie <= x"00000000";
      mtvec <= x"00000000";
      mcause <= x"00000000";
      cause_known <= '1';
      stops_cycle <= '0';
      stops_instructions <= '0';
      instructions <= (others => '0');
    end if;
  end process;

end architecture;
