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
  -- Upper bound of clocks between two events while the processor does not sleep: a bus access with a
  -- load-use hazard, or a trap by it, takes longest.
  constant most_clocks_between_events : positive := 10;
  constant most_clocks_of_bus : positive := 2;
  -- Clocks after which a request must be visible.
  constant clocks_to_settle : positive := 5;
  -- Upper bound of clocks that wfi sleeps with an enabled request: one to sample it, and one until
  -- `csr_model` sees a write of mie.
  constant most_clocks_to_wake : positive := 2;

  attribute anyconst : boolean;
  -- Any two registers: the programs read no others, but write all.
  signal first_register, second_register : register_index_t := (others => '0');
  attribute anyconst of first_register : signal is true;
  attribute anyconst of second_register : signal is true;
  -- Any half word of the program, and the one after it.
  signal code_place : unsigned(31 downto 1) := (others => '0');
  signal code_low, code_high : std_ulogic_vector(15 downto 0) := (others => '0');
  attribute anyconst of code_place : signal is true;
  attribute anyconst of code_low : signal is true;
  attribute anyconst of code_high : signal is true;
  -- Any word of the data, with its initial value.
  signal data_place : unsigned(31 downto 2) := (others => '0');
  signal data_at_first : value_t := (others => '0');
  attribute anyconst of data_place : signal is true;
  attribute anyconst of data_at_first : signal is true;
  -- Any interrupts, which begin at any time and stay.
  signal any_requests : value_t := (others => '0');
  attribute anyconst of any_requests : signal is true;

  -- lui and addi of any value to x8, then csrw mie, and csrw mtvec, csrsi mstatus; or wfi and a nop.
  signal mask_high : std_ulogic_vector(31 downto 12) := (others => '0');
  signal mask_low : std_ulogic_vector(11 downto 0) := (others => '0');
  attribute anyconst of mask_high : signal is true;
  attribute anyconst of mask_low : signal is true;
  type words_t is array (0 to 4) of value_t;
  signal prologue_words : words_t;

  signal running : std_ulogic := '0';
  signal reset : std_ulogic;

  signal instruction_request : instruction_request_t;
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal instruction_data, memory_data, data_word : value_t := (others => '0');
  signal requests : value_t := (others => '0');
  signal requested_for : natural range 0 to clocks_to_settle := 0;
  signal settled : std_ulogic;
  signal sleeping, at_rest : std_ulogic;
  signal rested : std_ulogic := '0';
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
  signal must_trap, writes, requests_bus : std_ulogic;
  signal cause : std_ulogic_vector(4 downto 0);
  signal trap_value : value_t;
  signal expected : value_t;

  -- State of the model.
  signal first_content, second_content : value_t := (others => '0');
  signal expected_address : unsigned(31 downto 0) := x"80000000";
  signal address_known : std_ulogic := '1';
  signal word_in_memory : value_t := (others => '0');
  signal waited : natural range 0 to most_clocks_between_events + 1 := 0;
  signal due_before : std_ulogic := '0';
  -- Asleep in the previous clock; awake in it after sleep.
  signal slept, woken : std_ulogic := '0';
  signal asleep_for : natural range 0 to most_clocks_to_wake + 1 := 0;

  -- The last bus response without an event since.
  signal bus_answered : std_ulogic := '0';
  signal bus_failed, bus_wrote : std_ulogic;
  signal bus_address : unsigned(31 downto 0);
  signal bus_lanes : std_ulogic_vector(3 downto 0);
  signal bus_data, bus_written : value_t;
  signal bus_waited : natural range 0 to most_clocks_of_bus := 0;

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

  prologue_words(0) <= mask_high & x"437";
  prologue_words(1) <= mask_low & x"40413";
  prologue_words(2) <= x"30441073";
  prologue_words(3) <= x"10500073" when prologue = 2 else x"30541073";
  prologue_words(4) <= x"00000013" when prologue = 2 else x"30046073";

  -- The memory: two half words of the program are constant and known, and one word of the data. All others
  -- are unconstrained, but stable without a request.
  memory : process
  begin
    wait until rising_edge(clk);
    running <= '1';
    if instruction_request.enable then
      instruction_data <= any_instruction;
      if instruction_request.upper_address & '1' = code_place then
        instruction_data(31 downto 16) <= code_low;
      elsif instruction_request.upper_address & '1' = code_place + 1 then
        instruction_data(31 downto 16) <= code_high;
      end if;
      if instruction_request.lower_address & '0' = code_place then
        instruction_data(15 downto 0) <= code_low;
      elsif instruction_request.lower_address & '0' = code_place + 1 then
        instruction_data(15 downto 0) <= code_high;
      end if;
      for index in words_t'range loop
        if prologue /= 0 and instruction_request.upper_address = unsigned'(30x"20000000") + index then
          instruction_data(31 downto 16) <= prologue_words(index)(31 downto 16);
        end if;
        if prologue /= 0 and instruction_request.lower_address = unsigned'(30x"20000000") + index then
          instruction_data(15 downto 0) <= prologue_words(index)(15 downto 0);
        end if;
      end loop;
    end if;
    if memory_request.enable then
      memory_data <= any_data;
      if memory_request.address = data_place and memory_request.write_bytes = "0000" then
        memory_data <= data_word;
      end if;
      for lane in 0 to 3 loop
        if memory_request.address = data_place and memory_request.write_bytes(lane) = '1' then
          data_word(8 * lane + 7 downto 8 * lane) <= memory_request.data(8 * lane + 7 downto 8 * lane);
        end if;
      end loop;
    end if;
    if reset then
      data_word <= data_at_first;
    end if;
  end process;

  request_interrupts : process
  begin
    wait until rising_edge(clk);
    if interrupts_begin = '1' or requested_for > 0 then
      requests <= any_requests and x"ffff0880";
      if requested_for < clocks_to_settle then
        requested_for <= requested_for + 1;
      end if;
    end if;
    if reset then
      requests <= x"00000000";
      requested_for <= 0;
    end if;
  end process;
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
    if completed = '1' and kind = store and data_address(31 downto 2) = data_place then
      word_in_memory <= stored(word, word_in_memory, second, data_address);
    end if;
    if event then
      expected_address <= next_address;
      address_known <= return_known when kind = trap_return and completed = '1' else '1';
      due_before <= due;
    end if;

    rested <= at_rest and running;
    waited <= waited + 1 when waited <= most_clocks_between_events else waited;
    if event or sleeping then
      waited <= 0;
    end if;
    slept <= sleeping and running;
    woken <= slept and not sleeping;
    asleep_for <= 0;
    if sleeping = '1' and active /= x"00000000" then
      asleep_for <= asleep_for + 1 when asleep_for <= most_clocks_to_wake else asleep_for;
    end if;
    if reset then
      word_in_memory <= data_at_first;
      expected_address <= x"80000000";
      address_known <= '1';
      waited <= 0;
      due_before <= '0';
      slept <= '0';
      woken <= '0';
      asleep_for <= 0;
    end if;
  end process;

  watch_bus : process
  begin
    wait until rising_edge(clk);
    if event then
      bus_answered <= '0';
    end if;
    bus_waited <= 0;
    if bus_request.strobe = '1' and bus_response.acknowledge = '0' and bus_response.error = '0' and
       bus_waited < most_clocks_of_bus then
      bus_waited <= bus_waited + 1;
    end if;
    if bus_request.strobe = '1' and (bus_response.acknowledge = '1' or bus_response.error = '1') then
      bus_answered <= '1';
      bus_failed <= bus_response.error;
      bus_wrote <= bus_request.write;
      bus_address <= bus_request.address;
      bus_lanes <= bus_request.select_bytes;
      bus_data <= bus_response.data;
      bus_written <= bus_request.data;
    end if;
    if reset then
      bus_answered <= '0';
      bus_waited <= 0;
    end if;
  end process;

  expected <= std_ulogic_vector(immediate_u(word)) when kind = load_upper else
              std_ulogic_vector(address + immediate_u(word)) when kind = add_upper else
              std_ulogic_vector(link) when kind = jump or kind = jump_register else
              stand_in(word(14 downto 12), first, second) when kind = multiplication or kind = division else
              sum(word, first, operand) when word(14 downto 12) = "000" else
              shift(word, first, operand) when word(13 downto 12) = "01" else
              comparison(word, first, operand) when word(14) = '0' else
              logic(word, first, operand);

  writes <= '1' when completed = '1' and retirement.destination /= "00000" else '0';
  requests_bus <= (completed or exception) and not fetch_fault and is_access and over_bus and not misaligned;

  -- Constraints.
  only_these_registers_are_read : assume always (has_word ->
    ((not reads_first(word) or word(19 downto 15) = "00000" or word(19 downto 15) = first_register) and
     (not reads_second(word) or word(24 downto 20) = "00000" or word(24 downto 20) = second_register)));
  bus_responds_within_limit : assume always
    ((bus_request.strobe = '1' and bus_waited = most_clocks_of_bus) ->
     (bus_response.acknowledge or bus_response.error));
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

  upper_immediates_are_right : assert always
    ((writes = '1' and (kind = load_upper or kind = add_upper)) -> retirement.value = expected);
  links_are_right : assert always
    ((writes = '1' and (kind = jump or kind = jump_register)) -> retirement.value = expected);
  sums_are_right : assert always
    ((writes = '1' and kind = operation and word(14 downto 12) = "000") -> retirement.value = expected);
  shifts_are_right : assert always
    ((writes = '1' and kind = operation and word(13 downto 12) = "01") -> retirement.value = expected);
  comparisons_are_right : assert always
    ((writes = '1' and kind = operation and word(14 downto 13) = "01") -> retirement.value = expected);
  logic_is_right : assert always
    ((writes = '1' and kind = operation and word(14) = '1' and word(13 downto 12) /= "01") ->
     retirement.value = expected);
  products_and_quotients_are_right : assert always
    ((writes = '1' and (kind = multiplication or kind = division)) -> retirement.value = expected);

  loads_return_stored_data : assert always
    ((writes = '1' and kind = load and over_bus = '0' and data_address(31 downto 2) = data_place) ->
     retirement.value = loaded(word, word_in_memory, data_address));
  bus_request_is_right : assert always
    (requests_bus ->
     (bus_answered = '1' and bus_address = data_address and (bus_wrote = '1') = (kind = store) and
      bus_lanes = lanes(word, data_address) and
      (kind = load or stored(word, bus_written, second, data_address) = bus_written)));
  no_other_bus_request : assert always ((event and not requests_bus) -> not bus_answered);
  bus_loads_are_right : assert always
    ((writes = '1' and kind = load and requests_bus = '1') ->
     retirement.value = loaded(word, bus_data, data_address));

  csr_reads_are_right : assert always
    ((writes = '1' and kind = csr and csr_known = '1') -> retirement.value = csr_value);
  only_enabled_interrupts_are_taken : assert always
    (interrupted -> (permitted = '1' and active /= x"00000000"));
  pending_interrupts_are_taken : assert always
    ((event = '1' and due_before = '1' and due = '1') ->
     (interrupted = '1' or (completed = '1' and kind = wait_for_interrupt)));
  wake_up_is_bounded : assert always (asleep_for <= most_clocks_to_wake);
  wfi_waits_for_enabled_interrupt : assert always
    ((completed = '1' and kind = wait_for_interrupt) -> active /= x"00000000");
  wfi_retires_after_wake_up : assert always
    (woken -> (completed = '1' and kind = wait_for_interrupt));
  -- Clock gating relies on it: the next edge changes nothing.
  no_request_after_rest : assert always
    (rested -> (sleeping = '1' and event = '0' and instruction_request.enable = '0' and
                memory_request.enable = '0' and bus_request.strobe = '0'));
  nothing_retires_at_rest : assert always ((at_rest and running) -> event = '0');
  pipeline_never_deadlocks : assert always (waited <= most_clocks_between_events);

end architecture;
