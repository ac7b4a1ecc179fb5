-- SPDX-License-Identifier: Apache-2.0
-- The memory of the chip: program, data and stack, one port for instructions and one for data.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity memory is
  generic (
    -- A multiple of 8 bytes, of at most 8 banks (`bits_of_banks`).
    size_bytes : positive := 65536;
    -- The blocks of RAM can clear what they show, as those of an ECP5: a bank of which nothing is requested
    -- shows 0, and no gate chooses one. Where they cannot, this would make them of registers.
    shows_clear : boolean := false
  );
  port (
    clk : in std_ulogic;
    instruction_request : in instruction_request_t;
    -- The half words requested in the clock before, each in its place in a word; they stay until the
    -- next enabled request.
    instruction_data : out std_ulogic_vector(31 downto 0);
    data_request : in memory_request_t;
    -- The word requested in the clock before; undefined after a write.
    data : out std_ulogic_vector(31 downto 0)
  );
end entity;

architecture rtl of memory is

  constant bank_bits : address_bits_t := bits_of_banks(size_bytes);
  subtype banks_t is natural range 0 to bank_bits'length - 1;

  type bank_words_t is array (banks_t) of std_ulogic_vector(31 downto 0);

  -- No signal depends on another part of itself: the model's evaluation relies on that.
  function selected(words : bank_words_t; chosen : std_ulogic_vector(banks_t)) return std_ulogic_vector is
    variable word : std_ulogic_vector(31 downto 0) := (others => '0');
  begin
    if banks_t'high = 0 then
      return words(0);
    end if;
    for bank in banks_t loop
      if shows_clear then
        word := word or words(bank);
      else
        word := word or (words(bank) and chosen(bank));
      end if;
    end loop;
    return word;
  end function;

  -- What each bank shows, and which of them was requested.
  signal bank_instruction, bank_data : bank_words_t;
  signal upper_shown, lower_shown, data_shown : std_ulogic_vector(banks_t);
  signal data_bank : bank_choice_t;
  signal upper_instruction, lower_instruction : std_ulogic_vector(31 downto 0);

begin

  size_is_possible : assert bank_bits(banks_t'high) >= 3 and banks_t'high <= bank_choice_t'high
    report "the memory has " & integer'image(size_bytes) & " bytes" severity failure;

  data_bank <= bank_of(data_request.address, size_bytes);

  banks : for bank in banks_t generate
    constant bits : natural := bank_bits(bank);
    subtype word_address_t is natural range 0 to 2 ** (bits - 2) - 1;
    signal upper_word, lower_word, data_word : word_address_t;
    signal data_here : std_ulogic;
  begin

    upper_word <= to_integer(instruction_request.upper_address(bits - 1 downto 2));
    lower_word <= to_integer(instruction_request.lower_address(bits - 1 downto 2));
    data_word <= to_integer(data_request.address(bits - 1 downto 2));

    -- One array of bytes per lane: the form in which every tool finds block RAM with byte writes.
    lanes : for lane in 0 to 3 generate
      type bytes_t is array (2 ** (bits - 2) - 1 downto 0) of std_ulogic_vector(7 downto 0);
      signal bytes : bytes_t;
      signal instruction_word : word_address_t;
      signal clear_instruction, clear_data : std_ulogic;
    begin

      instruction_word <= lower_word when lane < 2 else upper_word;
      clear_instruction <= '0' when not shows_clear else
                           instruction_request.lower_elsewhere(bank) when lane < 2 else
                           instruction_request.upper_elsewhere(bank);
      clear_data <= '0' when not shows_clear else not data_here;

      read_instruction : process
      begin
        wait until rising_edge(clk);
        if clear_instruction then
          bank_instruction(bank)(8 * lane + 7 downto 8 * lane) <= x"00";
        elsif instruction_request.enable then
          bank_instruction(bank)(8 * lane + 7 downto 8 * lane) <= bytes(instruction_word);
        end if;
      end process;

      access_data : process
      begin
        wait until rising_edge(clk);
        if data_request.enable then
          if data_request.write_bytes(lane) and data_here then
            bytes(data_word) <= data_request.data(8 * lane + 7 downto 8 * lane);
          else
            bank_data(bank)(8 * lane + 7 downto 8 * lane) <= bytes(data_word);
            if clear_data then
              bank_data(bank)(8 * lane + 7 downto 8 * lane) <= x"00";
            end if;
          end if;
        end if;
      end process;

    end generate;

    data_here <= data_bank(bank);

    remember : process
    begin
      wait until rising_edge(clk);
      if instruction_request.enable then
        upper_shown(bank) <= not instruction_request.upper_elsewhere(bank);
        lower_shown(bank) <= not instruction_request.lower_elsewhere(bank);
      end if;
      if data_request.enable then
        data_shown(bank) <= data_here;
      end if;
    end process;

  end generate;

  upper_instruction <= selected(bank_instruction, upper_shown);
  lower_instruction <= selected(bank_instruction, lower_shown);
  instruction_data <= upper_instruction(31 downto 16) & lower_instruction(15 downto 0);
  data <= selected(bank_data, data_shown);

end architecture;
