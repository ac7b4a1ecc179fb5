-- SPDX-License-Identifier: Apache-2.0
-- The highest-priority interrupt of those requested and enabled is selected, in the next clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.machine_mode_pkg.all;

entity interrupt_control_proof is
  port (
    clk : in std_ulogic;
    requested : in value_t;
    enabled : in value_t
  );
end entity;

architecture proof of interrupt_control_proof is

  signal pending : std_ulogic;
  signal cause : std_ulogic_vector(4 downto 0);
  signal started : std_ulogic := '0';
  signal requested_before, enabled_before : value_t;

  default clock is rising_edge(clk);

begin

  interrupt_control : entity work.interrupt_control
    port map (
      clk => clk, requested => requested, enabled => enabled, pending => pending, cause => cause);

  remember : process
  begin
    wait until rising_edge(clk);
    started <= '1';
    requested_before <= requested;
    enabled_before <= enabled;
  end process;

  only_existing_interrupts_are_enabled : assume always ((enabled and not x"ffff0880") = x"00000000");

  pending_follows_enabled_request : assert always
    (started -> (pending = '1') = ((requested_before and enabled_before) /= x"00000000"));
  cause_has_highest_priority : assert always
    ((started and pending) ->
     to_integer(unsigned(cause)) = first_of(requested_before and enabled_before));

end architecture;
