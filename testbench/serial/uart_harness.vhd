-- SPDX-License-Identifier: Apache-2.0
-- A serial line with its clock; what it hears comes from the bench or, looped back, from itself.

library ieee;
use ieee.std_logic_1164.all;

use work.bus_pkg.all;
use work.uart_harness_pkg.all;

entity uart_harness is
  port (
    clk : out std_ulogic := '0';
    reset : in std_ulogic;
    request : in bus_request_t;
    response : out bus_response_t;
    sent : in std_ulogic;
    looped_back : in boolean;
    transmit : out std_ulogic;
    receive_interrupt : out std_ulogic;
    transmit_interrupt : out std_ulogic
  );
end entity;

architecture simulation of uart_harness is

  signal receive : std_ulogic;

begin

  clk <= not clk after clock_period / 2;
  receive <= transmit when looped_back else sent;

  uart : entity work.uart
    generic map (receive_depth => receive_depth, transmit_depth => transmit_depth)
    port map (
      clk => clk, bus_clk => clk,
      reset => reset, request => request, response => response, receive => receive,
      transmit => transmit, receive_interrupt => receive_interrupt,
      transmit_interrupt => transmit_interrupt);

end architecture;
