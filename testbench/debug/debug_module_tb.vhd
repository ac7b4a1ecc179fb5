-- SPDX-License-Identifier: Apache-2.0
-- The registers of the debug module: stored values, refusals, and the reset of an inactive module.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.debug_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity debug_module_tb is
end entity;

architecture tb of debug_module_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal processor_reset, halted : std_ulogic := '0';
  signal request : dmi_request_t := (
    strobe | write => '0', address => 7x"0", data => x"00000000");
  signal data : word_t;
  signal chip_reset, halt_request, halt_at_reset, resume, inject : std_ulogic;
  signal instruction : word_t;
  signal csr_request : debug_csr_request_t;
  signal from_processor : debug_response_t := (
    address | next_address => x"00000000", value => x"00000000", others => '0');
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;

begin

  clk <= not clk after 5 ns;

  uut : entity work.debug_module
    port map (
      clk => clk, reset => reset, dmi_request => request, dmi_data => data, chip_reset => chip_reset,
      processor_reset => processor_reset, halted => halted, halt_request => halt_request,
      halt_at_reset => halt_at_reset, resume => resume, csr_request => csr_request,
      csr_response => (exists => '0', data => x"00000000"), inject => inject,
      instruction => instruction, debug_response => from_processor, port_free => '1',
      memory_request => memory_request, memory_data => x"0000c0de", bus_request => bus_request,
      bus_response => bus_response_idle);

  check : process

    procedure clock is
    begin
      wait until falling_edge(clk);
    end procedure;

    procedure write(address : std_ulogic_vector(6 downto 0); value : word_t) is
    begin
      request <= (strobe => '1', write => '1', address => address, data => value);
      clock;
      request.strobe <= '0';
      request.write <= '0';
    end procedure;

    procedure expect(address : std_ulogic_vector(6 downto 0); value : word_t) is
    begin
      request <= (strobe => '1', write => '0', address => address, data => x"00000000");
      wait for 1 ns;
      assert data = value report to_hstring(address) & " is " & to_hstring(data) severity failure;
      clock;
      request.strobe <= '0';
    end procedure;

  begin
    clock;
    reset <= '0';
    clock;

    -- An inactive module takes nothing but being activated.
    write(dmcontrol_address, x"80000002");
    clock;
    expect(dmcontrol_address, x"00000000");
    assert not (halt_request or chip_reset) severity failure;
    write(data0_address, x"12345678");
    expect(data0_address, x"00000000");
    write(dmcontrol_address, x"00000001");
    clock;
    write(data0_address, x"12345678");
    expect(data0_address, x"12345678");
    expect(dmstatus_address, x"00000ca2");
    expect(7x"12", x"00000000");
    expect(7x"1d", x"00000000");
    expect(abstractcs_address, x"00000001");

    -- A reset is remembered until it is acknowledged.
    write(dmcontrol_address, x"00000003");
    clock;
    assert chip_reset severity failure;
    processor_reset <= '1';
    clock;
    clock;
    expect(dmstatus_address, x"000c30a2");
    write(dmcontrol_address, x"00000009");
    assert not chip_reset and halt_at_reset and not halt_request severity failure;
    processor_reset <= '0';
    clock;
    write(dmcontrol_address, x"10000005");
    assert not halt_at_reset severity failure;
    expect(dmstatus_address, x"00000ca2");

    -- Halting, and resuming, which is acknowledged until the next time.
    write(dmcontrol_address, x"80000001");
    assert halt_request and halt_at_reset severity failure;
    halted <= '1';
    write(dmcontrol_address, x"00000001");
    expect(dmstatus_address, x"000003a2");
    expect(haltsum0_address, x"00000001");
    write(dmcontrol_address, x"c0000001");
    assert not resume report "a halt that is asked for wins at once" severity failure;
    clock;
    assert not resume report "a halt that is asked for wins" severity failure;
    write(dmcontrol_address, x"40000001");
    assert resume severity failure;
    clock;
    assert not resume severity failure;
    halted <= '0';
    expect(dmstatus_address, x"00030ca2");
    halted <= '1';
    expect(dmstatus_address, x"000303a2");

    -- A command that never ends: all that would disturb it is an error, and the first error stays.
    write(command_address, x"0022100a");
    expect(abstractcs_address, x"00001001");
    clock;
    clock;
    clock;
    write(dmcontrol_address, x"40000001");
    assert not resume report "a command is under way" severity failure;
    expect(dmstatus_address, x"000003a2");
    write(data0_address, x"00000000");
    expect(abstractcs_address, x"00001101");
    from_processor.trapped <= '1';
    clock;
    from_processor.trapped <= '0';
    clock;
    clock;
    expect(abstractcs_address, x"00000101");
    expect(dmstatus_address, x"000303a2");
    expect(data0_address, x"12345678");
    write(command_address, x"00220000");
    expect(abstractcs_address, x"00000101");
    write(abstractcs_address, x"00000600");
    expect(abstractcs_address, x"00000101");
    write(abstractcs_address, x"00000100");
    expect(abstractcs_address, x"00000001");

    -- Inactive, it does not affect the processor.
    write(dmcontrol_address, x"80000001");
    write(dmcontrol_address, x"00000000");
    clock;
    clock;
    assert not (halt_request or chip_reset or halt_at_reset or inject) severity failure;
    expect(data0_address, x"00000000");
    report "debug_module_tb passed";
    std.env.finish;
  end process;

end architecture;
