// SPDX-License-Identifier: Apache-2.0
// The VHDL of a register file, with @names@ where a peripheral's own go.
#pragma once

#include <string_view>

namespace register_generator {

inline constexpr std::string_view entity_template =
    R"(-- SPDX-License-Identifier: Apache-2.0
-- Registers of `@unit@`. Generated from @source@: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bus_pkg.all;
use work.@unit@_registers_pkg.all;

entity @unit@_registers is
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    request : in bus_request_t;
    @ports@
  );
end entity;

architecture rtl of @unit@_registers is

  -- The first clock of an access, and what it was, one clock later.
  signal access_begins : std_ulogic;
  signal answered, writing : std_ulogic := '0';
  -- Of what is known only: the bits above are 0.
  signal register_index : unsigned(@index_high@ downto 0) := (others => '0');
  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');
  signal whole_write : std_ulogic;
  signal readable, writable, known : std_ulogic;
  signal read_word : std_ulogic_vector(31 downto 0);
  @signals@

begin

  access_begins <= request.strobe and not answered;

  -- Answers in the clock after the strobe; an error for everything that is not described.
  answer : process
  begin
    wait until rising_edge(clk);
    answered <= access_begins;
    writing <= access_begins and known and request.write;
    response.acknowledge <= access_begins and known;
    response.error <= access_begins and not known;
    response.data <= (others => '0');
    if access_begins then
      response.data <= read_word;
      written_data <= request.data;
      register_index <= request.address(@address_high@ downto 2);
    end if;
    if reset then
      answered <= '0';
      writing <= '0';
      response <= bus_response_idle;
    end if;
  end process;

  -- Whole words only.
  whole_write <= request.write and (and request.select_bytes);
  known <= writable and whole_write when request.write = '1' else readable;

  readable <= @readable@;

  writable <= @writable@;

  @reads@

  read_word <= @any_word@;
  @store@
  @events@
  @connections@

end architecture;
)";

// The word of a register, 0 while another is read.
inline constexpr std::string_view read_template =
    R"(@name@_word <= to_word(@value@)
  when request.address(11 downto 2) = @index@ else (others => '0');
)";

// Registers that are kept here.
inline constexpr std::string_view store_template = R"(
store : process
begin
  wait until rising_edge(clk);
  @stores@
  if reset then
    @resets@
  end if;
end process;
)";

inline constexpr std::string_view one_store_template =
    R"(if writing = '1' and register_index = @index@ then
  @name@_stored <= to_@register@(written_data);
end if;
)";

// Writes and reads that the hardware sees in the clock of their acknowledge.
inline constexpr std::string_view events_template =
    R"(
-- Which register it is, is found out before the clock in which the hardware needs it. Only what
-- can be written, or read, has such an event: the address alone says that it is known.
find_events : process
begin
  wait until rising_edge(clk);
  @finds@
  if reset then
    @resets@
  end if;
end process;
)";

inline constexpr std::string_view one_event_template =
    R"(@event@ <= access_begins and @direction@ and (request.address(11 downto 2) ?= @index@);
)";

inline constexpr std::string_view note_template =
    R"(
-- One clock later than the write, together with the stored value.
note_@name@ : process
begin
  wait until rising_edge(clk);
  from_software.@written@ <= '1' when writing = '1' and register_index = @index@ else '0';
end process;
)";

}  // namespace register_generator
