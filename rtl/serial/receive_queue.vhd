-- SPDX-License-Identifier: Apache-2.0
-- Received bytes in their order, and when software wants to be woken for them: many bytes, or a whole line.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity receive_queue is
  generic (
    -- Bytes, a power of two, at most 2048.
    depth : positive := 2048
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Appends `write_data`; bit 8 goes with the byte. Ignored while `full`.
    write_enable : in std_ulogic;
    write_data : in std_ulogic_vector(8 downto 0);
    full : out std_ulogic;
    -- As those of `fifo`.
    read_enable : in std_ulogic;
    read_data : out std_ulogic_vector(8 downto 0);
    read_valid : out std_ulogic;
    level : out natural range 0 to depth;
    -- The bytes that end a line; each byte is classified on arrival.
    first_line_end : in std_ulogic_vector(7 downto 0);
    second_line_end : in std_ulogic_vector(7 downto 0);
    -- A byte that ends a line is in the queue.
    line_waits : out std_ulogic;
    -- Level, a clock later: at least `threshold` bytes wait, if that is not 0, or a line does.
    threshold : in unsigned(11 downto 0);
    wake_on_line : in std_ulogic;
    interrupt : out std_ulogic := '0'
  );
end entity;

architecture rtl of receive_queue is

  signal ends_line, written, taken : std_ulogic;
  -- Bytes to be read until no line end is left in the queue; the last of them is the newest line
  -- end. So the memory needs no marks.
  signal to_last_line_end : natural range 0 to depth := 0;

begin

  bytes : entity work.fifo
    generic map (width => 9, depth => depth)
    port map (
      clk => clk,
      reset => reset,
      write_enable => write_enable,
      write_data => write_data,
      full => full,
      read_enable => read_enable,
      read_data => read_data,
      read_valid => read_valid,
      level => level
    );

  ends_line <= '1' when write_data(7 downto 0) = first_line_end or
    write_data(7 downto 0) = second_line_end else '0';
  written <= write_enable and not full;
  taken <= read_enable and read_valid;
  line_waits <= '1' when to_last_line_end /= 0 else '0';

  follow_line_ends : process
    variable level_after_take : natural range 0 to depth;
  begin
    wait until rising_edge(clk);
    level_after_take := level;
    if taken then
      level_after_take := level - 1;
      if to_last_line_end /= 0 then
        to_last_line_end <= to_last_line_end - 1;
      end if;
    end if;
    if written and ends_line then
      to_last_line_end <= level_after_take + 1;
    end if;
    if reset then
      to_last_line_end <= 0;
    end if;
  end process;

  wake_software : process
  begin
    wait until rising_edge(clk);
    interrupt <= '1' when (threshold /= 0 and level >= threshold)
      or (wake_on_line = '1' and line_waits = '1') else '0';
    if reset then
      interrupt <= '0';
    end if;
  end process;

end architecture;
