// SPDX-License-Identifier: Apache-2.0
// The whole chip is loaded over its simulated serial line, with all kinds of errors.
#include <gtest/gtest.h>

#include <deque>
#include <string>

#include "sim/processor/encode.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/loading/loading.hpp"

namespace {

namespace encode = processor::encode;
using loading::LoadFailed;
using loading::Program;

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr std::uint32_t sign_address = 0x8000E000, sign = 0x12345678;

// Leaves its sign in memory and sleeps.
Program small_program(std::size_t bytes = 3000) {
  Program program{
      .address = loading::memory_address, .bytes = {}, .entry = loading::memory_address};
  for (const std::uint32_t word :
       {encode::load_upper(5, sign_address), encode::load_upper(6, sign & 0xFFFFF000),
        encode::add_immediate(6, 6, sign & 0xFFF), encode::store(2, 6, 5, 0),
        std::uint32_t{0x10500073}, encode::jump_and_link(0, -4)}) {
    for (int shift = 0; shift < 32; shift += 8) {
      program.bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
  }
  while (program.bytes.size() < bytes) {
    program.bytes.push_back(static_cast<std::uint8_t>(program.bytes.size() * 37));
  }
  return program;
}

// The printer with its firmware, and a host's port on its line.
class Bench : public loading::ByteStream, public devices::ByteListener {
 public:
  explicit Bench(double corrupted_bytes = 0)
      : loaded_(chip_, clock_hz, 40, 30, faults(corrupted_bytes)) {
    loaded_.printer.serial_line().set_listener(*this);
  }

  void byte_received(sim::Clock, std::uint8_t byte) override {
    to_read_.push_back(byte);
    heard += static_cast<char>(byte);
  }

  void write(std::span<const std::uint8_t> bytes) override {
    if (bytes.size() > vanishes_after) throw LoadFailed("the host is gone");
    vanishes_after -= bytes.size();
    send({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    while (loaded_.printer.serial_line().waiting_bytes() != 0) run(0.0005);
  }
  std::size_t read(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    for (double waited = 0; to_read_.empty() && waited < 1e-3 * double(timeout.count());
         waited += 0.001) {
      run(0.001);
    }
    std::size_t count = 0;
    while (count < bytes.size() && !to_read_.empty()) {
      bytes[count++] = to_read_.front();
      to_read_.pop_front();
    }
    return count;
  }

  void send(std::string_view text) { loaded_.printer.serial_line().send(chip_.now(), text); }
  void run(double seconds) {
    loaded_.simulation.run_until(loaded_.simulation.now() +
                                 loaded_.simulation.rate().clocks(seconds));
    heated = heated || chip_.outputs().heater(0) || chip_.outputs().heater(1);
  }
  // Milliseconds until the text is heard, from now on.
  unsigned milliseconds_to(std::string_view text, unsigned most) {
    heard.clear();
    unsigned waited = 0;
    for (; waited < most && !heard.contains(text); ++waited) run(0.001);
    return waited;
  }
  bool program_ran() const { return chip_.read_memory(sign_address) == sign; }
  void reset() { chip_.reset(); }
  std::uint32_t word(std::uint32_t address) const { return chip_.read_memory(address); }

  std::size_t vanishes_after = ~std::size_t{0};
  std::string heard;
  bool heated = false;

 private:
  static machine::FaultPlan faults(double corrupted_bytes) {
    machine::FaultPlan faults;
    faults.corrupted_bytes = corrupted_bytes;
    return faults;
  }

  sim::VerilatedChip chip_{clock_hz};
  tests::LoadedPrinter loaded_;
  std::deque<std::uint8_t> to_read_;
};

TEST(boot_loader_chip, the_firmware_greets_soon_after_reset_and_sooner_to_a_host_that_speaks) {
  Bench bench;
  const unsigned silent = bench.milliseconds_to("start\n", 200);
  EXPECT_LE(silent, 50u);  // at 4 MHz
  EXPECT_GE(silent, 10u);  // the loader's window
  bench.reset();
  bench.run(0.001);  // in which the loader sets up the line
  bench.send("\n");
  const unsigned spoken_to = bench.milliseconds_to("start\n", 200);
  EXPECT_LE(spoken_to + 8, silent);
  bench.send("M105\n");
  // With the first reading, which takes as long as a cold sensor charges.
  EXPECT_LT(bench.milliseconds_to("ok T:", 1500), 1000u);
}

TEST(boot_loader_chip, a_program_takes_the_firmwares_place_with_heat_off) {
  Bench bench;
  bench.milliseconds_to("start\n", 200);
  bench.send("M104 S200\n");
  bench.run(0.5);
  EXPECT_TRUE(bench.heated);
  const Program program = small_program();
  bool first = true;
  loading::load(bench, program, {.sent = [&](std::size_t) {
                  if (first) bench.heated = false;
                  first = false;
                }});
  EXPECT_FALSE(bench.heated);
  EXPECT_FALSE(bench.program_ran());  // until a repeated `start` would have come
  bench.run(1);
  EXPECT_TRUE(bench.program_ran());
  EXPECT_FALSE(bench.heated);
}

TEST(boot_loader_chip, a_noisy_line_only_takes_longer) {
  Bench bench(0.001);
  bench.milliseconds_to("start\n", 200);
  const auto figures = loading::load(bench, small_program(12'000));
  EXPECT_GT(figures.repeated_frames, 0u);
  bench.run(1);
  EXPECT_TRUE(bench.program_ran());
}

TEST(boot_loader_chip, after_an_aborted_load_nothing_starts_until_a_whole_program_is_there) {
  Bench bench;
  bench.milliseconds_to("start\n", 200);
  bench.vanishes_after = 2000;
  EXPECT_THROW(loading::load(bench, small_program(6000)), LoadFailed);
  bench.run(2);
  EXPECT_FALSE(bench.program_ran());
  bench.reset();
  EXPECT_EQ(bench.milliseconds_to("start\n", 300), 300u);
  EXPECT_FALSE(bench.program_ran());
  bench.vanishes_after = ~std::size_t{0};
  // The firmware itself, as a user restores it.
  loading::load(bench, loading::read_program(tests::firmware_file));
  EXPECT_LT(bench.milliseconds_to("start\n", 1500), 1500u);
  bench.reset();
  EXPECT_LT(bench.milliseconds_to("start\n", 200), 200u);
}

TEST(boot_loader_chip, a_program_that_would_overwrite_the_loader_leaves_the_firmware_running) {
  Bench bench;
  bench.milliseconds_to("start\n", 200);
  EXPECT_THROW(
      loading::load(bench, small_program(loading::program_end - loading::memory_address + 1)),
      LoadFailed);
  // It was not begun, so the firmware goes on after the next reset.
  bench.reset();
  EXPECT_LT(bench.milliseconds_to("start\n", 200), 200u);
}

TEST(boot_loader_chip, a_host_that_knocks_at_reset_gets_the_loader_instead_of_the_firmware) {
  Bench bench;
  bench.send(std::string(64, '\xFF'));
  EXPECT_EQ(bench.milliseconds_to("start\n", 200), 200u);
  loading::load(bench, small_program());
  bench.run(1);
  EXPECT_TRUE(bench.program_ran());
}

}  // namespace
