-- SPDX-License-Identifier: Apache-2.0
-- Random instructions that read each other's results, some of them late, some behind a stop: each gets
-- what registers that are written at once would hold.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.processor_pkg.all;

entity operand_reader_tb is
end entity;

architecture tb of operand_reader_tb is

  signal clk : std_ulogic := '0';
  signal read, next_writes, write, await_result : std_ulogic := '0';
  signal first_choice, second_choice : register_choice_t := (place => "00", others => "00001");
  signal next_destination, destination : register_index_t := "00001";
  signal result, write_data, last_written, first, second : word_t := (others => '0');
  signal first_is_result, second_is_result : std_ulogic;

begin

  clk <= not clk after 5 ns;

  uut : entity work.operand_reader
    port map (
      clk => clk,
      read => read,
      first_choice => first_choice,
      second_choice => second_choice,
      next_writes => next_writes,
      next_destination => next_destination,
      result => result,
      write => write,
      destination => destination,
      write_data => write_data,
      await_result => await_result,
      last_written => last_written,
      first => first,
      first_is_result => first_is_result,
      second => second,
      second_is_result => second_is_result);

  check : process
    variable seed_1, seed_2 : positive := 7;

    impure function random(bound : positive) return natural is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      return integer(floor(value * real(bound)));
    end function;

    -- Few registers, of both halves, so that the same are read and written again and again.
    impure function random_index return register_index_t is
    begin
      return std_ulogic_vector(to_unsigned(14 + random(4), 5));
    end function;

    -- The register in one of its places, and whatever in the others.
    impure function random_place(index : register_index_t) return register_choice_t is
      variable choice : register_choice_t;
    begin
      choice := (place => "00", short => random_index, long => random_index, implied => random_index,
                 of_word => random_index);
      case random(4) is
        when 0 => choice.short := index;
        when 1 =>
          choice.place := "01";
          choice.long := index;
        when 2 =>
          choice.place := "10";
          choice.implied := index;
        when others =>
          choice.place := "11";
          choice.of_word := index;
      end case;
      return choice;
    end function;

    impure function random_word return word_t is
    begin
      return std_ulogic_vector(to_unsigned(random(65536), 16)) &
             std_ulogic_vector(to_unsigned(random(65536), 16));
    end function;

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    type registers_t is array (0 to 31) of word_t;
    variable registers : registers_t := (others => (others => '0'));
    -- Of the instruction in execute: what it reads, its result, when this comes.
    variable reads_first, reads_second : register_index_t;
    variable value : word_t;
    variable late, late_before : boolean := false;
    variable waited, stopped : natural := 0;

    procedure expect_operands is
    begin
      assert first = registers(to_integer(unsigned(reads_first))) and
        second = registers(to_integer(unsigned(reads_second)))
        report to_hstring(first) & " and " & to_hstring(second) & " after " & integer'image(waited) &
          " late results" severity failure;
    end procedure;
  begin
    for count in 1 to 50_000 loop
      -- The next instruction is decoded while the one before, whatever it writes, leaves execute.
      reads_first := random_index;
      reads_second := random_index;
      first_choice <= random_place(reads_first);
      second_choice <= random_place(reads_second);
      read <= '1';
      clock;
      read <= '0';
      first_choice <= random_place(random_index);
      second_choice <= random_place(random_index);

      -- The one before is in write back now.
      write <= next_writes;
      destination <= next_destination;
      write_data <= value;
      result <= not value when late else value;
      if next_writes then
        registers(to_integer(unsigned(next_destination))) := value;
      end if;
      late_before := late and next_writes = '1';
      wait for 1 ns;

      if random(8) = 0 and write = '1' then
        -- It ends only later, and all stand still for it.
        write <= '0';
        stopped := stopped + 1;
        for clocks in 0 to random(3) loop
          clock;
        end loop;
        write <= '1';
        wait for 1 ns;
      end if;

      if late_before and (first_is_result = '1' or second_is_result = '1') then
        waited := waited + 1;
        await_result <= '1';
        result <= last_written;
        wait for 1 ns;
        -- The register that has `result` takes what was written last with this clock.
        value := last_written;
        clock;
        await_result <= '0';
        write <= '0';
        result <= value;
        wait for 1 ns;
      end if;
      expect_operands;

      value := random_word;
      late := random(3) = 0;
      next_writes <= '0' when random(5) = 0 else '1';
      next_destination <= random_index;
    end loop;
    assert waited > 5000 and stopped > 2000 report "too few of both" severity failure;
    std.env.finish;
  end process;

end architecture;
