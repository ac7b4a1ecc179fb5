// SPDX-License-Identifier: Apache-2.0
// Reads tables of comma-separated values with a header row.
#include "tools/files/table.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace files {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char character : line) {
    if (character == ',') {
      cells.emplace_back();
    } else {
      cells.back() += character;
    }
  }
  return cells;
}

}  // namespace

std::vector<Row> read_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw std::runtime_error("no table " + file.string());
  const std::vector<std::string> names = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != names.size()) throw std::runtime_error(file.string() + ": " + line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells[i];
  }
  return rows;
}

const Row* row_with(const std::vector<Row>& rows, const std::string& column,
                    const std::string& value) {
  const auto found =
      std::ranges::find_if(rows, [&](const Row& row) { return row.at(column) == value; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace files
