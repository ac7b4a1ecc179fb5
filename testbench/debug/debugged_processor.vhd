-- SPDX-License-Identifier: Apache-2.0
-- Processor, memory and debug port with JTAG pins; what must hold whatever a debugger does is watched.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.jtag_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity debugged_processor is
  port (
    jtag : inout jtag_t;
    reset : in std_ulogic;
    -- The processor alone is held in reset.
    hold : in std_ulogic;
    timer_interrupt : in std_ulogic := '0';
    -- The debugger accesses memory only: each round of the program's loop must take the same time.
    memory_only : in boolean := false;
    -- How many of them there were.
    rounds : out natural;
    -- The program is left to itself, but for halts: its numbers come one after the other.
    undisturbed : in boolean := false
  );
end entity;

architecture tb of debugged_processor is

  signal clk : std_ulogic := '0';
  signal chip_reset, processor_reset : std_ulogic := '1';
  signal to_processor : debug_request_t;
  signal from_processor : debug_response_t;
  signal instruction_request : instruction_request_t;
  signal instruction_word, data_word : word_t;
  signal processor_memory_request, memory_request : memory_request_t;
  signal processor_bus_request, bus_request : bus_request_t;
  signal processor_bus_response, bus_response : bus_response_t := bus_response_idle;
  signal bus_word : word_t := x"00000000";

begin

  jtag.tck <= 'Z';
  jtag.tms <= 'Z';
  jtag.tdi <= 'Z';

  clk <= not clk after 5 ns;
  processor_reset <= reset or hold or chip_reset;

  uut : entity work.debug_port
    port map (
      clk => clk, reset => reset, tck => jtag.tck, tms => jtag.tms, tdi => jtag.tdi, tdo => jtag.tdo,
      chip_reset => chip_reset, processor_reset => processor_reset,
      debug_request => to_processor, debug_response => from_processor,
      processor_memory_request => processor_memory_request, memory_request => memory_request,
      memory_data => data_word,
      processor_bus_request => processor_bus_request,
      processor_bus_response => processor_bus_response,
      bus_request => bus_request, bus_response => bus_response);

  processor : entity work.processor
    port map (
      clk => clk, always_clk => clk, reset => processor_reset,
      instruction_request => instruction_request, instruction_data => instruction_word,
      memory_request => processor_memory_request, memory_data => data_word,
      bus_request => processor_bus_request, bus_response => processor_bus_response,
      timer_interrupt => timer_interrupt, external_interrupt => '0', interrupts => x"0000",
      sleeping => open, at_rest => open, retired => open, retirement => open,
      debug_request => to_processor, debug_response => from_processor);

  memory : entity work.memory
    port map (
      clk => clk, instruction_request => instruction_request, instruction_data => instruction_word,
      data_request => memory_request, data => data_word);

  -- One word on the bus; all other addresses are refused.
  peripheral : process
  begin
    wait until rising_edge(clk);
    bus_response <= bus_response_idle;
    if bus_request.strobe and not (bus_response.acknowledge or bus_response.error) then
      if bus_request.address = x"f0000000" then
        bus_response.acknowledge <= '1';
        bus_response.data <= bus_word;
        if bus_request.write then
          bus_word <= bus_request.data;
        end if;
      else
        bus_response.error <= '1';
      end if;
    end if;
  end process;

  -- Between two accesses on the bus the strobe is low, whose ever they are.
  watch_bus : process
    variable answered : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    strobe_falls_behind_an_answer : assert not (answered = '1' and bus_request.strobe = '1')
      severity failure;
    answered := bus_request.strobe and (bus_response.acknowledge or bus_response.error);
  end process;

  -- Memory accesses cost the program no clock.
  watch_times : process
    variable strobe_before : std_ulogic := '0';
    variable since, period, rounds_seen : natural := 0;
  begin
    wait until rising_edge(clk);
    since := since + 1;
    if processor_bus_request.strobe = '1' and strobe_before = '0' and
      processor_bus_request.write = '1' then
      if memory_only then
        each_round_takes_the_same_time : assert period = 0 or since = period severity failure;
        period := since;
        rounds_seen := rounds_seen + 1;
        rounds <= rounds_seen;
      else
        period := 0;
      end if;
      since := 0;
    end if;
    strobe_before := processor_bus_request.strobe;
  end process;

  -- Halts lose and repeat nothing.
  watch_numbers : process
    variable strobe_before : std_ulogic := '0';
    variable number, last_number : natural := 0;
  begin
    wait until rising_edge(clk);
    if processor_bus_request.strobe = '1' and strobe_before = '0' and
      processor_bus_request.write = '1' then
      number := to_integer(unsigned(processor_bus_request.data));
      numbers_follow_each_other : assert not undisturbed or number = last_number + 1
        severity failure;
      last_number := number;
    end if;
    strobe_before := processor_bus_request.strobe;
  end process;

end architecture;
