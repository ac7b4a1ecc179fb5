// SPDX-License-Identifier: Apache-2.0
// The number by which a queue's database knows a spooler.
#pragma once

#include <filesystem>
#include <string>

namespace spooler {

inline constexpr const char* spooler_id_file = "spooler_id";

// That of the folder of its data, which a restart finds again. A folder that was copied or moved,
// to another machine too, gets a new one: two spoolers with one number would take each other's
// printers for their own. Throws std::runtime_error where it cannot be written.
std::string spooler_id(const std::filesystem::path& data);

}  // namespace spooler
