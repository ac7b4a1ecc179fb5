// SPDX-License-Identifier: Apache-2.0
#include "tools/command/search_state_file.hpp"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/files/file_text.hpp"
#include "tools/files/write_file.hpp"

namespace command {

using nlohmann::json;

SearchStateFile::SearchStateFile(std::filesystem::path file, const sim::ElfImage& firmware,
                                 std::uint64_t seed)
    : file_(std::move(file)) {
  if (file_.empty()) return;
  // What the search does is in the program itself.
  const std::uint64_t program = std::hash<std::string>()(files::text_of("/proc/self/exe"));
  for (const std::uint64_t part : {program, seed}) {
    for (unsigned shift = 0; shift < 64; shift += 8) {
      of_.push_back(static_cast<std::uint8_t>(part >> shift));
    }
  }
  for (const sim::ElfSegment& segment : firmware.segments) {
    of_.insert(of_.end(), segment.bytes.begin(), segment.bytes.end());
  }
}

bool SearchStateFile::is_there() const { return !file_.empty() && std::filesystem::exists(file_); }

void SearchStateFile::resume(worst_inputs::Search& search) const try {
  const json all = json::from_cbor(files::text_of(file_));
  const std::vector<std::uint8_t>& of = all.at("of").get_binary();
  if (of != of_) throw std::runtime_error("it is of another firmware, program or seed");
  const auto& state = all.at("search").get_binary();
  search.resume({state.begin(), state.end()});
} catch (const std::exception& error) {
  throw std::runtime_error(
      fmt::format("cannot go on with the search in {}: {}; remove it, or name another file",
                  file_.string(), error.what()));
}

void SearchStateFile::write(const worst_inputs::Search& search) const {
  if (file_.empty()) return;
  const std::string state = search.state();
  const json all{{"of", json::binary_t(of_)},
                 {"search", json::binary_t({state.begin(), state.end()})}};
  std::string bytes;
  json::to_cbor(all, bytes);
  files::write_file(file_, bytes);
}

}  // namespace command
