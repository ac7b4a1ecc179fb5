-- SPDX-License-Identifier: Apache-2.0
-- Execute: results, redirects of fetch, accesses to memory and bus.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity execute_stage is
  generic (
    -- As of the processor.
    reset_address : unsigned(31 downto 0) := x"80000000";
    memory_size_bytes : positive := 65536;
    has_zbb : boolean := false
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- The instruction starts in this clock.
    start : in std_ulogic;
    -- As decode has issued it.
    redirect_condition : in redirect_condition_t;
    control : in control_t;
    result_is_address : in std_ulogic;
    executing_instruction : in word_t;
    executing_immediate : in word_t;
    alternate_address : in unsigned(31 downto 0);
    first_operand : in word_t;
    second_operand : in word_t;
    -- Flush by a trap or return. In the clock after: to the handler or away from it, and where to.
    flush : in std_ulogic;
    entering_handler : in std_ulogic;
    leaving_handler : in std_ulogic;
    trap_target : in unsigned(31 downto 0);
    return_target : in unsigned(31 downto 0);
    -- To fetch.
    redirect : out redirect_t;
    flushed : out std_ulogic;
    -- Accesses of loads and stores; the address also for `mtval`. A bus access goes on in the next clocks.
    memory_request : out memory_request_t;
    bus_request : out bus_request_t;
    bus_response : in bus_response_t;
    data_address : out unsigned(31 downto 0);
    data_misaligned : out std_ulogic;
    data_in_memory : out std_ulogic;
    bus_active : out std_ulogic;
    bus_done : out std_ulogic;
    bus_error : out std_ulogic;
    divider_done : out std_ulogic;
    -- Of a CSR instruction.
    csr_data : in word_t;
    -- For the next instruction, the OR of what settles late in the clock and the rest; to write-back,
    -- with late results a clock later.
    forwarded_late : out word_t;
    forwarded_early : out word_t;
    result : out word_t;
    product : out word_t;
    manipulated : out word_t := (others => '0')
  );
end entity;

architecture rtl of execute_stage is

  signal alu_result, divider_result, early_result, late_result : word_t;
  signal from_alu : std_ulogic;
  signal less, data_enable : std_ulogic;
  signal comparison : comparison_t;
  signal offset : unsigned(31 downto 0);

begin

  arithmetic : entity work.alu
    generic map (has_zbb => has_zbb)
    port map (
      first => first_operand,
      second => second_operand,
      operation => control.operation,
      shift => control.shift,
      subtract => control.subtract,
      arithmetic_shift => control.arithmetic_shift,
      rotate => control.rotate,
      compare_unsigned => control.compare_unsigned,
      result => alu_result,
      less => less,
      comparison => comparison);

  offset <= unsigned(executing_immediate);
  data_address <= unsigned(first_operand) + offset;
  branch_resolution : entity work.branch_resolution
    port map (
      clk => clk,
      reset => reset,
      condition => redirect_condition,
      comparison => comparison,
      alternate_address => alternate_address,
      jump_register => control.jump_register,
      base => unsigned(first_operand),
      offset => offset,
      sum => data_address,
      flush => flush,
      to_handler => entering_handler,
      to_return => leaving_handler,
      handler_address => trap_target,
      return_address => return_target,
      redirect => redirect.enable,
      target => redirect.target,
      target_plus_2 => redirect.target_plus_2,
      flushed => flushed);

  multiplication : entity work.multiplier
    port map (
      clk => clk,
      enable => control.multiply,
      operation => control.funct3(1 downto 0),
      first => first_operand,
      second => second_operand,
      result => product);

  division : entity work.divider
    port map (
      clk => clk,
      reset => reset,
      request => start and control.divide,
      operation => control.funct3(1 downto 0),
      first => first_operand,
      second => second_operand,
      done => divider_done,
      result => divider_result);

  with_zbb : if has_zbb generate
    bits : entity work.bit_manipulation
      port map (
        clk => clk,
        enable => control.manipulate,
        instruction => executing_instruction,
        first => first_operand,
        second => second_operand,
        less => less,
        result => manipulated);
  end generate;

  data_enable <= start and (control.load or control.store);
  data_access : entity work.data_access
    generic map (memory_address => reset_address, memory_size_bytes => memory_size_bytes)
    port map (
      clk => clk,
      reset => reset,
      enable => data_enable,
      store => control.store,
      base => unsigned(first_operand),
      offset => offset,
      address => data_address,
      size => control.funct3(1 downto 0),
      store_data => second_operand,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => data_misaligned,
      to_memory => data_in_memory,
      bus_active => bus_active,
      done => bus_done,
      error => bus_error);

  -- Result forwarded to the next instruction; the ALU's settles last.
  -- Late results are forwarded from write-back.
  early_result <= divider_result when control.divide else std_ulogic_vector(alternate_address);
  from_alu <= not (control.divide or result_is_address);
  forwarded_late <= alu_result and (31 downto 0 => from_alu);
  forwarded_early <= early_result and (31 downto 0 => not from_alu);
  late_result <= bus_response.data when bus_active else csr_data;
  result <= late_result when bus_active or control.csr else forwarded_late or forwarded_early;

end architecture;
