-- SPDX-License-Identifier: Apache-2.0
-- Accesses wait for a free port, use the right lanes, and count on; errors stay until they are cleared.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity system_bus_access_tb is
end entity;

architecture tb of system_bus_access_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal write_control, write_address, write_data, read_data : std_ulogic := '0';
  signal written, control, data : word_t := x"00000000";
  signal address : unsigned(31 downto 0);
  signal port_free : std_ulogic := '1';
  signal memory_request : memory_request_t;
  signal memory_data : word_t := x"00000000";
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;

begin

  clk <= not clk after 5 ns;

  uut : entity work.system_bus_access
    generic map (memory_size_bytes => 32768)
    port map (
      clk => clk, reset => reset, write_control => write_control, write_address => write_address,
      write_data => write_data, read_data => read_data, written => written, control => control,
      address => address, data => data, port_free => port_free, memory_request => memory_request,
      memory_data => memory_data, bus_request => bus_request, bus_response => bus_response);

  -- The data of the last request, and nothing once the port is granted to another master.
  answer : process
  begin
    wait until rising_edge(clk);
    memory_data <= x"ffffffff";
    if memory_request.enable then
      memory_data <= x"44332211";
    end if;
  end process;

  check : process

    procedure clock is
    begin
      wait until falling_edge(clk);
    end procedure;

    procedure pulse(signal enable : out std_ulogic; value : word_t) is
    begin
      written <= value;
      enable <= '1';
      clock;
      enable <= '0';
    end procedure;

    procedure expect_control(value, mask : word_t; what : string) is
    begin
      wait for 1 ns;
      assert (control and mask) = value report what & ": " & to_hstring(control) severity failure;
    end procedure;

    procedure read_at(place : word_t; size : natural; wanted : word_t) is
    begin
      pulse(write_control, std_ulogic_vector(to_unsigned(16#100000# + size * 16#20000#, 32)));
      pulse(write_address, place);
      assert memory_request.enable = '1' and memory_request.write_bytes = "0000" severity failure;
      clock;
      clock;
      assert data = wanted report "read " & to_hstring(data) severity failure;
      expect_control(x"00000000", x"00607000", "done without error");
    end procedure;

    procedure write_at(place, value : word_t; size : natural; lanes : std_ulogic_vector(3 downto 0);
                       wanted : word_t) is
    begin
      pulse(write_control, std_ulogic_vector(to_unsigned(size * 16#20000#, 32)));
      pulse(write_address, place);
      assert not memory_request.enable report "nothing was asked for" severity failure;
      pulse(write_data, value);
      assert memory_request.enable = '1' and memory_request.write_bytes = lanes and
        memory_request.data = wanted and
        memory_request.address = unsigned(place(31 downto 2)) severity failure;
      clock;
      clock;
      expect_control(x"00000000", x"00607000", "done without error");
    end procedure;

  begin
    clock;
    reset <= '0';
    clock;
    expect_control(x"20040407", x"ffffffff", "after reset: 32 bits");

    read_at(x"80000000", 2, x"44332211");
    for place in 0 to 3 loop
      read_at(std_ulogic_vector(to_unsigned(place, 32) or x"80000000"), 0,
              x"000000" & std_ulogic_vector(to_unsigned(16#11# * (place + 1), 8)));
    end loop;
    read_at(x"80000000", 1, x"00002211");
    read_at(x"80007ffe", 1, x"00004433");
    write_at(x"80000004", x"89abcdef", 2, "1111", x"89abcdef");
    write_at(x"80000004", x"89abcdef", 1, "0011", x"cdefcdef");
    write_at(x"80000006", x"89abcdef", 1, "1100", x"cdefcdef");
    write_at(x"80000004", x"89abcdef", 0, "0001", x"efefefef");
    write_at(x"80000005", x"89abcdef", 0, "0010", x"efefefef");
    write_at(x"80000006", x"89abcdef", 0, "0100", x"efefefef");
    write_at(x"80000007", x"89abcdef", 0, "1000", x"efefefef");

    -- The port is the processor's for a while; what is requested meanwhile comes too early.
    port_free <= '0';
    pulse(write_control, x"00150000");
    pulse(write_address, x"80000010");
    for wait_clock in 1 to 5 loop
      assert not memory_request.enable report "the port is taken" severity failure;
      expect_control(x"00200000", x"00607000", "busy");
      clock;
    end loop;
    pulse(write_address, x"80000020");
    expect_control(x"00600000", x"00607000", "busy error");
    port_free <= '1';
    wait for 1 ns;
    assert memory_request.enable = '1' and memory_request.address = x"80000010" / 4 severity failure;
    clock;
    port_free <= '0';
    clock;
    assert data = x"44332211" and address = x"80000014" report "increment" severity failure;
    pulse(write_address, x"80000030");
    expect_control(x"00400000", x"00607000", "busy error stays, nothing begins");
    pulse(write_control, x"00540000");
    expect_control(x"00000000", x"00607000", "cleared");
    port_free <= '1';

    -- The bus: as long as it takes, and an error of it.
    pulse(write_address, x"f0000ffe");
    expect_control(x"00003000", x"00607000", "misaligned");
    pulse(write_control, x"00167000");
    pulse(write_address, x"80000000");
    expect_control(x"00004000", x"00607000", "size");
    pulse(write_control, x"00147000");
    pulse(write_address, x"80008000");
    clock;
    for wait_clock in 1 to 5 loop
      assert bus_request.strobe and not bus_request.write severity failure;
      assert bus_request.address = x"80008000" and bus_request.select_bytes = "1111" severity failure;
      clock;
    end loop;
    bus_response <= (acknowledge => '1', error => '0', data => x"12348765");
    clock;
    bus_response <= bus_response_idle;
    assert data = x"12348765" and bus_request.strobe = '0' severity failure;
    pulse(write_data, x"00000001");
    clock;
    assert bus_request.strobe and bus_request.write severity failure;
    bus_response.error <= '1';
    clock;
    bus_response.error <= '0';
    assert not bus_request.strobe severity failure;
    expect_control(x"00002000", x"00607000", "nothing there");
    pulse(write_address, x"80000000");
    assert not memory_request.enable report "an error stops all" severity failure;
    clock;
    assert not memory_request.enable report "an error stops all that comes later" severity failure;
    reset <= '1';
    clock;
    expect_control(x"20040407", x"ffffffff", "after reset");
    report "system_bus_access_tb passed";
    std.env.finish;
  end process;

end architecture;
