-- SPDX-License-Identifier: Apache-2.0
-- Runs a program on the processor with its memory and writes a line for each retired instruction or
-- exception, with its clock: for tests/processor/compare_with_ghdl.sh, which compares it with the netlist.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use std.textio.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity processor_trace is
  generic (
    -- Image of the memory, in bytes; output file.
    program_file : string := "program.bin";
    trace_file : string := "trace.txt";
    -- Offset of the program's `tohost` in the memory, in bytes.
    tohost_offset : natural := 0;
    has_zbb : boolean := false
  );
end entity;

architecture tb of processor_trace is

  constant memory_words : positive := 16384;
  constant device_address : unsigned(31 downto 0) := x"f0000000";
  constant request_address : unsigned(31 downto 0) := x"f0000100";
  constant writable_requests : word_t := x"ffff0880";
  -- Value that the program stores in the device's first word before it sleeps, the request that wakes it
  -- up, and after how many clocks.
  constant wake_word : word_t := x"00051ee9";
  constant wake_request : natural := 20;
  constant wake_after_cycles : positive := 49;
  constant clocks_behind_the_end : positive := 10;
  constant most_clocks : positive := 2_000_000;

  type words_t is array (natural range <>) of word_t;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal loading : std_ulogic := '1';
  signal instruction_request : instruction_request_t;
  signal instruction_data, data : word_t;
  signal processor_request, memory_request : memory_request_t;
  signal load_request : memory_request_t := memory_request_idle;
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;
  signal requests : word_t := (others => '0');
  signal sleeping : std_ulogic;
  signal retirement : retirement_t;
  signal device_words : words_t(0 to 63) := (others => (others => '0'));

begin

  clk <= not clk after 5 ns;
  memory_request <= load_request when loading else processor_request;

  processor : entity work.processor
    generic map (has_zbb => has_zbb)
    port map (
      clk => clk,
      always_clk => clk,
      reset => reset,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      memory_request => processor_request,
      memory_data => data,
      bus_request => bus_request,
      bus_response => bus_response,
      timer_interrupt => requests(7),
      external_interrupt => requests(11),
      interrupts => requests(31 downto 16),
      sleeping => sleeping,
      retired => open,
      retirement => retirement);

  memory : entity work.memory
    port map (
      clk => clk,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      data_request => memory_request,
      data => data);

  -- As tests/processor/test_device.hpp: read-write words and a request register.
  answer_on_bus : process
    variable index : natural range 0 to 63;
    variable asleep : natural := 0;
  begin
    wait until rising_edge(clk);
    bus_response <= bus_response_idle;
    index := to_integer(bus_request.address(7 downto 2));
    if bus_request.strobe = '1' and (bus_response.acknowledge or bus_response.error) = '0' then
      if bus_request.address(31 downto 8) = device_address(31 downto 8) then
        bus_response.acknowledge <= '1';
        bus_response.data <= device_words(index);
        for lane in 0 to 3 loop
          if bus_request.write and bus_request.select_bytes(lane) then
            device_words(index)(8 * lane + 7 downto 8 * lane) <=
              bus_request.data(8 * lane + 7 downto 8 * lane);
          end if;
        end loop;
      elsif bus_request.address(31 downto 2) = request_address(31 downto 2) and
            (bus_request.write = '0' or bus_request.select_bytes = "1111") then
        bus_response.acknowledge <= '1';
        bus_response.data <= requests;
        if bus_request.write then
          requests <= bus_request.data and writable_requests;
        end if;
      else
        bus_response.error <= '1';
      end if;
    end if;

    asleep := asleep + 1 when sleeping = '1' else 0;
    if asleep = wake_after_cycles and device_words(0) = wake_word then
      requests(wake_request) <= '1';
    end if;
  end process;

  run : process
    type bytes_t is file of character;
    file image : bytes_t open read_mode is program_file;
    file trace : text open write_mode is trace_file;
    variable next_byte : character;
    variable word : word_t;
    variable line_out : line;
    variable clocks : natural := 0;
    variable clocks_left : natural := most_clocks;
  begin
    load_request.enable <= '1';
    load_request.write_bytes <= "1111";
    for index in 0 to memory_words - 1 loop
      for lane in 0 to 3 loop
        next_byte := NUL;
        if not endfile(image) then
          read(image, next_byte);
        end if;
        word(8 * lane + 7 downto 8 * lane) :=
          std_ulogic_vector(to_unsigned(character'pos(next_byte), 8));
      end loop;
      load_request.address <= to_unsigned(index, 30);
      load_request.data <= word;
      wait until rising_edge(clk);
    end loop;
    loading <= '0';
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';

    wait until rising_edge(clk);
    while clocks_left > 0 loop
      if processor_request.enable = '1' and processor_request.write_bytes /= "0000" and
         to_integer(processor_request.address(15 downto 2)) = tohost_offset / 4 and
         unsigned(processor_request.data) /= 0 and clocks_left > clocks_behind_the_end then
        clocks_left := clocks_behind_the_end + 1;
      end if;
      wait until rising_edge(clk);
      clocks := clocks + 1;
      clocks_left := clocks_left - 1;
      if retirement.valid or retirement.trap then
        write(line_out, integer'image(clocks) & " " & to_string(retirement.valid) &
                        to_string(retirement.trap) & to_string(retirement.interrupt) & " " &
                        to_hstring(std_ulogic_vector(retirement.address)));
        if retirement.valid then
          write(line_out, " " & to_hstring(retirement.instruction));
        end if;
        if retirement.valid = '1' and retirement.destination /= "00000" then
          write(line_out, " x" & integer'image(to_integer(unsigned(retirement.destination))) & " " &
                          to_hstring(retirement.value));
        end if;
        writeline(trace, line_out);
      end if;
    end loop;
    std.env.finish;
  end process;

end architecture;
