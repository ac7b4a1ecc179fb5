-- SPDX-License-Identifier: Apache-2.0
-- A short program on the processor: a loop, multiplication, division, memory, bus, trap,
-- interrupt, sleep.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.processor_pkg.all;
use work.memory_pkg.all;

entity processor_tb is
end entity;

architecture tb of processor_tb is

  type words_t is array (natural range <>) of word_t;
  constant program : words_t := (
    x"800002b7",  --  0 lui t0, 0x80000
    x"06828293",  --  1 addi t0, t0, 104       handler
    x"30529073",  --  2 csrw mtvec, t0
    x"f0000437",  --  3 lui s0, 0xf0000
    x"00a00593",  --  4 li a1, 10
    x"00000513",  --  5 li a0, 0
    x"00b50533",  --  6 add a0, a0, a1         loop
    x"fff58593",  --  7 addi a1, a1, -1
    x"fe059ce3",  --  8 bnez a1, loop
    x"02a50533",  --  9 mul a0, a0, a0         3025
    x"00700593",  -- 10 li a1, 7
    x"02b54633",  -- 11 div a2, a0, a1         432
    x"02b566b3",  -- 12 rem a3, a0, a1         1
    x"10c02023",  -- 13 sw a2, 256(zero)       traps: nothing answers
    x"00d42023",  -- 14 sw a3, 0(s0)
    x"00c42223",  -- 15 sw a2, 4(s0)
    x"00442703",  -- 16 lw a4, 4(s0)           bus: what was written
    x"00e42423",  -- 17 sw a4, 8(s0)
    x"fff00793",  -- 18 li a5, -1
    x"30479073",  -- 19 csrw mie, a5
    x"30046073",  -- 20 csrsi mstatus, 8
    x"10500073",  -- 21 wfi
    x"01142623",  -- 22 sw a7, 12(s0)          the interrupt's cause
    x"0000006f",  -- 23 j .
    x"00000013",  -- 24 nop
    x"00000013",  -- 25 nop
    x"342028f3",  -- 26 csrr a7, mcause        handler
    x"01142823",  -- 27 sw a7, 16(s0)
    x"341022f3",  -- 28 csrr t0, mepc
    x"0008c463",  -- 29 bltz a7, +8
    x"00428293",  -- 30 addi t0, t0, 4
    x"34129073",  -- 31 csrw mepc, t0
    x"30200073"); -- 32 mret

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal instruction_request : instruction_request_t;
  signal instruction_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;
  signal timer_interrupt, sleeping, retired : std_ulogic := '0';
  signal bus_words : words_t(0 to 7) := (others => (others => '0'));
  signal writes : natural := 0;

begin

  clk <= not clk after 5 ns;

  uut : entity work.processor
    generic map (memory_size_bytes => 1024)
    port map (
      clk => clk,
      always_clk => clk,
      reset => reset,
      instruction_request => instruction_request,
      instruction_data => instruction_data,
      memory_request => memory_request,
      memory_data => x"00000000",
      bus_request => bus_request,
      bus_response => bus_response,
      timer_interrupt => timer_interrupt,
      external_interrupt => '0',
      interrupts => x"0000",
      sleeping => sleeping,
      retired => retired,
      retirement => open);

  give_instructions : process
    impure function word_at(address : unsigned(31 downto 2)) return word_t is
      constant index : natural := to_integer(address(9 downto 2));
    begin
      if index < program'length then
        return program(index);
      end if;
      return x"00000000";
    end function;
  begin
    wait until rising_edge(clk);
    if instruction_request.enable then
      instruction_data <= word_at(instruction_request.upper_address)(31 downto 16) &
                          word_at(instruction_request.lower_address)(15 downto 0);
    end if;
    assert not (sleeping = '1' and instruction_request.enable = '1')
      report "a sleeping processor fetches nothing" severity failure;
  end process;

  answer_on_bus : process
    variable index : natural;
  begin
    wait until rising_edge(clk);
    bus_response <= bus_response_idle;
    if bus_request.strobe = '1' and (bus_response.acknowledge or bus_response.error) = '0' then
      index := to_integer(bus_request.address(4 downto 2));
      if bus_request.address(31 downto 5) /= x"f00000" & "000" then
        bus_response.error <= '1';
      else
        bus_response.acknowledge <= '1';
        bus_response.data <= bus_words(index);
        if bus_request.write then
          bus_words(index) <= bus_request.data;
          writes <= writes + 1;
        end if;
      end if;
    end if;
  end process;

  check : process
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    wait until sleeping = '1' for 5 us;
    assert sleeping = '1' report "it never came to wfi" severity failure;
    assert bus_words(4) = x"00000007" report "a store to nothing traps" severity failure;
    assert bus_words(0) = x"00000001" report "remainder" severity failure;
    assert bus_words(1) = x"000001b0" report "quotient" severity failure;
    assert bus_words(2) = x"000001b0" report "what was loaded over the bus" severity failure;
    assert writes = 4 severity failure;
    wait for 200 ns;
    assert sleeping = '1' severity failure;
    timer_interrupt <= '1';
    wait until writes = 5 for 1 us;
    assert bus_words(4) = x"80000007" report "the timer's interrupt" severity failure;
    timer_interrupt <= '0';
    wait until writes = 6 for 1 us;
    assert bus_words(3) = x"80000007" report "it goes on behind wfi" severity failure;
    std.env.finish;
  end process;

end architecture;
