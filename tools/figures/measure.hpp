// SPDX-License-Identifier: Apache-2.0
// Measuring the figures of a group.
#pragma once

#include <filesystem>
#include <functional>

#include "tools/figures/group.hpp"
#include "tools/figures/store.hpp"

namespace figures {

// Where the calls run. `look` is called every few milliseconds; where it throws, the call ends.
struct Place {
  std::filesystem::path project;
  std::filesystem::path build;
  std::function<void()> look;
};

// Runs the group's command with a folder of its own, `<build>/figures/NAME`, reads its values,
// and copies its pictures to their places.
// Throws std::runtime_error where the command ends with a status above the group's highest (with
// the end of its output), or where a value is missing.
Record measure(const Group& group, const Place& place);

}  // namespace figures
