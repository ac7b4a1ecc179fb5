-- SPDX-License-Identifier: Apache-2.0
-- Machine timer: 64-bit clock counter and compare register (mtime, mtimecmp).

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.timer_registers_pkg.all;

entity timer is
  port (
    clk : in std_ulogic;
    -- The same clock for registers and interrupt; may be gated while no access is made and `alarm` is low.
    bus_clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    -- Level: the deadline has been reached and no later one has been set.
    timer_interrupt : out std_ulogic;
    -- The next edge of bus_clk changes the interrupt.
    alarm : out std_ulogic
  );
end entity;

architecture rtl of timer is

  signal from_software : timer_from_software_t;
  signal to_software : timer_to_software_t;

  signal now_cycles : unsigned(63 downto 0) := (others => '0');
  signal next_cycles : unsigned(63 downto 0);
  -- The value that software reads: equal to `now_cycles` in every clock that follows an edge of `bus_clk`.
  -- Logic clocked by `bus_clk` has no input that changes in every clock:
  -- a simulation would evaluate all of it.
  signal seen_cycles : unsigned(63 downto 0) := (others => '0');
  signal due : std_ulogic;
  -- High half of `seen_cycles` in the previous clock, in which the read value was sampled.
  signal earlier_high : unsigned(31 downto 0) := (others => '0');
  signal deadline_cycles : unsigned(63 downto 0) := (others => '1');
  signal reached : std_ulogic := '0';

begin

  registers : entity work.timer_registers
    port map (
      clk => bus_clk,
      reset => reset,
      request => request,
      response => response,
      from_software => from_software,
      to_software => to_software
    );

  to_software.time_low.cycles <= seen_cycles(31 downto 0);
  to_software.compare_high.cycles <= deadline_cycles(63 downto 32);
  -- Cleared combinationally in the clock of the acknowledge, so that no interrupt is taken twice.
  timer_interrupt <= reached and not from_software.compare_high_written;

  next_cycles <= now_cycles + 1;
  due <= '1' when now_cycles >= deadline_cycles else '0';
  alarm <= due xor reached;

  keep_time : process
  begin
    wait until rising_edge(clk);
    now_cycles <= next_cycles;
    if reset then
      now_cycles <= (others => '0');
    end if;
  end process;

  serve_software : process
  begin
    wait until rising_edge(bus_clk);
    seen_cycles <= next_cycles;
    earlier_high <= seen_cycles(63 downto 32);
    reached <= due;
    if from_software.time_low_read then
      to_software.time_high.cycles <= earlier_high;
    end if;
    if from_software.compare_high_written then
      deadline_cycles <= from_software.compare_high.cycles & from_software.compare_low.cycles;
      reached <= '0';
    end if;
    if reset then
      seen_cycles <= (others => '0');
      earlier_high <= (others => '0');
      deadline_cycles <= (others => '1');
      reached <= '0';
      to_software.time_high.cycles <= (others => '0');
    end if;
  end process;

end architecture;
