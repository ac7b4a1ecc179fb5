-- SPDX-License-Identifier: Apache-2.0
-- The processor sleeps in wfi only as long as it must, requests nothing at rest, and never stands still.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;

entity sleep_checks is
  port (
    clk : in std_ulogic;
    running : in std_ulogic;
    -- A retirement or trap; a retirement; that of a wfi.
    event, completed : in std_ulogic;
    kind : in kind_t;
    sleeping, at_rest : in std_ulogic;
    -- Interrupts that are requested and enabled in mie.
    active : in value_t;
    -- A request to memory or bus.
    requesting : in std_ulogic
  );
end entity;

architecture proof of sleep_checks is

  -- Upper bound of clocks between two events while the processor does not sleep: a bus access with a
  -- load-use hazard, or a trap by it, takes longest.
  constant most_clocks_between_events : positive := 10;
  -- Upper bound of clocks that wfi sleeps with an enabled request: one to sample it, and one until
  -- `csr_model` sees a write of mie.
  constant most_clocks_to_wake : positive := 2;

  signal rested : std_ulogic := '0';
  signal waited : natural range 0 to most_clocks_between_events + 1 := 0;
  -- Asleep in the previous clock; awake in it after sleep.
  signal slept, woken : std_ulogic := '0';
  signal asleep_for : natural range 0 to most_clocks_to_wake + 1 := 0;

  default clock is rising_edge(clk);

begin

  follow : process
  begin
    wait until rising_edge(clk);
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
    if not running then
      waited <= 0;
      slept <= '0';
      woken <= '0';
      asleep_for <= 0;
    end if;
  end process;

  wake_up_is_bounded : assert always (asleep_for <= most_clocks_to_wake);
  wfi_waits_for_enabled_interrupt : assert always
    ((completed = '1' and kind = wait_for_interrupt) -> active /= x"00000000");
  wfi_retires_after_wake_up : assert always
    (woken -> (completed = '1' and kind = wait_for_interrupt));
  -- Clock gating relies on it: the next edge changes nothing.
  no_request_after_rest : assert always
    (rested -> (sleeping = '1' and event = '0' and requesting = '0'));
  nothing_retires_at_rest : assert always ((at_rest and running) -> event = '0');
  pipeline_never_deadlocks : assert always (waited <= most_clocks_between_events);

end architecture;
