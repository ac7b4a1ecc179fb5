// SPDX-License-Identifier: Apache-2.0
// A table that a person can read and that merges line by line.
#include "tools/proof/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tools/proof/source_tree.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

constexpr const char* heading = "# name\toutcome\tdigest of all that it depends on";

}  // namespace

Records read_records(const fs::path& file) {
  Records records;
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream row(line);
    std::string name, outcome, digest, more;
    std::getline(row, name, '\t');
    std::getline(row, outcome, '\t');
    std::getline(row, digest, '\t');
    const bool is_row = !name.empty() && (outcome == "holds" || outcome == "caught") &&
                        !digest.empty() && !std::getline(row, more, '\t');
    const Record record{outcome == "holds" ? Recorded::holds : Recorded::caught, digest};
    if (!is_row || !records.emplace(name, record).second) {
      throw std::runtime_error(
          fmt::format("{}: no row, or the second of its name: {}", file.string(), line));
    }
  }
  return records;
}

void write_records(const fs::path& file, const Records& records) {
  // Renamed when complete: an interrupted run leaves the old table or one with more rows.
  const fs::path whole = file.string() + ".new";
  std::ofstream stream(whole);
  stream << "# SPDX-License-Identifier: Apache-2.0\n" << heading << "\n";
  for (const auto& [name, record] : records) {
    stream << fmt::format("{}\t{}\t{}\n", name,
                          record.outcome == Recorded::holds ? "holds" : "caught", record.digest);
  }
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + whole.string());
  fs::rename(whole, file);
}

std::vector<std::string> part_of(std::vector<std::string> names, std::size_t wanted,
                                 std::uint64_t seed) {
  if (wanted == 0 || names.empty()) return {};
  // By digest, so that what stands together and takes long does not come together.
  std::ranges::sort(names, {}, [](const std::string& name) { return fingerprint(name); });
  const std::size_t parts = (names.size() + wanted - 1) / wanted;
  std::vector<std::string> part;
  for (std::size_t i = static_cast<std::size_t>(seed % parts); i < names.size(); i += parts) {
    part.push_back(names[i]);
  }
  return part;
}

}  // namespace proof
