-- SPDX-License-Identifier: Apache-2.0
-- A debugger on the JTAG pins steps, halts and resumes a running program, and looks at its memory meanwhile.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.debug_pkg.all;
use work.debugger_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

entity debug_port_tb is
end entity;

architecture tb of debug_port_tb is

  signal jtag : jtag_t := jtag_idle;
  signal reset, hold : std_ulogic := '1';
  signal memory_only, undisturbed : boolean := false;
  signal rounds : natural;

begin

  uut : entity work.debugged_computer
    port map (
      jtag => jtag, reset => reset, hold => hold,
      memory_only => memory_only, rounds => rounds, undisturbed => undisturbed);

  debug : process
    variable before : word_t;
    variable seed_1, seed_2 : positive := 5;
    variable chance : real;
  begin
    wait for 95 ns;
    reset <= '0';
    halt_at_first_instruction(jtag, hold);
    load_program(jtag);

    -- Single steps: each instruction once, peripherals too.
    write_register(jtag, x"07b0", x"00008004");
    step_to(jtag, 16#04#);
    step_to(jtag, 16#08#);
    step_to(jtag, 16#0c#);
    step_to(jtag, 16#10#);
    expect_register(jtag, x"100a", x"00000001");
    step_to(jtag, 16#14#);
    expect_memory(jtag, x"f0000000", x"00000001");
    step_to(jtag, 16#18#);
    expect_register(jtag, x"1007", x"00000001");
    step_to(jtag, 16#1c#);
    expect_memory(jtag, x"8000fffc", x"00000001");
    step_to(jtag, 16#04#);

    -- A trigger halts before its instruction is executed, a step leaves it.
    write_register(jtag, x"07a0", x"00000001");
    write_register(jtag, x"07a1", x"28001044");
    expect_register(jtag, x"07a1", x"28001044");
    write_register(jtag, x"07a2", x"80000018");
    write_register(jtag, x"07a0", x"00000004");
    expect_register(jtag, x"07a0", x"00000001");
    write_register(jtag, x"07b0", x"00008000");
    resume(jtag);
    expect_halt(jtag, base + 16#18#, 2);
    expect_memory(jtag, x"8000fffc", x"00000001");
    write_register(jtag, x"07a1", x"00000000");

    -- While it runs, memory and peripherals can be read and written, and registers cannot.
    resume(jtag);
    expect(jtag, dmstatus_address, x"00000c00", x"00000f00", "running");
    write_dmi(jtag, command_address, x"0022100a");
    expect_error(jtag, command_error_not_halted, "running");
    for round in 1 to 8 loop
      write_dmi(jtag, sbaddress0_address, x"f0000000");
      read_dmi(jtag, sbdata0_address, before);
      write_dmi(jtag, sbaddress0_address, x"8000fffc");
      expect(jtag, sbcs_address, x"00000000", x"00607000", "sberror");
      read_dmi(jtag, sbdata0_address, before);
    end loop;
    assert unsigned(before) > 10 report "it does not run" severity failure;
    -- Accesses of both on the bus meet in every way.
    for round in 1 to 40 loop
      wait for 10 ns * (round mod 17);
      write_dmi(jtag, sbaddress0_address, x"f0000000");
    end loop;
    wait for 1 us;
    memory_only <= true;
    for round in 1 to 8 loop
      write_dmi(jtag, sbcs_address, x"00040000");
      write_dmi(jtag, sbaddress0_address, x"80001004");
      write_dmi(jtag, sbdata0_address, std_ulogic_vector(to_unsigned(round, 32)));
      expect_memory(jtag, x"80001004", std_ulogic_vector(to_unsigned(round, 32)));
    end loop;
    memory_only <= false;
    assert rounds > 100 report "the program stands" severity failure;

    -- A breakpoint put into the running program.
    write_dmi(jtag, sbaddress0_address, x"8000001c");
    write_dmi(jtag, sbdata0_address, program(8));
    expect_halt(jtag, base + 16#1c#, 1);
    write_dmi(jtag, sbaddress0_address, x"8000001c");
    write_dmi(jtag, sbdata0_address, program(7));
    resume(jtag);
    halt(jtag);
    expect_register(jtag, x"07b0", x"000000c3", x"000001c3");

    -- Halts at any moment, in the middle of accesses too.
    undisturbed <= true;
    for halts in 1 to 40 loop
      resume(jtag);
      uniform(seed_1, seed_2, chance);
      wait for 1 ns * integer(chance * 200.0);
      halt(jtag);
    end loop;
    undisturbed <= false;
    report "debug_port_tb passed";
    std.env.finish;
  end process;

end architecture;
