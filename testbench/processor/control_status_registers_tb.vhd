-- SPDX-License-Identifier: Apache-2.0
-- The CSRs: reads, writes, updates by traps and mret, pending interrupts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity control_status_registers_tb is
end entity;

architecture tb of control_status_registers_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : csr_request_t := (
    enable => '0', cancelled => '0', address => x"000", operation => "01", operand => (others => '0'),
    writes => '0');
  signal read_data : word_t;
  signal trap : trap_t := (
    enable => '0', interrupt => '0', cause => "00000", address => (others => '0'),
    value => (others => '0'));
  signal trap_return, retire, timer_interrupt, external_interrupt : std_ulogic := '0';
  signal interrupts : std_ulogic_vector(15 downto 0) := (others => '0');
  signal wake_request, interrupt_pending : std_ulogic;
  signal interrupt_cause : std_ulogic_vector(4 downto 0);
  signal trap_target, return_address : unsigned(31 downto 0);

begin

  clk <= not clk after 5 ns;

  uut : entity work.control_status_registers
    port map (
      clk => clk,
      always_clk => clk,
      reset => reset,
      request => request,
      read_data => read_data,
      trap => trap,
      trap_return => trap_return,
      retire => retire,
      timer_interrupt => timer_interrupt,
      external_interrupt => external_interrupt,
      interrupts => interrupts,
      wake_request => wake_request,
      interrupt_pending => interrupt_pending,
      interrupt_cause => interrupt_cause,
      trap_target => trap_target,
      return_address => return_address);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure access_csr(address : std_ulogic_vector(11 downto 0);
                         operation : std_ulogic_vector(1 downto 0);
                         operand : word_t; writes : std_ulogic) is
    begin
      request <= (enable => '1', cancelled => '0', address => address, operation => operation,
                  operand => operand, writes => writes);
      wait for 1 ns;
    end procedure;

    procedure write(address : std_ulogic_vector(11 downto 0); value : word_t) is
    begin
      access_csr(address, "01", value, '1');
      clock;
      request.enable <= '0';
    end procedure;

    procedure expect(address : std_ulogic_vector(11 downto 0); value : word_t) is
    begin
      access_csr(address, "10", x"ffffffff", '0');
      assert read_data = value report to_hstring(address) & " is " &
        to_hstring(read_data) severity failure;
      clock;
      request.enable <= '0';
    end procedure;
  begin
    clock;
    reset <= '0';
    expect(x"300", x"00001800");
    expect(x"301", x"40001104");
    write(x"340", x"12345678");
    access_csr(x"340", "10", x"0000000f", '1');
    assert read_data = x"12345678" severity failure;
    clock;
    access_csr(x"340", "11", x"12000000", '1');
    clock;
    expect(x"340", x"0034567f");

    -- A trap, direct and vectored.
    write(x"305", x"80000400");
    write(x"300", x"00000008");
    trap <= (enable => '1', interrupt => '0', cause => 5d"5", address => x"80000010",
             value => x"f0000000");
    wait for 1 ns;
    assert trap_target = x"80000400" severity failure;
    clock;
    trap.enable <= '0';
    expect(x"300", x"00001880");
    expect(x"341", x"80000010");
    expect(x"342", x"00000005");
    expect(x"343", x"f0000000");
    assert return_address = x"80000010" severity failure;
    trap_return <= '1';
    clock;
    trap_return <= '0';
    expect(x"300", x"00001888");
    write(x"305", x"80000401");
    wait for 1 ns;
    assert trap_target = x"80000400" severity failure;

    -- Interrupts.
    interrupts(4) <= '1';
    clock;
    assert wake_request = '0' and interrupt_pending = '0' severity failure;
    expect(x"344", x"00100000");
    write(x"304", x"00100000");
    wait for 1 ns;
    assert wake_request = '1' and interrupt_pending = '1' and interrupt_cause = 5d"20"
      report "a write of mie counts at once" severity failure;
    clock;
    trap.interrupt <= '1';
    trap.cause <= 5d"20";
    wait for 1 ns;
    assert trap_target = x"80000450" report "the vector of the cause of the clock before" severity failure;
    trap.interrupt <= '0';
    wait for 1 ns;
    assert trap_target = x"80000400" report "exceptions have no vectors" severity failure;
    write(x"300", x"00000000");
    wait for 1 ns;
    assert wake_request = '1' and interrupt_pending = '0' severity failure;
    interrupts(4) <= '0';
    clock;
    assert wake_request = '0' severity failure;

    -- Counters.
    write(x"b02", x"00000000");
    retire <= '1';
    clock;
    clock;
    retire <= '0';
    expect(x"c02", x"00000002");
    write(x"320", x"00000005");
    write(x"b00", x"00000007");
    retire <= '1';
    clock;
    retire <= '0';
    expect(x"b00", x"00000007");
    expect(x"b02", x"00000002");
    write(x"320", x"00000000");
    retire <= '1';
    clock;
    expect(x"b02", x"00000003");
    expect(x"b02", x"00000004");
    write(x"b02", x"00000040");
    expect(x"b02", x"00000040");
    write(x"b82", x"00000009");
    retire <= '0';
    expect(x"b02", x"00000041");
    expect(x"c82", x"00000009");
    -- Not the one of an interrupted instruction.
    request <= (enable => '1', cancelled => '1', address => x"304", operation => "01", operand => x"00000080",
                writes => '1');
    clock;
    request.enable <= '0';
    expect(x"304", x"00100000");
    std.env.finish;
  end process;

end architecture;
