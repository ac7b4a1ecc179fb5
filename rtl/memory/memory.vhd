-- SPDX-License-Identifier: Apache-2.0
-- The memory of the chip: program, data and stack, one port for instructions and one for data.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity memory is
  generic (
    -- Each 1 among its binary digits is a bank, the largest first: 104 KiB are banks of 64, 32 and 8 KiB. So
    -- no bank adds logic to an address, and each tool makes it of whole blocks of RAM.
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

  type address_bits_t is array (natural range <>) of natural;

  -- As many bits as the addresses of each bank have: the places of the size's binary digits 1.
  function bits_of_banks(size : positive) return address_bits_t is
    variable bits : address_bits_t(0 to 30);
    variable count : natural := 0;
  begin
    for place in 30 downto 0 loop
      if size / 2 ** place mod 2 = 1 then
        bits(count) := place;
        count := count + 1;
      end if;
    end loop;
    return bits(0 to count - 1);
  end function;

  constant bank_bits : address_bits_t := bits_of_banks(size_bytes);
  subtype banks_t is natural range 0 to bank_bits'length - 1;
  constant clears : boolean := shows_clear and banks_t'high > 0;

  type bank_words_t is array (banks_t) of std_ulogic_vector(31 downto 0);

  -- The address is in this bank: the bits of all larger banks are set, and its own is not, but for the last.
  function is_in(bank : banks_t; address : unsigned(31 downto 2)) return std_ulogic is
    variable found : std_ulogic := '1';
  begin
    for other in banks_t loop
      if other < bank then
        found := found and address(bank_bits(other));
      elsif other = bank and bank < banks_t'high then
        found := found and not address(bank_bits(other));
      end if;
    end loop;
    return found;
  end function;

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

  -- What each bank shows, in its block RAM and on the way from it, and which of them was requested.
  signal bank_instruction, bank_data : bank_words_t;
  signal way_from_instruction, way_from_data : bank_words_t;
  signal upper_shown, lower_shown, data_shown : std_ulogic_vector(banks_t);
  signal upper_instruction, lower_instruction : std_ulogic_vector(31 downto 0);

begin

  size_is_possible : assert bank_bits(banks_t'high) >= 3
    report "the memory has " & integer'image(size_bytes) & " bytes" severity failure;

  banks : for bank in banks_t generate
    constant bits : natural := bank_bits(bank);
    subtype word_address_t is natural range 0 to 2 ** (bits - 2) - 1;
    -- What goes to the block RAM, with no gate behind it but for clears_data: addresses, enables, and what
    -- clears what it shows.
    signal upper_word, lower_word, data_word : word_address_t;
    signal reads_instruction, accesses_data : std_ulogic;
    signal clears_upper, clears_lower, clears_data : std_ulogic;
    signal data_here, upper_here, lower_here : std_ulogic;
  begin

    upper_word <= to_integer(instruction_request.upper_address(bits - 1 downto 2));
    lower_word <= to_integer(instruction_request.lower_address(bits - 1 downto 2));
    data_word <= to_integer(data_request.address(bits - 1 downto 2));
    reads_instruction <= instruction_request.enable;
    accesses_data <= data_request.enable;
    clears_upper <= instruction_request.enable and not upper_here when clears else '0';
    clears_lower <= instruction_request.enable and not lower_here when clears else '0';
    clears_data <= not data_here when clears else '0';

    -- One array of bytes per lane: the form in which every tool finds block RAM with byte writes.
    lanes : for lane in 0 to 3 generate
      type bytes_t is array (2 ** (bits - 2) - 1 downto 0) of std_ulogic_vector(7 downto 0);
      signal bytes : bytes_t;
      signal instruction_word : word_address_t;
      signal clear_instruction : std_ulogic;
    begin

      instruction_word <= lower_word when lane < 2 else upper_word;
      clear_instruction <= clears_lower when lane < 2 else clears_upper;

      read_instruction : process
      begin
        wait until rising_edge(clk);
        if reads_instruction then
          bank_instruction(bank)(8 * lane + 7 downto 8 * lane) <= bytes(instruction_word);
        end if;
        if clear_instruction then
          bank_instruction(bank)(8 * lane + 7 downto 8 * lane) <= x"00";
        end if;
      end process;

      access_data : process
      begin
        wait until rising_edge(clk);
        if accesses_data then
          if data_request.write_bytes(lane) and data_here then
            bytes(data_word) <= data_request.data(8 * lane + 7 downto 8 * lane);
          else
            bank_data(bank)(8 * lane + 7 downto 8 * lane) <= bytes(data_word);
            -- Only here: while it is cleared the block RAM does not write.
            if clears_data then
              bank_data(bank)(8 * lane + 7 downto 8 * lane) <= x"00";
            end if;
          end if;
        end if;
      end process;

    end generate;

    data_here <= is_in(bank, data_request.address);
    upper_here <= is_in(bank, instruction_request.upper_address);
    lower_here <= is_in(bank, instruction_request.lower_address);

    remember : process
    begin
      wait until rising_edge(clk);
      if instruction_request.enable then
        upper_shown(bank) <= upper_here;
        lower_shown(bank) <= lower_here;
      end if;
      if data_request.enable then
        data_shown(bank) <= data_here;
      end if;
    end process;

  end generate;

  way_from_instruction <= bank_instruction;
  way_from_data <= bank_data;
  upper_instruction <= selected(way_from_instruction, upper_shown);
  lower_instruction <= selected(way_from_instruction, lower_shown);
  instruction_data <= upper_instruction(31 downto 16) & lower_instruction(15 downto 0);
  data <= selected(way_from_data, data_shown);

end architecture;
