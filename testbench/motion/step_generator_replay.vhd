-- SPDX-License-Identifier: Apache-2.0
-- Plays stimuli from a file to the step generator and writes every edge of its pins to another: the VHDL's
-- side of the comparison with the Verilated netlist.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;
use std.textio.all;

use work.bus_pkg.all;
use work.step_generator_registers_pkg.all;

entity step_generator_replay is
  generic (
    -- Lines of `clock kind offset value`: kind 0 writes value to the register at offset (hexadecimal);
    -- kind 1 sets the end stops to bits 7:0 of value, the emergency stop to bit 8, the start to bit 9.
    stimuli_file : string;
    -- Lines of `clock step direction`.
    edges_file : string;
    -- How long to play.
    clocks : natural
  );
end entity;

architecture simulation of step_generator_replay is

  constant period : time := 20 ns;
  constant axes : positive := 5;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal request : bus_request_t := bus_request_idle;
  signal response : bus_response_t;
  signal end_stops : std_ulogic_vector(7 downto 0) := x"00";
  signal emergency_stop : std_ulogic := '0';
  signal start : std_ulogic := '0';
  signal step : std_ulogic_vector(axes - 1 downto 0);
  signal direction : std_ulogic_vector(axes - 1 downto 0);

begin

  clk <= not clk after period / 2;

  generator : entity work.step_generator
    generic map (axes => axes)
    port map (
      clk => clk, always_clk => clk, bus_clk => clk,
      reset => reset, request => request, response => response,
      end_stops => end_stops, emergency_stop => emergency_stop, start => start, step => step,
      direction => direction, enable => open, moving => open, queue_interrupt => open,
      stop_interrupt => open);

  play : process
    file stimuli : text open read_mode is stimuli_file;
    file edges : text open write_mode is edges_file;
    variable text_line : line;
    variable next_clock : integer := -1;
    variable kind : natural;
    variable offset : std_ulogic_vector(11 downto 0);
    variable value : std_ulogic_vector(31 downto 0);
    variable last_step : std_ulogic_vector(7 downto 0) := x"00";
    variable last_direction : std_ulogic_vector(7 downto 0) := x"00";

    procedure read_stimulus is
    begin
      next_clock := -1;
      if not endfile(stimuli) then
        readline(stimuli, text_line);
        read(text_line, next_clock);
        read(text_line, kind);
        hread(text_line, offset);
        hread(text_line, value);
      end if;
    end procedure;

    procedure apply_stimulus is
    begin
      if kind = 0 then
        request <= (
          strobe => '1', write => '1', address => step_generator_address + unsigned(offset),
          select_bytes => "1111", data => value);
      else
        end_stops <= value(7 downto 0);
        emergency_stop <= value(8);
        start <= value(9);
      end if;
    end procedure;

    procedure note_pins(now_clock : natural) is
      variable new_step : std_ulogic_vector(7 downto 0) := (others => '0');
      variable new_direction : std_ulogic_vector(7 downto 0) := (others => '0');
    begin
      new_step(axes - 1 downto 0) := step;
      new_direction(axes - 1 downto 0) := direction;
      if new_step /= last_step or new_direction /= last_direction then
        write(text_line, now_clock);
        write(text_line, string'(" "));
        hwrite(text_line, new_step);
        write(text_line, string'(" "));
        hwrite(text_line, new_direction);
        writeline(edges, text_line);
      end if;
      last_step := new_step;
      last_direction := new_direction;
    end procedure;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    read_stimulus;
    for now_clock in 0 to clocks loop
      request <= bus_request_idle;
      while next_clock = now_clock loop
        apply_stimulus;
        read_stimulus;
      end loop;
      wait until falling_edge(clk);
      note_pins(now_clock);
      wait until rising_edge(clk);
    end loop;
    file_close(edges);
    finish;
  end process;

end architecture;
