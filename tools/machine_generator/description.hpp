// SPDX-License-Identifier: Apache-2.0
// From a machine description file to the firmware's parameters. What an entry may be stands here
// alone, in the call that reads it (description.cpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <toml++/toml.hpp>

#include "application/machine_description.hpp"
#include "machine_generator/parts_description.hpp"

namespace machine_generator {

struct Machine {
  std::string name;
  std::optional<std::uint32_t> memory_bytes{};  // that its chip must have; none: the default's
  std::optional<std::uint32_t> clock_hz{};  // of its chip; none: not said
  std::optional<motion::LevellingSettings> levelling{};
  Parts parts{};
  application::MachineDescription description{};  // but for its name and for what it points to

  // The description, with its name and what it points to; this must outlive it.
  application::MachineDescription whole() const;
};

// Throws DescriptionError on anything missing, ill-typed, out of the firmware's range or unknown.
Machine read_machine(const std::filesystem::path& file);
// `file` is for the message.
Machine read_machine(const toml::table& table, const std::filesystem::path& file);

}  // namespace machine_generator
