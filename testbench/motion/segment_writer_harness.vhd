-- SPDX-License-Identifier: Apache-2.0
-- A segment_writer with its clock, for its benches.

library ieee;
use ieee.std_logic_1164.all;

use work.segment_writer_harness_pkg.all;

entity segment_writer_harness is
  port (
    clk : out std_ulogic := '0';
    inputs : in segment_writer_inputs_t;
    outputs : out segment_writer_outputs_t
  );
end entity;

architecture simulation of segment_writer_harness is
begin

  clk <= not clk after 10 ns;

  writer : entity work.segment_writer
    generic map (axes => axes)
    port map (
      clk => clk, reset => inputs.reset, write => inputs.write, commit => inputs.commit,
      flush => inputs.flush, queue_full => inputs.queue_full, stopped => inputs.stopped,
      enabled => inputs.enabled, accepted => outputs.accepted, refused => outputs.refused);

end architecture;
