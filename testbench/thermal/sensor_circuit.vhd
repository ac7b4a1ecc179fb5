-- SPDX-License-Identifier: Apache-2.0
-- Model of one sensor channel outside the chip: a capacitor and the resistors through which pins charge it.

library ieee;
use ieee.math_real.all;
use ieee.std_logic_1164.all;

use work.thermal_pkg.all;

entity sensor_circuit is
  generic (
    -- Time constant of one ohm with the capacitor, in clocks.
    clocks_per_ohm : real;
    reference_low_ohms : real := 470.0;
    reference_high_ohms : real := 10_000.0;
    -- Of the supply.
    threshold : real := 0.5
  );
  port (
    clk : in std_ulogic;
    drive_enable : in std_ulogic_vector(resistors - 1 downto 0);
    drive_level : in std_ulogic_vector(resistors - 1 downto 0);
    -- Infinite where negative: a broken wire.
    thermistor_ohms : in real;
    -- The pin reads 1 or 0, whatever the voltage.
    stuck_high : in std_ulogic := '0';
    stuck_low : in std_ulogic := '0';
    sense : out std_ulogic := '0'
  );
end entity;

architecture simulation of sensor_circuit is

  signal volts : real := 0.0;

begin

  charge : process
    variable siemens, amperes, branch, remaining : real;
    variable drive_before, level_before : std_ulogic_vector(resistors - 1 downto 0) := (others => '0');
    variable ohms_before : real := 0.0;
    variable final : real := 0.0;
    variable decay : real := 1.0;
    type ohms_t is array (0 to resistors - 1) of real;
    variable ohms : ohms_t;
  begin
    wait until falling_edge(clk);
    if drive_enable /= drive_before or drive_level /= level_before or thermistor_ohms /= ohms_before then
      drive_before := drive_enable;
      level_before := drive_level;
      ohms_before := thermistor_ohms;
      ohms := (thermistor => thermistor_ohms, reference_low => reference_low_ohms,
        reference_high => reference_high_ohms);
      siemens := 1.0e-12;
      amperes := 0.0;
      for i in ohms'range loop
        if drive_enable(i) = '1' and ohms(i) >= 0.0 then
          branch := 1.0 / (ohms(i) + 1.0);
          siemens := siemens + branch;
          if drive_level(i) then
            amperes := amperes + branch;
          end if;
        end if;
      end loop;
      final := amperes / siemens;
      decay := exp(-siemens / clocks_per_ohm);
    end if;
    volts <= final + (volts - final) * decay;
  end process;

  sense <= '1' when stuck_high = '1' or (volts > threshold and stuck_low = '0') else '0';

end architecture;
