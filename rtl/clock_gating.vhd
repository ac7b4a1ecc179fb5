-- SPDX-License-Identifier: Apache-2.0
-- The resets of all clocks, and the wake-up logic: which clocks may be gated now.

library ieee;
use ieee.std_logic_1164.all;

use work.clocks_pkg.all;

entity clock_gating is
  generic (
    -- A debugger may connect at any time: the processor's clock is never gated.
    has_debug : boolean := false
  );
  port (
    clocks : in clocks_t;
    -- The chip's pin; the debugger resets the chip.
    reset : in std_ulogic;
    chip_reset : in std_ulogic;
    -- The processor sleeps; its timer wakes it with the next edge.
    processor_rests : in std_ulogic;
    timer_alarm : in std_ulogic;
    -- An access to the registers.
    bus_strobe : in std_ulogic;
    -- All blocks with this clock are at rest.
    axes_rest : in std_ulogic;
    peripherals_rest : in std_ulogic;
    resets : out resets_t := (others => '1');
    at_rest : out clocks_at_rest_t
  );
end entity;

architecture rtl of clock_gating is
begin

  reset_free_running : process
  begin
    wait until rising_edge(clocks.free_running);
    resets.free_running <= reset or chip_reset;
  end process;

  reset_processor : process
  begin
    wait until rising_edge(clocks.processor);
    resets.processor <= reset or chip_reset;
  end process;

  reset_axes : process
  begin
    wait until rising_edge(clocks.axes);
    resets.axes <= reset or chip_reset;
  end process;

  reset_peripherals : process
  begin
    wait until rising_edge(clocks.peripherals);
    resets.peripherals <= reset or chip_reset;
  end process;

  at_rest.processor <= processor_rests and not (timer_alarm or resets.processor) when not has_debug else '0';
  at_rest.axes <= axes_rest and not chip_reset;
  at_rest.peripherals <= peripherals_rest and not chip_reset;

  -- All activity that an access starts, in the registers and in what watches accesses, has ended
  -- after this many clocks.
  watch_bus : entity work.rest_watch
    generic map (settling_clocks => 6)
    port map (
      clk => clocks.registers,
      bus_clk => clocks.registers,
      reset => resets.processor,
      strobe => bus_strobe,
      working => '0',
      alarm => bus_strobe,
      at_rest => at_rest.registers);

end architecture;
