-- SPDX-License-Identifier: Apache-2.0
-- Each refusal sets its own bit, which stays until software clears it or a reset.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library std;
use std.env.finish;

use work.step_generator_pkg.all;
use work.step_generator_registers_pkg.all;

entity error_latch_tb is
end entity;

architecture simulation of error_latch_tb is

  -- One event for each bit of the register, in the order of the bits.
  constant events : positive := 7;

  signal clk : std_ulogic := '0';
  signal reset : std_ulogic := '1';
  signal clear : std_ulogic := '0';
  signal event : std_ulogic_vector(events - 1 downto 0) := (others => '0');
  signal errors : step_generator_errors_t;

begin

  clk <= not clk after 10 ns;

  latch : entity work.error_latch
    port map (
      clk => clk, reset => reset, clear => clear,
      segment_refused => (
        queue_full => event(step_generator_errors_queue_full_bit),
        incomplete => event(step_generator_errors_incomplete_bit),
        illegal => event(step_generator_errors_illegal_bit),
        while_stopped => event(step_generator_errors_while_stopped_bit),
        disabled => event(step_generator_errors_disabled_bit)),
      position_refused => event(step_generator_errors_position_bit),
      setting_refused => event(step_generator_errors_settings_bit), errors => errors);

  test : process

    procedure clock is
    begin
      wait until rising_edge(clk);
      wait for 1 ns;
    end procedure;

    procedure expect(bits : std_ulogic_vector(events - 1 downto 0); what : string) is
    begin
      shows_what_was_refused : assert to_word(errors) = 25x"0" & bits
        report what & ": " & to_hstring(to_word(errors)) severity failure;
    end procedure;

    procedure refuse(bits : std_ulogic_vector(events - 1 downto 0)) is
    begin
      event <= bits;
      clock;
      event <= (others => '0');
    end procedure;

    variable bit_number : natural;
    variable one, kept : std_ulogic_vector(events - 1 downto 0);

  begin
    clock;
    reset <= '0';
    clock;
    expect("0000000", "after reset");

    for each in event'range loop
      one := (others => '0');
      one(each) := '1';
      refuse(one);
      expect(one, "one refusal");
      clock;
      expect(one, "later");
      clear <= '1';
      clock;
      clear <= '0';
      expect("0000000", "cleared");
    end loop;

    -- Several stay together, whichever comes first.
    for order in 0 to 1 loop
      kept := (others => '0');
      for i in event'range loop
        bit_number := i when order = 0 else event'high - i;
        one := (others => '0');
        one(bit_number) := '1';
        kept := kept or one;
        refuse(one);
        expect(kept, "several");
      end loop;
      clear <= '1';
      clock;
      clear <= '0';
    end loop;

    -- What is refused in the clock of the clearing is not lost.
    for each in event'range loop
      one := (others => '0');
      one(each) := '1';
      clear <= '1';
      clock;
      refuse(one);
      clear <= '0';
      expect(one, "while it is cleared");
    end loop;

    reset <= '1';
    refuse("1111111");
    expect("0000000", "reset");
    finish;
  end process;

end architecture;
