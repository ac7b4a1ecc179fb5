-- SPDX-License-Identifier: Apache-2.0
-- What a debugger does with the processor through the JTAG pins, and the program that it does it to.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

package debugger_pkg is

  type words_t is array (natural range <>) of word_t;
  constant program : words_t := (
    x"00000513",  --  0 li a0, 0
    x"00150513",  --  4 addi a0, a0, 1         loop
    x"80010437",  --  8 lui s0, 0x80010
    x"f0000337",  --  c lui t1, 0xf0000
    x"00a32023",  -- 10 sw a0, 0(t1)           a peripheral
    x"00032383",  -- 14 lw t2, 0(t1)
    x"fea42e23",  -- 18 sw a0, -4(s0)
    x"fe9ff06f",  -- 1c j loop
    x"00100073",  -- 20 ebreak
    x"10500073",  -- 24 wfi
    x"ffdff06f"); -- 28 j 24

  -- Where the memory begins.
  constant base : unsigned(31 downto 0) := x"80000000";

  -- A register of the debug module, as far as the mask goes.
  procedure expect(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                   data, mask : word_t; what : string);
  -- At once, and it is halted.
  procedure halt(signal jtag : inout jtag_t);
  -- The resume is acknowledged.
  procedure resume(signal jtag : inout jtag_t);
  -- What the last abstract command ended with, which is cleared.
  procedure expect_error(signal jtag : inout jtag_t; error : command_error_t; what : string);
  -- A register of the processor, by the number that abstract commands give it.
  procedure expect_register(signal jtag : inout jtag_t; number : std_ulogic_vector(15 downto 0);
                            value : word_t; mask : word_t := x"ffffffff");
  procedure write_register(signal jtag : inout jtag_t; number : std_ulogic_vector(15 downto 0);
                           value : word_t);
  -- A word on the bus or in the memory, read past the processor.
  procedure expect_memory(signal jtag : inout jtag_t; address : unsigned(31 downto 0); value : word_t);
  -- Halted before this address, for the reason in dcsr.cause.
  procedure expect_halt(signal jtag : inout jtag_t; address : unsigned(31 downto 0); cause : natural);
  -- One instruction, which ends so far from the beginning of the memory.
  procedure step_to(signal jtag : inout jtag_t; address : natural);
  -- From power on: the chip's reset is over, the processor is still held. The debugger takes the module into
  -- use and halts the processor before its first instruction, once `hold` is released.
  procedure halt_at_first_instruction(signal jtag : inout jtag_t; signal hold : out std_ulogic);
  -- Through the memory, and reads it back.
  procedure load_program(signal jtag : inout jtag_t);

end package;

package body debugger_pkg is

  procedure expect(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                   data, mask : word_t; what : string) is
    variable found : word_t;
  begin
    read_dmi(jtag, address, found);
    assert (found and mask) = data
      report what & ": " & to_hstring(found and mask) & " instead of " & to_hstring(data)
      severity failure;
  end procedure;

  procedure halt(signal jtag : inout jtag_t) is
  begin
    write_dmi(jtag, dmcontrol_address, x"80000001");
    write_dmi(jtag, dmcontrol_address, x"00000001");
    expect(jtag, dmstatus_address, x"00000300", x"00000f00", "halted");
  end procedure;

  procedure resume(signal jtag : inout jtag_t) is
  begin
    write_dmi(jtag, dmcontrol_address, x"40000001");
    expect(jtag, dmstatus_address, x"00030000", x"00030000", "resumed");
  end procedure;

  procedure expect_error(signal jtag : inout jtag_t; error : command_error_t; what : string) is
  begin
    expect(jtag, abstractcs_address, x"00000" & '0' & error & x"01", x"ffffffff", what);
    write_dmi(jtag, abstractcs_address, x"00000700");
  end procedure;

  procedure expect_register(signal jtag : inout jtag_t; number : std_ulogic_vector(15 downto 0);
                            value : word_t; mask : word_t := x"ffffffff") is
  begin
    write_dmi(jtag, command_address, x"0022" & number);
    expect_error(jtag, command_error_none, "read register");
    expect(jtag, data0_address, value, mask, "register " & to_hstring(number));
  end procedure;

  procedure write_register(signal jtag : inout jtag_t; number : std_ulogic_vector(15 downto 0);
                           value : word_t) is
  begin
    write_dmi(jtag, data0_address, value);
    write_dmi(jtag, command_address, x"0023" & number);
    expect_error(jtag, command_error_none, "write register");
  end procedure;

  procedure expect_memory(signal jtag : inout jtag_t; address : unsigned(31 downto 0); value : word_t) is
  begin
    write_dmi(jtag, sbcs_address, x"00140000");
    write_dmi(jtag, sbaddress0_address, std_ulogic_vector(address));
    expect(jtag, sbdata0_address, value, x"ffffffff", "memory " & to_hstring(address));
    expect(jtag, sbcs_address, x"00000000", x"00607000", "sberror");
  end procedure;

  procedure expect_halt(signal jtag : inout jtag_t; address : unsigned(31 downto 0); cause : natural) is
  begin
    expect(jtag, dmstatus_address, x"00000300", x"00000f00", "halted");
    expect_register(jtag, x"07b1", std_ulogic_vector(address));
    expect_register(jtag, x"07b0", std_ulogic_vector(to_unsigned(cause * 64 + 3, 32)), x"000001c3");
  end procedure;

  procedure step_to(signal jtag : inout jtag_t; address : natural) is
  begin
    resume(jtag);
    expect_halt(jtag, base + address, 4);
  end procedure;

  procedure halt_at_first_instruction(signal jtag : inout jtag_t; signal hold : out std_ulogic) is
  begin
    reset_tap(jtag);
    scan_instruction(jtag, 5x"11");
    expect(jtag, dmcontrol_address, x"00000000", x"ffffffff", "not active");
    write_dmi(jtag, dmcontrol_address, x"00000001");
    expect(jtag, dmstatus_address, x"000c30a2", x"ffffffff", "in reset");
    write_dmi(jtag, dmcontrol_address, x"ffffffc1");
    expect(jtag, dmcontrol_address, x"80000001", x"ffffffff", "one hart");
    write_dmi(jtag, dmcontrol_address, x"80000001");
    hold <= '0';
    expect_halt(jtag, base, 5);
    write_dmi(jtag, dmcontrol_address, x"10000001");
    expect(jtag, dmstatus_address, x"000003a2", x"ffffffff", "halted, no reset since");
  end procedure;

  procedure load_program(signal jtag : inout jtag_t) is
  begin
    write_dmi(jtag, sbcs_address, x"00050000");
    write_dmi(jtag, sbaddress0_address, std_ulogic_vector(base));
    for index in program'range loop
      write_dmi(jtag, sbdata0_address, program(index));
    end loop;
    for index in program'range loop
      expect_memory(jtag, base + 4 * index, program(index));
    end loop;
  end procedure;

end package body;
