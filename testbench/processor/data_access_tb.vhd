-- SPDX-License-Identifier: Apache-2.0
-- Loads and stores access the memory in the same clock, or the bus until it responds.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity data_access_tb is
end entity;

architecture tb of data_access_tb is

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal enable, store : std_ulogic := '0';
  signal address, offset : unsigned(31 downto 0) := (others => '0');
  signal size : std_ulogic_vector(1 downto 0) := "00";
  signal store_data : word_t := x"a1b2c3d4";
  signal memory_request : memory_request_t;
  signal bus_request : bus_request_t;
  signal bus_response : bus_response_t := bus_response_idle;
  -- Of 104 KiB.
  signal to_larger_memory : std_ulogic;
  signal misaligned, to_memory, bus_active, done, error : std_ulogic;

begin

  clk <= not clk after 5 ns;

  uut : entity work.data_access
    generic map (memory_address => x"80000000", memory_size_bytes => 65536)
    port map (
      clk => clk,
      reset => reset,
      enable => enable,
      store => store,
      base => address - offset,
      offset => offset,
      address => address,
      size => size,
      store_data => store_data,
      memory_request => memory_request,
      bus_request => bus_request,
      bus_response => bus_response,
      misaligned => misaligned,
      to_memory => to_memory,
      bus_active => bus_active,
      done => done,
      error => error);

  of_104_kib : entity work.data_access
    generic map (memory_address => x"80000000", memory_size_bytes => 106496)
    port map (
      clk => clk,
      reset => reset,
      enable => '0',
      store => store,
      base => address - offset,
      offset => offset,
      address => address,
      size => size,
      store_data => store_data,
      memory_request => open,
      bus_request => open,
      bus_response => bus_response_idle,
      misaligned => open,
      to_memory => to_larger_memory,
      bus_active => open,
      done => open,
      error => open);

  check : process
    type uppers_t is array (natural range <>) of unsigned(15 downto 0);
    constant uppers : uppers_t := (
      x"0000", x"0001", x"7fff", x"8000", x"8001", x"8002", x"c000", x"f000", x"ffff");

    type offsets_t is array (natural range <>) of unsigned(31 downto 0);
    constant offsets : offsets_t := (
      x"00000000", x"00000001", x"ffffffff", x"000007ff", x"fffff800", x"7fffffff", x"80000000");

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure expect_store(width : std_ulogic_vector(1 downto 0); place : natural;
                           lanes : std_ulogic_vector(3 downto 0); is_misaligned : std_ulogic) is
    begin
      enable <= '1';
      store <= '1';
      size <= width;
      address <= x"80001230" + place;
      wait for 1 ns;
      assert misaligned = is_misaligned and memory_request.enable = '1' severity failure;
      assert memory_request.write_bytes = lanes report to_string(memory_request.write_bytes) severity failure;
      if not is_misaligned then
        assert memory_request.address & "00" = x"80001230"
          report to_string(memory_request.write_bytes) severity failure;
        for lane in 0 to 3 loop
          if lanes(lane) then
            assert memory_request.data(8 * lane + 7 downto 8 * lane) =
              store_data(8 * (lane - place) + 7 downto 8 * (lane - place)) severity failure;
          end if;
        end loop;
      end if;
      clock;
      assert bus_active = '0' severity failure;
    end procedure;

    procedure use_bus(wait_clocks : natural; fails : std_ulogic) is
    begin
      enable <= '1';
      store <= '1';
      size <= "01";
      address <= x"f0001232";
      wait for 1 ns;
      assert done = '0' and memory_request.write_bytes = "0000" and bus_active = '0'
        report "nothing outside is written to the memory" severity failure;
      clock;
      -- The next access is stalled.
      enable <= '0';
      address <= x"80000000";
      store <= '0';
      for count in 1 to wait_clocks loop
        assert bus_active = '1' and done = '0' and bus_request.strobe = '1' and
          bus_request.write = '1' and bus_request.address = x"f0001232" and
          bus_request.select_bytes = "1100" and bus_request.data(31 downto 16) = x"c3d4"
          severity failure;
        clock;
      end loop;
      bus_response.acknowledge <= not fails;
      bus_response.error <= fails;
      wait for 1 ns;
      assert done = not fails and error = fails severity failure;
      clock;
      bus_response <= bus_response_idle;
      assert bus_request.strobe = '0' report "a request ends with its response" severity failure;
    end procedure;
  begin
    clock;
    reset <= '0';
    for place in 0 to 3 loop
      expect_store("00", place, std_ulogic_vector(shift_left(unsigned'("0001"), place)), '0');
    end loop;
    expect_store("01", 0, "0011", '0');
    expect_store("01", 1, "0000", '1');
    expect_store("01", 2, "1100", '0');
    expect_store("01", 3, "0000", '1');
    expect_store("10", 0, "1111", '0');
    for place in 1 to 3 loop
      expect_store("10", place, "0000", '1');
    end loop;
    -- A load writes no lane.
    store <= '0';
    address <= x"8000fffc";
    wait for 1 ns;
    assert memory_request.enable = '1' and memory_request.write_bytes = "0000" and to_memory = '1'
      severity failure;
    -- Inside and outside the memory, far and near, with and without carries from the immediate.
    enable <= '0';
    for index in uppers'range loop
      for lower in -7 to 7 loop
        for part in offsets'range loop
          address <= (uppers(index) & x"0000") + unsigned(to_signed(lower * 300 + lower mod 2, 32));
          offset <= offsets(part);
          wait for 1 ns;
          assert to_memory = (address(31 downto 16) ?= x"8000")
            report to_hstring(address) & " with " & to_hstring(offset) severity failure;
          for eighth in 0 to 7 loop
            address(15 downto 13) <= to_unsigned(eighth, 3);
            wait for 1 ns;
            assert (to_larger_memory = '1') = (address >= x"80000000" and address < x"8001a000")
              report to_hstring(address) & " with " & to_hstring(offset) & " of 104 KiB" severity failure;
          end loop;
        end loop;
      end loop;
    end loop;
    address <= x"80000000";
    clock;
    use_bus(1, '0');
    use_bus(4, '0');
    use_bus(1, '1');
    -- Misaligned accesses do not reach the bus.
    address <= x"f0001231";
    clock;
    assert bus_request.strobe = '0' severity failure;
    address <= x"f0001232";
    enable <= '0';
    clock;
    assert bus_request.strobe = '0' severity failure;
    std.env.finish;
  end process;

end architecture;
