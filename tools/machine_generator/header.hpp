// SPDX-License-Identifier: Apache-2.0
// From a machine description to the C++ header with the firmware's constants.
#pragma once

#include <filesystem>
#include <string>
#include <toml++/toml.hpp>

namespace machine_generator {

// The text of machine/machine.hpp. Throws DescriptionError on anything missing, ill-typed, out of
// the firmware's range or unknown.
std::string header_of(const std::filesystem::path& file);
// The same for firmware that is compiled for size, whatever the chip's memory.
std::string small_header_of(const std::filesystem::path& file);

// The same judgement for another reader of the description, which then needs none of its own.
// `file` is for the message.
void check(const toml::table& description, const std::filesystem::path& file);

}  // namespace machine_generator
