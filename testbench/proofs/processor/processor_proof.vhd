-- SPDX-License-Identifier: Apache-2.0
-- The processor with memory, bus and interrupts constrained only by their protocols, against a model of the
-- instruction set: every retired instruction and every trap is checked.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.data_width_pkg.all;
use work.instruction_set_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;
use work.short_instructions_pkg.all;

entity processor_proof is
  generic (
    -- The program begins with instructions that enable any interrupts with any handler (1), or that sleep
    -- until any interrupt (2), followed by anything: interrupts are reached in few clocks.
    prologue : natural range 0 to 2 := 0
  );
  port (
    clk : in std_ulogic;
    -- Unconstrained in each clock.
    any_instruction : in value_t;
    any_data : in value_t;
    bus_response : in bus_response_t;
    interrupts_begin : in std_ulogic
  );
end entity;

architecture proof of processor_proof is

  constant memory_end : unsigned(31 downto 0) := x"80010000";
  -- Clocks after which a request must be visible.
  constant clocks_to_settle : positive := 5;

  attribute anyconst : boolean;
  -- Any two registers: the programs read no others, but write all.
  signal first_register, second_register : register_index_t := (others => '0');
  attribute anyconst of first_register : signal is true;
  attribute anyconst of second_register : signal is true;
  -- Of the environment: any half word of the program, and the one after it; any word of the data.
  signal code_place : unsigned(31 downto 1);
  signal code_low, code_high : std_ulogic_vector(15 downto 0);
  signal data_place : unsigned(31 downto 2);
  signal data_at_first : value_t;

  signal running : std_ulogic;
  signal reset : std_ulogic;

  signal instruction_request : instruction_request_t;
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal instruction_data, memory_data : value_t;
  signal requests : value_t;
  signal requested_for : natural range 0 to 15;
  signal settled : std_ulogic;
  signal sleeping, at_rest : std_ulogic;
  signal retirement : retirement_t;

  -- Events of this clock.
  signal event, completed, exception, interrupted, has_word : std_ulogic;
  signal is_long : std_ulogic;
  signal word : value_t;
  signal kind : kind_t;
  signal address, link, next_address : unsigned(31 downto 0);
  signal first, second, operand, immediate : value_t;
  signal data_address, fetch_fault_address : unsigned(31 downto 0);
  signal fetch_fault, misaligned, over_bus, is_access : std_ulogic;
  signal must_trap, writes, requests_bus, bus_failed, bus_must_respond : std_ulogic;
  signal requesting : std_ulogic;
  signal cause : std_ulogic_vector(4 downto 0);
  signal trap_value : value_t;

  -- State of the model.
  signal first_content, second_content : value_t := (others => '0');
  signal expected_address : unsigned(31 downto 0) := x"80000000";
  signal address_known : std_ulogic := '1';
  signal due_before : std_ulogic := '0';

  signal csr_legal, csr_known, permitted, return_known, due : std_ulogic;
  signal csr_value, active : value_t;
  signal trap_target, return_address : unsigned(31 downto 0);

  default clock is rising_edge(clk);

begin

  reset <= not running;

  processor : entity work.processor
    port map (
      clk => clk,
      always_clk => clk,
      reset => reset,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      memory_request => memory_request,
      memory_data => memory_data,
      bus_request => bus_request,
      bus_response => bus_response,
      timer_interrupt => requests(7),
      external_interrupt => requests(11),
      interrupts => requests(31 downto 16),
      sleeping => sleeping,
      at_rest => at_rest,
      retirement => retirement);

  environment : entity work.processor_environment
    generic map (prologue => prologue, clocks_to_settle => clocks_to_settle)
    port map (
      clk => clk, any_instruction => any_instruction, any_data => any_data,
      interrupts_begin => interrupts_begin, running => running,
      instruction_request => instruction_request, instruction_data => instruction_data,
      memory_request => memory_request, memory_data => memory_data, requests => requests,
      requested_for => requested_for, known_code_place => code_place, known_code_low => code_low,
      known_code_high => code_high, known_data_place => data_place,
      known_data_at_first => data_at_first);

  settled <= '1' when requested_for = 0 or requested_for = clocks_to_settle else '0';

  -- The event of this clock, and what the specification says of it.
  completed <= running and retirement.valid;
  interrupted <= running and retirement.trap and retirement.interrupt;
  exception <= running and retirement.trap and not retirement.interrupt;
  event <= completed or exception or interrupted;
  address <= retirement.address;
  is_long <= and retirement.instruction(1 downto 0);
  word <= retirement.instruction when is_long = '1' else expanded(retirement.instruction(15 downto 0));
  kind <= kind_of(word);
  link <= address + 4 when is_long = '1' else address + 2;

  first <= x"00000000" when word(19 downto 15) = "00000" else first_content;
  second <= x"00000000" when word(24 downto 20) = "00000" else second_content;
  immediate <= std_ulogic_vector(immediate_s(word)) when kind = store else
               std_ulogic_vector(immediate_i(word));
  operand <= first when kind = csr and word(14) = '0' else
             x"000000" & "000" & word(19 downto 15) when kind = csr else
             second when word(5) = '1' else
             immediate;
  data_address <= unsigned(first) + unsigned(immediate);
  over_bus <= '1' when data_address(31 downto 16) /= x"8000" else '0';
  is_access <= '1' when kind = load or kind = store else '0';
  misaligned <= '1' when is_misaligned(word, data_address) else '0';

  fetch_fault <= '1' when address(31 downto 16) /= x"8000" or
                          (address = memory_end - 2 and is_long = '1') else '0';
  fetch_fault_address <= memory_end when address(31 downto 16) = x"8000" else address;
  has_word <= completed or (exception and not fetch_fault);

  specify_traps : process (all)
  begin
    must_trap <= '1';
    cause <= "00000";
    trap_value <= std_ulogic_vector(address);
    if fetch_fault then
      cause <= cause_instruction_access;
      trap_value <= std_ulogic_vector(fetch_fault_address);
    elsif kind = illegal or (kind = csr and csr_legal = '0') then
      cause <= cause_illegal_instruction;
      trap_value <= retirement.instruction;
    elsif kind = environment_call then
      cause <= cause_environment_call;
      trap_value <= x"00000000";
    elsif kind = breakpoint then
      cause <= cause_breakpoint;
    elsif is_access = '1' and misaligned = '1' then
      cause <= cause_load_misaligned when kind = load else cause_store_misaligned;
      trap_value <= std_ulogic_vector(data_address);
    elsif is_access = '1' and over_bus = '1' and bus_failed = '1' then
      cause <= cause_load_access when kind = load else cause_store_access;
      trap_value <= std_ulogic_vector(data_address);
    else
      must_trap <= '0';
    end if;
  end process;

  registers : entity work.csr_model
    port map (
      clk => clk,
      reset => reset,
      completed => completed,
      exception => exception,
      interrupted => interrupted,
      word => word,
      address => address,
      operand => operand,
      cause => cause,
      trap_value => trap_value,
      requests => requests,
      settled => settled,
      legal => csr_legal,
      value => csr_value,
      known => csr_known,
      active => active,
      permitted => permitted,
      trap_target => trap_target,
      return_address => return_address,
      return_known => return_known,
      state => open);

  choose_next_address : process (all)
  begin
    next_address <= link;
    if exception or interrupted then
      next_address <= trap_target;
    elsif kind = jump then
      next_address <= address + immediate_j(word);
    elsif kind = jump_register then
      next_address <= data_address(31 downto 1) & '0';
    elsif kind = branch and is_taken(word, first, second) then
      next_address <= address + immediate_b(word);
    elsif kind = trap_return then
      next_address <= return_address;
    end if;
  end process;

  due <= '1' when active /= x"00000000" and permitted = '1' and requested_for = clocks_to_settle else '0';

  follow : process
  begin
    wait until rising_edge(clk);
    if completed = '1' and retirement.destination /= "00000" then
      if retirement.destination = first_register then
        first_content <= retirement.value;
      end if;
      if retirement.destination = second_register then
        second_content <= retirement.value;
      end if;
    end if;
    if event then
      expected_address <= next_address;
      address_known <= return_known when kind = trap_return and completed = '1' else '1';
      due_before <= due;
    end if;

    if reset then
      expected_address <= x"80000000";
      address_known <= '1';
      due_before <= '0';
    end if;
  end process;

  writes <= '1' when completed = '1' and retirement.destination /= "00000" else '0';
  requests_bus <= (completed or exception) and not fetch_fault and is_access and over_bus and not misaligned;

  results : entity work.result_checks
    port map (
      clk => clk, writes => writes, value => retirement.value, word => word, address => address,
      link => link, first => first, second => second, operand => operand);

  data : entity work.data_checks
    port map (
      clk => clk, reset => reset, event => event, completed => completed, writes => writes,
      value => retirement.value, word => word, second => second, data_address => data_address,
      over_bus => over_bus, requests_bus => requests_bus, bus_request => bus_request,
      bus_response => bus_response, data_place => data_place, data_at_first => data_at_first,
      bus_failed => bus_failed, bus_must_respond => bus_must_respond);

  requesting <= instruction_request.enable or memory_request.enable or bus_request.strobe;
  sleep : entity work.sleep_checks
    port map (
      clk => clk, running => running, event => event, completed => completed, kind => kind,
      sleeping => sleeping, at_rest => at_rest, active => active, requesting => requesting);

  -- Constraints, which count only in the entity that is proved.
  only_these_registers_are_read : assume always (has_word ->
    ((not reads_first(word) or word(19 downto 15) = "00000" or word(19 downto 15) = first_register) and
     (not reads_second(word) or word(24 downto 20) = "00000" or word(24 downto 20) = second_register)));
  bus_responds_within_limit : assume always
    (bus_must_respond -> (bus_response.acknowledge or bus_response.error));
  bus_response_is_exclusive : assume always not (bus_response.acknowledge and bus_response.error);

  instruction_is_from_its_address : assert always
    ((has_word = '1' and address(31 downto 1) = code_place) ->
     (retirement.instruction(15 downto 0) = code_low and
      ((is_long = '1' and retirement.instruction(31 downto 16) = code_high) or
       (is_long = '0' and retirement.instruction(31 downto 16) = x"0000"))));
  program_order_is_kept : assert always
    ((event and address_known) -> address = expected_address);
  one_outcome_per_instruction : assert always
    (not (completed and exception) and not (completed and interrupted));
  traps_exactly_where_specified : assert always ((completed or exception) -> exception = must_trap);
  destination_is_right : assert always
    (completed -> retirement.destination = destination_of(word));

  csr_reads_are_right : assert always
    ((writes = '1' and kind = csr and csr_known = '1') -> retirement.value = csr_value);
  only_enabled_interrupts_are_taken : assert always
    (interrupted -> (permitted = '1' and active /= x"00000000"));
  pending_interrupts_are_taken : assert always
    ((event = '1' and due_before = '1' and due = '1') ->
     (interrupted = '1' or (completed = '1' and kind = wait_for_interrupt)));
end architecture;
