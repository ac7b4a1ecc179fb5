// SPDX-License-Identifier: Apache-2.0
// `figures`: measures, writes the file and the pages, or checks them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace figures {

struct Options {
  std::vector<std::string> names;
  bool check = false;
};

// What a group needs is built by this, target by target.
using Build = std::function<void(const std::vector<std::string>& targets)>;

void add_options(CLI::App& job, Options& options);

// Each group is written as soon as it is measured. False where a page and the file differ after all
// is done. `look` as for process::run(). Throws std::runtime_error where a command fails.
bool run(const Options& options, const std::filesystem::path& project,
         const std::filesystem::path& build_folder, const Build& build,
         const std::function<void()>& look);

}  // namespace figures
