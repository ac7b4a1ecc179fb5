// SPDX-License-Identifier: Apache-2.0
// A debugger on the adapter's TCP port moves the pins of the Verilated access port.
#include "sim/devices/debug_adapter.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <Vdebug_transport.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <system_error>

#include "sim/simulation/simulation.hpp"

namespace {

constexpr sim::ClockRate rate(4'000'000);
constexpr std::uint32_t identity = 0x15f0'1001;
// In real time.
constexpr std::chrono::seconds timeout{60};

// Nothing of the chip but its access port.
class TapChip : public sim::Chip {
 public:
  TapChip() {
    model_.reset = 1;
    clock();
    model_.reset = 0;
  }
  ~TapChip() override { model_.final(); }

  void advance(sim::Clock limit) override {
    const sim::OutputPins before = outputs_;
    while (now_ < limit && outputs_ == before) {
      clock();
      ++now_;
    }
  }
  void reset() override {}
  std::uint32_t read_memory(std::uint32_t) const override { return 0; }
  void write_memory(std::uint32_t, std::uint32_t) override {}
  sim::QueueStatistics queue_statistics() const override { return {}; }
  sim::ProcessorStatistics processor_statistics() const override { return {}; }
  void trace_to(const std::string&) override { throw std::runtime_error("no traces"); }

  unsigned writes = 0;
  std::uint32_t last_address = 0, last_written = 0;
  // The contents of every register of the debug module.
  std::uint32_t register_value = 0;

 private:
  void clock() {
    model_.tck = inputs_.jtag.tck;
    model_.tms = inputs_.jtag.tms;
    model_.tdi = inputs_.jtag.tdi;
    model_.dmi_data = register_value;
    model_.clk = 1;
    model_.eval();
    model_.clk = 0;
    model_.eval();
    outputs_.word = std::uint64_t{model_.tdo} << sim::OutputPins::jtag_bit;
    if (model_.dmi_request_strobe && model_.dmi_request_write) {
      ++writes;
      last_address = model_.dmi_request_address;
      last_written = model_.dmi_request_data;
    }
  }

  Vdebug_transport model_;
};

class Debugger {
 public:
  explicit Debugger(std::uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;
  ~Debugger() { close(socket_); }

  void send(const std::string& requests) {
    EXPECT_EQ(::send(socket_, requests.data(), requests.size(), 0),
              static_cast<ssize_t>(requests.size()));
  }
  // What has come so far.
  std::string receive() {
    std::array<char, 4096> buffer{};
    const ssize_t count = recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT);
    return {buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
  }

 private:
  int socket_;
};

// One clock of TCK with these levels, with a look at TDO before it rises.
std::string clock(bool tms, bool tdi) {
  const int levels = (tms ? 2 : 0) + (tdi ? 1 : 0);
  return std::to_string(levels) + "R" + std::to_string(levels + 4);
}

std::string walk(const std::string& tms) {
  std::string requests;
  for (const char level : tms) requests += clock(level == '1', false);
  return requests;
}

// From run-test/idle through a register and back; `select` leads there.
std::string scan(const std::string& select, std::uint64_t bits, unsigned count) {
  std::string requests = walk(select + "00");
  for (unsigned i = 0; i < count; ++i) requests += clock(i + 1 == count, (bits >> i & 1) != 0);
  return requests + walk("10");
}

const std::string to_data = "1", to_instruction = "11", reset_tap = "111110";

class DebugAdapterTest : public testing::Test {
 protected:
  DebugAdapterTest() { simulation.attach(adapter, sim::OutputPins::jtag_pin()); }

  // Runs until the condition holds: the time that bytes take through the network is not tested.
  template <typename Predicate>
  void run_until(Predicate holds) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    do {
      simulation.run_until(simulation.now() + 100'000);
    } while (!holds() && std::chrono::steady_clock::now() < end);
    EXPECT_TRUE(holds());
  }
  // So many levels of TDO.
  std::string hear(Debugger& debugger, std::size_t count) {
    std::string levels;
    run_until([&] {
      levels += debugger.receive();
      return levels.size() >= count;
    });
    return levels;
  }
  std::string ask(Debugger& debugger, const std::string& requests) {
    debugger.send(requests);
    return hear(debugger, static_cast<std::size_t>(std::ranges::count(requests, 'R')));
  }
  // `count` bits of TDO after the two clocks and the select that lead to them.
  std::uint64_t scanned(Debugger& debugger, const std::string& select, std::uint64_t bits,
                        unsigned count) {
    const std::string levels = ask(debugger, scan(select, bits, count));
    EXPECT_EQ(levels.size(), select.size() + 2 + count + 2);
    std::uint64_t value = 0;
    for (unsigned i = 0; i < count && i < 64; ++i) {
      value |= std::uint64_t{levels.at(select.size() + 2 + i) == '1'} << i;
    }
    return value;
  }

  TapChip chip;
  sim::Simulation simulation{chip, rate};
  devices::DebugAdapter adapter{0, chip.inputs()};
};

TEST_F(DebugAdapterTest, reads_the_identity_after_five_clocks_with_tms_high) {
  Debugger debugger(adapter.port());
  EXPECT_EQ(ask(debugger, walk(reset_tap)).size(), reset_tap.size());
  EXPECT_EQ(scanned(debugger, to_data, 0, 32), identity);
  // Also out of the middle of a scan with another instruction.
  EXPECT_EQ(scanned(debugger, to_instruction, 0x11, 5) & 3, 1);
  ask(debugger, walk("100"));
  ask(debugger, walk(reset_tap));
  EXPECT_EQ(scanned(debugger, to_data, 0, 32), identity);
}

TEST_F(DebugAdapterTest, bypasses_with_one_bit) {
  Debugger debugger(adapter.port());
  ask(debugger, walk(reset_tap));
  scanned(debugger, to_instruction, 0x1f, 5);
  EXPECT_EQ(scanned(debugger, to_data, 0b1011'0010, 8), 0b0110'0100U);
}

TEST_F(DebugAdapterTest, reaches_the_registers_of_the_debug_module) {
  constexpr std::uint64_t write = 2, read = 1;
  Debugger debugger(adapter.port());
  ask(debugger, walk(reset_tap));
  scanned(debugger, to_instruction, 0x11, 5);
  scanned(debugger, to_data, std::uint64_t{0x10} << 34 | std::uint64_t{0x8000'0001} << 2 | write,
          41);
  EXPECT_EQ(chip.writes, 1U);
  EXPECT_EQ(chip.last_address, 0x10U);
  EXPECT_EQ(chip.last_written, 0x8000'0001U);
  chip.register_value = 0x1357'9bdf;
  scanned(debugger, to_data, std::uint64_t{0x11} << 34 | read, 41);
  EXPECT_EQ(scanned(debugger, to_data, 0, 41),
            std::uint64_t{0x11} << 34 | std::uint64_t{0x1357'9bdf} << 2);
  EXPECT_EQ(chip.writes, 1U);
}

TEST_F(DebugAdapterTest, leaves_lamp_and_reset_lines_alone) {
  Debugger debugger(adapter.port());
  ask(debugger, walk(reset_tap));
  const sim::InputPins before = chip.inputs();
  // The level that follows shows that they have been obeyed.
  EXPECT_EQ(ask(debugger, "BbrstuXR").size(), 1U);
  EXPECT_EQ(chip.inputs(), before);
  EXPECT_EQ(scanned(debugger, to_data, 0, 32), identity);
}

TEST_F(DebugAdapterTest, serves_one_debugger_after_the_other) {
  unsigned came = 0, left = 0;
  adapter.on_connect = [&came](sim::Clock) { ++came; };
  adapter.on_disconnect = [&left](sim::Clock) { ++left; };
  Debugger first(adapter.port());
  ask(first, walk(reset_tap));
  {
    Debugger second(adapter.port());
    second.send(walk(reset_tap));
    EXPECT_EQ(ask(first, "R").size(), 1U);
    EXPECT_EQ(second.receive(), "");
    EXPECT_EQ(came, 1U);
    first.send("Q");
    run_until([&left] { return left == 1; });
    EXPECT_EQ(hear(second, reset_tap.size()).size(), reset_tap.size());
    EXPECT_EQ(came, 2U);
  }
  // The second disconnects without sending anything.
  run_until([&left] { return left == 2; });
  Debugger third(adapter.port());
  ask(third, walk(reset_tap));
  EXPECT_EQ(scanned(third, to_data, 0, 32), identity);
}

TEST_F(DebugAdapterTest, does_not_share_its_port) {
  sim::InputPins pins;
  EXPECT_THROW(devices::DebugAdapter(adapter.port(), pins), std::system_error);
}

}  // namespace
