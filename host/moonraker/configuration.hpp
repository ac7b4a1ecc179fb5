// SPDX-License-Identifier: Apache-2.0
// What front ends look for in Klipper's configuration.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

namespace moonraker {

// Commands with a button in front ends.
struct Macro {
  std::string_view name;
  std::string_view help;
};
std::span<const Macro> macros();

// Other commands that scripts may have, with their help.
std::span<const Macro> other_commands();

// The object `configfile`: the sections that front ends look for. Limits of a real printer are not
// known here, so they are left out.
const nlohmann::json& configfile();

}  // namespace moonraker
