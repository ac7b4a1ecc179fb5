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
    size_bytes : positive := 65536
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

  type bank_words_t is array (banks_t) of std_ulogic_vector(31 downto 0);

  -- What each bank shows, and what it shows or one of the banks after it.
  signal bank_instruction, bank_data, instruction_from, data_from : bank_words_t;
  -- The data requested lies after this bank.
  signal data_after : std_ulogic_vector(banks_t);

begin

  size_is_possible : assert bank_bits(banks_t'high) >= 3
    report "the memory has " & integer'image(size_bytes) & " bytes" severity failure;

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
    begin

      instruction_word <= lower_word when lane < 2 else upper_word;

      read_instruction : process
      begin
        wait until rising_edge(clk);
        if instruction_request.enable then
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
          end if;
        end if;
      end process;

    end generate;

    first : if bank = 0 generate
      data_here <= not data_after(bank);
    end generate;

    later : if bank > 0 generate
      data_here <= data_after(bank - 1) and not data_after(bank);
    end generate;

    last : if bank = banks_t'high generate
      data_after(bank) <= '0';
      instruction_from(bank) <= bank_instruction(bank);
      data_from(bank) <= bank_data(bank);
    end generate;

    earlier : if bank < banks_t'high generate
      -- The address's bit of the bank's size: where it is set the request is for a bank after this one. Of
      -- what is shown it is remembered.
      signal upper_shown_after, lower_shown_after, data_shown_after : std_ulogic;
    begin

      after_first : if bank = 0 generate
        data_after(bank) <= data_request.address(bits);
      end generate;

      after_later : if bank > 0 generate
        data_after(bank) <= data_after(bank - 1) and data_request.address(bits);
      end generate;

      remember : process
      begin
        wait until rising_edge(clk);
        if instruction_request.enable then
          upper_shown_after <= instruction_request.upper_address(bits);
          lower_shown_after <= instruction_request.lower_address(bits);
        end if;
        if data_request.enable then
          data_shown_after <= data_request.address(bits);
        end if;
      end process;

      instruction_from(bank)(31 downto 16) <=
        instruction_from(bank + 1)(31 downto 16) when upper_shown_after else
        bank_instruction(bank)(31 downto 16);
      instruction_from(bank)(15 downto 0) <=
        instruction_from(bank + 1)(15 downto 0) when lower_shown_after else
        bank_instruction(bank)(15 downto 0);
      data_from(bank) <= data_from(bank + 1) when data_shown_after else bank_data(bank);
    end generate;

  end generate;

  instruction_data <= instruction_from(0);
  data <= data_from(0);

end architecture;
