-- SPDX-License-Identifier: Apache-2.0
-- Each limit takes one write within its bounds, alone, and keeps it until reset.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.thermal_pkg.all;

entity heater_limits_tb is
end entity;

architecture simulation of heater_limits_tb is

  -- Bit numbers in what this bench writes and compares.
  constant minimum : natural := 0;
  constant maximum : natural := 1;
  constant hot : natural := 2;
  constant settle : natural := 3;

  type value_array_t is array (0 to 3) of unsigned(31 downto 0);
  constant forbids_everything : value_array_t := (
    x"FFFF_FFFF", x"0000_0000", x"0000_0000", x"00FF_FFFF");
  constant bounds : value_array_t := (x"0001_2345", x"00AB_CDEF", x"0009_1A28", x"0008_7654");

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal word : unsigned(31 downto 0) := (others => '0');
  signal written : std_ulogic_vector(3 downto 0) := "0000";
  signal forget_refused : std_ulogic := '0';
  signal values : value_array_t;
  signal settle_ticks : settle_t;
  signal locked : std_ulogic_vector(3 downto 0);
  signal refused : std_ulogic;

begin

  clk <= not clk after 10 ns;

  limits : entity work.heater_limits
    port map (
      clk => clk, reset => reset, least_count => bounds(minimum), most_count => bounds(maximum),
      least_hot_count => bounds(hot), longest_settle => bounds(settle)(settle_t'range),
      written => word, minimum_written => written(minimum), maximum_written => written(maximum),
      hot_written => written(hot), settle_written => written(settle),
      forget_refused => forget_refused, minimum_count => values(minimum),
      maximum_count => values(maximum), hot_count => values(hot), settle_ticks => settle_ticks,
      minimum_locked => locked(minimum), maximum_locked => locked(maximum),
      hot_locked => locked(hot), settle_locked => locked(settle), refused => refused);

  values(settle) <= resize(settle_ticks, 32);

  test : process

    variable expected : value_array_t;
    variable expected_locked : std_ulogic_vector(3 downto 0);

    procedure check (expected_refused : std_ulogic; what : string) is
    begin
      wait for 1 ns;
      for limit in value_array_t'range loop
        holds_its_value : assert values(limit) = expected(limit)
          report what & ": limit " & to_string(limit) & " is " & to_hstring(values(limit)) severity error;
      end loop;
      locks_alone : assert locked = expected_locked
        report what & ": locked " & to_string(locked) severity error;
      says_what_it_refused : assert refused = expected_refused
        report what & ": refused is " & to_string(refused) severity error;
    end procedure;

    function to_std_ulogic (condition : boolean) return std_ulogic is
    begin
      if condition then
        return '1';
      end if;
      return '0';
    end function;

    procedure restart is
    begin
      reset <= '1';
      wait until rising_edge(clk);
      reset <= '0';
      expected := forbids_everything;
      expected_locked := "0000";
      check('0', "reset");
    end procedure;

    procedure write (limit : natural; value : unsigned(31 downto 0); is_taken : boolean) is
    begin
      word <= value;
      written(limit) <= '1';
      wait until rising_edge(clk);
      written(limit) <= '0';
      if is_taken then
        expected(limit) := value;
        expected_locked(limit) := '1';
      end if;
      check(not to_std_ulogic(is_taken), "limit " & to_string(limit) & " := " & to_hstring(value));
      wait until rising_edge(clk);
      check(not to_std_ulogic(is_taken), "a clock later");
      forget_refused <= '1';
      wait until rising_edge(clk);
      forget_refused <= '0';
      check('0', "forgotten");
    end procedure;

    -- One step over the bound, to the side that is forbidden.
    function beyond (limit : natural) return unsigned is
    begin
      if limit = minimum or limit = hot then
        return bounds(limit) - 1;
      end if;
      return bounds(limit) + 1;
    end function;

    function within (limit : natural) return unsigned is
    begin
      if limit = minimum or limit = hot then
        return bounds(limit) + 16#5432#;
      end if;
      return bounds(limit) - 16#5432#;
    end function;

  begin
    wait until rising_edge(clk);
    restart;
    for limit in value_array_t'range loop
      write(limit, beyond(limit), false);
      -- Of the settling time no bit is lost before it is compared.
      if limit = settle then
        write(limit, x"0100_0001", false);
      end if;
      write(limit, bounds(limit), true);
      write(limit, bounds(limit), false);
      write(limit, within(limit), false);
      write(limit, beyond(limit), false);
    end loop;
    -- Each is set and refused also where it is the only one.
    for limit in value_array_t'range loop
      restart;
      write(limit, within(limit), true);
      write(limit, within(limit), false);
    end loop;
    restart;

    -- What is forgotten and refused in the same clock has been refused.
    word <= beyond(maximum);
    written(maximum) <= '1';
    forget_refused <= '1';
    wait until rising_edge(clk);
    written(maximum) <= '0';
    forget_refused <= '0';
    check('1', "forgotten in the clock of a refusal");
    restart;

    -- Reset wins over a write.
    for limit in value_array_t'range loop
      word <= bounds(limit);
      written(limit) <= '1';
      restart;
      written(limit) <= '0';
    end loop;
    finish;
  end process;

end architecture;
