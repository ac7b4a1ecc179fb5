// SPDX-License-Identifier: Apache-2.0
// What front ends keep on the server: their settings, by namespace and key.
#pragma once

#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/queue/sqlite_database.hpp"

namespace moonraker {

// For any thread. A change has reached the disk when its call returns.
class SettingsStore {
 public:
  static constexpr std::size_t most_namespaces = 64;
  static constexpr std::size_t longest_namespace = 1024 * 1024;  // bytes of JSON
  static constexpr std::size_t most_levels = 24;  // of a key

  explicit SettingsStore(const std::filesystem::path& file);

  std::vector<std::string> namespaces() const;
  // `key`: names with dots between them, or empty for all of the namespace. Throws Error 404.
  nlohmann::json item(const std::string& space, const std::string& key) const;
  // Objects on the way to the key are made. Throws Error 400 where something else is there, or it
  // would be too much.
  void set(const std::string& space, const std::string& key, const nlohmann::json& value);
  // Returns what it was. Throws Error 404.
  nlohmann::json remove(const std::string& space, const std::string& key);

 private:
  nlohmann::json read(const std::string& space) const;  // null where there is none
  void write(const std::string& space, const nlohmann::json& document);

  mutable std::mutex mutex_;
  mutable queue::SqliteDatabase database_;
};

}  // namespace moonraker
