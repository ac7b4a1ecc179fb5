-- SPDX-License-Identifier: Apache-2.0
-- What surrounds the processor in its proof: any program, any data, any interrupts.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.instruction_set_pkg.all;
use work.memory_pkg.all;

entity processor_environment is
  generic (
    -- As of `processor_proof`.
    prologue : natural range 0 to 2;
    -- Clocks after which a request must be visible.
    clocks_to_settle : positive
  );
  port (
    clk : in std_ulogic;
    -- Unconstrained in each clock.
    any_instruction : in value_t;
    any_data : in value_t;
    interrupts_begin : in std_ulogic;

    running : out std_ulogic := '0';
    instruction_request : in instruction_request_t;
    instruction_data : out value_t := (others => '0');
    memory_request : in memory_request_t;
    memory_data : out value_t := (others => '0');
    requests : out value_t := (others => '0');
    -- Clocks since the requests began, up to `clocks_to_settle`.
    requested_for : out natural range 0 to 15 := 0;

    -- Any half word of the program, and the one after it.
    known_code_place : out unsigned(31 downto 1);
    known_code_low, known_code_high : out std_ulogic_vector(15 downto 0);
    -- Any word of the data, with its initial value.
    known_data_place : out unsigned(31 downto 2);
    known_data_at_first : out value_t
  );
end entity;

architecture proof of processor_environment is

  attribute anyconst : boolean;
  -- Any half word of the program, and the one after it.
  signal code_place : unsigned(31 downto 1) := (others => '0');
  signal code_low, code_high : std_ulogic_vector(15 downto 0) := (others => '0');
  attribute anyconst of code_place : signal is true;
  attribute anyconst of code_low : signal is true;
  attribute anyconst of code_high : signal is true;
  -- Any word of the data, with its initial value.
  signal data_place : unsigned(31 downto 2) := (others => '0');
  signal data_at_first : value_t := (others => '0');
  attribute anyconst of data_place : signal is true;
  attribute anyconst of data_at_first : signal is true;
  -- Any interrupts, which begin at any time and stay.
  signal any_requests : value_t := (others => '0');
  attribute anyconst of any_requests : signal is true;

  -- lui and addi of any value to x8, then csrw mie, and csrw mtvec, csrsi mstatus; or wfi and a nop.
  signal mask_high : std_ulogic_vector(31 downto 12) := (others => '0');
  signal mask_low : std_ulogic_vector(11 downto 0) := (others => '0');
  attribute anyconst of mask_high : signal is true;
  attribute anyconst of mask_low : signal is true;
  type words_t is array (0 to 4) of value_t;
  signal prologue_words : words_t;

  signal data_word : value_t := (others => '0');

begin

  known_code_place <= code_place;
  known_code_low <= code_low;
  known_code_high <= code_high;
  known_data_place <= data_place;
  known_data_at_first <= data_at_first;

  prologue_words(0) <= mask_high & x"437";
  prologue_words(1) <= mask_low & x"40413";
  prologue_words(2) <= x"30441073";
  prologue_words(3) <= x"10500073" when prologue = 2 else x"30541073";
  prologue_words(4) <= x"00000013" when prologue = 2 else x"30046073";

  -- The memory: two half words of the program are constant and known, and one word of the data. All others
  -- are unconstrained, but stable without a request.
  memory : process
  begin
    wait until rising_edge(clk);
    running <= '1';
    if instruction_request.enable then
      instruction_data <= any_instruction;
      if instruction_request.upper_address & '1' = code_place then
        instruction_data(31 downto 16) <= code_low;
      elsif instruction_request.upper_address & '1' = code_place + 1 then
        instruction_data(31 downto 16) <= code_high;
      end if;
      if instruction_request.lower_address & '0' = code_place then
        instruction_data(15 downto 0) <= code_low;
      elsif instruction_request.lower_address & '0' = code_place + 1 then
        instruction_data(15 downto 0) <= code_high;
      end if;
      for index in words_t'range loop
        if prologue /= 0 and instruction_request.upper_address = unsigned'(30x"20000000") + index then
          instruction_data(31 downto 16) <= prologue_words(index)(31 downto 16);
        end if;
        if prologue /= 0 and instruction_request.lower_address = unsigned'(30x"20000000") + index then
          instruction_data(15 downto 0) <= prologue_words(index)(15 downto 0);
        end if;
      end loop;
    end if;
    if memory_request.enable then
      memory_data <= any_data;
      if memory_request.address = data_place and memory_request.write_bytes = "0000" then
        memory_data <= data_word;
      end if;
      for lane in 0 to 3 loop
        if memory_request.address = data_place and memory_request.write_bytes(lane) = '1' then
          data_word(8 * lane + 7 downto 8 * lane) <= memory_request.data(8 * lane + 7 downto 8 * lane);
        end if;
      end loop;
    end if;
    if not running then
      data_word <= data_at_first;
    end if;
  end process;

  request_interrupts : process
  begin
    wait until rising_edge(clk);
    if interrupts_begin = '1' or requested_for > 0 then
      requests <= any_requests and x"ffff0880";
      if requested_for < clocks_to_settle then
        requested_for <= requested_for + 1;
      end if;
    end if;
    if not running then
      requests <= x"00000000";
      requested_for <= 0;
    end if;
  end process;

end architecture;
