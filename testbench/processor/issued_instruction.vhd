-- SPDX-License-Identifier: Apache-2.0
-- The decoder and the register between decode and execute, for benches of what follows it.

library ieee;
use ieee.std_logic_1164.all;

use work.processor_pkg.all;

entity issued_instruction is
  port (
    clk : in std_ulogic;
    instruction : in word_t;
    -- A clock after the instruction.
    control : out control_t;
    immediate : out word_t
  );
end entity;

architecture simulation of issued_instruction is

  signal decoded : control_t;
  signal decoded_immediate : word_t;

begin

  decoder : entity work.instruction_decoder
    generic map (has_zbb => false)
    port map (
      instruction => instruction, is_word => '1', decoded => decoded,
      immediate => decoded_immediate, first => open, second => open);

  issue : process
  begin
    wait until rising_edge(clk);
    control <= decoded;
    immediate <= decoded_immediate;
  end process;

end architecture;
