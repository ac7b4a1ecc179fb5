-- SPDX-License-Identifier: Apache-2.0
-- What the step generator has refused, until software clears it: the register `errors`.

library ieee;
use ieee.std_logic_1164.all;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity error_latch is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Clears them; a segment refused in the same clock is still recorded.
    clear : in std_ulogic;
    -- Refused in this clock: a segment, a position, a setting.
    segment_refused : in refusal_t;
    position_refused : in std_ulogic;
    setting_refused : in std_ulogic;
    errors : out step_generator_errors_t := (others => '0')
  );
end entity;

architecture rtl of error_latch is
begin

  remember : process
  begin
    wait until rising_edge(clk);
    if clear then
      errors <= (others => '0');
    end if;
    if segment_refused /= refusal_none then
      errors.queue_full <= errors.queue_full or segment_refused.queue_full;
      errors.incomplete <= errors.incomplete or segment_refused.incomplete;
      errors.illegal <= errors.illegal or segment_refused.illegal;
      errors.while_stopped <= errors.while_stopped or segment_refused.while_stopped;
      errors.disabled <= errors.disabled or segment_refused.disabled;
    end if;
    if position_refused then
      errors.position <= '1';
    end if;
    if setting_refused then
      errors.settings <= '1';
    end if;
    if reset then
      errors <= (others => '0');
    end if;
  end process;

end architecture;
