-- SPDX-License-Identifier: Apache-2.0
-- Integrates the tick rate of the segment being executed and makes the ticks that all axes share.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.step_generator_pkg.all;

-- Each clock: phase += rate; rate += acceleration; acceleration += jerk; a carry of phase is a tick.
-- The rate is at most 1/2, so two ticks are at least two clocks apart: what depends on the tick before
-- is worked out in the clock between. The end of a segment passes the rest of its phase to the next one.
entity time_base is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;

    -- Time passes for the base: low clocks stretch the motion without changing its path. The place for
    -- feed hold and override.
    advance : in std_ulogic;
    -- Motion may begin from rest.
    run : in std_ulogic;
    -- No tick in this clock, and back to rest.
    stop : in std_ulogic;
    -- In 2^-32 ticks per clock.
    rate_floor : in unsigned(30 downto 0);

    head_valid : in std_ulogic;
    head : in segment_t;
    -- The head becomes the segment being executed with the next clock.
    take : out std_ulogic;

    -- The base has come to a tick, which is made unless an axis is not ready for its step: then the base
    -- stands still in this clock.
    due : out std_ulogic;
    axes_ready : in std_ulogic;
    tick : out std_ulogic;

    -- A segment is being executed, and ends by these end stops.
    active : out std_ulogic := '0';
    stop_mask : out std_ulogic_vector(7 downto 0) := (others => '0');

    segments : out count_t := (others => '0');
    underruns : out count_t := (others => '0');
    -- Clocks in which an axis was not ready.
    stalls : out count_t := (others => '0')
  );
end entity;

architecture rtl of time_base is

  constant highest_rate : unsigned(63 downto 0) := (63 => '1', others => '0');

  signal phase : unsigned(63 downto 0) := (others => '0');
  signal rate : unsigned(63 downto 0) := (others => '0');
  signal acceleration : signed(63 downto 0) := (others => '0');
  signal jerk : signed(63 downto 0) := (others => '0');
  signal ends_motion : std_ulogic := '0';
  signal ticks_left : ticks_t := (others => '0');
  -- Known from the clock after a tick on: the next tick is the segment's last.
  signal last : std_ulogic := '0';
  signal count_changed : std_ulogic := '0';

  signal phase_sum : unsigned(63 downto 0);
  signal carry : std_ulogic;
  signal next_rate : unsigned(63 downto 0);

  -- A rate below the floor is held at it.
  function floored(value : unsigned(63 downto 0); floor : unsigned(30 downto 0)) return unsigned is
  begin
    if value(63 downto 32) < floor then
      return '0' & floor & x"00000000";
    end if;
    return value;
  end function;

  -- The acceleration's part of a whole rate unit is 44 bits, so that a sum below 0 shows as one above
  -- 3/4, and one above the highest rate as one below 3/4.
  function integrated(value : unsigned(63 downto 0); change : signed(63 downto 0);
    floor : unsigned(30 downto 0)) return unsigned is
    variable sum : unsigned(63 downto 0);
  begin
    sum := value + unsigned(resize(change(63 downto 20), 64));
    case sum(63 downto 62) is
      when "10" => return highest_rate;
      when "11" => return '0' & floor & x"00000000";
      when others => return floored(sum, floor);
    end case;
  end function;

begin

  phase_sum <= phase + rate;
  -- With a rate of at most 1/2 a carry leaves less than 1/2 behind, and only comes from more than 1/2.
  carry <= phase(63) and not phase_sum(63);
  next_rate <= integrated(rate, acceleration, rate_floor);

  due <= active and advance and not stop and carry;
  tick <= due and axes_ready;
  take <= head_valid and not stop and ((tick and last) or (not active and run));

  integrate : process
  begin
    wait until rising_edge(clk);

    if active and advance and (not carry or axes_ready) then
      phase <= phase_sum;
      rate <= next_rate;
      acceleration <= acceleration + jerk;
    end if;

    count_changed <= tick or take;
    if count_changed then
      last <= '1' when ticks_left = 1 else '0';
    end if;

    if tick then
      ticks_left <= ticks_left - 1;
      if last then
        active <= '0';
        if not (head_valid or ends_motion) then
          underruns <= underruns + 1;
        end if;
      end if;
    elsif due then
      stalls <= stalls + 1;
    end if;

    if take then
      active <= '1';
      segments <= segments + 1;
      rate <= floored(head.rate, rate_floor);
      acceleration <= head.acceleration;
      jerk <= head.jerk;
      ticks_left <= head.ticks;
      ends_motion <= head.ends_motion;
      stop_mask <= head.stop_mask;
      if not active then
        phase <= (others => '0');
      end if;
    end if;

    if stop then
      active <= '0';
    end if;

    if reset then
      active <= '0';
      segments <= (others => '0');
      underruns <= (others => '0');
      stalls <= (others => '0');
    end if;

    ticks_are_two_clocks_apart : assert reset = '1' or tick = '0' or count_changed = '0'
      severity failure;
    no_tick_is_made_when_stopped : assert tick = '0' or stop = '0' severity failure;
  end process;

end architecture;
