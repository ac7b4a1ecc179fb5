-- SPDX-License-Identifier: Apache-2.0
-- The requests to the two ports of the tightly coupled memory; the data comes in the next clock.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package memory_pkg is

  -- Each 1 among the binary digits of the memory's size is a bank, the largest first: 104 KiB are banks of
  -- 64, 32 and 8 KiB. So no bank adds logic to an address, and each tool makes it of whole blocks of RAM. The
  -- bits of the addresses of each bank are the places of the digits.
  type address_bits_t is array (natural range <>) of natural;
  function bits_of_banks(size_bytes : positive) return address_bits_t;

  -- One-hot: the bank that holds an address.
  subtype bank_choice_t is std_ulogic_vector(7 downto 0);
  function bank_of(address : unsigned(31 downto 2); size_bytes : positive) return bank_choice_t;

  -- Read of 32 bits that begin at any half word: the upper half word of one word and the lower half
  -- word of the same or of the next. While `enable` is low the port keeps its last data.
  type instruction_request_t is record
    enable : std_ulogic;
    -- Addresses of the two words; the memory looks only at as many low bits as it has words.
    upper_address : unsigned(31 downto 2);
    lower_address : unsigned(31 downto 2);
    -- The banks that do not hold them (`bank_of`), none while `enable` is low. Found for each address before
    -- one is chosen, which is late in the clock.
    upper_elsewhere : bank_choice_t;
    lower_elsewhere : bank_choice_t;
  end record;

  -- Read or write of one data word. While `enable` is low the port keeps its last data; what it
  -- shows after a write is undefined.
  type memory_request_t is record
    enable : std_ulogic;
    -- Byte lanes to write, bit 0 for data(7 downto 0); a read has none.
    write_bytes : std_ulogic_vector(3 downto 0);
    address : unsigned(31 downto 2);
    data : std_ulogic_vector(31 downto 0);
  end record;

  constant instruction_request_idle : instruction_request_t := (
    enable => '0', upper_address => (others => '0'), lower_address => (others => '0'),
    upper_elsewhere => (others => '0'), lower_elsewhere => (others => '0'));
  constant memory_request_idle : memory_request_t := (
    enable => '0', write_bytes => (others => '0'), address => (others => '0'),
    data => (others => '0'));

  -- The memory's addresses have as many bits, of which the lowest say nothing about where it ends.
  function address_bits_of(size_bytes : positive) return positive;
  function bits_below_end_of(size_bytes : positive) return natural;

  -- The address lies beyond a memory of this size that begins at a multiple of its next power of two. Only
  -- the address's bits below that are looked at.
  function is_beyond_memory(address : unsigned(31 downto 0); size_bytes : positive) return std_ulogic;

end package;

package body memory_pkg is

  function bits_of_banks(size_bytes : positive) return address_bits_t is
    variable bits : address_bits_t(0 to 30);
    variable count : natural := 0;
  begin
    for place in 30 downto 0 loop
      if size_bytes / 2 ** place mod 2 = 1 then
        bits(count) := place;
        count := count + 1;
      end if;
    end loop;
    return bits(0 to count - 1);
  end function;

  -- The bits of all larger banks are set, and its own is not, but for the last.
  function bank_of(address : unsigned(31 downto 2); size_bytes : positive) return bank_choice_t is
    constant bits : address_bits_t := bits_of_banks(size_bytes);
    variable beyond_larger : std_ulogic := '1';
    variable found : bank_choice_t := (others => '0');
  begin
    for bank in 0 to bits'high - 1 loop
      found(bank) := beyond_larger and not address(bits(bank));
      beyond_larger := beyond_larger and address(bits(bank));
    end loop;
    found(bits'high) := beyond_larger;
    return found;
  end function;

  function address_bits_of(size_bytes : positive) return positive is
    variable bits : positive := 1;
  begin
    while 2 ** bits < size_bytes loop
      bits := bits + 1;
    end loop;
    return bits;
  end function;

  function bits_below_end_of(size_bytes : positive) return natural is
    variable bits : natural := 0;
  begin
    while size_bytes mod 2 ** (bits + 1) = 0 loop
      bits := bits + 1;
    end loop;
    return bits;
  end function;

  function is_beyond_memory(address : unsigned(31 downto 0); size_bytes : positive) return std_ulogic is
    constant bits : positive := address_bits_of(size_bytes);
    constant below : natural := bits_below_end_of(size_bytes);
  begin
    if size_bytes = 2 ** bits then
      return '0';
    end if;
    if address(bits - 1 downto below) >= to_unsigned(size_bytes / 2 ** below, bits - below) then
      return '1';
    end if;
    return '0';
  end function;

end package body;
