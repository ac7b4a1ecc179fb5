-- SPDX-License-Identifier: Apache-2.0
-- The computer with a debugger on its JTAG pins: asleep, where the program traps, and reset.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.debugger_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

entity computer_tb is
end entity;

architecture tb of computer_tb is

  signal jtag : jtag_t := jtag_idle;
  signal reset, hold : std_ulogic := '1';
  signal timer_interrupt : std_ulogic := '0';

begin

  uut : entity work.debugged_computer
    port map (
      jtag => jtag, reset => reset, hold => hold,
      timer_interrupt => timer_interrupt, rounds => open);

  debug : process
  begin
    wait for 95 ns;
    reset <= '0';
    halt_at_first_instruction(jtag, hold);
    load_program(jtag);

    write_dmi(jtag, sbcs_address, x"00140000");
    -- Instructions are counted that the program executes, none of the debugger's.
    for instruction in 0 to 3 loop
      write_register(jtag, x"1007", x"00000000");
      expect_register(jtag, x"0b02", std_ulogic_vector(to_unsigned(instruction, 32)));
      write_register(jtag, x"07b0", x"00008004");
      step_to(jtag, 4 * instruction + 4);
    end loop;
    write_register(jtag, x"07b0", x"00008000");

    -- Asleep: a request halts before the wfi, a step goes over it, an interrupt waits for the end of both.
    write_register(jtag, x"07b1", x"80000024");
    resume(jtag);
    wait for 1 us;
    halt(jtag);
    expect_register(jtag, x"07b1", x"80000024");
    write_register(jtag, x"07b0", x"00008004");
    step_to(jtag, 16#28#);
    write_register(jtag, x"07b1", x"80000024");
    write_register(jtag, x"0304", x"00000080");
    write_register(jtag, x"0305", x"80000020");
    write_register(jtag, x"0300", x"00000008");
    timer_interrupt <= '1';
    write_register(jtag, x"07b0", x"00008004");
    step_to(jtag, 16#28#);
    expect_register(jtag, x"0344", x"00000080");
    -- None is taken between steps.
    step_to(jtag, 16#24#);
    step_to(jtag, 16#28#);
    expect_register(jtag, x"0342", x"00000000");
    write_register(jtag, x"07b0", x"00008000");
    resume(jtag);
    expect_halt(jtag, base + 16#20#, 1);
    expect_register(jtag, x"0342", x"80000007");
    expect_register(jtag, x"0341", x"80000028");
    timer_interrupt <= '0';

    -- A step into an access that nothing answers ends at the handler. A trigger after such an
    -- access is not reached.
    for access_address in 4 to 5 loop
      write_register(jtag, x"1006", x"10000000");
      write_register(jtag, x"07b1", std_ulogic_vector(base + 4 * access_address));
      write_register(jtag, x"07b0", x"00008004");
      step_to(jtag, 16#20#);
      expect_register(jtag, x"0342", std_ulogic_vector(to_unsigned(7 - 2 * (access_address mod 2), 32)));
      expect_register(jtag, x"0341", std_ulogic_vector(base + 4 * access_address));
      expect_register(jtag, x"0343", x"10000000");
      write_register(jtag, x"07b0", x"00008000");
      write_register(jtag, x"07a1", x"28001044");
      write_register(jtag, x"07a2", std_ulogic_vector(base + 4 * access_address + 4));
      write_register(jtag, x"07b1", std_ulogic_vector(base + 4 * access_address));
      resume(jtag);
      expect_halt(jtag, base + 16#20#, 1);
      write_register(jtag, x"07a1", x"00000000");
    end loop;

    -- Without ebreakm an ebreak traps, here to itself; a step ends there, too.
    write_register(jtag, x"07b0", x"00000004");
    step_to(jtag, 16#20#);
    expect_register(jtag, x"0342", x"00000003");
    write_register(jtag, x"07b0", x"00000000");
    resume(jtag);
    wait for 1 us;
    halt(jtag);
    expect_register(jtag, x"0342", x"00000003");
    expect_register(jtag, x"07b1", x"80000020");

    -- Reset of the chip with and without a halt after it.
    write_dmi(jtag, dmcontrol_address, x"00000003");
    expect(jtag, dmstatus_address, x"00003000", x"00003f00", "in reset");
    write_dmi(jtag, dmcontrol_address, x"0000000b");
    write_dmi(jtag, dmcontrol_address, x"00000001");
    expect(jtag, dmstatus_address, x"000c0000", x"000c0000", "has been reset");
    expect_halt(jtag, base, 5);
    write_dmi(jtag, dmcontrol_address, x"00000007");
    write_dmi(jtag, dmcontrol_address, x"00000001");
    write_dmi(jtag, dmcontrol_address, x"10000001");
    expect(jtag, dmstatus_address, x"00000c00", x"000c0f00", "running");
    report "computer_tb passed";
    std.env.finish;
  end process;

end architecture;
