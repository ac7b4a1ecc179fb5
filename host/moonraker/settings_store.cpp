// SPDX-License-Identifier: Apache-2.0
// One document of JSON for each namespace.
#include "host/moonraker/settings_store.hpp"

#include <algorithm>

#include "host/moonraker/rpc.hpp"

namespace moonraker {

namespace {

constexpr std::size_t longest_name = 64;

std::vector<std::string> levels_of(const std::string& key) {
  std::vector<std::string> levels;
  std::size_t begin = 0;
  while (begin <= key.size() && !key.empty()) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    levels.push_back(key.substr(begin, end - begin));
    begin = end + 1;
  }
  const bool is_wrong = std::ranges::any_of(levels, &std::string::empty);
  if (is_wrong || levels.size() > SettingsStore::most_levels) {
    throw Error(400, "no such form of key");
  }
  return levels;
}

void check_name(const std::string& space) {
  if (space.empty() || space.size() > longest_name) throw Error(400, "no such form of namespace");
}

[[noreturn]] void fail_to_find(const std::string& space, const std::string& key) {
  throw Error(404, "Key '" + key + "' in namespace '" + space + "' not found");
}

}  // namespace

SettingsStore::SettingsStore(const std::filesystem::path& file) : database_(file) {
  database_.execute(
      "CREATE TABLE IF NOT EXISTS front_ends(space TEXT PRIMARY KEY, document TEXT NOT NULL)");
}

std::vector<std::string> SettingsStore::namespaces() const {
  const std::scoped_lock lock(mutex_);
  queue::Statement rows(database_, "SELECT space FROM front_ends ORDER BY space");
  std::vector<std::string> names;
  while (rows.step()) names.push_back(rows.text(0));
  return names;
}

nlohmann::json SettingsStore::read(const std::string& space) const {
  queue::Statement row(database_, "SELECT document FROM front_ends WHERE space = ?");
  row.bind(space);
  return row.step() ? nlohmann::json::parse(row.text(0)) : nlohmann::json();
}

void SettingsStore::write(const std::string& space, const nlohmann::json& document) {
  const std::string text = dumped(document);
  if (text.size() > longest_namespace) throw Error(400, "more than 1 MiB in a namespace");
  queue::Statement(database_, "INSERT OR REPLACE INTO front_ends(space, document) VALUES(?, ?)")
      .bind(space)
      .bind(text)
      .run();
}

nlohmann::json SettingsStore::item(const std::string& space, const std::string& key) const {
  const auto levels = levels_of(key);
  const std::scoped_lock lock(mutex_);
  const nlohmann::json document = read(space);
  if (document.is_null()) throw Error(404, "Namespace '" + space + "' not found");
  const nlohmann::json* place = &document;
  for (const std::string& level : levels) {
    if (!place->is_object() || !place->contains(level)) fail_to_find(space, key);
    place = &place->at(level);
  }
  return *place;
}

void SettingsStore::set(const std::string& space, const std::string& key,
                        const nlohmann::json& value) {
  check_name(space);
  const auto levels = levels_of(key);
  if (levels.empty() && !value.is_object()) throw Error(400, "a namespace is an object");
  const std::scoped_lock lock(mutex_);
  nlohmann::json document = read(space);
  if (document.is_null()) {
    queue::Statement count(database_, "SELECT count(*) FROM front_ends");
    count.step();
    if (count.integer(0) >= std::int64_t{most_namespaces}) throw Error(400, "too many namespaces");
    document = nlohmann::json::object();
  }
  nlohmann::json* place = &document;
  for (const std::string& level : levels) {
    if (!place->is_object()) throw Error(400, "the key leads through a value");
    const bool is_new = !place->contains(level);
    place = &(*place)[level];
    if (is_new && &level != &levels.back()) *place = nlohmann::json::object();
  }
  *place = value;
  write(space, document);
}

nlohmann::json SettingsStore::remove(const std::string& space, const std::string& key) {
  const auto levels = levels_of(key);
  if (levels.empty()) throw Error(400, "a key is needed");
  const std::scoped_lock lock(mutex_);
  nlohmann::json document = read(space);
  nlohmann::json* place = &document;
  for (const std::string& level : levels) {
    if (!place->is_object() || !place->contains(level)) fail_to_find(space, key);
    if (&level == &levels.back()) break;
    place = &place->at(level);
  }
  nlohmann::json old = place->at(levels.back());
  place->erase(levels.back());
  write(space, document);
  return old;
}

}  // namespace moonraker
