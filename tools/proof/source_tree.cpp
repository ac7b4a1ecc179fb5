// SPDX-License-Identifier: Apache-2.0
// A unit needs what it calls `work.NAME`.
#include "tools/proof/source_tree.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>

#include "tools/proof/process.hpp"
#include "tools/proof/vhdl_tokens.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

std::set<std::string> names_needed(const std::string& text) {
  std::set<std::string> needs;
  const std::vector<Token> tokens = tokens_of(text);
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (tokens[i].text == "work" && tokens[i + 1].text == ".") needs.insert(tokens[i + 2].text);
  }
  return needs;
}

}  // namespace

SourceTree::SourceTree(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".vhd") {
        const std::string text = proof::text_of(entry.path());
        files_[entry.path().stem().string()] = {entry.path(), text, names_needed(text)};
      }
    }
  }
}

const SourceTree::File& SourceTree::file(const std::string& unit) const {
  const auto found = files_.find(unit);
  if (found == files_.end()) throw std::runtime_error(fmt::format("there is no file {}.vhd", unit));
  return found->second;
}

const fs::path& SourceTree::file_of(const std::string& unit) const { return file(unit).path; }
const std::string& SourceTree::text_of(const std::string& unit) const { return file(unit).text; }

std::set<std::string> SourceTree::closure_of(const std::string& unit) const {
  std::set<std::string> closure;
  std::vector<std::string> open{unit};
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (files_.contains(name) && closure.insert(name).second) {
      const auto& needs = files_.at(name).needs;
      open.insert(open.end(), needs.begin(), needs.end());
    }
  }
  return closure;
}

void SourceTree::replace(const std::string& unit, const fs::path& path, const std::string& text) {
  files_[unit] = {path, text, names_needed(text)};
}

std::vector<std::string> SourceTree::units() const {
  std::vector<std::string> names;
  for (const auto& [name, file] : files_) names.push_back(name);
  return names;
}

std::string fingerprint(std::string_view text) {
  // FNV-1a, from two offsets.
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t one = 0xcbf29ce484222325;
  std::uint64_t other = 0x84222325cbf29ce4;
  for (const char c : text) {
    one = (one ^ static_cast<unsigned char>(c)) * prime;
    other = (other ^ static_cast<unsigned char>(c) ^ (one >> 56)) * prime;
  }
  return fmt::format("{:016x}{:016x}", one, other);
}

}  // namespace proof
