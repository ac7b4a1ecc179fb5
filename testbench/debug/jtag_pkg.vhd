-- SPDX-License-Identifier: Apache-2.0
-- A JTAG adapter: moves the pins of the debug port and accesses the debug module through them.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package jtag_pkg is

  -- The adapter drives all but `tdo`, the port drives that alone: so the fields are resolved.
  type jtag_t is record
    tck : std_logic;
    tms : std_logic;
    tdi : std_logic;
    tdo : std_logic;
  end record;

  constant jtag_idle : jtag_t := (tck => '0', tms => '1', tdi => '0', tdo => 'Z');

  -- The fastest that the port allows, with a chip's clock of 10 ns: low for five clocks, high for two.
  constant low_time : time := 50 ns;
  constant high_time : time := 20 ns;

  -- One clock of `tck`; `tdo` is what an adapter sees as `tck` rises.
  procedure clock_tap(signal jtag : inout jtag_t; tms, tdi : std_ulogic; seen : out std_ulogic);
  -- Five clocks with `tms` high, then to run-test/idle.
  procedure reset_tap(signal jtag : inout jtag_t);
  -- From run-test/idle through a register and back, lowest bit first; `captured` is what was in it.
  procedure scan_instruction(signal jtag : inout jtag_t; instruction : std_ulogic_vector);
  procedure scan_data(signal jtag : inout jtag_t; data : std_ulogic_vector; captured : out std_ulogic_vector);
  -- Of a register of the debug module; dmi must be the instruction.
  procedure write_dmi(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                      data : std_ulogic_vector(31 downto 0));
  procedure read_dmi(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                     data : out std_ulogic_vector(31 downto 0));

end package;

package body jtag_pkg is

  procedure clock_tap(signal jtag : inout jtag_t; tms, tdi : std_ulogic; seen : out std_ulogic) is
  begin
    jtag <= (tck => '0', tms => tms, tdi => tdi, tdo => 'Z');
    wait for low_time;
    seen := jtag.tdo;
    jtag.tck <= '1';
    wait for high_time;
  end procedure;

  procedure walk(signal jtag : inout jtag_t; path : std_ulogic_vector) is
    variable seen : std_ulogic;
  begin
    for index in path'range loop
      clock_tap(jtag, path(index), '0', seen);
    end loop;
  end procedure;

  procedure reset_tap(signal jtag : inout jtag_t) is
  begin
    walk(jtag, "111110");
  end procedure;

  -- From the state select to run-test/idle.
  procedure scan(signal jtag : inout jtag_t; data : std_ulogic_vector;
                 captured : out std_ulogic_vector) is
    alias bits : std_ulogic_vector(data'length - 1 downto 0) is data;
    variable seen : std_ulogic_vector(data'length - 1 downto 0);
    variable last : std_ulogic;
  begin
    walk(jtag, "00");
    for index in 0 to data'length - 1 loop
      last := '1' when index = data'length - 1 else '0';
      clock_tap(jtag, last, bits(index), seen(index));
    end loop;
    captured := seen;
    walk(jtag, "10");
  end procedure;

  procedure scan_instruction(signal jtag : inout jtag_t; instruction : std_ulogic_vector) is
    variable captured : std_ulogic_vector(instruction'length - 1 downto 0);
  begin
    walk(jtag, "11");
    scan(jtag, instruction, captured);
    assert captured(1 downto 0) = "01" report "the instruction register captures 01" severity failure;
  end procedure;

  procedure scan_data(signal jtag : inout jtag_t; data : std_ulogic_vector;
                      captured : out std_ulogic_vector) is
  begin
    walk(jtag, "1");
    scan(jtag, data, captured);
  end procedure;

  procedure write_dmi(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                      data : std_ulogic_vector(31 downto 0)) is
    variable captured : std_ulogic_vector(40 downto 0);
  begin
    scan_data(jtag, address & data & "10", captured);
  end procedure;

  procedure read_dmi(signal jtag : inout jtag_t; address : std_ulogic_vector(6 downto 0);
                     data : out std_ulogic_vector(31 downto 0)) is
    variable captured : std_ulogic_vector(40 downto 0);
  begin
    scan_data(jtag, address & x"00000000" & "01", captured);
    scan_data(jtag, 41x"0", captured);
    assert captured(40 downto 34) = address report "the answer names the register" severity failure;
    assert captured(1 downto 0) = "00" report "an access is reported to have failed" severity failure;
    data := captured(33 downto 2);
  end procedure;

end package body;
