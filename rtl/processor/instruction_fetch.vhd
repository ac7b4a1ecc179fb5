-- SPDX-License-Identifier: Apache-2.0
-- Asks the memory for the next instruction, and remembers the address of the one that it shows.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity instruction_fetch is
  generic (
    reset_address : unsigned(31 downto 0);
    -- The memory holds 2 to this power bytes.
    memory_address_bits : positive
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    -- In the order of their rank. A trap or a return from one, then nothing else matters. It takes
    -- one
    -- clock more than a jump, which goes to the memory in the clock in which it is executed.
    redirect : in std_ulogic;
    redirect_address : in unsigned(31 downto 0);
    jump : in std_ulogic;
    jump_address : in unsigned(31 downto 0);
    -- The instruction shown is taken in this clock.
    advance : in std_ulogic;
    instruction_request : out instruction_request_t;
    -- Of the instruction that the memory shows now.
    valid : out std_ulogic;
    address : out unsigned(31 downto 0);
    -- It comes from outside the memory.
    fault : out std_ulogic
  );
end entity;

architecture rtl of instruction_fetch is

  signal redirecting : std_ulogic;
  signal redirect_target : unsigned(31 downto 0);
  signal enable : std_ulogic;
  signal next_address : unsigned(31 downto 0);

begin

  enable <= redirecting or jump or advance;
  next_address <= redirect_target when redirecting else
                  jump_address when jump else
                  address + 4;
  instruction_request.enable <= enable;
  instruction_request.address <= next_address(31 downto 2);

  follow : process
  begin
    wait until rising_edge(clk);
    redirecting <= redirect;
    if redirect then
      redirect_target <= redirect_address;
    end if;
    if enable then
      address <= next_address(31 downto 2) & "00";
    end if;

    if reset then
      redirecting <= '1';
      redirect_target <= reset_address;
    end if;
  end process;

  valid <= not redirecting;
  fault <= address(31 downto memory_address_bits) ?/= reset_address(31 downto memory_address_bits);

end architecture;
