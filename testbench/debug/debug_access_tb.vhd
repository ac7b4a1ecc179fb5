-- SPDX-License-Identifier: Apache-2.0
-- A debugger on the JTAG pins reads and writes registers and memory of the halted processor.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.debugger_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

entity debug_access_tb is
end entity;

architecture tb of debug_access_tb is

  signal jtag : jtag_t := jtag_idle;
  signal reset, hold : std_ulogic := '1';

begin

  uut : entity work.debugged_computer
    port map (
      jtag => jtag, reset => reset, hold => hold);

  debug : process
  begin
    wait for 95 ns;
    reset <= '0';
    halt_at_first_instruction(jtag, hold);
    load_program(jtag);

    -- Registers: with values at the edges of lui and addi; x8 survives writes of CSRs.
    write_register(jtag, x"1008", x"12345fff");
    write_register(jtag, x"100a", x"fffff800");
    write_register(jtag, x"101f", x"7fffffff");
    write_register(jtag, x"1000", x"55555555");
    write_register(jtag, x"0340", x"80000801");
    expect_register(jtag, x"1000", x"00000000");
    expect_register(jtag, x"1008", x"12345fff");
    expect_register(jtag, x"100a", x"fffff800");
    expect_register(jtag, x"101f", x"7fffffff");
    expect_register(jtag, x"0340", x"80000801");
    expect_register(jtag, x"0301", x"40001104", x"fff01f04");

    -- What cannot be done is refused, and changes nothing.
    write_dmi(jtag, command_address, x"00220123");
    expect_error(jtag, command_error_exception, "no such CSR");
    write_dmi(jtag, command_address, x"00230123");
    expect_error(jtag, command_error_exception, "write of no such CSR");
    expect_register(jtag, x"1008", x"12345fff");
    expect_register(jtag, x"0342", x"00000000");
    write_dmi(jtag, command_address, x"00321008");
    expect_error(jtag, command_error_not_supported, "64 bits");
    write_dmi(jtag, command_address, x"00261008");
    expect_error(jtag, command_error_not_supported, "program buffer");
    write_dmi(jtag, command_address, x"02200000");
    expect_error(jtag, command_error_not_supported, "memory");
    write_dmi(jtag, command_address, x"00221020");
    expect_error(jtag, command_error_not_supported, "floating point");

    -- abstractauto repeats the command with each access to data0.
    write_dmi(jtag, command_address, x"0022100a");
    write_dmi(jtag, abstractauto_address, x"00000001");
    write_dmi(jtag, data0_address, x"00000000");
    write_dmi(jtag, abstractauto_address, x"00000000");
    expect(jtag, data0_address, x"fffff800", x"ffffffff", "repeated");

    -- Memory by bytes and half words, and what is refused there.
    write_dmi(jtag, sbcs_address, x"00020000");
    write_dmi(jtag, sbaddress0_address, x"80001002");
    write_dmi(jtag, sbdata0_address, x"0000beef");
    write_dmi(jtag, sbcs_address, x"00000000");
    write_dmi(jtag, sbaddress0_address, x"80001001");
    write_dmi(jtag, sbdata0_address, x"000000aa");
    write_dmi(jtag, sbaddress0_address, x"80001000");
    write_dmi(jtag, sbdata0_address, x"00000055");
    expect_memory(jtag, x"80001000", x"beefaa55");
    write_dmi(jtag, sbcs_address, x"00118000");
    write_dmi(jtag, sbaddress0_address, x"80001000");
    expect(jtag, sbdata0_address, x"00000055", x"ffffffff", "byte 0");
    expect(jtag, sbdata0_address, x"000000aa", x"ffffffff", "byte 1");
    expect(jtag, sbdata0_address, x"000000ef", x"ffffffff", "byte 2");
    expect(jtag, sbdata0_address, x"000000be", x"ffffffff", "byte 3");
    write_dmi(jtag, sbcs_address, x"00120000");
    write_dmi(jtag, sbaddress0_address, x"80001002");
    expect(jtag, sbdata0_address, x"0000beef", x"ffffffff", "half word");
    write_dmi(jtag, sbaddress0_address, x"80001001");
    expect(jtag, sbcs_address, x"00003000", x"00007000", "misaligned");
    write_dmi(jtag, sbcs_address, x"00147000");
    write_dmi(jtag, sbaddress0_address, x"10000000");
    expect(jtag, sbcs_address, x"00002000", x"00007000", "nothing there");
    write_dmi(jtag, sbcs_address, x"00167000");
    write_dmi(jtag, sbaddress0_address, x"80001000");
    expect(jtag, sbcs_address, x"00004000", x"00007000", "64 bits");
    write_dmi(jtag, sbcs_address, x"00147000");
    report "debug_access_tb passed";
    std.env.finish;
  end process;

end architecture;
