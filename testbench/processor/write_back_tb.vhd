-- SPDX-License-Identifier: Apache-2.0
-- Each class of instructions writes its result a clock after execute, or after the bus response.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

entity write_back_tb is
end entity;

architecture tb of write_back_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  constant empty : control_t := (
    legal => "0000", destination => "00101", operation => "000", funct3 => "000", others => '0');
  signal control : control_t := empty;
  signal complete, trapped, interrupted, to_memory, bus_active, bus_done, retire : std_ulogic := '0';
  signal byte_index : std_ulogic_vector(1 downto 0) := "00";
  signal instruction, writing_instruction : word_t := x"00000013";
  signal result : word_t := x"11111111";
  signal value, value_late, value_product, value_early : word_t;
  signal writing : writing_t;

begin

  clk <= not clk after 5 ns;

  uut : entity work.write_back
    port map (
      clk => clk,
      reset => reset,
      complete => complete,
      control => control,
      instruction => instruction,
      result => result,
      trapped => trapped,
      interrupted => interrupted,
      to_memory => to_memory,
      byte_index => byte_index,
      bus_active => bus_active,
      bus_done => bus_done,
      product => x"22222222",
      memory_data => x"84838281",
      retire => retire,
      writing => writing,
      writing_instruction => writing_instruction,
      value => value,
      value_late => value_late,
      value_product => value_product,
      value_early => value_early);

  check : process
    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure expect(valid, writes : std_ulogic; wanted : word_t) is
    begin
      assert writing.valid = valid and writing.writes = writes severity failure;
      assert writes = '0' or
        (value = wanted and value = (value_late or value_product or value_early) and
         writing.destination = "00101" and
         ((or value_late) nor (or value_product)) = '1') or
        (value = wanted and value = value_late and ((or value_product) nor (or value_early)) = '1') or
        (value = wanted and value = value_product and ((or value_late) nor (or value_early)) = '1')
        report to_hstring(value) severity failure;
    end procedure;
  begin
    clock;
    reset <= '0';
    expect('0', '0', x"00000000");

    complete <= '1';
    control.writes <= '1';
    wait for 1 ns;
    assert retire = '1' severity failure;
    clock;
    expect('1', '1', x"11111111");
    assert value_early = x"11111111" severity failure;
    control.multiply <= '1';
    clock;
    expect('1', '1', x"22222222");
    control.multiply <= '0';
    control.load <= '1';
    to_memory <= '1';
    byte_index <= "10";
    clock;
    expect('1', '1', x"ffffff83");
    control.funct3 <= "101";
    clock;
    expect('1', '1', x"00008483");
    -- Destination x0, or none.
    control.writes <= '0';
    clock;
    expect('1', '0', x"00000000");
    control <= empty;
    complete <= '0';
    clock;
    expect('0', '0', x"00000000");

    -- Bus access: it retires with the response.
    for answered in 0 to 1 loop
      complete <= '1';
      control.writes <= '1';
      control.load <= '1';
      control.funct3 <= "000";
      byte_index <= "01";
      to_memory <= '0';
      instruction <= x"00158283";
      wait for 1 ns;
      assert retire = '0' severity failure;
      clock;
      expect('0', '0', x"00000000");
      bus_active <= '1';
      complete <= '0';
      control <= empty;
      instruction <= x"00000013";
      clock;
      expect('0', '0', x"00000000");
      result <= x"0000f700";
      bus_done <= '1' when answered = 1 else '0';
      trapped <= '0' when answered = 1 else '1';
      wait for 1 ns;
      assert retire = bus_done severity failure;
      clock;
      expect(not trapped, not trapped, x"fffffff7");
      assert writing.trapped = trapped and writing_instruction = x"00158283" severity failure;
      bus_active <= '0';
      bus_done <= '0';
      trapped <= '0';
      clock;
      expect('0', '0', x"00000000");
    end loop;
    std.env.finish;
  end process;

end architecture;
