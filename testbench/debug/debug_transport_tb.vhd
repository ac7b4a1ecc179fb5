-- SPDX-License-Identifier: Apache-2.0
-- The test access port: identity, bypass, reset from every state, and accesses that reach the module.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.debug_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

entity debug_transport_tb is
end entity;

architecture tb of debug_transport_tb is

  constant identity_code : word_t := x"15f01001";

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal jtag : jtag_t := jtag_idle;
  signal request : dmi_request_t;
  signal data, last_written : word_t := x"00000000";
  signal last_address : std_ulogic_vector(6 downto 0);
  signal accesses, writes : natural := 0;

begin

  clk <= not clk after 5 ns;

  uut : entity work.debug_transport
    port map (
      clk => clk, reset => reset, tck => jtag.tck, tms => jtag.tms, tdi => jtag.tdi, tdo => jtag.tdo,
      dmi_request => request, dmi_data => data);

  -- Reads bring the address that they name, and how many there were.
  data <= x"a500" & std_ulogic_vector(to_unsigned(accesses, 8)) & '0' & request.address when request.strobe
          else x"deadbeef";

  count_accesses : process
  begin
    wait until rising_edge(clk);
    if request.strobe then
      accesses <= accesses + 1;
      last_address <= request.address;
      if request.write then
        writes <= writes + 1;
        last_written <= request.data;
      end if;
    end if;
  end process;

  check : process

    procedure expect_data(sent, wanted : std_ulogic_vector; what : string) is
      variable captured : std_ulogic_vector(sent'length - 1 downto 0);
    begin
      scan_data(jtag, sent, captured);
      assert captured = wanted report what & ": " & to_hstring(captured) severity failure;
    end procedure;

    -- From run-test/idle through a register and back, with a pause after each bit.
    procedure scan_slowly(of_instruction : boolean; sent : std_ulogic_vector;
                          captured : out std_ulogic_vector) is
      alias bits : std_ulogic_vector(sent'length - 1 downto 0) is sent;
      variable word : std_ulogic_vector(sent'length - 1 downto 0);
      variable seen : std_ulogic;
    begin
      clock_tap(jtag, '1', '0', seen);
      if of_instruction then
        clock_tap(jtag, '1', '0', seen);
      end if;
      clock_tap(jtag, '0', '0', seen);
      for index in 0 to sent'length - 1 loop
        clock_tap(jtag, '0', '0', seen);
        clock_tap(jtag, '1', bits(index), word(index));
        if index < sent'length - 1 then
          clock_tap(jtag, '0', '0', seen);
          clock_tap(jtag, '0', '0', seen);
          clock_tap(jtag, '1', '0', seen);
        end if;
      end loop;
      clock_tap(jtag, '1', '0', seen);
      clock_tap(jtag, '0', '0', seen);
      captured := word;
    end procedure;

    variable word : word_t;
    variable captured_instruction : std_ulogic_vector(4 downto 0);
    variable access_word : std_ulogic_vector(40 downto 0);
    variable seed_1, seed_2 : positive := 11;
    variable chance : real;
    variable seen, level : std_ulogic;

  begin
    wait for 42 ns;
    reset <= '0';
    reset_tap(jtag);
    expect_data(x"00000000", identity_code, "identity after a reset");

    -- After the identity comes the input, 32 bits later.
    expect_data(x"3c5a12345678", x"5678" & identity_code, "identity register of 32 bits");

    scan_instruction(jtag, "11111");
    expect_data(x"9b", x"36", "bypass of one bit");
    scan_instruction(jtag, "01010");
    expect_data(x"9b", x"36", "bypass by any other instruction");
    scan_instruction(jtag, 5x"10");
    expect_data(x"00030000", x"00000071", "dtmcs: version, width of addresses, no error");

    -- Pauses change nothing.
    scan_slowly(true, 5x"01", captured_instruction);
    assert captured_instruction = "00001" report "instruction register" severity failure;
    scan_slowly(false, x"00000000", word);
    assert word = identity_code report "with pauses " & to_hstring(word) severity failure;

    scan_instruction(jtag, 5x"11");
    write_dmi(jtag, 7x"12", x"89abcdef");
    wait for 50 ns;
    assert accesses = 1 and writes = 1 and last_address = 7x"12" and last_written = x"89abcdef"
      severity failure;
    read_dmi(jtag, 7x"7f", word);
    assert word = x"a500017f" and accesses = 2 and writes = 1
      report "read " & to_hstring(word) severity failure;
    -- Operations 0 and 3 are none.
    scan_data(jtag, 7x"55" & x"00000000" & "11", access_word);
    wait for 50 ns;
    assert accesses = 2 report "no access was asked for" severity failure;

    -- Whatever happened before, five clocks with tms high lead to the identity. Without the instruction
    -- dmi nothing on the way is an access.
    reset_tap(jtag);
    for round in 1 to 40 loop
      uniform(seed_1, seed_2, chance);
      for step in 1 to 20 + integer(chance * 20.0) loop
        uniform(seed_1, seed_2, chance);
        level := '1' when chance < 0.5 else '0';
        clock_tap(jtag, level, '0', seen);
      end loop;
      reset_tap(jtag);
      expect_data(x"00000000", identity_code, "identity after a reset from anywhere");
    end loop;
    assert accesses = 2 report "a walk made an access" severity failure;

    -- A reset of the chip while a scan is under way.
    clock_tap(jtag, '1', '0', seen);
    clock_tap(jtag, '0', '0', seen);
    clock_tap(jtag, '0', '0', seen);
    wait until rising_edge(clk);
    reset <= '1';
    wait until rising_edge(clk);
    reset <= '0';
    clock_tap(jtag, '0', '0', seen);
    expect_data(x"00000000", identity_code, "identity after a reset of the chip");
    report "debug_transport_tb passed";
    std.env.finish;
  end process;

end architecture;
