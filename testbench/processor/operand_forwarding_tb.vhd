-- SPDX-License-Identifier: Apache-2.0
-- Random dependent instructions, some with late results, some stalled: each operand is its immediate, or
-- what the register would hold if every instruction wrote it at once.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;
use work.random_source_pkg.all;

entity operand_forwarding_tb is
end entity;

architecture tb of operand_forwarding_tb is

  signal clk : std_ulogic := '0';
  signal advance, executable, reads_first, reads_second, second_is_immediate : std_ulogic := '0';
  signal execute_writes, execute_late, write, forward_late_result, hazard : std_ulogic := '0';
  signal first_index, second_index, execute_destination, destination : register_index_t := "00001";
  signal immediate, execute_result, first, second : word_t := (others => '0');
  signal write_data_late, write_data_early, late_bits : word_t := (others => '0');
  signal register_write : register_write_t := (
    enable => '0', destination => "00001", data => (others => '0'));

begin

  clk <= not clk after 5 ns;

  uut : entity work.operand_forwarding
    port map (
      clk => clk,
      advance => advance,
      executable => executable,
      first_index => first_index,
      second_index => second_index,
      reads_first => reads_first,
      reads_second => reads_second,
      second_is_immediate => second_is_immediate,
      immediate => immediate,
      execute_writes => execute_writes,
      execute_destination => execute_destination,
      execute_late => execute_late,
      execute_result_late => execute_result and late_bits,
      execute_result_early => execute_result and not late_bits,
      write => write,
      destination => destination,
      write_data_late => write_data_late and late_bits,
      write_data_product => write_data_late and not late_bits,
      write_data_early => write_data_early,
      register_write => register_write,
      forward_late_result => forward_late_result,
      hazard => hazard,
      first => first,
      second => second);

  write_register : process
  begin
    wait until rising_edge(clk);
    register_write <= (
      enable => write, destination => destination, data => write_data_late or write_data_early);
  end process;

  check : process
    variable random : random_source_t;

    -- Few registers, of both halves, for many dependencies.
    impure function random_index return register_index_t is
    begin
      return std_ulogic_vector(to_unsigned(14 + random.between(0, 3), 5));
    end function;

    impure function random_word return word_t is
    begin
      return std_ulogic_vector(to_unsigned(random.between(0, 65535), 16)) &
             std_ulogic_vector(to_unsigned(random.between(0, 65535), 16));
    end function;

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    type registers_t is array (0 to 31) of word_t;
    -- Architectural state: written at once by each instruction; the same before the instruction in execute.
    variable registers, registers_before : registers_t := (others => (others => '0'));

    -- The instructions in decode, execute and write-back.
    type instruction_t is record
      first, second, destination : register_index_t;
      writes, late, is_immediate, executable : boolean;
      reads_first, reads_second : boolean;
      immediate, value : word_t;
    end record;
    variable decoded, executing, writing : instruction_t := (
      first | second | destination => "00001", immediate | value => x"00000000",
      others => false);
    variable hazards, stalls : natural := 0;

    function content(contents : registers_t; index : register_index_t) return word_t is
    begin
      return contents(to_integer(unsigned(index)));
    end function;

    impure function random_instruction return instruction_t is
      variable is_immediate : boolean;
    begin
      is_immediate := random.between(0, 2) = 0;
      return (
        first => random_index, second => random_index, destination => random_index,
        writes => random.between(0, 4) /= 0, late => random.between(0, 2) = 0, is_immediate => is_immediate,
        executable => random.between(0, 9) /= 0, reads_first => random.between(0, 7) /= 0,
        reads_second => not is_immediate and random.between(0, 7) /= 0,
        immediate => random_word, value => random_word);
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
        report "first " & to_hstring(first) & " after " & integer'image(hazards) severity failure;
      assert second = content(registers_before, executing.second) or not executing.reads_second
        report "second " & to_hstring(second) & " after " & integer'image(hazards) severity failure;
      assert not executing.is_immediate or second = executing.immediate
        report "immediate" severity failure;
    end procedure;
  begin
    for count in 1 to 50_000 loop
      decoded := random_instruction;
      first_index <= decoded.first;
      second_index <= decoded.second;
      reads_first <= '1' when decoded.reads_first else '0';
      reads_second <= '1' when decoded.reads_second else '0';
      second_is_immediate <= '1' when decoded.is_immediate else '0';
      immediate <= decoded.immediate;
      executable <= '1' when decoded.executable else '0';
      execute_writes <= '1' when executing.writes else '0';
      execute_destination <= executing.destination;
      execute_late <= '1' when executing.late else '0';
      -- A late result is not available yet.
      late_bits <= random_word;
      execute_result <= not executing.value when executing.late else executing.value;
      show_write_back(true);
      wait for 1 ns;

      if executing.executable and hazard = '1' then
        assert reads_late_result report "hazard without a late result" severity failure;
        if random.between(0, 3) = 0 then
          -- A bus access: the pipeline stalls.
          stalls := stalls + 1;
          show_write_back(false);
          for clocks in 0 to random.between(0, 2) loop
            clock;
          end loop;
          show_write_back(true);
        end if;
        hazards := hazards + 1;
        forward_late_result <= '1';
        clock;
        forward_late_result <= '0';
        writing.writes := false;
        show_write_back(true);
        wait for 1 ns;
        assert hazard = '0' severity failure;
      end if;
      if executing.executable then
        assert not reads_late_result report "missed hazard" severity failure;
        expect_operands;
      end if;
      if random.between(0, 7) = 0 then
        -- It takes several clocks, and write-back becomes empty; its operands need not stay.
        writing.writes := false;
        clock;
        show_write_back(true);
      end if;

      advance <= '1';
      clock;
      advance <= '0';
      registers_before := registers;
      if executing.writes then
        registers_before(to_integer(unsigned(executing.destination))) := executing.value;
      end if;
      registers := registers_before;
      writing := executing;
      executing := decoded;
      if not executing.executable then
        -- It traps: no side effect, and the next instruction is flushed.
        executing.writes := false;
      end if;
    end loop;
    assert hazards > 3000 and stalls > 700 report "too few hazards or stalls" severity failure;
    std.env.finish;
  end process;

end architecture;
