-- SPDX-License-Identifier: Apache-2.0
-- Instructions are asked one after the other, from jumps at once, from redirections a clock later.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.memory_pkg.all;

entity instruction_fetch_tb is
end entity;

architecture tb of instruction_fetch_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal redirect, jump, advance, valid, fault : std_ulogic := '0';
  signal redirect_address, jump_address, address : unsigned(31 downto 0) := (others => '0');
  signal instruction_request : instruction_request_t;

begin

  clk <= not clk after 5 ns;

  uut : entity work.instruction_fetch
    generic map (reset_address => x"80000000", memory_address_bits => 16)
    port map (
      clk => clk,
      reset => reset,
      redirect => redirect,
      redirect_address => redirect_address,
      jump => jump,
      jump_address => jump_address,
      advance => advance,
      instruction_request => instruction_request,
      valid => valid,
      address => address,
      fault => fault);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;
    procedure expect_request(wanted : unsigned(31 downto 0)) is
    begin
      wait for 1 ns;
      assert instruction_request.enable = '1' and instruction_request.address = wanted(31 downto 2)
        report "asks for " & to_hstring(instruction_request.address & "00") severity failure;
    end procedure;
  begin
    clock;
    reset <= '0';
    expect_request(x"80000000");
    assert valid = '0' severity failure;
    clock;
    assert valid = '1' and address = x"80000000" and fault = '0' severity failure;
    assert instruction_request.enable = '0' report "nobody has taken it" severity failure;
    advance <= '1';
    expect_request(x"80000004");
    clock;
    assert address = x"80000004" severity failure;
    advance <= '0';
    clock;
    assert address = x"80000004" severity failure;
    jump <= '1';
    jump_address <= x"80000103";
    expect_request(x"80000100");
    clock;
    jump <= '0';
    assert valid = '1' and address = x"80000100" severity failure;
    redirect <= '1';
    redirect_address <= x"80000200";
    clock;
    redirect <= '0';
    assert valid = '0' severity failure;
    jump <= '1';
    expect_request(x"80000200");
    clock;
    jump <= '0';
    assert valid = '1' and address = x"80000200" and fault = '0' severity failure;
    jump <= '1';
    jump_address <= x"80010000";
    clock;
    assert fault = '1' severity failure;
    jump_address <= x"8000fffc";
    clock;
    assert fault = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
