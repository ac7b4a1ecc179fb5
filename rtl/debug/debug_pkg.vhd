-- SPDX-License-Identifier: Apache-2.0
-- Interfaces within the debug port, and the addresses of its registers.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.processor_pkg.all;

package debug_pkg is

  -- A debugger's access to a register of the debug module: for one clock.
  type dmi_request_t is record
    strobe : std_ulogic;
    write : std_ulogic;
    address : std_ulogic_vector(6 downto 0);
    data : word_t;
  end record;

  -- A debugger's access to a CSR outside the processor: written in the clock of `write`;
  -- read data is combinational.
  type debug_csr_request_t is record
    write : std_ulogic;
    address : std_ulogic_vector(11 downto 0);
    data : word_t;
  end record;

  type debug_csr_response_t is record
    exists : std_ulogic;
    data : word_t;
  end record;

  -- Registers of the debug module (RISC-V External Debug Support 0.13.2, table 3.8).
  constant data0_address : std_ulogic_vector(6 downto 0) := 7x"04";
  constant dmcontrol_address : std_ulogic_vector(6 downto 0) := 7x"10";
  constant dmstatus_address : std_ulogic_vector(6 downto 0) := 7x"11";
  constant abstractcs_address : std_ulogic_vector(6 downto 0) := 7x"16";
  constant command_address : std_ulogic_vector(6 downto 0) := 7x"17";
  constant abstractauto_address : std_ulogic_vector(6 downto 0) := 7x"18";
  constant sbcs_address : std_ulogic_vector(6 downto 0) := 7x"38";
  constant sbaddress0_address : std_ulogic_vector(6 downto 0) := 7x"39";
  constant sbdata0_address : std_ulogic_vector(6 downto 0) := 7x"3c";
  constant haltsum0_address : std_ulogic_vector(6 downto 0) := 7x"40";

  -- abstractcs.cmderr, table 3.7.
  subtype command_error_t is std_ulogic_vector(2 downto 0);
  constant command_error_none : command_error_t := "000";
  constant command_error_busy : command_error_t := "001";
  constant command_error_not_supported : command_error_t := "010";
  constant command_error_exception : command_error_t := "011";
  constant command_error_not_halted : command_error_t := "100";

end package;
