// SPDX-License-Identifier: Apache-2.0
// One line each: key, finding, detail. What is not a whole line is not read.
#include "tools/proof/findings.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace proof {

namespace {

struct Name {
  Finding finding;
  const char* text;
};
constexpr std::array<Name, 4> names{{{Finding::passes, "passes"},
                                     {Finding::killed, "killed"},
                                     {Finding::refused, "refused"},
                                     {Finding::equivalent, "equivalent"}}};

}  // namespace

Findings::Findings(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::string key, finding, detail;
    words >> key >> finding >> std::ws;
    std::getline(words, detail);
    const auto* name = std::ranges::find_if(
        names, [&finding](const Name& entry) { return entry.text == finding; });
    if (name != names.end() && !stream.eof()) known_[key] = {name->finding, detail};
  }
  file_.open(file, std::ios::app);
  file_ << "\n";
}

std::optional<Judged> Findings::find(const std::string& key) {
  const std::scoped_lock lock(mutex_);
  const auto found = known_.find(key);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void Findings::add(const std::string& key, const Judged& judged) {
  const std::scoped_lock lock(mutex_);
  std::string detail = judged.detail;
  std::ranges::replace(detail, '\n', ' ');
  known_[key] = {judged.finding, detail, judged.timed_out};
  if (judged.timed_out) return;
  const auto* name = std::ranges::find_if(
      names, [&judged](const Name& entry) { return entry.finding == judged.finding; });
  file_ << key << ' ' << name->text << ' ' << detail << std::endl;
}

}  // namespace proof
