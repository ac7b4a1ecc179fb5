-- SPDX-License-Identifier: Apache-2.0
-- Receives bytes from a serial line: 8 data bits, no parity, 1 stop bit, from 4 clocks per bit on.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity uart_receiver is
  port (
    clk : in std_ulogic;
    -- Ends a frame that is under way. To be held while `increment` is 0.
    reset : in std_ulogic;
    -- Bits per clock in 2**-32, at most 2**30.
    increment : in unsigned(31 downto 0);
    -- The pin, asynchronous, idle high.
    receive : in std_ulogic;
    -- Each of these is '1' for one clock: a byte in `data`, one that had no stop bit and is
    -- dropped, or a frame that was low from end to end.
    valid : out std_ulogic := '0';
    -- With `valid`: the samples of a bit of this byte differed. Below 16 clocks per bit a deviation
    -- of the baud rate alone can cause this.
    noisy : out std_ulogic := '0';
    framing_error : out std_ulogic := '0';
    break_condition : out std_ulogic := '0';
    data : out std_ulogic_vector(7 downto 0) := (others => '0');
    -- In a frame, or about to begin one.
    busy : out std_ulogic;
    -- A new level of the pin is under way to the receiver.
    settling : out std_ulogic
  );
end entity;

architecture rtl of uart_receiver is

  type state_t is (idle, start_bit, data_bits, stop_bit, late_stop_bit, recovering);

  signal state : state_t := idle;
  -- The line, synchronised.
  signal received : std_ulogic;
  -- Its levels at the last two ticks, the newer one in (0).
  signal earlier : std_ulogic_vector(1 downto 0) := (others => '1');
  -- Time since the start bit began, in bits, without the whole ones.
  signal phase : unsigned(31 downto 0) := (others => '0');
  -- The last tick was the nearest to the middle of a bit.
  signal middle_passed : std_ulogic := '0';
  signal bit_index : natural range 0 to 7 := 0;
  -- Samples of a bit of the current frame differed.
  signal looks_differed : std_ulogic := '0';

begin

  synchronize : entity work.synchronizer
    generic map (idle_level => '1')
    port map (
      clk => clk, asynchronous(0) => receive, synchronous(0) => received, settling => settling);

  busy <= '1' when state /= idle or received = '0' else '0';

  -- Work is done in ticks: every clock of a fast line, every 16th of a bit of a slow one. A bit's
  -- level is the majority of three ticks around its middle. The first clock that sees the start bit
  -- low is on average half a clock late, so it counts as one clock into the bit where the middle is
  -- rounded up.
  receive_frames : process
    variable next_phase : unsigned(31 downto 0);
    variable tick : boolean;
    variable level : std_ulogic;
    variable looks_differ : std_ulogic;

    procedure begin_frame is
    begin
      state <= start_bit;
      phase <= increment;
      middle_passed <= '0';
      looks_differed <= '0';
      earlier <= "10";
    end procedure;
  begin
    wait until rising_edge(clk);
    valid <= '0';
    framing_error <= '0';
    break_condition <= '0';
    if state = idle then
      if not received then
        begin_frame;
      end if;
    else
      next_phase := phase + increment;
      phase <= next_phase;
      tick := increment(31 downto 28) /= 0 or next_phase(31 downto 28) /= phase(31 downto 28);
      if tick then
        level := (received and earlier(0)) or (received and earlier(1))
          or (earlier(0) and earlier(1));
        earlier <= earlier(0) & received;
        looks_differ := (received xor earlier(0)) or (received xor earlier(1));
        middle_passed <= next_phase(31) and not phase(31);
        if middle_passed then
          looks_differed <= looks_differed or looks_differ;
        end if;
        case state is
          when idle =>
            null;
          when start_bit =>
            -- Not low from its first tick to its middle: that was noise.
            if level then
              state <= idle;
            elsif middle_passed then
              state <= data_bits;
              bit_index <= 0;
            end if;
          when data_bits =>
            if middle_passed then
              data <= level & data(7 downto 1);
              if bit_index = 7 then
                state <= stop_bit;
              else
                bit_index <= bit_index + 1;
              end if;
            end if;
          when stop_bit | late_stop_bit =>
            if state = late_stop_bit or middle_passed = '1' then
              if level then
                valid <= '1';
                noisy <= looks_differed or looks_differ;
                state <= idle;
                if not received then
                  -- The next start bit of a fast sender has already begun.
                  begin_frame;
                end if;
              elsif state = stop_bit then
                -- The stop bit of a slow sender may come a tick later.
                state <= late_stop_bit;
              else
                framing_error <= '1' when data /= x"00" else '0';
                break_condition <= '1' when data = x"00" else '0';
                state <= recovering;
              end if;
            end if;
          when recovering =>
            if level then
              state <= idle;
            end if;
        end case;
      end if;
    end if;
    if reset then
      state <= idle;
      valid <= '0';
      framing_error <= '0';
      break_condition <= '0';
    end if;
  end process;

end architecture;
