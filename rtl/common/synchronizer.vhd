-- SPDX-License-Identifier: Apache-2.0
-- Brings asynchronous inputs into the clock domain: a chain of flip-flops per bit.

library ieee;
use ieee.std_logic_1164.all;

entity synchronizer is
  generic (
    -- Independent bits; they are not kept together, so a multi-bit number must not pass here.
    width : positive := 1;
    -- Flip-flops in a row: the delay in clocks, and the time that a metastable first one has to settle.
    stages : positive := 2;
    -- Level of every bit until real samples have come through.
    idle_level : std_ulogic := '0'
  );
  port (
    clk : in std_ulogic;
    asynchronous : in std_ulogic_vector(width - 1 downto 0);
    synchronous : out std_ulogic_vector(width - 1 downto 0);
    -- A new level is under way to `synchronous`.
    settling : out std_ulogic
  );
end entity;

architecture rtl of synchronizer is

  subtype sample_t is std_ulogic_vector(width - 1 downto 0);
  type samples_t is array (0 to stages - 1) of sample_t;

  signal samples : samples_t := (others => (others => idle_level));

begin

  has_at_least_two_stages : assert stages >= 2 severity failure;

  sample : process
  begin
    wait until rising_edge(clk);
    samples <= asynchronous & samples(0 to stages - 2);
  end process;

  synchronous <= samples(stages - 1);

  compare : process (all)
  begin
    settling <= '0';
    for stage in 1 to stages - 1 loop
      if samples(stage) /= samples(stage - 1) then
        settling <= '1';
      end if;
    end loop;
  end process;

end architecture;
