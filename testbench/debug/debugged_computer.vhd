-- SPDX-License-Identifier: Apache-2.0
-- The computer with its JTAG pins and a peripheral; what must hold whatever a debugger does is watched.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.jtag_pkg.all;
use work.processor_pkg.all;

entity debugged_computer is
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

architecture tb of debugged_computer is

  signal clk : std_ulogic := '0';
  signal chip_reset, computer_reset : std_ulogic := '1';
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;
  signal bus_word : word_t := x"00000000";

begin

  jtag.tck <= 'Z';
  jtag.tms <= 'Z';
  jtag.tdi <= 'Z';

  clk <= not clk after 5 ns;
  computer_reset <= reset or hold or chip_reset;

  uut : entity work.computer
    generic map (memory_size_bytes => 65536, has_debug => true)
    port map (
      clk => clk, always_clk => clk, external_reset => reset, reset => computer_reset,
      chip_reset => chip_reset, bus_request => bus_request, bus_response => bus_response,
      timer_interrupt => timer_interrupt, interrupts => x"0000",
      tck => jtag.tck, tms => jtag.tms, tdi => jtag.tdi, tdo => jtag.tdo,
      sleeping => open, retired => open, at_rest => open);

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

  -- What the processor is answered is the answer to its own access.
  watch_answers : process
    alias request is << signal uut.processor_bus_request : bus_request_t >>;
    alias response is << signal uut.processor_bus_response : bus_response_t >>;
  begin
    wait until rising_edge(clk);
    if (response.acknowledge or response.error) and request.strobe then
      the_answered_access_is_the_processor_s : assert
        bus_request.strobe = '1' and bus_request.write = request.write and
        bus_request.address = request.address and
        (request.write = '0' or bus_request.data = request.data)
        severity failure;
    end if;
  end process;

  -- Memory accesses cost the program no clock.
  watch_times : process
    alias request is << signal uut.processor_bus_request : bus_request_t >>;
    variable strobe_before : std_ulogic := '0';
    variable since, period, rounds_seen : natural := 0;
  begin
    wait until rising_edge(clk);
    since := since + 1;
    if request.strobe = '1' and strobe_before = '0' and
      request.write = '1' then
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
    strobe_before := request.strobe;
  end process;

  -- Halts lose and repeat nothing.
  watch_numbers : process
    alias request is << signal uut.processor_bus_request : bus_request_t >>;
    variable strobe_before : std_ulogic := '0';
    variable number, last_number : natural := 0;
  begin
    wait until rising_edge(clk);
    if request.strobe = '1' and strobe_before = '0' and
      request.write = '1' then
      number := to_integer(unsigned(request.data));
      numbers_follow_each_other : assert not undisturbed or number = last_number + 1
        severity failure;
      last_number := number;
    end if;
    strobe_before := request.strobe;
  end process;

end architecture;
