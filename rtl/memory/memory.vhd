-- SPDX-License-Identifier: Apache-2.0
-- The memory of the chip: program, data and stack, one port for instructions and one for data.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.memory_pkg.all;

entity memory is
  generic (
    -- A power of two, or three quarters of one: then the first two thirds are one bank, the last another.
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

  constant window_bits : positive := integer(ceil(log2(real(size_bytes))));
  constant has_upper_bank : boolean := size_bytes /= 2 ** window_bits;

  function bank_bits return positive is
  begin
    if has_upper_bank then
      return window_bits - 1;
    end if;
    return window_bits;
  end function;

  -- Of a word, and of one in the upper bank.
  constant address_bits : positive := bank_bits - 2;
  subtype word_address_t is natural range 0 to 2 ** address_bits - 1;
  subtype upper_bank_word_t is natural range 0 to 2 ** (address_bits - 1) - 1;

  signal upper_word, lower_word, data_word : word_address_t;
  -- The bank requested, and that of what is shown.
  signal upper_in_upper, lower_in_upper, data_in_upper : std_ulogic;
  signal upper_from_upper, lower_from_upper, data_from_upper : std_ulogic;
  -- What each bank shows.
  signal bank_instruction, upper_instruction : std_ulogic_vector(31 downto 0);
  signal bank_data, upper_data : std_ulogic_vector(31 downto 0);

begin

  size_is_possible : assert
    size_bytes = 2 ** window_bits or size_bytes = 3 * 2 ** (window_bits - 2)
    report "the memory has " & integer'image(size_bytes) & " bytes" severity failure;

  upper_word <= to_integer(instruction_request.upper_address(address_bits + 1 downto 2));
  lower_word <= to_integer(instruction_request.lower_address(address_bits + 1 downto 2));
  data_word <= to_integer(data_request.address(address_bits + 1 downto 2));

  -- One array of bytes per lane: the form in which every tool finds block RAM with byte writes.
  lanes : for lane in 0 to 3 generate
    type bytes_t is array (2 ** address_bits - 1 downto 0) of std_ulogic_vector(7 downto 0);
    signal bytes : bytes_t;
    signal instruction_word : word_address_t;
  begin

    instruction_word <= lower_word when lane < 2 else upper_word;

    read_instruction : process
    begin
      wait until rising_edge(clk);
      if instruction_request.enable then
        bank_instruction(8 * lane + 7 downto 8 * lane) <= bytes(instruction_word);
      end if;
    end process;

    access_data : process
    begin
      wait until rising_edge(clk);
      if data_request.enable then
        if data_request.write_bytes(lane) and not data_in_upper then
          bytes(data_word) <= data_request.data(8 * lane + 7 downto 8 * lane);
        else
          bank_data(8 * lane + 7 downto 8 * lane) <= bytes(data_word);
        end if;
      end if;
    end process;

  end generate;

  one_bank : if not has_upper_bank generate
    data_in_upper <= '0';
    instruction_data <= bank_instruction;
    data <= bank_data;
  end generate;

  two_banks : if has_upper_bank generate
    upper_in_upper <= instruction_request.upper_address(window_bits - 1);
    lower_in_upper <= instruction_request.lower_address(window_bits - 1);
    data_in_upper <= data_request.address(window_bits - 1);

    upper_lanes : for lane in 0 to 3 generate
      type bytes_t is array (2 ** (address_bits - 1) - 1 downto 0) of std_ulogic_vector(7 downto 0);
      signal bytes : bytes_t;
      signal instruction_word, accessed_word : upper_bank_word_t;
    begin

      instruction_word <= lower_word mod 2 ** (address_bits - 1) when lane < 2 else
                          upper_word mod 2 ** (address_bits - 1);
      accessed_word <= data_word mod 2 ** (address_bits - 1);

      read_instruction : process
      begin
        wait until rising_edge(clk);
        if instruction_request.enable then
          upper_instruction(8 * lane + 7 downto 8 * lane) <= bytes(instruction_word);
        end if;
      end process;

      access_data : process
      begin
        wait until rising_edge(clk);
        if data_request.enable then
          if data_request.write_bytes(lane) and data_in_upper then
            bytes(accessed_word) <= data_request.data(8 * lane + 7 downto 8 * lane);
          else
            upper_data(8 * lane + 7 downto 8 * lane) <= bytes(accessed_word);
          end if;
        end if;
      end process;

    end generate;

    remember_banks : process
    begin
      wait until rising_edge(clk);
      if instruction_request.enable then
        upper_from_upper <= upper_in_upper;
        lower_from_upper <= lower_in_upper;
      end if;
      if data_request.enable then
        data_from_upper <= data_in_upper;
      end if;
    end process;

    instruction_data(31 downto 16) <= upper_instruction(31 downto 16) when upper_from_upper else
                                      bank_instruction(31 downto 16);
    instruction_data(15 downto 0) <= upper_instruction(15 downto 0) when lower_from_upper else
                                     bank_instruction(15 downto 0);
    data <= upper_data when data_from_upper else bank_data;
  end generate;

end architecture;
