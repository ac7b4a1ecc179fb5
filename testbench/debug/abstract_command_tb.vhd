-- SPDX-License-Identifier: Apache-2.0
-- Each command becomes the instructions that it is meant to, and an exception is reported.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.processor_pkg.all;

entity abstract_command_tb is
end entity;

architecture tb of abstract_command_tb is

  type words_t is array (natural range <>) of word_t;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal halted : std_ulogic := '1';
  signal start, busy, done, has_result, inject : std_ulogic := '0';
  signal command, data, result, instruction : word_t := x"00000000";
  signal error : command_error_t;
  signal csr_request : debug_csr_request_t;
  signal csr_response : debug_csr_response_t := (exists => '0', data => x"00000000");
  signal from_processor : debug_response_t := (
    address | next_address => x"00000000", value => x"00000000", others => '0');

  signal executed : words_t(0 to 15) := (others => (others => '0'));
  signal count : natural := 0;
  signal traps_at : natural := 99;

begin

  clk <= not clk after 5 ns;

  uut : entity work.abstract_command
    port map (
      clk => clk, reset => reset, halted => halted, start => start, command => command, data => data,
      busy => busy, done => done, error => error, has_result => has_result, result => result,
      csr_request => csr_request, csr_response => csr_response, inject => inject,
      instruction => instruction, debug_response => from_processor);

  csr_response <= (exists => '1', data => x"0000feed") when csr_request.address = x"7b1" else
                  (exists => '0', data => x"00000000");

  -- A processor that completes each instruction three clocks after it was given, with a value that
  -- shows which it was.
  execute : process
  begin
    wait until rising_edge(clk);
    if start then
      count <= 0;
    end if;
    if inject then
      executed(count) <= instruction;
      wait until rising_edge(clk);
      assert not inject report "the next one is given too early" severity failure;
      wait until rising_edge(clk);
      from_processor.completed <= '1' when count /= traps_at else '0';
      from_processor.trapped <= '1' when count = traps_at else '0';
      from_processor.value <= std_ulogic_vector(to_unsigned(16#8008f00# + count, 32));
      wait until rising_edge(clk);
      from_processor.completed <= '0';
      from_processor.trapped <= '0';
      count <= count + 1;
    end if;
  end process;

  check : process

    procedure run(what : word_t; value : word_t; wanted_error : command_error_t; instructions : words_t) is
    begin
      wait until falling_edge(clk);
      command <= what;
      data <= value;
      start <= '1';
      wait until falling_edge(clk);
      start <= '0';
      assert busy report "not busy" severity failure;
      wait until falling_edge(clk) and done = '1' for 1 us;
      assert done report "it does not end" severity failure;
      assert error = wanted_error report "error " & to_string(error) severity failure;
      assert count = instructions'length
        report integer'image(count) & " instructions" severity failure;
      for index in instructions'range loop
        assert executed(index - instructions'low) = instructions(index)
          report "instruction " & integer'image(index) & " is " &
            to_hstring(executed(index - instructions'low)) severity failure;
      end loop;
      wait until falling_edge(clk);
      assert not busy severity failure;
    end procedure;

    constant none : words_t(1 to 0) := (others => (others => '0'));

    procedure expect_result(value : word_t) is
    begin
      assert result = value report "result " & to_hstring(result) severity failure;
    end procedure;

  begin
    wait until falling_edge(clk);
    reset <= '0';

    -- addi x0, x13, 0
    run(x"0022100d", x"00000000", command_error_none, (0 => x"00068013"));
    expect_result(x"08008f00");
    -- lui x31, 0x12346; addi x31, x31, -1
    run(x"0023101f", x"12345fff", command_error_none, (x"12346fb7", x"ffff8f93"));
    -- csrrs x0, mcause, x0
    run(x"00220342", x"00000000", command_error_none, (0 => x"34202073"));
    -- x8 is read, gets the value, goes to mtvec, and gets back what was read.
    run(x"00230305", x"80000104", command_error_none,
        (x"00040013", x"80000437", x"10440413", x"30541073", x"08009437", x"f0040413"));

    traps_at <= 0;
    run(x"00220123", x"00000000", command_error_exception, (0 => x"12302073"));
    traps_at <= 3;
    run(x"00230123", x"00000001", command_error_exception,
        (x"00040013", x"00000437", x"00140413", x"12341073", x"08009437", x"f0040413"));
    traps_at <= 99;

    -- Registers outside the processor need none of its instructions.
    run(x"002207b1", x"00000000", command_error_none, none);
    expect_result(x"0000feed");
    -- No transfer, of any size: nothing.
    run(x"00700000", x"00000000", command_error_none, none);

    run(x"0032100d", x"00000000", command_error_not_supported, none);
    run(x"002a100d", x"00000000", command_error_not_supported, none);
    run(x"0026100d", x"00000000", command_error_not_supported, none);
    run(x"00221020", x"00000000", command_error_not_supported, none);
    run(x"01220000", x"00000000", command_error_not_supported, none);
    halted <= '0';
    run(x"0022100d", x"00000000", command_error_not_halted, none);
    run(x"002307b1", x"00000000", command_error_not_halted, none);
    run(x"0032100d", x"00000000", command_error_not_supported, none);
    report "abstract_command_tb passed";
    std.env.finish;
  end process;

  watch_csrs : process
  begin
    wait until rising_edge(clk);
    only_a_halted_processor_is_written : assert not (csr_request.write = '1' and halted = '0')
      severity failure;
  end process;

end architecture;
