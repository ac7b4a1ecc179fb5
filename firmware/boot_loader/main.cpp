// SPDX-License-Identifier: Apache-2.0
// The boot loader: after a reset it starts the firmware unless a host calls; then it waits for
// a program.
#include <array>
#include <string_view>

#include "boot_loader/line.hpp"
#include "boot_loader/session.hpp"
#include "machine/machine.hpp"
#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/identity_registers.hpp"
#include "registers/step_generator_registers.hpp"

extern "C" {
// Of start.S and boot_loader.ld.
extern volatile std::uint32_t program_entry;
extern std::uint8_t _program_memory[], _program_memory_end[];
extern std::uint8_t _start[];

std::uint32_t load_or_pass(bool requested);
}

namespace {

using namespace boot_loader;

// A host that knocks does it without end.
constexpr std::uint32_t windows_per_second = 100;  // 10 ms
// A frame comes without a pause as long as this.
constexpr std::uint32_t silences_per_second = 20;  // 50 ms
// A host whose answer to `start` was lost asks again within this time.
constexpr std::uint32_t silences_before_start = 12;  // 0.6 s
// Without a load the program that was there goes on.
constexpr std::uint32_t silences_before_return = 60 * silences_per_second;

constexpr std::string_view greeting = "echo:Boot loader waits for a program\n";

void stop_everything() {
  using Duty = registers::heater_control::Duty;
  for (std::size_t channel = 0; channel < Duty::count; ++channel) platform::write(channel, Duty{});
  platform::write(registers::step_generator::Command{.flush = true, .stop = true});
}

// Any other byte is from a host that uses the firmware.
bool knocked(std::uint32_t clock_hz) {
  for (unsigned count = 0; count < knocks; ++count) {
    if (Line::receive(clock_hz / windows_per_second) != knock) return false;
  }
  return true;
}

// As reset.S has them: lui t0, %hi(loader); jalr zero, %lo(loader)(t0). The lower part is signed.
Session::ResetCode way_back() {
  constexpr std::uint32_t lui_t0 = 0x2B7, jalr_t0 = 0x00028067;
  constexpr unsigned lower_bits = 12;
  const std::uint32_t address = reinterpret_cast<std::uintptr_t>(_start);
  const std::uint32_t upper = (address + (1u << (lower_bits - 1))) >> lower_bits << lower_bits;
  Session::ResetCode code;
  put_word(code, 0, upper | lui_t0);
  put_word(code, 4, (address - upper) << (32 - lower_bits) | jalr_t0);
  return code;
}

// The entry of the program to start.
std::uint32_t serve(std::uint32_t clock_hz) {
  FrameReceiver receiver;
  const std::uint32_t old_entry = program_entry;
  Session session({_program_memory, _program_memory_end},
                  reinterpret_cast<std::uintptr_t>(_program_memory),
                  old_entry != 0 ? std::optional(old_entry) : std::nullopt, way_back());
  std::uint32_t silences = 0;
  for (;;) {
    const auto byte = Line::receive(clock_hz / silences_per_second);
    if (byte) {
      silences = 0;
      if (!receiver.receive(*byte)) continue;
      const Answer answer = session.handle(receiver.frame());
      program_entry = session.entry().value_or(0);
      Line::send(answer.bytes());
      continue;
    }
    if (!receiver.silence()) Line::send(Session::refuse(Refusal::damaged).bytes());
    ++silences;
    const bool over =
        silences >= (session.start_wanted() ? silences_before_start : silences_before_return);
    if (over && session.entry()) return *session.entry();
  }
}

}  // namespace

std::uint32_t load_or_pass(bool requested) {
  const std::uint32_t clock_hz = platform::read<registers::identity::Clock>().frequency_hz;
  if (!requested) Line::configure(machine::machine.baud, clock_hz);
  if (requested || program_entry == 0 || knocked(clock_hz)) {
    stop_everything();
    if (requested) {
      Line::send({reinterpret_cast<const std::uint8_t*>(greeting.data()), greeting.size()});
    }
    program_entry = serve(clock_hz);
  }
  Line::leave();
  return program_entry;
}
