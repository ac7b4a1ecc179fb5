-- SPDX-License-Identifier: Apache-2.0
-- Each reason to halt is reported as such, and triggers compare what is about to be executed.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.processor_pkg.all;

entity hart_control_tb is
end entity;

architecture tb of hart_control_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal halt_request, halt_at_reset, resume, halted : std_ulogic := '0';
  signal csr_request : debug_csr_request_t := (write => '0', address => x"000", data => x"00000000");
  signal csr_response : debug_csr_response_t;
  signal to_processor : debug_request_t;
  signal from_processor : debug_response_t := (
    address | next_address => x"00000000", value => x"00000000", advance => '1', others => '0');

begin

  clk <= not clk after 5 ns;

  uut : entity work.hart_control
    generic map (triggers => 2)
    port map (
      clk => clk, reset => reset, halt_request => halt_request, halt_at_reset => halt_at_reset,
      resume => resume, halted => halted, csr_request => csr_request, csr_response => csr_response,
      inject => '0', instruction => x"00000000", debug_request => to_processor,
      debug_response => from_processor);

  check : process

    procedure clock is
    begin
      wait until falling_edge(clk);
    end procedure;

    procedure write_csr(address : std_ulogic_vector(11 downto 0); data : word_t) is
    begin
      csr_request <= (write => '1', address => address, data => data);
      clock;
      csr_request.write <= '0';
    end procedure;

    procedure expect_csr(address : std_ulogic_vector(11 downto 0); data : word_t) is
    begin
      csr_request.address <= address;
      wait for 1 ns;
      assert csr_response.exists = '1' and csr_response.data = data
        report to_hstring(address) & " is " & to_hstring(csr_response.data) severity failure;
    end procedure;

    -- The processor obeys, at an address of its own.
    procedure enter(address : unsigned(31 downto 0); cause : natural; at_breakpoint : std_ulogic := '0') is
    begin
      assert to_processor.halt = not at_breakpoint report "halt is not asked for" severity failure;
      from_processor.enter <= '1';
      from_processor.at_breakpoint <= at_breakpoint;
      from_processor.address <= address;
      clock;
      from_processor.enter <= '0';
      from_processor.at_breakpoint <= '0';
      assert halted and to_processor.halted and not to_processor.halt severity failure;
      expect_csr(x"7b1", std_ulogic_vector(address));
      csr_request.address <= x"7b0";
      wait for 1 ns;
      assert to_integer(unsigned(csr_response.data(8 downto 6))) = cause
        report "cause " & to_string(csr_response.data(8 downto 6)) severity failure;
    end procedure;

    procedure go_on is
    begin
      resume <= '1';
      clock;
      resume <= '0';
      assert not halted severity failure;
    end procedure;

    procedure fetch(address : unsigned(31 downto 0); follows, advance : std_ulogic := '1') is
    begin
      from_processor.next_address <= address;
      from_processor.issue <= follows;
      from_processor.advance <= advance;
      clock;
      from_processor.issue <= '0';
      from_processor.advance <= '1';
      wait for 1 ns;
    end procedure;

  begin
    clock;
    halt_at_reset <= '1';
    clock;
    reset <= '0';
    halt_at_reset <= '0';
    clock;
    enter(x"80000000", 5);
    expect_csr(x"7b0", x"40000143");
    csr_request.address <= x"300";
    wait for 1 ns;
    assert not csr_response.exists report "mstatus is the processor's" severity failure;

    -- What cannot be set reads as it is.
    write_csr(x"7b0", x"ffffffff");
    expect_csr(x"7b0", x"40008147");
    assert to_processor.halt_at_breakpoint and not to_processor.step severity failure;
    write_csr(x"7b0", x"00000000");
    write_csr(x"7b1", x"80001235");
    expect_csr(x"7b1", x"80001234");
    assert to_processor.resume_address = x"80001234" severity failure;
    -- Halted, it cannot halt once more.
    from_processor.enter <= '1';
    clock;
    from_processor.enter <= '0';
    expect_csr(x"7b1", x"80001234");
    go_on;
    clock;
    assert not to_processor.halt report "nothing asks for a halt" severity failure;

    halt_request <= '1';
    clock;
    enter(x"80000100", 3);
    halt_request <= '0';
    go_on;
    enter(x"80000102", 1, at_breakpoint => '1');

    -- Steps end with the first instruction that is completed or traps.
    write_csr(x"7b0", x"00000004");
    go_on;
    clock;
    assert to_processor.step and not to_processor.halt severity failure;
    from_processor.finish <= '1';
    clock;
    from_processor.finish <= '0';
    enter(x"80000104", 4);
    assert not to_processor.step severity failure;
    write_csr(x"7b0", x"00000000");

    -- Two triggers; the third does not exist.
    for index in 0 to 1 loop
      write_csr(x"7a0", std_ulogic_vector(to_unsigned(index, 32)));
      write_csr(x"7a1", x"ffffffff");
      expect_csr(x"7a1", x"28001044");
      write_csr(x"7a2", std_ulogic_vector(to_unsigned(16#1000# + 16 * index, 32)));
    end loop;
    write_csr(x"7a0", x"00000002");
    expect_csr(x"7a0", x"00000001");
    expect_csr(x"7a2", x"00001010");
    expect_csr(x"7a4", x"00000004");
    fetch(x"00001000");
    assert not to_processor.halt report "halted already" severity failure;
    from_processor.advance <= '0';
    go_on;
    assert not to_processor.halt report "what was injected is no reason to halt" severity failure;
    fetch(x"00001004");
    fetch(x"00001000", follows => '0');
    fetch(x"00001010", advance => '0');
    assert not to_processor.halt report "none of these is executed" severity failure;
    fetch(x"00001010");
    enter(x"00001010", 2);
    go_on;
    fetch(x"00001000");
    -- A trigger stays with its instruction while that waits.
    fetch(x"00001004", advance => '0');
    enter(x"00001000", 2);
    -- It needs to be the debugger's, in machine mode, at execution.
    write_csr(x"7a1", x"20000044");
    go_on;
    fetch(x"00001010");
    assert not to_processor.halt report "the trigger is a program's" severity failure;
    write_csr(x"7a1", x"28000004");
    fetch(x"00001010");
    assert not to_processor.halt report "the trigger is for another mode" severity failure;
    write_csr(x"7a1", x"28000040");
    fetch(x"00001010");
    assert not to_processor.halt report "the trigger is for no execution" severity failure;

    write_csr(x"7a0", x"00000000");
    write_csr(x"7b0", x"00008004");
    reset <= '1';
    clock;
    reset <= '0';
    expect_csr(x"7a1", x"20001000");
    expect_csr(x"7b0", x"40000003");
    fetch(x"00001000");
    assert not to_processor.halt report "a reset leaves a trigger on" severity failure;
    report "hart_control_tb passed";
    std.env.finish;
  end process;

end architecture;
