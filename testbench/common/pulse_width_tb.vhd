-- SPDX-License-Identifier: Apache-2.0
-- The pulse-width modulator is on for its duty at the start of every period, and changes without a glitch.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pulse_width_tb is
end entity;

architecture simulation of pulse_width_tb is

  constant width : positive := 4;
  constant slots : positive := 2 ** width - 1;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal advance : std_ulogic := '0';
  signal duty : unsigned(width - 1 downto 0) := (others => '0');
  signal level : std_ulogic;

begin

  clk <= not clk after 5 ns;

  modulator : entity work.pulse_width
    generic map (width => width)
    port map (clk => clk, reset => reset, advance => advance, duty => duty, level => level);

  check : process

    procedure next_slot is
    begin
      advance <= '1';
      wait until rising_edge(clk);
      advance <= '0';
      wait until rising_edge(clk);
      wait until falling_edge(clk);
    end procedure;

    -- A whole period at `present`; in its middle the duty is set to `following`.
    procedure check_period (present, following : natural) is
    begin
      for slot in 0 to slots - 1 loop
        next_slot;
        is_on_for_its_duty : assert (level = '1') = (slot < present)
          report "slot " & to_string(slot) & " at duty " & to_string(present) severity error;
        if slot = slots / 2 then
          duty <= to_unsigned(following, width);
        end if;
      end loop;
    end procedure;

    variable before : natural := 0;
  begin
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    reset <= '0';
    is_off_after_reset : assert level = '0' report "on after reset" severity error;
    for present in 0 to slots loop
      for following in 0 to slots loop
        check_period(before, present);
        check_period(present, following);
        before := following;
      end loop;
    end loop;
    reset <= '1';
    wait until rising_edge(clk);
    wait until falling_edge(clk);
    goes_off_at_reset : assert level = '0' report "on in reset" severity error;
    std.env.finish;
  end process;

end architecture;
