// SPDX-License-Identifier: Apache-2.0
// Tables of comma-separated values with a header row.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace files {

// A row of a table, by the names in its header row.
using Row = std::map<std::string, std::string>;

// Throws std::runtime_error where there is no such file, or a row has another number of cells.
std::vector<Row> read_table(const std::filesystem::path& file);

// The first row with this value in this column, or null.
const Row* row_with(const std::vector<Row>& rows, const std::string& column,
                    const std::string& value);

}  // namespace files
