-- SPDX-License-Identifier: Apache-2.0
-- Each exception has its cause, address and value, and the one of highest priority is taken.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity trap_control_tb is
end entity;

architecture tb of trap_control_tb is

  signal executing : executing_t := (valid => '1', others => '0');
  signal control : control_t := (
    legal => "0001", destination => "00000",
    operation | funct3 => "000", others => '0');
  signal take_interrupt, data_misaligned, bus_error, bus_store : std_ulogic := '0';
  signal csr_legal, legal, ready : std_ulogic := '1';
  signal interrupt_cause : std_ulogic_vector(4 downto 0) := 5d"20";
  signal next_address : unsigned(31 downto 0) := x"80000200";
  signal trap : trap_t;

begin

  uut : entity work.trap_control
    generic map (memory_end => x"80010000")
    port map (
      executing => executing,
      control => control,
      legal => legal,
      ready => ready,
      address => x"80000100",
      instruction => x"12345678",
      take_interrupt => take_interrupt,
      interrupt_cause => interrupt_cause,
      next_address => next_address,
      csr_legal => csr_legal,
      data_address => x"80000303",
      data_misaligned => data_misaligned,
      bus_error => bus_error,
      bus_store => bus_store,
      trap => trap);

  check : process
    procedure expect(cause : natural; value : word_t;
                     address : unsigned(31 downto 0) := x"80000100") is
    begin
      wait for 1 ns;
      assert trap.enable = '1' and trap.interrupt = '0' and
        to_integer(unsigned(trap.cause)) = cause and trap.value = value and
        trap.address = address
        report "cause " & integer'image(to_integer(unsigned(trap.cause))) & ", value " &
          to_hstring(trap.value) severity failure;
    end procedure;

    -- Its address and value were given before.
    procedure expect_cause(cause : natural) is
    begin
      wait for 1 ns;
      assert trap.enable = '1' and trap.interrupt = '0' and to_integer(unsigned(trap.cause)) = cause
        severity failure;
    end procedure;

    procedure expect_none is
    begin
      wait for 1 ns;
      assert trap.enable = '0' severity failure;
    end procedure;
  begin
    expect_none;
    data_misaligned <= '1';
    csr_legal <= '0';
    expect_none;
    control.load <= '1';
    expect(4, x"80000303");
    control.load <= '0';
    control.store <= '1';
    expect(6, x"80000303");
    data_misaligned <= '0';
    -- For a bus error of the access.
    wait for 1 ns;
    assert trap.enable = '0' and trap.value = x"80000303" and trap.address = x"80000100" severity failure;
    control.store <= '0';
    -- Bus error of the previous instruction's access, while this one stalls.
    ready <= '0';
    bus_error <= '1';
    bus_store <= '1';
    expect_cause(7);
    bus_store <= '0';
    expect_cause(5);
    bus_error <= '0';
    expect_none;
    ready <= '1';
    control.csr <= '1';
    expect(2, x"12345678");
    csr_legal <= '1';
    expect_none;
    control.csr <= '0';
    control.environment_call <= '1';
    expect(11, x"00000000");
    control.environment_call <= '0';
    control.breakpoint <= '1';
    expect(3, x"80000100");
    control.breakpoint <= '0';
    legal <= '0';
    expect(2, x"12345678");
    executing.fetch_fault <= '1';
    expect(1, x"80000100");
    executing.crosses_memory_end <= '1';
    expect(1, x"80010000");
    ready <= '0';
    expect_none;
    ready <= '1';
    executing.valid <= '0';
    expect_none;

    take_interrupt <= '1';
    wait for 1 ns;
    assert trap.enable = '1' and trap.interrupt = '1' and trap.cause = interrupt_cause and
      trap.value = x"00000000" and trap.address = x"80000200" severity failure;
    executing.valid <= '1';
    wait for 1 ns;
    assert trap.interrupt = '1' and trap.cause = interrupt_cause and trap.address = x"80000100"
      report "an interrupt goes before an exception" severity failure;
    std.env.finish;
  end process;

end architecture;
