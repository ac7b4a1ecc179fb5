// SPDX-License-Identifier: Apache-2.0
// A host that has disconnected: the line was low and then idle. Its incomplete line is discarded,
// and the first line of the next host is whole.
#include <gtest/gtest.h>

#include "registers/uart_registers.hpp"
#include "tests/application/dialogue.hpp"

namespace {

using application_test::Printer;
using registers::uart::Breaks;
using registers::uart::FramingErrors;

class HangUp : public testing::Test {
 protected:
  HangUp() { printer.run(0.5); }

  void come(std::string_view bytes) {
    printer.chip.to_firmware.insert(printer.chip.to_firmware.end(), bytes.begin(), bytes.end());
  }
  // As the uart has it: counted, and the next byte is marked.
  void lose(std::uint32_t counter) {
    printer.chip.write(counter, printer.chip.read(counter) + 1);
    printer.chip.gap_before_next_byte = true;
  }

  Printer printer;
};

TEST_F(HangUp, leaves_no_half_line_to_the_next_host) {
  come("M118 old");
  printer.run(0.05);
  lose(Breaks::address);
  printer.run(0.1);
  printer.talk(R"(
    -> 
    <- ok
    -> M118 new
    <- new
    <- ok
  )");
}

TEST_F(HangUp, leaves_the_first_line_of_the_next_host_whole) {
  come("N1 M118 o");
  printer.run(0.05);
  lose(Breaks::address);
  printer.run(0.1);
  printer.talk(R"(
    -> M118 new
    <- new
    <- ok
  )");
}

TEST_F(HangUp, counts_where_the_half_line_and_the_break_are_seen_at_once) {
  come("M118 old");
  lose(Breaks::address);
  printer.chip.gap_before_next_byte = false;
  printer.run(0.1);
  printer.chip.gap_before_next_byte = true;
  printer.talk(R"(
    -> M118 new
    <- new
    <- ok
  )");
}

// The rest of a line must not run as a line of its own.
TEST_F(HangUp, is_not_a_break_in_the_midst_of_a_line) {
  come("M118 old");
  printer.run(0.05);
  lose(Breaks::address);
  printer.talk(R"(
    -> M118 rest
    <- echo:Line damaged on the serial line, not executed
    <- ok
    -> M118 new
    <- new
    <- ok
  )");
}

TEST_F(HangUp, does_not_hide_what_the_next_host_loses) {
  come("M118 old");
  printer.run(0.05);
  lose(Breaks::address);
  printer.run(0.1);
  lose(FramingErrors::address);
  printer.talk(R"(
    -> 118 new
    <- echo:Line damaged on the serial line, not executed
    <- ok
    -> M118 new
    <- new
    <- ok
  )");
}

// They are no longer awaited.
TEST_F(HangUp, ends_the_oks_that_wake_a_host) {
  printer.talk(R"(
    -> N0 M110 N0*125
    <- ok
  )");
  lose(Breaks::address);
  EXPECT_EQ(printer.reply(30), std::nullopt);
}

}  // namespace
