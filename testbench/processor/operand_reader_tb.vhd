-- SPDX-License-Identifier: Apache-2.0
-- Random instructions that read each other's results, some of them late, some behind a stop: each gets its
-- constant, or what registers that are written at once would hold.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.processor_pkg.all;

entity operand_reader_tb is
end entity;

architecture tb of operand_reader_tb is

  signal clk : std_ulogic := '0';
  signal read, is_able, reads_first, reads_second, second_is_constant : std_ulogic := '0';
  signal next_writes, next_is_late, write, await_result, awaits : std_ulogic := '0';
  signal first_index, second_index, next_destination, destination : register_index_t := "00001";
  signal constant_operand, next_result, first, second : word_t := (others => '0');
  signal write_data_late, write_data_early : word_t := (others => '0');

begin

  clk <= not clk after 5 ns;

  uut : entity work.operand_reader
    port map (
      clk => clk,
      read => read,
      is_able => is_able,
      first_index => first_index,
      second_index => second_index,
      reads_first => reads_first,
      reads_second => reads_second,
      second_is_constant => second_is_constant,
      constant_operand => constant_operand,
      next_writes => next_writes,
      next_destination => next_destination,
      next_is_late => next_is_late,
      next_result => next_result,
      write => write,
      destination => destination,
      write_data => write_data_late or write_data_early,
      write_data_late => write_data_late,
      write_data_early => write_data_early,
      await_result => await_result,
      awaits => awaits,
      first => first,
      second => second);

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
    -- With each instruction at once what it writes; as they were before the one in execute.
    variable registers, registers_before : registers_t := (others => (others => '0'));

    -- One after the other: an instruction is decoded, while the one before is in execute.
    type instruction_t is record
      first, second, destination : register_index_t;
      writes, late, is_constant, able : boolean;
      reads_first, reads_second : boolean;
      constant_operand, value : word_t;
    end record;
    variable decoded, executing, writing : instruction_t := (
      first | second | destination => "00001", constant_operand | value => x"00000000",
      others => false);
    variable awaited, stopped : natural := 0;

    function content(contents : registers_t; index : register_index_t) return word_t is
    begin
      return contents(to_integer(unsigned(index)));
    end function;

    impure function random_instruction return instruction_t is
      variable is_constant : boolean;
    begin
      is_constant := random(3) = 0;
      return (
        first => random_index, second => random_index, destination => random_index,
        writes => random(5) /= 0, late => random(3) = 0, is_constant => is_constant,
        able => random(10) /= 0, reads_first => random(8) /= 0,
        reads_second => not is_constant and random(8) /= 0,
        constant_operand => random_word, value => random_word);
    end function;

    procedure show_write_back(shown : boolean) is
    begin
      write <= '1' when shown and writing.writes else '0';
      destination <= writing.destination;
      write_data_late <= writing.value when writing.late else x"00000000";
      write_data_early <= x"00000000" when writing.late else writing.value;
    end procedure;

    impure function reads_late_result return boolean is
    begin
      return writing.writes and writing.late and
        ((executing.reads_first and executing.first = writing.destination) or
         (executing.reads_second and executing.second = writing.destination));
    end function;

    procedure expect_operands is
    begin
      assert first = content(registers_before, executing.first) or not executing.reads_first
        report "first " & to_hstring(first) & " after " & integer'image(awaited) severity failure;
      assert second = content(registers_before, executing.second) or not executing.reads_second
        report "second " & to_hstring(second) & " after " & integer'image(awaited) severity failure;
      assert not executing.is_constant or second = executing.constant_operand
        report "a constant" severity failure;
    end procedure;
  begin
    for count in 1 to 50_000 loop
      decoded := random_instruction;
      first_index <= decoded.first;
      second_index <= decoded.second;
      reads_first <= '1' when decoded.reads_first else '0';
      reads_second <= '1' when decoded.reads_second else '0';
      second_is_constant <= '1' when decoded.is_constant else '0';
      constant_operand <= decoded.constant_operand;
      is_able <= '1' when decoded.able else '0';
      next_writes <= '1' when executing.writes else '0';
      next_destination <= executing.destination;
      next_is_late <= '1' when executing.late else '0';
      -- What comes late is not there yet.
      next_result <= not executing.value when executing.late else executing.value;
      show_write_back(true);
      wait for 1 ns;

      if executing.able and awaits = '1' then
        assert reads_late_result report "waits for nothing" severity failure;
        if random(4) = 0 then
          -- It ends only later, and all stand still for it.
          stopped := stopped + 1;
          show_write_back(false);
          for clocks in 0 to random(3) loop
            clock;
          end loop;
          show_write_back(true);
        end if;
        awaited := awaited + 1;
        await_result <= '1';
        clock;
        await_result <= '0';
        writing.writes := false;
        show_write_back(true);
        wait for 1 ns;
        assert awaits = '0' severity failure;
      end if;
      if executing.able then
        assert not reads_late_result report "does not wait" severity failure;
        expect_operands;
      end if;
      if random(8) = 0 then
        -- It takes some clocks, in which write back gets empty; its operands need not stay, its result
        -- comes then.
        writing.writes := false;
        clock;
        show_write_back(true);
      end if;

      read <= '1';
      clock;
      read <= '0';
      registers_before := registers;
      if executing.writes then
        registers_before(to_integer(unsigned(executing.destination))) := executing.value;
      end if;
      registers := registers_before;
      writing := executing;
      executing := decoded;
      if not executing.able then
        -- It traps: nothing of it happens, and the next one is none.
        executing.writes := false;
      end if;
    end loop;
    assert awaited > 3000 and stopped > 700 report "too few of both" severity failure;
    std.env.finish;
  end process;

end architecture;
