-- SPDX-License-Identifier: Apache-2.0
-- Sends bytes on a serial line: 8 data bits, no parity, 1 stop bit, without a gap between bytes.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity uart_transmitter is
  port (
    clk : in std_ulogic;
    -- Ends a frame that is under way. To be held while `increment` is 0.
    reset : in std_ulogic;
    -- Bits per clock in 2**-32, at most 2**30. Every edge comes less than a clock after its exact time.
    increment : in unsigned(31 downto 0);
    -- The next byte to send, if `valid`. `taken` is '1' in the clock after it was taken; the
    -- following byte must be there two clocks later.
    data : in std_ulogic_vector(7 downto 0);
    valid : in std_ulogic;
    taken : out std_ulogic := '0';
    -- A frame is under way.
    busy : out std_ulogic := '0';
    -- The pin, idle high.
    transmit : out std_ulogic := '1'
  );
end entity;

architecture rtl of uart_transmitter is

  -- What follows the bit on the line: data bits, then ones.
  signal remaining_bits : std_ulogic_vector(7 downto 0) := (others => '1');
  -- Bits to come after the one on the line.
  signal remaining : natural range 0 to 9 := 0;
  -- Time since the bit on the line began, in bits.
  signal phase : unsigned(31 downto 0) := (others => '0');

begin

  send_frames : process
    variable next_phase : unsigned(32 downto 0);
    variable frame_ends : boolean;
  begin
    wait until rising_edge(clk);
    taken <= '0';
    frame_ends := false;
    if busy then
      next_phase := ('0' & phase) + increment;
      phase <= next_phase(31 downto 0);
      if next_phase(32) then
        frame_ends := remaining = 0;
        if not frame_ends then
          transmit <= remaining_bits(0);
          remaining_bits <= '1' & remaining_bits(7 downto 1);
          remaining <= remaining - 1;
        end if;
      end if;
    else
      phase <= (others => '0');
    end if;
    if frame_ends or busy = '0' then
      busy <= valid;
      if valid then
        taken <= '1';
        transmit <= '0';
        remaining_bits <= data;
        remaining <= 9;
      end if;
    end if;
    if reset then
      taken <= '0';
      busy <= '0';
      transmit <= '1';
    end if;
  end process;

end architecture;
