// SPDX-License-Identifier: Apache-2.0
// The firmware has no heap, so its state is its bytes: a prepared one is copied back for each
// input, to the place where it was made.
#include "tests/fuzz/printer_model.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <new>

#include "tests/fuzz/firmware_in_memory.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {

namespace {

using application_test::clock_hz;
using application_test::FakeChip;

FakeChip* living_chip = nullptr;

void pass_unchecked(FakeChip& chip) {
  if (firmware().application.update()) return;
  const std::uint64_t alarm = chip.alarm();
  chip.advance(alarm > chip.time ? static_cast<std::uint32_t>(alarm - chip.time) : 1);
}

struct Snapshot {
  std::array<std::byte, sizeof(Firmware)> memory;
  FakeChip chip;
};

void send(FakeChip& chip, std::string_view text) {
  chip.to_firmware.insert(chip.to_firmware.end(), text.begin(), text.end());
}

// Until the firmware has answered so many lines.
void await_oks(FakeChip& chip, int count) {
  for (int pass = 0; pass < 100'000; ++pass) {
    int oks = 0;
    for (std::size_t at = 0; (at = chip.from_firmware.find("ok", at)) != std::string::npos; ++at) {
      ++oks;
    }
    if (oks >= count) return chip.from_firmware.clear();
    pass_unchecked(chip);
  }
  fail("the firmware does not come to the prepared state; it said: {}", chip.from_firmware);
}

Snapshot prepare(Prepared state) {
  FakeChip& chip = *living_chip;
  static const FakeChip fresh = chip;
  chip = fresh;
  if (state == Prepared::hot) chip.heaters[0].celsius = 205, chip.heaters[1].celsius = 60;
  if (state == Prepared::nearly_too_hot) {
    chip.heaters[0].celsius = 270, chip.heaters[1].celsius = 116;
  }
  new (memory.data()) Firmware;
  while (chip.time < clock_hz / 10) pass_unchecked(chip);
  chip.from_firmware.clear();
  if (state != Prepared::started) {
    send(chip, "G28\nG1 X60 Y60 Z5 F9000\nM400\n");
    await_oks(chip, 3);
  }
  if (state == Prepared::hot) {
    send(chip, "M104 S200\nM140 S60\n");
    await_oks(chip, 2);
  }
  return {memory, chip};
}

const Snapshot& snapshot(Prepared state) {
  static FakeChip chip;
  living_chip = &chip;
  static const std::array<Snapshot, prepared_states> all{
      prepare(Prepared::started), prepare(Prepared::homed), prepare(Prepared::hot),
      prepare(Prepared::nearly_too_hot)};
  return all[static_cast<std::size_t>(state)];
}

constexpr std::array max_c{static_cast<double>(description.hotend.max.count()) / 1000,
                           static_cast<double>(description.bed.max.count()) / 1000};

}  // namespace

PrinterModel::PrinterModel(Prepared state) : travel_known_(state != Prepared::started) {
  const Snapshot& wanted = snapshot(state);
  std::memcpy(memory.data(), wanted.memory.data(), memory.size());
  *living_chip = wanted.chip;
}

FakeChip& PrinterModel::chip() { return *living_chip; }

bool PrinterModel::halted() const { return firmware().application.halted(); }

double PrinterModel::seconds() const { return static_cast<double>(living_chip->time) / clock_hz; }

void PrinterModel::pass() {
  pass_unchecked(chip());
  check();
}

void PrinterModel::run(double seconds) {
  const auto end = chip().time + static_cast<std::uint64_t>(seconds * clock_hz);
  while (chip().time < end) pass();
}

std::optional<std::string> PrinterModel::reply() {
  std::string& said = chip().from_firmware;
  const std::size_t end = said.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = said.substr(0, end);
  said.erase(0, end + 1);
  check_reply(line);
  return line;
}

void PrinterModel::check() {
  FakeChip& printer = chip();
  constexpr std::int64_t tolerance_steps = 8;
  for (std::size_t axis = 0; travel_known_ && axis < 3; ++axis) {
    const auto& limits = description.limits.axes[axis];
    const std::int64_t travel =
        limits.travel.count() / 1000 * limits.steps_per_meter.count() / 1'000'000;
    const std::int64_t place = printer.mechanical[axis];
    require(place >= -tolerance_steps && place <= travel + tolerance_steps,
            "axis {} stands at step {} of 0 to {}", axis, place, travel);
  }
  for (std::size_t i = 0; i < max_c.size(); ++i) {
    const bool heats = printer.supply_closed() && printer.heater_duty(i) != 0;
    const bool too_hot = printer.heaters[i].celsius > max_c[i];
    if (!too_hot || !heats) too_hot_since_[i] = printer.time;
    require(printer.time - too_hot_since_[i] <= clock_hz, "heater {} heats at {} degrees", i,
            printer.heaters[i].celsius);
  }
  require(printer.wrong_watchdog_feeds == 0, "the watchdog got a wrong key");
}

void PrinterModel::check_reply(std::string_view line) {
  require(std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; }),
          "a reply holds a byte that is no ASCII");
  if (!line.starts_with("ok T:") && !line.starts_with(" T:")) return;
  check_target(line, "T:", max_c[0]);
  check_target(line, "B:", max_c[1]);
}

// "T:20.00 /200.00"
void PrinterModel::check_target(std::string_view line, std::string_view name, double most_c) {
  const std::size_t place = line.find(name);
  const std::size_t slash = line.find('/', place);
  if (place == std::string_view::npos || slash == std::string_view::npos) return;
  double target = 0;
  std::from_chars(line.data() + slash + 1, line.data() + line.size(), target);
  require(target <= most_c, "a target above {}: {}", most_c, line);
}

void PrinterModel::check_at_the_end() {
  check();
  while (reply()) {
  }
  require(chip().underruns == 0, "the step generator's queue ran dry");
  if (!halted()) return;
  // For good: nothing moves or heats any more.
  const auto before = chip().mechanical;
  for (int i = 0; i < 4; ++i) pass();
  require(chip().mechanical == before && chip().motors == 0, "a halted printer moves");
  for (std::size_t i = 0; i < max_c.size(); ++i) {
    require(chip().heater_duty(i) == 0 || !chip().supply_closed(), "a halted printer heats");
  }
}

}  // namespace fuzz
