// SPDX-License-Identifier: Apache-2.0
// Plays every dialogue of the folder next to this file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "directories.hpp"
#include "tests/host_link/dialogue.hpp"

namespace host_link::test {
namespace {

std::vector<std::filesystem::path> dialogues() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(PROJECT_DIRECTORY "/tests/host_link/dialogues")) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

class Dialogues : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Dialogues, goes_as_written) {
  const std::optional<std::string> wrong = Dialogue().play(GetParam());
  EXPECT_FALSE(wrong.has_value()) << *wrong;
}

INSTANTIATE_TEST_SUITE_P(host_link, Dialogues, testing::ValuesIn(dialogues()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace host_link::test
