-- SPDX-License-Identifier: Apache-2.0
-- Execute gives each kind of instruction its result, redirects fetch by mispredictions, jumps and traps, and
-- reaches memory and bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.clocked_bench_pkg.all;
use work.instruction_words_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity execute_stage_tb is
end entity;

architecture simulation of execute_stage_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal instruction : word_t := add;
  signal control : control_t;
  signal immediate : word_t;
  signal start, result_is_address, flush, entering_handler, leaving_handler : std_ulogic := '0';
  signal redirect_condition : redirect_condition_t := redirect_never;
  signal alternate_address, trap_target, return_target : unsigned(31 downto 0) := (others => '0');
  signal first_operand, second_operand, csr_data : word_t := (others => '0');
  signal redirect : redirect_t;
  signal flushed : std_ulogic;
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;
  signal data_address : unsigned(31 downto 0);
  signal data_misaligned, data_in_memory, bus_active, bus_done, bus_error, divider_done : std_ulogic;
  signal forwarded_late, forwarded_early, result, product : word_t;

begin

  clk <= not clk after 10 ns;

  issue : entity work.issued_instruction
    port map (
      clk => clk, instruction => instruction, control => control,
      immediate => immediate);

  stage : entity work.execute_stage
    port map (
      clk => clk, reset => reset, start => start, redirect_condition => redirect_condition,
      control => control, result_is_address => result_is_address, executing_instruction => instruction,
      executing_immediate => immediate, alternate_address => alternate_address,
      first_operand => first_operand, second_operand => second_operand, flush => flush,
      entering_handler => entering_handler, leaving_handler => leaving_handler,
      trap_target => trap_target, return_target => return_target, redirect => redirect,
      flushed => flushed, memory_request => memory_request, bus_request => bus_request,
      bus_response => bus_response, data_address => data_address, data_misaligned => data_misaligned,
      data_in_memory => data_in_memory, bus_active => bus_active, bus_done => bus_done,
      bus_error => bus_error, divider_done => divider_done, csr_data => csr_data,
      forwarded_late => forwarded_late, forwarded_early => forwarded_early, result => result,
      product => product, manipulated => open);

  test : process

    procedure execute(word, first, second : word_t) is
    begin
      start <= '0';
      instruction <= word;
      wait_for_clock(clk);
      first_operand <= first;
      second_operand <= second;
      start <= '1';
      wait for 1 ns;
    end procedure;

  begin
    execute(add, x"00000000", x"00000000");
    reset <= '0';
    wait_for_clock(clk);

    execute(add, x"00000007", x"00000005");
    adds : assert result = x"0000000c" and forwarded_late = x"0000000c" and forwarded_early = x"00000000"
      severity failure;
    execute(mul, x"00000007", x"00000005");
    wait_for_clock(clk);
    multiplies : assert product = x"00000023" severity failure;

    execute(divu, x"00000023", x"00000005");
    division_takes_its_time : assert divider_done = '0' severity failure;
    wait until divider_done = '1' for 1 us;
    wait for 1 ns;
    divides : assert divider_done = '1' and result = x"00000007" severity failure;
    wait_for_clock(clk);

    alternate_address <= x"80000004";
    result_is_address <= '1';
    execute(jal_x3_16, x"11111111", x"11111111");
    links : assert result = x"80000004" and forwarded_late = x"00000000" and forwarded_early = x"80000004"
      severity failure;
    result_is_address <= '0';

    csr_data <= x"c5c5c5c5";
    execute(csrr_mscratch, x"11111111", x"11111111");
    reads_a_csr : assert result = x"c5c5c5c5" severity failure;

    -- Redirects.
    redirect_condition <= (if_below => '1', if_above => '1', inverted => '1');
    execute(beq, x"00000001", x"00000001");
    redirects_where_equal : assert redirect.enable = '1' and redirect.target = x"80000004" and
      redirect.target_plus_2 = 30x"20000001" severity failure;
    execute(beq, x"00000001", x"00000002");
    goes_on_where_unequal : assert redirect.enable = '0' severity failure;
    redirect_condition <= redirect_always;
    execute(jalr_8, x"80000100", x"00000000");
    jumps : assert redirect.enable = '1' and redirect.target = x"80000108" and
      redirect.target_plus_2 = 30x"20000042" severity failure;
    start <= '0';
    flush <= '1';
    wait_for_clock(clk);
    flush <= '0';
    is_flushed : assert flushed = '1' severity failure;
    alternate_address <= x"00000000";
    instruction <= add;
    wait_for_clock(clk);
    entering_handler <= '1';
    trap_target <= x"80000040";
    return_target <= x"80000080";
    wait for 1 ns;
    goes_to_the_handler : assert redirect.enable = '1' and redirect.target = x"80000040" severity failure;
    entering_handler <= '0';
    leaving_handler <= '1';
    wait for 1 ns;
    returns : assert redirect.target = x"80000080" severity failure;
    leaving_handler <= '0';
    redirect_condition <= redirect_never;
    is_no_longer_flushed : assert flushed = '0' severity failure;

    -- Memory.
    execute(lw_4, x"80000010", x"00000000");
    loads : assert memory_request.enable = '1' and memory_request.write_bytes = "0000" and
      memory_request.address = 30x"20000005" and data_in_memory = '1' and data_misaligned = '0'
      severity failure;
    execute(sb_1, x"80000010", x"000000a5");
    stores : assert memory_request.enable = '1' and memory_request.write_bytes = "0010" and
      memory_request.data(15 downto 8) = x"a5" severity failure;
    execute(lw_4, x"80000011", x"00000000");
    finds_misaligned : assert data_misaligned = '1' and data_address = x"80000015" severity failure;

    -- The bus.
    execute(lw_4, x"f0000010", x"00000000");
    is_not_in_memory : assert data_in_memory = '0' severity failure;
    wait_for_clock(clk);
    start <= '0';
    asks_the_bus : assert bus_active = '1' and bus_request.strobe = '1' and bus_request.write = '0' and
      bus_request.address = x"f0000014" severity failure;
    wait_for_clock(clk);
    bus_response <= (acknowledge => '1', error => '0', data => x"0badcafe");
    wait for 1 ns;
    is_done : assert bus_done = '1' and bus_error = '0' and result = x"0badcafe" severity failure;
    wait_for_clock(clk);
    bus_response <= bus_response_idle;
    wait for 1 ns;
    is_over : assert bus_active = '0' severity failure;
    execute(sb_1, x"f0000010", x"000000a5");
    wait_for_clock(clk);
    start <= '0';
    bus_response.error <= '1';
    wait for 1 ns;
    is_refused : assert bus_error = '1' and bus_done = '0' and bus_request.write = '1' severity failure;
    std.env.finish;
  end process;

end architecture;
