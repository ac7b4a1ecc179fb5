// SPDX-License-Identifier: Apache-2.0
// report.json: the results under names that are kept stable.
#pragma once

#include <filesystem>
#include <string>

#include "sim/report/results.hpp"

namespace report {

std::string to_json(const Results& results);

// Throws std::runtime_error where the folder or the file cannot be written.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace report
