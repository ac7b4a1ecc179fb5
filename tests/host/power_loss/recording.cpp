// SPDX-License-Identifier: Apache-2.0
// The environment of recorded programs.
#include "tests/host/power_loss/recording.hpp"

#include <cstdlib>
#include <iterator>
#include <map>

#include "directories.hpp"

namespace power_loss {

Recording::Recording(const std::filesystem::path& place, std::string fault)
    : place_(std::filesystem::canonical(place)), fault_(std::move(fault)), disk_(folder()) {
  std::filesystem::create_directory(folder());
}

Recording::~Recording() { unsetenv("LD_PRELOAD"); }

void Recording::begin() {
  ++number_;
  setenv("RECORDER_FOLDER", (folder() / "").c_str(), 1);
  setenv("RECORDER_LOG", log().c_str(), 1);
  setenv("RECORDER_FAULT", fault_.c_str(), 1);
  setenv("LD_PRELOAD", BUILD_DIRECTORY "/bin/librecorder.so", 1);
}

std::vector<Record> Recording::end() {
  unsetenv("LD_PRELOAD");
  auto records = records_of(log());
  std::filesystem::remove(log());
  return records;
}

std::string Recording::cut(const std::vector<Record>& records, std::size_t operations,
                           std::mt19937& random) {
  std::string said;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i >= operations) {
      disk_.skip(records[i]);
      continue;
    }
    if (records[i].head.kind == Kind::said) said += records[i].first;
    disk_.apply(records[i]);
  }
  disk_.lose_power(random);
  disk_.restore();
  return said;
}

std::size_t random_cut(const std::vector<Record>& records, std::mt19937& random) {
  std::map<Kind, std::vector<std::size_t>> ends;
  for (std::size_t i = 0; i < records.size(); ++i) ends[records[i].head.kind].push_back(i + 1);
  if (ends.empty() || random() % 2 == 0) return random() % (records.size() + 1);
  const auto& of_kind =
      std::next(ends.begin(), static_cast<std::ptrdiff_t>(random() % ends.size()))->second;
  return of_kind[random() % of_kind.size()];
}

}  // namespace power_loss
