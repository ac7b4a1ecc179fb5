-- SPDX-License-Identifier: Apache-2.0
-- The queue of received bytes against a list: bytes come and are taken at random times, also both in one
-- clock, and its interrupt is there a clock after a reason, and only then.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity receive_queue_tb is
end entity;

architecture simulation of receive_queue_tb is

  constant clock_period : time := 10 ns;
  constant depth : positive := 8;
  constant clocks : positive := 60_000;

  subtype word_t is std_ulogic_vector(8 downto 0);
  type list_t is array (0 to depth - 1) of word_t;
  type flags_t is array (0 to depth - 1) of boolean;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal write_enable, read_enable, wake_on_line : std_ulogic := '0';
  signal write_data, read_data : word_t := (others => '0');
  signal full, read_valid, line_waits, interrupt : std_ulogic;
  signal level : natural range 0 to depth;
  signal first_line_end : std_ulogic_vector(7 downto 0) := x"0A";
  signal second_line_end : std_ulogic_vector(7 downto 0) := x"0D";
  signal threshold : unsigned(11 downto 0) := (others => '0');

begin

  clk <= not clk after clock_period / 2;

  queue : entity work.receive_queue
    generic map (depth => depth)
    port map (
      clk => clk, reset => reset, write_enable => write_enable, write_data => write_data, full => full,
      read_enable => read_enable, read_data => read_data, read_valid => read_valid, level => level,
      first_line_end => first_line_end, second_line_end => second_line_end, line_waits => line_waits,
      threshold => threshold, wake_on_line => wake_on_line, interrupt => interrupt);

  check : process
    variable seed_1, seed_2 : positive := 7;
    variable waiting : list_t;
    variable ends_line : flags_t;
    variable count : natural range 0 to depth := 0;
    variable wanted_interrupt : boolean := false;
    -- How often it came to what the bench is for.
    variable taken_while_one_comes, lost, wakes, sleeps : natural := 0;
    variable write_share, read_share : real := 0.5;
    variable was_taken, was_written : boolean;
    variable line_is_there : boolean;

    impure function chance (share : real) return boolean is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      return value < share;
    end function;

    impure function any_byte return std_ulogic_vector is
      variable value : real;
    begin
      uniform(seed_1, seed_2, value);
      if value < 0.1 then
        return first_line_end;
      elsif value < 0.2 then
        return second_line_end;
      end if;
      return std_ulogic_vector(to_unsigned(integer(floor(value * 256.0)), 8));
    end function;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    for i in 1 to clocks loop
      if i mod 200 = 0 then
        uniform(seed_1, seed_2, write_share);
        uniform(seed_1, seed_2, read_share);
        threshold <= to_unsigned(i / 200 mod (depth + 2), 12);
        wake_on_line <= '1' when i / 2000 mod 3 /= 0 else '0';
        -- Other line ends, while the queue holds bytes that came under the old ones.
        first_line_end <= x"0A" when chance(0.5) else x"41";
        second_line_end <= x"0D" when chance(0.5) else x"0A";
      end if;
      reset <= '1' when i mod 10_000 = 9_999 else '0';
      write_enable <= '1' when chance(write_share) else '0';
      write_data <= '0' & any_byte;
      read_enable <= '1' when chance(read_share) else '0';
      wait until falling_edge(clk);

      the_level_is_that_of_the_list : assert level = count report to_string(level) severity error;
      line_is_there := false;
      for n in 0 to count - 1 loop
        line_is_there := line_is_there or ends_line(n);
      end loop;
      a_line_waits_with_its_end : assert (line_waits = '1') = line_is_there
        report "line_waits at level " & to_string(level) severity error;
      the_interrupt_is_that_of_the_clock_before : assert (interrupt = '1') = wanted_interrupt
        report "interrupt " & to_string(interrupt) severity error;
      wanted_interrupt := reset = '0' and ((threshold /= 0 and count >= threshold) or
        (wake_on_line = '1' and line_is_there));

      was_taken := read_enable = '1' and read_valid = '1';
      was_written := write_enable = '1' and count < depth;
      if write_enable = '1' and count = depth then
        lost := lost + 1;
      end if;
      if was_taken then
        gives_the_oldest : assert count /= 0 and read_data = waiting(0)
          report to_hstring(read_data) severity error;
        if ends_line(0) and was_written then
          taken_while_one_comes := taken_while_one_comes + 1;
        end if;
        waiting(0 to depth - 2) := waiting(1 to depth - 1);
        ends_line(0 to depth - 2) := ends_line(1 to depth - 1);
        count := count - 1;
      end if;
      if was_written then
        waiting(count) := write_data;
        ends_line(count) := write_data(7 downto 0) = first_line_end or
          write_data(7 downto 0) = second_line_end;
        count := count + 1;
      end if;
      if reset = '1' then
        count := 0;
      end if;
      if wanted_interrupt then
        wakes := wakes + 1;
      else
        sleeps := sleeps + 1;
      end if;
      wait until rising_edge(clk);
    end loop;
    it_came_to_everything : assert taken_while_one_comes > 100 and lost > 100 and wakes > 1000
      and sleeps > 1000
      report to_string(taken_while_one_comes) & " " & to_string(lost) & " " & to_string(wakes) & " "
        & to_string(sleeps) severity error;
    std.env.finish;
  end process;

end architecture;
