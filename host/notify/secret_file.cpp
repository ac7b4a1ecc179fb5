// SPDX-License-Identifier: Apache-2.0
// Reads lines and looks at the file's mode.
#include "host/notify/secret_file.hpp"

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

namespace notify {

namespace {

constexpr std::size_t longest_line = 2000;

}  // namespace

std::vector<std::string> read_secret(const std::filesystem::path& file, std::size_t lines) {
  struct stat status{};
  std::ifstream stream(file);
  if (!stream || stat(file.c_str(), &status) != 0) {
    throw std::runtime_error("cannot read " + file.string());
  }
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw std::runtime_error("other users may use it: chmod 600 " + file.string());
  }
  std::vector<std::string> all;
  for (std::string line; all.size() < lines && std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.size() > longest_line) break;
    all.push_back(line);
  }
  if (all.size() < lines) {
    throw std::runtime_error(file.string() + " has not the " + std::to_string(lines) +
                             " lines that are needed");
  }
  return all;
}

}  // namespace notify
