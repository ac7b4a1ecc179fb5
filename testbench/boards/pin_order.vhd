-- SPDX-License-Identifier: Apache-2.0
-- Sets one signal at a time, at the chip inside a board's top entity or outside, and looks at the other end.

library ieee;
use ieee.std_logic_1164.all;

package pin_types is

  -- What the chip sets.
  type Chip_outputs is record
    step : std_ulogic_vector(4 downto 0);
    direction : std_ulogic_vector(4 downto 0);
    enable : std_ulogic_vector(4 downto 0);
    heater : std_ulogic_vector(1 downto 0);
    supply : std_ulogic;
    fan : std_ulogic;
    transmit : std_ulogic;
    fault : std_ulogic;
    driven : std_ulogic_vector(5 downto 0);
    level : std_ulogic_vector(5 downto 0);
  end record;

  -- What is set outside, and what the chip sees of it. The last are TCK, TMS, TDI.
  type Inputs is record
    end_stop : std_ulogic_vector(7 downto 0);
    sense : std_ulogic_vector(1 downto 0);
    emergency_stop : std_ulogic;
    receive : std_ulogic;
    jtag : std_ulogic_vector(2 downto 0);
  end record;

  type Pins is record
    step : std_ulogic_vector(4 downto 0);
    direction : std_ulogic_vector(4 downto 0);
    enable : std_ulogic_vector(4 downto 0);
    heater : std_ulogic_vector(1 downto 0);
    supply : std_ulogic;
    fan : std_ulogic;
    transmit : std_ulogic;
    -- Open, which a pull in the bench makes 'L'.
    resistor : std_logic_vector(5 downto 0);
    led : std_ulogic_vector(7 downto 0);
  end record;

end package;

library ieee;
use ieee.std_logic_1164.all;
use work.pin_types.all;

entity pin_order is
  generic (
    board : string;
    -- Of a motor's pin that enables it.
    enable_level : std_ulogic := '0';
    -- The fifth motor does as the third.
    has_second_z : boolean := false;
    end_stops : positive := 8
  );
  port (
    chip : out Chip_outputs;
    outside : out Inputs;
    seen : in Inputs;
    pin : in Pins;
    done : out std_ulogic := '0'
  );
end entity;

architecture simulation of pin_order is

  -- Longer than the registers before the pins.
  constant settle_time : time := 100 ns;
  -- Until the clock watch closes or opens the supply of the heaters.
  constant watch_time : time := 60 us;

begin

  check : process

    procedure expect(holds : boolean; what : string) is
    begin
      belongs : assert holds report board & ": another pin, or another level: " & what severity error;
    end procedure;

    variable one : std_ulogic_vector(7 downto 0);
    variable motors, enables : std_ulogic_vector(4 downto 0);
    variable high, low : std_logic_vector(5 downto 0);
    variable switches : std_ulogic_vector(7 downto 0);

  begin
    chip <= ("00000", "00000", "00000", "00", '0', '0', '1', '0', "000000", "000000");
    outside <= (x"00", "00", '0', '1', "111");
    -- The loops are locked, and the resets have ended.
    wait for 70 us;
    for index in 0 to 7 loop
      one := (others => '0');
      one(index) := '1';
      motors := one(4 downto 0);
      chip.step <= motors;
      chip.direction <= not motors;
      chip.enable <= motors;
      if has_second_z then
        motors(4) := motors(2);
      end if;
      enables := motors when enable_level = '1' else not motors;
      chip.heater <= one(1 downto 0);
      chip.fan <= one(2);
      chip.transmit <= one(3);
      chip.fault <= one(4);
      chip.driven <= one(5 downto 0);
      chip.level <= one(5 downto 0);
      outside.end_stop <= one;
      outside.sense <= one(1 downto 0);
      outside.jtag <= one(2 downto 0);
      outside.emergency_stop <= one(3);
      outside.receive <= one(4);
      switches := (others => '1');
      switches(end_stops - 1 downto 0) := one(end_stops - 1 downto 0);
      high := (others => 'L');
      low := (others => 'L');
      if index < 6 then
        high(index) := '1';
        low(index) := '0';
      end if;
      wait for settle_time;
      expect(pin.step = motors, "step");
      expect(pin.direction(3 downto 0) = not motors(3 downto 0), "direction");
      expect(has_second_z or pin.direction(4) = not motors(4), "direction of the fifth");
      expect(not has_second_z or pin.direction(4) = not motors(2), "direction of the second Z");
      expect(pin.enable = enables, "enable");
      expect(pin.led(6 downto 2) = one(4 downto 0), "lamps of the motors");
      expect(pin.led(0) = one(4), "lamp of the fault");
      expect(pin.heater = one(1 downto 0), "heater");
      expect(pin.fan = one(2), "fan");
      expect(pin.transmit = one(3), "transmit");
      expect(pin.resistor = high, "resistor that is driven high");
      expect(seen.end_stop = switches, "end stop");
      expect(seen.sense = one(1 downto 0), "sense");
      expect(seen.jtag = one(2 downto 0), "JTAG");
      expect(seen.emergency_stop = one(3), "emergency stop");
      expect(seen.receive = one(4), "receive");
      chip.level <= not one(5 downto 0);
      wait for settle_time;
      expect(pin.resistor = low, "resistor that is driven low");
    end loop;
    chip.supply <= '1';
    wait for watch_time;
    expect(pin.supply = '1', "supply that is wanted");
    chip.supply <= '0';
    wait for watch_time;
    expect(pin.supply = '0', "supply that is not wanted");
    done <= '1';
    wait;
  end process;

end architecture;
