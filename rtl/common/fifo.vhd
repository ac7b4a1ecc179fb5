-- SPDX-License-Identifier: Apache-2.0
-- First in, first out: a queue of words in block RAM, with the oldest word at the output
-- (first-word fall-through).

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity fifo is
  generic (
    -- Bits of a word.
    width : positive := 8;
    -- Words that it holds, a power of two.
    depth : positive := 16
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- Appends `write_data`. Ignored while `full`.
    write_enable : in std_ulogic;
    write_data : in std_ulogic_vector(width - 1 downto 0);
    full : out std_ulogic;
    -- `read_data` is the oldest word while `read_valid`, and stays so until it is taken by
    -- `read_enable`. A word written into the empty queue shows two clocks later.
    read_enable : in std_ulogic;
    read_data : out std_ulogic_vector(width - 1 downto 0) := (others => '0');
    read_valid : out std_ulogic := '0';
    -- Words inside, one just written included.
    level : out natural range 0 to depth := 0
  );
end entity;

architecture rtl of fifo is

  constant address_width : natural := integer(ceil(log2(real(depth))));

  subtype address_t is unsigned(address_width - 1 downto 0);
  type memory_t is array (depth - 1 downto 0) of std_ulogic_vector(width - 1 downto 0);

  signal memory : memory_t := (others => (others => '0'));
  signal write_address : address_t := (others => '0');
  signal read_address : address_t := (others => '0');
  signal next_read_address : address_t;
  signal written : std_ulogic;
  signal taken : std_ulogic;

begin

  depth_is_a_power_of_two : assert depth >= 2 and 2 ** address_width = depth severity failure;

  full <= '1' when level = depth else '0';
  written <= write_enable and not full;
  taken <= read_enable and read_valid;
  next_read_address <= read_address + 1 when taken else read_address;

  store : process
  begin
    wait until rising_edge(clk);
    if written then
      memory(to_integer(write_address)) <= write_data;
    end if;
    read_data <= memory(to_integer(next_read_address));
  end process;

  count : process
    variable level_after_take : natural range 0 to depth;
  begin
    wait until rising_edge(clk);
    level_after_take := level;
    if taken then
      level_after_take := level - 1;
    end if;
    level <= level_after_take;
    if written then
      level <= level_after_take + 1;
      write_address <= write_address + 1;
    end if;
    read_address <= next_read_address;
    -- A word written in this clock is not yet in the memory's read data.
    read_valid <= '1' when level_after_take /= 0 else '0';
    if reset then
      level <= 0;
      write_address <= (others => '0');
      read_address <= (others => '0');
      read_valid <= '0';
    end if;
  end process;

end architecture;
